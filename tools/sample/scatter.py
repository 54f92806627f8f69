"""Free ground: where something can still be put without touching what is there."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from shapely.geometry import Polygon, box
from shapely.geometry.base import BaseGeometry
from shapely.prepared import prep

from . import shapes

CELL_M = 100.0  # of the grid that finds neighbors; about two farmyards
TRIES = 60


class Ground:
    """The map's rectangle with what is already taken; grows as things are placed."""

    def __init__(self, size_xy: tuple[float, float], blocked: BaseGeometry, margin: float = 6.0) -> None:
        self.size_xy = size_xy
        self._inside = prep(box(margin, margin, size_xy[0] - margin, size_xy[1] - margin))
        self._blocked = prep(blocked)
        self._cells: dict[tuple[int, int], list[Polygon]] = {}

    def is_free(self, shape: Polygon, clearance: float) -> bool:
        """Return whether the shape and `clearance` m around it are inside the map and touch no placed shape."""
        if not self._inside.contains(shape):
            return False
        wide = shape.buffer(clearance, 2) if clearance else shape
        if self._blocked.intersects(wide):
            return False
        return not any(wide.intersects(other) for other in self._near(wide))

    def add(self, shape: Polygon) -> None:
        """Keeps the ground of a shape from then on."""
        for cell in _cells(shape):
            self._cells.setdefault(cell, []).append(shape)

    def place(
        self,
        rng: np.random.Generator,
        make: Callable,
        clearance: float,
        within: tuple[float, float, float, float] | None = None,
        area: BaseGeometry | None = None,
    ) -> list[Polygon]:
        """Try random spots (in the rectangle `within`, on `area`) until all shapes of `make(spot_xy)` are free.

        Returns what was placed; nothing when `TRIES` spots failed.
        """
        x0, y0, x1, y1 = within or (0.0, 0.0, *self.size_xy)
        for _ in range(TRIES):
            spot = rng.uniform((x0, y0), (x1, y1))
            made = make(spot)
            if area is not None and not all(area.contains(s) for s in made):
                continue
            if all(self.is_free(s, clearance) for s in made):
                for shape in made:
                    self.add(shape)
                return made
        return []

    def place_blob(
        self, rng: np.random.Generator, radius: float, roughness: float, stretch: float, clearance: float, **where: Any
    ) -> list[Polygon]:
        """Place a blob that is up to `stretch` times longer than wide; `where`: as for ``place``."""

        def blob(at: np.ndarray) -> list[Polygon]:
            return [shapes.blob(rng, at, radius, roughness, rng.uniform(1, stretch), rng.uniform(0, np.pi))]

        return self.place(rng, blob, clearance, **where)

    def _near(self, shape: BaseGeometry) -> Iterator[Polygon]:
        return (other for cell in _cells(shape) for other in self._cells.get(cell, ()))


def _cells(shape: BaseGeometry) -> list[tuple[int, int]]:
    x0, y0, x1, y1 = (int(v // CELL_M) for v in shape.bounds)
    return [(x, y) for x in range(x0, x1 + 1) for y in range(y0, y1 + 1)]
