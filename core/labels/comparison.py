"""Agreement of a predicted label map with a reference: confusion matrix, IoU, accuracy."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from ..errors import LabelMapError
from .class_table import MAXIMUM_VALUE, UNLABELED, ClassTable

_EXACT = 1 << 24
"""OpenCV's histogram counts in single precision, which is exact up to this."""

_VALUES = MAXIMUM_VALUE + 1


@dataclass(frozen=True)
class ClassMatch:
    """Which predicted class corresponds to which annotated one.

    ``values``: (256,) uint8: predicted value → value in ``table``. ``table``: the classes of both maps, None if
    neither map names any. ``by_name``: False if classes with the same value correspond. ``only_predicted``: names of
    classes that the annotated map lacks.
    """

    values: np.ndarray
    table: ClassTable | None
    by_name: bool
    only_predicted: tuple[str, ...] = ()

    def name(self, value: int) -> str:
        """Return the class's name; “unlabeled” for 0, the number for a class without a name."""
        found = None if self.table is None else self.table.by_value(value)
        return found.name if found else ("unlabeled" if value == UNLABELED else str(value))


def match_classes(annotated: ClassTable | None, predicted: ClassTable | None) -> ClassMatch:
    """Match by name (ignoring case) if both maps name their classes and share a name, otherwise by value.

    By name, predicted classes that the annotated map lacks keep their value if it is free, or get a free one. Predicted
    values without a class become 0.
    """
    same = np.arange(_VALUES, dtype=np.uint8)
    if annotated is None or predicted is None:
        return ClassMatch(same, annotated or predicted, False)
    known = {c.name.casefold(): c.value for c in annotated}
    extra = [c for c in predicted if c.name.casefold() not in known and c.value != UNLABELED]
    only = tuple(c.name for c in extra)
    if not any(c.name.casefold() in known for c in predicted):
        taken = {c.value for c in annotated}
        more = tuple(c for c in extra if c.value not in taken)
        return ClassMatch(same, ClassTable((*annotated, *more)), False, only)
    values = np.zeros(_VALUES, np.uint8)
    for c in predicted:
        values[c.value] = known.get(c.name.casefold(), UNLABELED)
    free = sorted(set(range(1, _VALUES)) - {c.value for c in annotated})
    added = []
    for c in extra:
        value = c.value if c.value in free else free[0]
        free.remove(value)
        values[c.value] = value
        added.append(replace(c, value=value))
    return ClassMatch(values, ClassTable((*annotated, *added)), True, only)


@dataclass(frozen=True)
class LabelComparison:
    """A confusion matrix.

    Pixels without annotation (0) are ignored; pixels without prediction count as wrong.

    Attributes:
        counts: (256, 256) int64 pixels, annotated values down, predicted values across.

    Raises:
        LabelMapError: No pixel can be compared.
    """

    counts: np.ndarray

    def __post_init__(self) -> None:
        """Ignore pixels without annotation."""
        counts = np.array(self.counts, np.int64)
        counts[UNLABELED] = 0
        object.__setattr__(self, "counts", counts)
        if not self.pixels:
            raise LabelMapError(
                "Where the maps overlap, the reference map has no labels; choose maps of the same ground."
            )

    @property
    def pixels(self) -> int:
        """Pixels that the annotation labels."""
        return int(self.counts.sum())

    @property
    def overall_accuracy(self) -> float:
        """Share of the pixels that have the annotated class."""
        return float(np.trace(self.counts) / self.pixels)

    @property
    def annotated(self) -> np.ndarray:
        """(256,) int64 annotated pixels of each class."""
        return self.counts.sum(axis=1)

    @property
    def predicted(self) -> np.ndarray:
        """(256,) int64 predicted pixels of each class."""
        return self.counts.sum(axis=0)

    @property
    def values(self) -> tuple[int, ...]:
        """Values that occur in either map, ascending."""
        return tuple(int(v) for v in np.flatnonzero(self.annotated + self.predicted))

    def iou(self, value: int) -> float:
        """Return intersection over union of a class that occurs: |both| / |either|."""
        both = self.counts[value, value]
        return float(both / (self.annotated[value] + self.predicted[value] - both))

    def recall(self, value: int) -> float | None:
        """Return the share of a class's annotated pixels that have it as prediction (producer's accuracy)."""
        return _share(self.counts[value, value], self.annotated[value])

    def precision(self, value: int) -> float | None:
        """Return the share of a class's predicted pixels that have it as annotation (user's accuracy)."""
        return _share(self.counts[value, value], self.predicted[value])

    @property
    def mean_iou(self) -> float:
        """Mean IoU of the classes that are annotated."""
        return float(np.mean([self.iou(int(value)) for value in np.flatnonzero(self.annotated)]))


def _share(part: int, whole: int) -> float | None:
    return float(part / whole) if whole else None


def count_pairs(annotated_hw: np.ndarray, predicted_hw: np.ndarray) -> np.ndarray:
    """Return (256, 256) int64 pixels of each pair of annotated (down) and predicted value of two (H, W) uint8 maps."""
    first, second = (np.ascontiguousarray(labels).reshape(-1, 1) for labels in (annotated_hw, predicted_hw))
    counts = np.zeros((_VALUES, _VALUES), np.int64)
    for start in range(0, len(first), _EXACT):
        parts = [first[start : start + _EXACT], second[start : start + _EXACT]]
        counts += cv2.calcHist(parts, [0, 1], None, [_VALUES] * 2, [0, _VALUES] * 2).astype(np.int64)
    return counts


def disagreement_codes(annotated_hw: np.ndarray, predicted_hw: np.ndarray) -> np.ndarray:
    """Return (H, W) uint16: 256 · annotated + predicted value where the maps disagree; 0 elsewhere and unannotated."""
    codes = annotated_hw.astype(np.uint16) * _VALUES + predicted_hw
    codes[(annotated_hw == predicted_hw) | (annotated_hw == UNLABELED)] = 0
    return codes


def decode_disagreement(code: int) -> tuple[int, int]:
    """Return the (annotated, predicted) value for a code of ``disagreement_codes``."""
    return divmod(code, _VALUES)
