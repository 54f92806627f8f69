"""The class table of the sample area."""

from __future__ import annotations

from dataclasses import dataclass

BUILDING, BARE_LAND, WATER, FOREST, CULTIVATED, GRASS = 1, 2, 3, 4, 5, 6


@dataclass(frozen=True)
class SampleClass:
    """One land-cover class; HSV in OpenCV's ranges (hue 0..180), hue wraps when the minimum exceeds the maximum."""

    value: int
    name: str
    color: str  # '#rrggbb'
    role: str  # 'reference' or 'background'
    hsv_min: tuple[int, int, int]
    hsv_max: tuple[int, int, int]

    @property
    def rgb(self) -> tuple[int, int, int]:
        """Red, green, blue, 0..255."""
        red, green, blue = (int(self.color[i : i + 2], 16) for i in (1, 3, 5))
        return red, green, blue


# Red, purple, blue and green are the colors of Figure 5 in Remote Sens. 2025, 17, 1671; black is what is in no class.
# Cultivated land is deep blue there, which over photos is taken for water: it is yellow here. Grass has no color there.
CLASSES = (
    SampleClass(BUILDING, "building", "#e3211c", "reference", (172, 120, 120), (8, 255, 255)),
    SampleClass(BARE_LAND, "bare_land", "#a032b4", "reference", (138, 100, 90), (160, 255, 255)),
    SampleClass(WATER, "water", "#2896ff", "reference", (96, 120, 180), (111, 255, 255)),
    SampleClass(FOREST, "forest", "#1e8c32", "background", (50, 120, 70), (80, 255, 220)),
    SampleClass(CULTIVATED, "cultivated", "#e4c65a", "background", (18, 90, 160), (27, 255, 255)),
    SampleClass(GRASS, "grass", "#b4dc46", "background", (28, 90, 140), (46, 255, 255)),
)
