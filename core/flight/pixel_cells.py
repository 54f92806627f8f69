"""Cells of the ground that two pictures share; each cell of one picture is searched in the other."""

from __future__ import annotations

import cv2
import numpy as np

from .pixel_features import Features
from .pixel_fit import Mapping

CELL_PX, SEARCH_PX = 32, 6
"""Edge of the cells and reach of their search, in working pixels."""

MOST_CELLS = 160
LEAST_TEXTURE = 12.0
"""Least standard deviation of a cell, in gray levels."""

LEAST_LIKENESS = 0.55
"""Least correlation of a matched cell."""


class SharedGround:
    """The second picture resampled onto the first by a mapping.

    Attributes:
        corners: (N, 2) int: first column and row, in the first picture, of textured cells that both pictures show.
    """

    def __init__(self, first: Features, second: Features, mapping: Mapping) -> None:
        """Resample the second picture.

        Args:
            first: Of the earlier image.
            second: Of the later image.
            mapping: From the second picture to the first.
        """
        self._first = first.picture_hw
        self._halves = _half_wh(first), _half_wh(second)
        self._matrix = self._forward(mapping)
        height, width = self._first.shape
        self._laid = cv2.warpPerspective(second.picture_hw, self._matrix, (width, height))
        known = np.ones(second.picture_hw.shape, np.uint8)
        if second.is_known_hw is not None:
            known = second.is_known_hw.astype(np.uint8)
        shared = cv2.warpPerspective(known, self._matrix, (width, height), flags=cv2.INTER_NEAREST)
        if first.is_known_hw is not None:
            shared &= first.is_known_hw.astype(np.uint8)
        self.corners = self._textured_cells(first, shared)

    def _forward(self, mapping: Mapping) -> np.ndarray:
        """Return (3, 3) from pixels of the second picture to those of the first, in OpenCV's coordinates."""
        first, second = self._halves
        corners = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]) * second
        return cv2.getPerspectiveTransform(
            (corners + second).astype(np.float32), (mapping(corners) + first).astype(np.float32)
        )

    def _textured_cells(self, first: Features, shared: np.ndarray) -> np.ndarray:
        """Return the cells inside the overlap with enough texture to match."""
        step = CELL_PX
        inside = float(shared.sum())
        while inside / step**2 > MOST_CELLS:
            step += 2
        height, width = self._first.shape
        margin = SEARCH_PX
        columns = np.arange(margin, width - CELL_PX - margin + 1, step)
        rows = np.arange(margin, height - CELL_PX - margin + 1, step)
        x, y = (grid.ravel() for grid in np.meshgrid(columns, rows))
        inside_px = _sums(cv2.integral(shared), x - margin, y - margin, CELL_PX + 2 * margin)
        whole = inside_px == (CELL_PX + 2 * margin) ** 2
        x, y = x[whole], y[whole]
        mean, square = (_sums(total, x, y, CELL_PX) / CELL_PX**2 for total in first.sums)
        textured = np.sqrt(np.maximum(square - mean * mean, 0)) >= LEAST_TEXTURE
        return np.column_stack([x[textured], y[textured]])

    def match_cells(self) -> tuple[np.ndarray, np.ndarray]:
        """Return matched places: (M, 2) in the second picture and (M, 2) in the first, from the pictures' centers."""
        moves = [self._move(int(x), int(y)) for x, y in self.corners]
        is_found = np.array([move is not None for move in moves], bool)
        shifts = np.array([move for move in moves if move is not None], np.float64).reshape(-1, 2)
        middles = self.corners[is_found] + (CELL_PX - 1) / 2
        back = cv2.perspectiveTransform((middles + shifts)[None], np.linalg.inv(self._matrix))
        ours = np.zeros((0, 2)) if back is None else back[0]
        return ours - self._halves[1], middles - self._halves[0]

    def _move(self, x: int, y: int) -> tuple[float, float] | None:
        """Return the shift (right, down) of a cell from its proposed place; None without a match."""
        cell = self._first[y : y + CELL_PX, x : x + CELL_PX]
        around = self._laid[y - SEARCH_PX : y + CELL_PX + SEARCH_PX, x - SEARCH_PX : x + CELL_PX + SEARCH_PX]
        likeness = cv2.matchTemplate(around, cell, cv2.TM_CCOEFF_NORMED)
        row, column = divmod(int(likeness.argmax()), likeness.shape[1])
        edge = likeness.shape[0] - 1
        if likeness[row, column] < LEAST_LIKENESS or not (0 < row < edge and 0 < column < edge):
            return None
        across = _peak(*likeness[row, column - 1 : column + 2].tolist())
        along = _peak(*likeness[row - 1 : row + 2, column].tolist())
        return column + across - SEARCH_PX, row + along - SEARCH_PX


def _peak(before: float, at: float, after: float) -> float:
    """Return the peak of a parabola through three values, relative to the middle one."""
    bend = before - 2 * at + after
    return 0.5 * (before - after) / bend if bend < 0 else 0.0


def _half_wh(features: Features) -> np.ndarray:
    """Return (2,) the offset from the center of the first pixel to the center of the picture."""
    return (np.array(features.picture_hw.shape[::-1], np.float64) - 1) / 2


def _sums(total: np.ndarray, x: np.ndarray, y: np.ndarray, edge: int) -> np.ndarray:
    """Return (N,) sums, from an integral image, over squares that begin at columns x and rows y."""
    return total[y + edge, x + edge] - total[y, x + edge] - total[y + edge, x] + total[y, x]
