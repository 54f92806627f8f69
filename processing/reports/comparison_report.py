"""The report of Compare label maps: key figures, the confusion matrix as a picture, the figures of each class."""

from __future__ import annotations

import os
from dataclasses import dataclass

from ...core.labels.comparison import ClassMatch, LabelComparison
from ...core.landmarks.class_shifts import PIECE_PX
from ...core.landmarks.compared import LandmarkErrors
from ..messages.numbers import count as number_text
from ..messages.numbers import shown
from ..translation import tr
from . import page, parts
from .network_noise import LEAST_LANDMARKS, network_meta

METER, PIXEL, MAP_UNIT = "m", "px", ""


@dataclass(frozen=True)
class ShiftRow:
    """One class: its name, landmarks in both maps, shift along two axes, how exactly it is known, and its spread."""

    name: str
    pairs: int
    along: tuple[float, float]
    deviation: float
    spread: float | None


@dataclass(frozen=True)
class MeasuredShifts:
    """Of all classes with enough landmarks; ``unit``: meters where the CRS is metric, pixels without a georeference,
    where the axes are the image's (``in_image``: right, down) instead of the map's (east, north)."""

    rows: tuple[ShiftRow, ...]
    unit: str
    in_image: bool
    piece_px: int = PIECE_PX


@dataclass(frozen=True)
class MeasuredErrors:
    """Landmarks: (name, errors) of each class, of all, and what assessments are to assume, by their keys."""

    rows: tuple[tuple[str, LandmarkErrors], ...]
    total: LandmarkErrors
    numbers: dict[str, float | None]


def comparison_html(
    comparison: LabelComparison,
    match: ClassMatch,
    shifts: MeasuredShifts,
    errors: MeasuredErrors,
    reference: str,
    predicted: str,
) -> str:
    """The whole page; ``reference``, ``predicted``: paths of the maps."""
    count = tr("{count} pixels compared").format(count=number_text(comparison.pixels))
    figures = page.key_figures(
        [
            (page.percent(comparison.overall_accuracy), tr("overall accuracy"), count),
            (page.percent(comparison.mean_iou), tr("mean IoU"), tr("of the classes that are annotated")),
        ]
    )
    classes = [value for value in comparison.values if value]
    title = tr("Comparison of label maps")
    subtitle = tr("{predicted} against {reference}").format(
        predicted=os.path.basename(predicted), reference=os.path.basename(reference)
    )
    return page.page(
        title,
        subtitle,
        figures,
        parts.next_steps(_next(comparison, match, shifts, errors)),
        page.section(tr("Confusion matrix"), parts.confusion_figure(comparison, match.name, comparison.values)),
        page.section(tr("Classes"), parts.class_table(comparison, match.name, classes)),
        page.section(tr("Landmarks"), *_landmarks(errors)),
        page.section(tr("Bias of classes"), *_biases(shifts)),
        meta=network_meta(errors.numbers, errors.total.annotated),
    )


def _next(comparison: LabelComparison, match: ClassMatch, shifts: MeasuredShifts, errors: MeasuredErrors) -> list[str]:
    steps = [tr("Go through the disagreements in the dock’s tab “Correct”: either map may be wrong.")]
    values = [value for value in comparison.values if value and comparison.annotated[value]]
    if values:
        worst = min(values, key=comparison.iou)
        text = tr("The class found worst is {name} ({iou}): more of it in the training helps most.")
        steps.append(text.format(name=match.name(worst), iou=page.percent(comparison.iou(worst))))
    if shifts.rows:
        steps.append(tr("Give the network’s file as MODEL, and positions are freed of the biases below."))
    if errors.total.annotated >= LEAST_LANDMARKS:
        steps.append(
            tr("Give this page as “Comparison report” to “Assess reference database”: will such labels be found?")
        )
    return steps


def _landmarks(errors: MeasuredErrors) -> list[str]:
    """How many were missed, misnamed and invented, a class a row."""
    if not errors.rows:
        return [page.paragraph(tr("Neither map has a landmark of a size that counts."))]
    header = [tr("Class"), tr("annotated"), tr("missed"), tr("misnamed"), tr("invented")]
    rows = [
        [name, number_text(found.annotated), *_shares(found)]
        for name, found in (*errors.rows, (tr("all"), errors.total))
    ]
    text = tr(
        "A landmark is found where the prediction has one of about its place and size. Shares are of the annotated "
        "ones, counted where they lie whole in pieces of {edge} pixels; houses that the network joins are missed."
    )
    return [page.table(header, rows, range(1, len(header))), page.paragraph(text.format(edge=PIECE_PX))]


def _shares(found: LandmarkErrors) -> list[str]:
    counts = found.missed, found.misnamed, found.invented
    return [page.percent(count / found.annotated) if found.annotated else number_text(count) for count in counts]


def _biases(shifts: MeasuredShifts) -> list[str]:
    """How far off landmarks are shown, a class a row."""
    if not shifts.rows:
        return [page.paragraph(tr("Too few landmarks are whole in both maps to tell."))]
    along = [tr("right"), tr("down")] if shifts.in_image else [tr("east"), tr("north")]
    columns = [
        (tr("Class"), lambda row: row.name),
        (tr("landmarks in both"), lambda row: number_text(row.pairs)),
        (along[0], lambda row: f"{shown(row.along[0], '+.2f')} {shifts.unit}"),
        (along[1], lambda row: f"{shown(row.along[1], '+.2f')} {shifts.unit}"),
        (tr("known to"), lambda row: f"± {shown(row.deviation, '.2f')} {shifts.unit}"),
        (tr("spread"), lambda row: page.number(row.spread, shifts.unit)),
    ]
    text = tr(
        "How far from where they are the landmarks of each class are shown, over pieces of {edge} pixels: an image’s "
        "position is off as much, and no residual tells. Spread: standard deviation along each axis of what one piece "
        "differs by."
    )
    return [page.records(shifts.rows, columns, range(1, 6)), page.paragraph(text.format(edge=shifts.piece_px))]
