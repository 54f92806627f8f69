"""Views of the map as an aircraft would have them: on windows, turned, scaled, and off the grid.

A view is cut from any raster of the landscape, labels (h, w) or photo (h, w, 3): always real ground, never padding.
Pixel coordinates are (column, row), (0.5, 0.5) at the center of the first pixel. The heading of the image's top is in
degrees clockwise from grid north: with 90 the top of the image is in the east.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from semref.core.simulation.views import PIXELS, View, lies_on
from semref.core.simulation.views import cut as cut_view

from .classes import CLASSES

WINDOW_PX, STRIDE_PX = 640, 160
HEADINGS_DEG = tuple(range(0, 360, 30))  # Table 5 of Remote Sens. 2025, 17, 1671
SCALES = (2.0, 1.8, 1.5, 1.2, 1.0, 0.8, 0.75, 0.65, 0.6, 0.5)  # its Table 4; how many times the view's radius
ON_WINDOW_COUNT, OFF_GRID_COUNT = 8, 8
COLOR_HEADINGS_DEG = (0, 60, 150, 240)
COLOR_ON_WINDOW_COUNT, COLOR_OFF_GRID_COUNT = 3, 1
OFF_GRID_SCALES = (0.8, 1.25)
PHOTO_COUNT = 12
FLIGHT_COUNT = 16
FLIGHT_SCALES = (0.95, 1.05)
"""Map pixels that an image pixel of the flight shows at its start and at its end: it climbs a little."""


@dataclass(frozen=True)
class Picture:
    """A picture of the sample, as in truth.csv.

    Attributes:
        name: Name of the file.
        kind: Kind of example.
        column: Column of the center, in pixels of the map.
        row: Row of the center, in pixels of the map.
        heading_deg: Heading of the top, clockwise from grid north.
        scale: Map pixels per image pixel.
        window: Name of the window at the center, if any.
        in_color: Whether classes are shown by their colors.
    """

    name: str
    kind: str
    column: float
    row: float
    heading_deg: float = 0.0
    scale: float = 1.0
    window: str = ""
    in_color: bool = False

    def view(self, size_px: int) -> View:
        """What a camera with so many pixels is over, on the map's pixel grid."""
        return View(self.column, -self.row, self.heading_deg, self.scale, size_px, size_px)


def cut(raster: np.ndarray, picture: Picture, size_px: int = WINDOW_PX) -> np.ndarray:
    """The picture (size, size[, bands]) of a label map (h, w) or photo (h, w, bands).

    Raises:
        ValueError: when it leaves the map.
    """
    view = picture.view(size_px)
    if not lies_on(PIXELS.of_shape((raster.shape[0], raster.shape[1])), view):
        raise ValueError(f"The view {picture.name} reaches beyond the map.")
    return cut_view(raster, PIXELS, view)


def colored(labels_hw: np.ndarray) -> np.ndarray:
    """RGB picture (h, w, 3) of a label map in the class colors; unlabeled is black."""
    table = np.zeros((256, 3), np.uint8)
    for entry in CLASSES:
        table[entry.value] = entry.rgb
    return table[labels_hw]


def plan_views(shape_hw: tuple[int, int], seed: int) -> tuple[Picture, ...]:
    """All pictures of the sample, in the order of truth.csv."""
    rng, grid = np.random.default_rng([seed, 100]), _grid(shape_hw)
    picked = rng.choice(len(grid), ON_WINDOW_COUNT, replace=False)
    chosen = sorted((grid[i] for i in picked), key=lambda at: at[::-1])
    # Around this window there is map for the largest scale.
    middle = (0.55 * shape_hw[1] - WINDOW_PX / 2, 0.5 * shape_hw[0] - WINDOW_PX / 2)
    turned = min(_grid(shape_hw, WINDOW_PX * (max(SCALES) - 1) / 2), key=lambda at: math.dist(at, middle))
    views = [_on(at, "on_window") for at in chosen]
    views += [_on(turned, "rotated", f"_{h:03d}", heading_deg=h) for h in HEADINGS_DEG]
    views += [_on(turned, "scaled", f"_{s:.2f}", scale=s) for s in SCALES]
    views += _off_grid(rng, shape_hw, OFF_GRID_COUNT, "off_grid")
    views += [_on(at, "color_on_window", in_color=True) for at in chosen[:COLOR_ON_WINDOW_COUNT]]
    views += [_on(turned, "color_rotated", f"_{h:03d}", heading_deg=h, in_color=True) for h in COLOR_HEADINGS_DEG]
    return tuple(views + _off_grid(rng, shape_hw, COLOR_OFF_GRID_COUNT, "color_off_grid", in_color=True))


def plan_photos(shape_hw: tuple[int, int], seed: int, count: int = PHOTO_COUNT) -> tuple[Picture, ...]:
    """Where photos are taken: any place, heading and scale; more of them begin with the same ones."""
    rng = np.random.default_rng([seed, 101])
    return tuple(_off_grid(rng, shape_hw, count, "photo", suffix="jpg"))


def plan_flight(shape_hw: tuple[int, int]) -> tuple[Picture, ...]:
    """Where the photos of one flight are taken: from west to east in a curve, tops in the direction of flight."""
    height, width = shape_hw
    margin = WINDOW_PX / 2 * np.sqrt(2) * max(OFF_GRID_SCALES) + 2
    along = np.linspace(0, 1, FLIGHT_COUNT)
    columns = margin + (width - 2 * margin) * along
    rows = height / 2 + (height / 2 - margin) * np.sin(1.5 * np.pi * along)
    headings = np.degrees(np.arctan2(np.gradient(columns), -np.gradient(rows))) % 360
    scales = np.interp(along, (0, 1), FLIGHT_SCALES)
    values = (np.round(each, 2).tolist() for each in (columns, rows, headings, scales))
    return tuple(
        Picture(f"flight_{number:02d}.jpg", "flight", column, row, heading, scale)
        for number, (column, row, heading, scale) in enumerate(zip(*values), start=1)
    )


def _on(at: tuple[int, int], kind: str, detail: str = "", **settings: Any) -> Picture:
    half, window = WINDOW_PX / 2, f"{at[0]}_{at[1]}"
    return Picture(f"{kind}{detail}_{window}.png", kind, at[0] + half, at[1] + half, window=window, **settings)


def _off_grid(
    rng: np.random.Generator, shape_hw: tuple[int, int], count: int, kind: str, suffix: str = "png", **settings: Any
) -> list[Picture]:
    """Draw views at any place, heading and scale with all corners on the map."""
    pictures = []
    margin = WINDOW_PX / 2 * np.sqrt(2) * max(OFF_GRID_SCALES) + 2
    for number in range(1, count + 1):
        column, row = np.round(rng.uniform(margin, np.subtract(shape_hw[::-1], margin)), 2)
        heading, scale = round(rng.uniform(0, 360), 1), round(rng.uniform(*OFF_GRID_SCALES), 3)
        name = f"{kind}_{number:02d}.{suffix}"
        pictures.append(Picture(name, kind, float(column), float(row), heading, scale, **settings))
    return pictures


def _grid(shape_hw: tuple[int, int], margin: float = 0) -> list[tuple[int, int]]:
    """First pixels of all windows with `margin` pixels of map around them, in reading order."""
    height, width = shape_hw
    columns, rows = (
        [at for at in range(0, side - WINDOW_PX + 1, STRIDE_PX) if margin <= at <= side - WINDOW_PX - margin]
        for side in (width, height)
    )
    return [(column, row) for row in rows for column in columns]
