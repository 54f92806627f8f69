"""How poor a prediction's landmarks are: missed, spurious, mislabeled, jittered.

See docs/explanation/method.md#noise-of-a-network.

The numbers are those that simulated images are spoiled with, so that a network that was compared can be assessed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from .class_shifts import LARGEST_RATIO, REACH
from .landmarks import Landmarks, extract_landmarks

MARGIN_PX = 3
"""Around a landmark's bounds its edge may lie in the prediction."""

GRID_LENGTH = np.pi / 4
"""Length of an edge, in the sides of pixels that it is made of, over all directions."""

DEVIATION_OF_MEAN = np.sqrt(np.pi / 2)
"""Standard deviation of normally distributed values around 0, in the mean of their sizes."""


@dataclass(frozen=True)
class LandmarkErrors:
    """Of one class, or of all, in one piece of ground or in all.

    Attributes:
        annotated: Landmarks that lie whole in a piece.
        missed: Of these, those that the prediction has nothing for.
        misnamed: Of these, those that it shows as another class.
        invented: Predicted landmarks, whole in a piece, where the annotation has none.
        apart_px: How far the edges of the others lie apart on average, one value a landmark, pixels.
    """

    annotated: int = 0
    missed: int = 0
    misnamed: int = 0
    invented: int = 0
    apart_px: tuple[float, ...] = field(default=())

    def __add__(self, other: LandmarkErrors) -> LandmarkErrors:
        """Both together."""
        return LandmarkErrors(
            self.annotated + other.annotated,
            self.missed + other.missed,
            self.misnamed + other.misnamed,
            self.invented + other.invented,
            self.apart_px + other.apart_px,
        )

    def ragged_px(self, shift_px: float = 0.0) -> float | None:
        """Return standard deviation of how far edges are moved, beyond a shift of the class; None where none was found."""
        if not self.apart_px:
            return None
        deviation = DEVIATION_OF_MEAN * float(np.median(self.apart_px))
        # Across an edge a shift in some direction moves it by half of its square.
        return float(np.sqrt(max(deviation**2 - shift_px**2 / 2, 0.0)))


def piece_errors(
    true_hw: np.ndarray, predicted_hw: np.ndarray, class_values: Sequence[int], minimum_area_px: float
) -> dict[int, LandmarkErrors]:
    """Return of each class in one piece of ground. A landmark is the same when place and size agree, as in ``class_shifts``.

    Args:
        true_hw: (H, W) uint8 labels, 0 where nothing is known.
        predicted_hw: The same ground, predicted.
        class_values: Classes of landmarks.
        minimum_area_px: Of landmarks that count.
    """
    known = np.where(true_hw == 0, np.uint8(0), predicted_hw)
    true, predicted = (extract_landmarks(labels, class_values, minimum_area_px) for labels in (true_hw, known))
    # One that is just too small in the other labels is not missing there.
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
    """Return (n,) the other landmark at the place and of the size of each, the nearest; -1 for none."""
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
    """Return how far apart a landmark's edges lie on average: the area between them over the length of the true one."""
    left, top, right, bottom = bounds.tolist()
    part = slice(max(top - MARGIN_PX, 0), bottom + MARGIN_PX), slice(max(left - MARGIN_PX, 0), right + MARGIN_PX)
    true, predicted = true_hw[part] == value, predicted_hw[part] == value
    sides = (true[1:] != true[:-1]).sum() + (true[:, 1:] != true[:, :-1]).sum()
    return float((true != predicted).sum() / (GRID_LENGTH * max(sides, 1)))
