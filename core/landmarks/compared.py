"""Landmark errors of a prediction: missed, spurious, mislabeled, boundary jitter.

See docs/explanation/method.md#noise-of-a-network.

Simulated images are degraded with the same numbers, so that a compared network can be assessed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from operator import add

import numpy as np

from .class_shifts import LARGEST_RATIO, REACH
from .landmarks import Landmarks, extract_landmarks

MARGIN_PX = 3
"""Pixels around a landmark's bounds where its predicted boundary may be."""

GRID_LENGTH = np.pi / 4
"""Length of a boundary relative to the pixel sides that it consists of, averaged over all directions."""

DEVIATION_OF_MEAN = np.sqrt(np.pi / 2)
"""Standard deviation of normally distributed values around 0 relative to their mean absolute value."""


@dataclass(frozen=True)
class LandmarkErrors:
    """Landmark errors of one class, or of all, in one piece of ground or in all.

    Attributes:
        annotated: Landmarks that are whole in a piece.
        missed: Annotated landmarks that the prediction lacks.
        misnamed: Mislabeled landmarks: annotated ones that the prediction shows as another class.
        invented: Spurious landmarks: predicted ones, whole in a piece, without an annotated one.
        apart_px: Mean distance between the boundaries of each other landmark, pixels.
    """

    annotated: int = 0
    missed: int = 0
    misnamed: int = 0
    invented: int = 0
    apart_px: tuple[float, ...] = field(default=())

    def __add__(self, other: LandmarkErrors) -> LandmarkErrors:
        return LandmarkErrors(*map(add, vars(self).values(), vars(other).values()))

    def ragged_px(self, shift_px: float = 0.0) -> float | None:
        """Return the boundary jitter: standard deviation beyond a shift of the class; None without measurements."""
        if not self.apart_px:
            return None
        deviation = DEVIATION_OF_MEAN * float(np.median(self.apart_px))
        # Across a boundary, a shift in a random direction contributes half of its square.
        return float(np.sqrt(max(deviation**2 - shift_px**2 / 2, 0.0)))


def piece_errors(
    true_hw: np.ndarray, predicted_hw: np.ndarray, class_values: Sequence[int], minimum_area_px: float
) -> dict[int, LandmarkErrors]:
    """Return the errors of each class in one piece of ground; ``class_shifts`` defines when landmarks are the same.

    Args:
        true_hw: (H, W) uint8 labels, 0 where unknown.
    """
    known = np.where(true_hw == 0, np.uint8(0), predicted_hw)
    true, predicted = (extract_landmarks(labels, class_values, minimum_area_px) for labels in (true_hw, known))
    # A landmark that is slightly too small in the other labels does not count as missed.
    faint_true, faint = (
        extract_landmarks(labels, class_values, minimum_area_px / LARGEST_RATIO) for labels in (true_hw, known)
    )
    named, called = _partners(true, faint, True), _partners(true, faint, False)
    there = _partners(predicted, faint_true, False) >= 0
    errors = {}
    for value in class_values:
        own = (true.classes == value) & ~true.touches_edge
        apart = [_apart_px(true_hw, known, value, true.bounds[n]) for n in np.flatnonzero(own & (named >= 0)).tolist()]
        errors[int(value)] = LandmarkErrors(
            int(own.sum()),
            int((own & (named < 0) & (called < 0)).sum()),
            int((own & (named < 0) & (called >= 0)).sum()),
            int(((predicted.classes == value) & ~predicted.touches_edge & ~there).sum()),
            tuple(apart),
        )
    return errors


def _partners(some: Landmarks, others: Landmarks, of_same_class: bool) -> np.ndarray:
    """Return (n,) index of the nearest other landmark with the same place and size; −1 without one."""
    if not len(some) or not len(others):
        return np.full(len(some), -1)
    apart = np.abs(some.centers_xy @ (1, 1j) - (others.centers_xy @ (1, 1j))[:, None]).T
    ratios = np.abs(np.log(others.areas_px / some.areas_px[:, None]))
    may_be = (ratios <= np.log(LARGEST_RATIO)) & (apart <= REACH * np.sqrt(some.areas_px)[:, None])
    if of_same_class:
        may_be &= others.classes == some.classes[:, None]
    distances = np.where(may_be, apart, np.inf)
    return np.where(may_be.any(axis=1), distances.argmin(axis=1), -1)


def _apart_px(true_hw: np.ndarray, predicted_hw: np.ndarray, value: int, bounds: np.ndarray) -> float:
    """Return the mean distance between a landmark's boundaries: the area between them over the true length."""
    left, top, right, bottom = bounds.tolist()
    part = slice(max(top - MARGIN_PX, 0), bottom + MARGIN_PX), slice(max(left - MARGIN_PX, 0), right + MARGIN_PX)
    true, predicted = true_hw[part] == value, predicted_hw[part] == value
    sides = (true[1:] != true[:-1]).sum() + (true[:, 1:] != true[:, :-1]).sum()
    return float((true != predicted).sum() / (GRID_LENGTH * max(sides, 1)))
