"""Landmark errors and class offsets that a comparison of label maps measures."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingFeedback

from ...core.errors import ModelError, ParameterError
from ...core.geometry.error_settings import ClassBias
from ...core.labels.comparison import ClassMatch, LabelComparison
from ...core.landmarks.class_shifts import LEAST_AREA_PX, PIECE_PX, ClassShift, class_shifts, piece_shifts
from ...core.landmarks.compared import LandmarkErrors, piece_errors
from ...core.landmarks.displacement import displacement_of
from ...core.segmentation.class_bias import KEY, class_bias_text, read_class_bias
from ...core.segmentation.metadata import named_channels
from ...core.segmentation.onnx_file import no_model_file, no_onnx_model, read_header, with_metadata
from ..base import parameters
from ..base.algorithm import check_canceled
from ..compat import is_metric
from ..reports.comparison_report import MAP_UNIT, METER, PIXEL, MeasuredErrors, MeasuredShifts, ShiftRow
from ..translation import tr

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...storage.label_comparison import LabelMapPair


MOST_PERCENT = 100.0


def measure_errors(
    pair: LabelMapPair,
    match: ClassMatch,
    comparison: LabelComparison,
    shifts: MeasuredShifts,
    minimum_area: float,
    feedback: QgsProcessingFeedback,
) -> MeasuredErrors:
    """Return the errors of the landmark classes, or of all classes without roles. Raises Canceled.

    ``minimum_area``: smallest landmark that counts, in square map units (square pixels without a georeference).
    """
    classes = _landmark_classes(match, comparison)
    size = pair.pixel_size
    area_px = max(minimum_area / size**2, LEAST_AREA_PX)
    errors = {value: LandmarkErrors() for value in classes}
    for share, _, annotated, predicted in pair.pieces(PIECE_PX):
        check_canceled(feedback)
        for value, found in piece_errors(annotated, match.values[predicted], classes, area_px).items():
            errors[value] += found
        feedback.setProgress(97.5 + 1.5 * share)
    total = sum(errors.values(), LandmarkErrors())
    numbers = _numbers(total, comparison, classes, shifts, size)
    rows = tuple((match.name(value), found) for value, found in errors.items() if found.annotated or found.invented)
    return MeasuredErrors(rows, total, numbers)


def _landmark_classes(match: ClassMatch, comparison: LabelComparison) -> list[int]:
    references = () if match.table is None else match.table.reference_values
    there = [value for value in comparison.values if value and comparison.annotated[value]]
    return [value for value in there if value in references] or there


def _numbers(
    errors: LandmarkErrors, comparison: LabelComparison, classes: Sequence[int], shifts: MeasuredShifts, size: float
) -> dict[str, float | None]:
    """Return the errors by key of assessments, in percent and map units; None for what the maps do not show."""
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
    """Return the percentage of background that is shown as another background class; None without background."""
    others = [value for value in comparison.values if value and value not in classes]
    counts = comparison.counts[np.ix_(others, others)]
    return 100 * float(1 - np.trace(counts) / counts.sum()) if counts.sum() else None


def _shifted(shifts: MeasuredShifts) -> float | None:
    """Return the class offset: root mean square over landmarks, of the mean offset and of its spread among images."""
    if shifts.unit == PIXEL or not shifts.rows:
        return None
    squares = [row.along[0] ** 2 + row.along[1] ** 2 + 2 * (row.spread or 0.0) ** 2 for row in shifts.rows]
    return float(np.sqrt(np.average(squares, weights=[row.pairs for row in shifts.rows])))


def measure_shifts(
    pair: LabelMapPair,
    match: ClassMatch,
    comparison: LabelComparison,
    crs: QgsCoordinateReferenceSystem,
    feedback: QgsProcessingFeedback,
) -> MeasuredShifts:
    """Return the offsets of the classes that both maps have. Raises Canceled."""
    values = [value for value in comparison.values if value and comparison.counts[value, value]]
    pieces = []
    for share, corner, annotated, predicted in pair.pieces(PIECE_PX):
        check_canceled(feedback)
        pieces += piece_shifts(annotated, match.values[predicted], values, corner)
        feedback.setProgress(96 + 1.5 * share)
    has_ground = pair.reference.dataset.GetGeoTransform(can_return_null=True) is not None
    rows = tuple(_row(shift, match.name(shift.value), pair.geotransform, has_ground) for shift in class_shifts(pieces))
    unit = PIXEL if not has_ground else METER if is_metric(crs) else MAP_UNIT
    landmarks = _landmark_classes(match, comparison)
    displacement = displacement_of([one for one in pieces if one.value in landmarks], pair.pixel_size)
    return MeasuredShifts(rows, unit, not has_ground, displacement)


def log_shifts(shifts: MeasuredShifts, feedback: QgsProcessingFeedback) -> None:
    for row in shifts.rows:
        text = tr("{name}: class offset {across:+.2f}, {along:+.2f} {unit} ({axes}), {count} landmarks.")
        axes = tr("right, down") if shifts.in_image else tr("east, north")
        across, along = row.along
        numbers = {"across": across, "along": along, "count": row.pairs}
        feedback.pushInfo(text.format(name=row.name, unit=shifts.unit, axes=axes, **numbers))
    found = shifts.displacement
    if found is not None:
        text = tr(
            "{count} landmarks are on both maps. {moved:.0%} of them moved. Standard deviation of the positions along "
            "each axis: {deviation:.2f} {unit}. If the maps show two dates, use this value as map accuracy."
        )
        numbers = {"count": found.pairs, "moved": found.moved, "deviation": found.deviation}
        feedback.pushInfo(text.format(unit=shifts.unit, **numbers))


def model_with_biases(path: str, shifts: MeasuredShifts, sun_deg: float | None) -> bytes:
    """Return an ONNX file with the offsets of the classes that it has; other offsets in it stay.

    Raises SemRefError if the offsets are not known in meters, the file is not a network, or it has several parts.
    """
    if shifts.unit != METER:
        raise ParameterError(
            "The CRS of the maps has no meters, so the class offset in meters is unknown. Select maps in a projected "
            "CRS with meters, or leave “Model with class offset” empty."
        )
    if not os.path.isfile(path):
        raise ModelError(no_model_file(path))
    data = Path(path).read_bytes()
    header = read_header(data)
    if header is None:
        raise ModelError(no_onnx_model(path))
    if header.weight_files:
        raise ModelError(
            "The weights of {path} are in another file, so it cannot be copied with its class offset. Export it as "
            "one file.",
            path=path,
        )
    names = named_channels(header.texts, path)
    known = None if names is None else {name.casefold() for name in names}
    rows = [row for row in shifts.rows if known is None or row.name.casefold() in known]
    if not rows:
        raise ParameterError(
            "No class of {path} has enough landmarks in both maps to measure its offset. Select maps of a larger "
            "area, or leave “Model with class offset” empty.",
            path=path,
        )
    biases = read_class_bias(header.texts, names, path)
    for row in rows:
        bias = ClassBias(0, *row.along, spread=row.spread)
        biases[row.name.casefold()] = replace(bias, sun_deg=sun_deg)
    return with_metadata(data, KEY, class_bias_text(biases))


def _row(shift: ClassShift, name: str, transform: tuple, has_ground: bool) -> ShiftRow:
    """Convert pixels to map units; without a georeference they stay pixels."""
    right, down = shift.shift.real, shift.shift.imag
    if not has_ground:
        return ShiftRow(name, shift.pairs, (right, down), shift.deviation, shift.spread)
    _, across, x_turn, _, y_turn, along = transform
    size = abs(across * along - x_turn * y_turn) ** 0.5
    spread = None if shift.spread is None else size * shift.spread
    east, north = across * right + x_turn * down, y_turn * right + along * down
    return ShiftRow(name, shift.pairs, (east, north), size * shift.deviation, spread)
