"""The class table of the sample area."""

from semref.core.labels.class_table import LandCoverClass

BUILDING, BARE_LAND, WATER, FOREST, CULTIVATED, GRASS = 1, 2, 3, 4, 5, 6

# Red, purple, blue and green are the colors of Figure 5 in Remote Sens. 2025, 17, 1671; black is what is in no class.
# Cultivated land is deep blue there, which over photos is taken for water: it is yellow here. Grass has no color there.
CLASSES = (
    LandCoverClass(BUILDING, "building", "#e3211c", "reference", None, (172, 120, 120), (8, 255, 255)),
    LandCoverClass(BARE_LAND, "bare_land", "#a032b4", "reference", None, (138, 100, 90), (160, 255, 255)),
    LandCoverClass(WATER, "water", "#2896ff", "reference", None, (96, 120, 180), (111, 255, 255)),
    LandCoverClass(FOREST, "forest", "#1e8c32", "background", None, (50, 120, 70), (80, 255, 220)),
    LandCoverClass(CULTIVATED, "cultivated", "#e4c65a", "background", None, (18, 90, 160), (27, 255, 255)),
    LandCoverClass(GRASS, "grass", "#b4dc46", "background", None, (28, 90, 140), (46, 255, 255)),
)
