"""River, side stream, lakes and ponds."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from . import shapes
from .scatter import Ground

LAKE_RADII_M = (135.0, 95.0, 80.0, 62.0)  # mean radius; the first two carry islands
POND_COUNT = 42
POND_RADIUS_M = (8.0, 24.0)
FISHPOND_ROWS = 4


@dataclass(frozen=True)
class Rivers:
    """Running waters: center line of the river, and one surface of each."""

    river_line: LineString
    river: BaseGeometry
    stream: BaseGeometry

    @property
    def surface(self) -> BaseGeometry:
        """The ground that both cover."""
        return unary_union([self.river, self.stream])


def banked(rng: np.random.Generator, points_xy: np.ndarray, width: float, variation: float) -> BaseGeometry:
    """Return a water surface along a line; its width varies by ± `variation` × width."""
    wave = np.interp(np.arange(len(points_xy)), np.linspace(0, len(points_xy), 60), rng.uniform(-1, 1, 60))
    half = 0.5 * width * (1 + variation * wave)
    pieces = [LineString(points_xy[i : i + 2]).buffer(half[i], 5) for i in range(len(points_xy) - 1)]
    return unary_union(pieces).simplify(0.4)


def make_rivers(rng: np.random.Generator, size_xy: tuple[float, float]) -> Rivers:
    """A river from the western to the eastern edge and a stream that joins it from the north."""
    width, height = size_xy
    start = (-200.0, height * rng.uniform(0.52, 0.66))
    end = (width + 200.0, height * rng.uniform(0.30, 0.42))
    points = shapes.meander(rng, start, end, wavelength=1050.0, swing=1.15)
    mouth = points[int(len(points) * rng.uniform(0.62, 0.72))]
    source = (mouth[0] + rng.uniform(-100, 500), height + 120.0)
    stream_points = shapes.meander(rng, source, mouth, wavelength=330.0, swing=0.95)
    return Rivers(LineString(points), banked(rng, points, 34.0, 0.25), banked(rng, stream_points, 8.0, 0.2))


def lake(rng: np.random.Generator, center_xy: npt.ArrayLike, radius: float, island: bool) -> Polygon:
    """A lake with an irregular shore; an island is a hole in it."""
    shore = shapes.blob(rng, center_xy, radius, 0.16, rng.uniform(1.0, 1.9), rng.uniform(0, np.pi))
    if not island:
        return shore
    hole = shapes.blob(rng, np.add(center_xy, rng.uniform(-0.2, 0.2, 2) * radius), 0.17 * radius, 0.15)
    return shore.difference(hole) if hole.within(shore.buffer(-6)) else shore


def fishponds(rng: np.random.Generator, center_xy: npt.ArrayLike, heading: float) -> list[Polygon]:
    """Three to five rounded rectangular ponds side by side."""
    width, length = rng.uniform(16, 24), rng.uniform(35, 55)
    along = np.array([np.cos(heading), np.sin(heading)])
    return [
        shapes.rectangle(np.add(center_xy, along * i * (width + 7)), heading, width, length * rng.uniform(0.8, 1))
        .buffer(-4)
        .buffer(4, 4)
        for i in range(rng.integers(3, 6))
    ]


def still_waters(rng: np.random.Generator, ground: Ground) -> list[Polygon]:
    """Lakes, fishponds and ponds on free ground; they are added to `ground`."""
    waters = []
    for index, radius in enumerate(LAKE_RADII_M):
        waters += ground.place(rng, lambda at, r=radius, i=index: [lake(rng, at, r, i < 2)], clearance=18)
    for _ in range(FISHPOND_ROWS):
        waters += ground.place(rng, lambda at: fishponds(rng, at, rng.uniform(0, np.pi)), clearance=4)
    for _ in range(POND_COUNT):
        waters += ground.place_blob(rng, rng.uniform(*POND_RADIUS_M), 0.14, 2, 12)
    return waters
