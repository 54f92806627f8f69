"""How poor a network's landmarks are: counted in a comparison, as numbers that assessments take."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ...core.landmarks.class_shifts import LEAST_AREA_PX, PIECE_PX
from ...core.landmarks.compared import LandmarkErrors, piece_errors
from ..reports.comparison_report import PIXEL, MeasuredErrors, MeasuredShifts
from . import parameters
from .base import check_canceled

if TYPE_CHECKING:
    from collections.abc import Sequence

    from qgis.core import QgsProcessingFeedback

    from ...core.labels.comparison import ClassMatch, LabelComparison
    from ...storage.comparing import LabelMapPair

MOST_PERCENT = 100.0


def measured_errors(
    pair: LabelMapPair,
    match: ClassMatch,
    comparison: LabelComparison,
    shifts: MeasuredShifts,
    minimum_area: float,
    feedback: QgsProcessingFeedback,
) -> MeasuredErrors:
    """Errors of the classes of landmarks – all classes where none is said to be –; raises Canceled.

    ``minimum_area``: of landmarks that count, in square map units, pixels without a georeference.
    """
    classes = _landmark_classes(match, comparison)
    _, across, x_turn, _, y_turn, along = pair.geotransform
    size = math.sqrt(abs(across * along - x_turn * y_turn))
    area_px = max(minimum_area / size**2, LEAST_AREA_PX)
    errors = {value: LandmarkErrors() for value in classes}
    for share, annotated, predicted in pair.pieces(PIECE_PX):
        check_canceled(feedback)
        for value, found in piece_errors(annotated, match.values[predicted], classes, area_px).items():
            errors[value] += found
        feedback.setProgress(97.5 + 1.5 * share)
    total = sum(errors.values(), LandmarkErrors())
    numbers = _numbers(total, comparison, classes, shifts, size)
    rows = tuple((match.name(value), found) for value, found in errors.items() if found.annotated or found.invented)
    return MeasuredErrors(rows, total, numbers)


def _landmark_classes(match: ClassMatch, comparison: LabelComparison) -> list[int]:
    """Values of the annotated classes that landmarks are made of."""
    told = () if match.table is None else match.table.reference_values
    there = [value for value in comparison.values if value and comparison.annotated[value]]
    return [value for value in there if value in told] or there


def _numbers(
    errors: LandmarkErrors, comparison: LabelComparison, classes: Sequence[int], shifts: MeasuredShifts, size: float
) -> dict[str, float | None]:
    """By key of assessments: percent and map units; None for what the maps don't tell."""
    of = max(errors.annotated, 1)
    shifted = _shifted(shifts)
    ragged = errors.ragged_px((shifted or 0.0) / size) if shifts.unit != PIXEL else None
    return {
        parameters.MISSED: 100 * errors.missed / of,
        parameters.INVENTED: min(100 * errors.invented / of, MOST_PERCENT),
        parameters.MISNAMED: 100 * errors.misnamed / of,
        parameters.RAGGED: None if ragged is None else size * ragged,
        parameters.BACKGROUND: _misnamed_background(comparison, classes),
        parameters.SHIFTED: shifted,
    }


def _misnamed_background(comparison: LabelComparison, classes: Sequence[int]) -> float | None:
    """Percent of the ground of other classes that is shown as another of these; None where there is none."""
    others = [value for value in comparison.values if value and value not in classes]
    counts = comparison.counts[np.ix_(others, others)]
    return 100 * float(1 - np.trace(counts) / counts.sum()) if counts.sum() else None


def _shifted(shifts: MeasuredShifts) -> float | None:
    """How far off an image shows a class: root mean square over landmarks, of the bias and what images differ by."""
    if shifts.unit == PIXEL or not shifts.rows:
        return None
    squares = [row.along[0] ** 2 + row.along[1] ** 2 + 2 * (row.spread or 0.0) ** 2 for row in shifts.rows]
    return float(np.sqrt(np.average(squares, weights=[row.pairs for row in shifts.rows])))
