"""Where the photos of the sample are taken: at any place, heading and scale, always over real ground.

Pixel coordinates are (column, row), (0.5, 0.5) at the center of the first pixel. The heading of the image's top is in
degrees clockwise from grid north: with 90 the top of the image is in the east.
"""

from dataclasses import dataclass

import numpy as np

from semref.core.simulation.views import View

WINDOW_PX = 640
SCALES = (0.8, 1.25)
PHOTO_COUNT = 12
FLIGHT_COUNT = 16
FLIGHT_SCALES = (0.95, 1.05)
"""Map pixels that an image pixel of the flight shows at its start and at its end: it climbs a little."""


@dataclass(frozen=True)
class Picture:
    """A picture of the sample, as in photos.csv.

    Attributes:
        name: Name of the file.
        column: Column of the center, in pixels of the map.
        row: Row of the center, in pixels of the map.
        heading_deg: Heading of the top, clockwise from grid north.
        scale: Map pixels per image pixel.
    """

    name: str
    column: float
    row: float
    heading_deg: float
    scale: float

    def view(self, size_px: int) -> View:
        """What a camera with so many pixels is over, on the map's pixel grid."""
        return View(self.column, -self.row, self.heading_deg, self.scale, size_px, size_px)


def plan_photos(shape_hw: tuple[int, int], seed: int, count: int = PHOTO_COUNT) -> tuple[Picture, ...]:
    """Where photos are taken: any place, heading and scale; more of them begin with the same ones."""
    rng, pictures = np.random.default_rng([seed, 101]), []
    margin = WINDOW_PX / 2 * np.sqrt(2) * max(SCALES) + 2
    for number in range(1, count + 1):
        column, row = np.round(rng.uniform(margin, np.subtract(shape_hw[::-1], margin)), 2)
        heading, scale = round(rng.uniform(0, 360), 1), round(rng.uniform(*SCALES), 3)
        pictures.append(Picture(f"photo_{number:02d}.jpg", float(column), float(row), heading, scale))
    return tuple(pictures)


def plan_flight(shape_hw: tuple[int, int]) -> tuple[Picture, ...]:
    """Where the photos of one flight are taken: from west to east in a curve, tops in the direction of flight."""
    height, width = shape_hw
    margin = WINDOW_PX / 2 * np.sqrt(2) * max(SCALES) + 2
    along = np.linspace(0, 1, FLIGHT_COUNT)
    columns = margin + (width - 2 * margin) * along
    rows = height / 2 + (height / 2 - margin) * np.sin(1.5 * np.pi * along)
    headings = np.degrees(np.arctan2(np.gradient(columns), -np.gradient(rows))) % 360
    scales = np.interp(along, (0, 1), FLIGHT_SCALES)
    values = (np.round(each, 2).tolist() for each in (columns, rows, headings, scales))
    return tuple(
        Picture(f"flight_{number:02d}.jpg", column, row, heading, scale)
        for number, (column, row, heading, scale) in enumerate(zip(*values), start=1)
    )
