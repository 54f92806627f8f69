"""Polygons to burn as they go from process to process: what is the same for all parts of a label map."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..geometry.frame import MapFrame
from ..labels.class_table import ClassTable


@dataclass(frozen=True)
class BurnJob:
    """A label map to burn, its polygons bottom first.

    Attributes:
        frame: Its pixels.
        table: Its classes.
        values: (N,) uint8, of the polygons' classes.
        bounds: (N, 4) their x_min, y_min, x_max, y_max.
        ends: (N,) where the outline of each ends in ``outlines``.
        outlines: (B,) uint8, WKB.
    """

    frame: MapFrame
    table: ClassTable
    values: np.ndarray
    bounds: np.ndarray
    ends: np.ndarray
    outlines: np.ndarray

    def within(self, extent: tuple[float, float, float, float]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Values, ends and outlines of the polygons that may reach into a rectangle, in their order.

        Args:
            extent: x_min, y_min, x_max, y_max.
        """
        left, bottom, right, top = extent
        x_min, y_min, x_max, y_max = self.bounds.T
        chosen = np.flatnonzero((x_min <= right) & (x_max >= left) & (y_min <= top) & (y_max >= bottom))
        begins = np.concatenate([[0], self.ends[:-1]])[chosen] if len(self.ends) else self.ends
        ends = self.ends[chosen]
        parts = [self.outlines[begin:end] for begin, end in zip(begins.tolist(), ends.tolist())]
        return self.values[chosen], np.cumsum(ends - begins), np.concatenate([np.zeros(0, np.uint8), *parts])
