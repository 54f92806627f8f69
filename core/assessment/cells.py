"""The squares of ground of an assessment."""

from __future__ import annotations

import math
from dataclasses import dataclass

import cv2
import numpy as np

from .. import limits
from ..database.model import ReferenceDatabase
from ..errors import ParameterError


@dataclass(frozen=True)
class Cells:
    """C squares of a grid.

    Attributes:
        size: Edge of a square, m.
        centers: (C, 2) map x, y.
        columns: (C,) in the grid.
        rows: (C,) in the grid, from the north.
    """

    size: float
    centers: np.ndarray
    columns: np.ndarray
    rows: np.ndarray

    def __len__(self) -> int:
        return len(self.centers)


def ground_cells(database: ReferenceDatabase, size: float) -> Cells:
    """Return squares that cover a map, row by row from its upper left corner.

    Ground without any label or landmark is left out if it is connected with the map's edge: the frame around a country.
    Ground without labels inside the map counts.

    Args:
        size: Edge of a square, m.

    Raises:
        ParameterError: The size can't be used.
    """
    if not 0 < size < math.inf:
        raise ParameterError("The edge of a square is {size:g} m; it must be more than 0 m.", size=size)
    x0, y_low, x1, y0 = database.parameters.extent
    width, height = (max(math.ceil((b - a) / size - 1e-6), 1) for a, b in ((x0, x1), (y_low, y0)))
    if width * height > limits.SQUARES:
        least = math.sqrt((x1 - x0) * (y0 - y_low) / limits.SQUARES)
        raise ParameterError(
            "The edge of a square is {size:g} m, which gives {count} squares on the map. Enter {least:.3g} m or more.",
            size=size,
            count=width * height,
            least=1.01 * least,
        )
    empty = ~_labeled_squares(database, size, width, height)
    positions = database.references.positions
    columns = np.clip(((positions[:, 0] - x0) / size).astype(int), 0, width - 1)
    rows = np.clip(((y0 - positions[:, 1]) / size).astype(int), 0, height - 1)
    empty[rows, columns] = False
    # A frame of empty ground around the map connects all empty ground at its edge.
    framed = np.pad(empty, 1, constant_values=True).astype(np.uint8)
    _, regions = cv2.connectedComponents(framed, connectivity=4)
    rows, columns = np.nonzero(regions[1:-1, 1:-1] != regions[0, 0])
    centers = np.column_stack([x0 + (columns + 0.5) * size, y0 - (rows + 0.5) * size])
    return Cells(size, centers, columns, rows)


def _labeled_squares(database: ReferenceDatabase, size: float, width: int, height: int) -> np.ndarray:
    """Return (height, width) bool: squares with a labeled pixel of the overview; all squares without overview."""
    overview = database.overview
    if overview is None:
        return np.ones((height, width), bool)
    pixel = database.parameters.pixel_size * database.parameters.overview_factor
    rows, columns = (
        np.unique(np.minimum((np.arange(count) * size / pixel).astype(int), length - 1), return_inverse=True)
        for count, length in ((height, overview.shape[0]), (width, overview.shape[1]))
    )
    some = np.maximum.reduceat(overview, rows[0], axis=0)
    return np.maximum.reduceat(some, columns[0], axis=1)[rows[1]][:, columns[1]] > 0
