"""Report of *Compare label maps*: key figures, confusion matrix, and tables by class."""

from __future__ import annotations

import os
from dataclasses import dataclass

from ...core.labels.comparison import ClassMatch, LabelComparison
from ...core.landmarks.class_shifts import PIECE_PX
from ...core.landmarks.compared import LandmarkErrors
from ...core.landmarks.displacement import Displacement
from ..messages.numbers import count as number_text
from ..messages.numbers import shown
from ..translation import tr
from . import page, parts
from .network_noise import LEAST_LANDMARKS, network_meta

METER, PIXEL, MAP_UNIT = "m", "px", ""


@dataclass(frozen=True)
class ShiftRow:
    """Offset of a class.

    Attributes:
        pairs: Number of landmarks in both maps.
        along: Offset along two axes.
        deviation: Standard error of the offset.
        spread: Standard deviation between pieces of the maps; None if unknown.
    """

    name: str
    pairs: int
    along: tuple[float, float]
    deviation: float
    spread: float | None


@dataclass(frozen=True)
class MeasuredShifts:
    """Offsets of all classes with enough landmarks.

    Attributes:
        unit: METER for a metric CRS, PIXEL without georeference.
        in_image: Whether the axes are right and down of the image instead of east and north.
        displacement: Of the landmarks, for two maps of the same ground; None without landmarks on both maps.
    """

    rows: tuple[ShiftRow, ...]
    unit: str
    in_image: bool
    displacement: Displacement | None = None


@dataclass(frozen=True)
class MeasuredErrors:
    """Errors of landmarks: (name, errors) of each class, the total, and the numbers for assessments by key."""

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
    """Return the page; ``reference``, ``predicted``: paths of the maps."""
    count = tr("{count} pixels compared").format(count=number_text(comparison.pixels))
    figures = page.key_figures(
        [
            (page.percent(comparison.overall_accuracy), tr("Overall accuracy"), count),
            (page.percent(comparison.mean_iou), tr("Mean IoU"), tr("of annotated classes")),
        ]
    )
    classes = [value for value in comparison.values if value]
    title = tr("Comparison of label maps")
    subtitle = tr("{predicted} compared with {reference}").format(
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
        page.section(tr("Class offsets"), *_biases(shifts)),
        page.section(tr("Map accuracy"), *_accuracy(shifts)),
        meta=network_meta(errors.numbers, errors.total.annotated),
    )


def _next(comparison: LabelComparison, match: ClassMatch, shifts: MeasuredShifts, errors: MeasuredErrors) -> list[str]:
    steps = [tr("Check the disagreements in the dock’s tab “Correct”. Either map may be wrong.")]
    values = [value for value in comparison.values if value and comparison.annotated[value]]
    if values:
        worst = min(values, key=comparison.iou)
        text = tr("The class with the lowest IoU is {name} ({iou}). Add training ground with this class first.")
        steps.append(text.format(name=match.name(worst), iou=page.percent(comparison.iou(worst))))
    if shifts.rows:
        steps.append(
            tr("Compare again with the network’s file as model, to correct positions by the class offsets below.")
        )
    if errors.total.annotated >= LEAST_LANDMARKS:
        steps.append(
            tr(
                "To assess with these label errors, choose this page as “Comparison report” in “Assess reference "
                "database”."
            )
        )
    return steps


def _landmarks(errors: MeasuredErrors) -> list[str]:
    if not errors.rows:
        return [page.paragraph(tr("Neither map has a landmark of sufficient size."))]
    header = [tr("Class"), tr("Annotated"), tr("Missed"), tr("Mislabeled"), tr("Spurious")]
    rows = [
        [name, number_text(found.annotated), *_shares(found)]
        for name, found in (*errors.rows, (tr("All classes"), errors.total))
    ]
    text = tr(
        "A landmark is found if the prediction has a landmark of similar position and size. Shares refer to the "
        "annotated landmarks that are completely inside a piece of {edge} pixels. Buildings that the network merges "
        "count as missed."
    )
    return [page.table(header, rows, range(1, len(header))), page.paragraph(text.format(edge=PIECE_PX))]


def _shares(found: LandmarkErrors) -> list[str]:
    counts = found.missed, found.misnamed, found.invented
    return [page.percent(count / found.annotated) if found.annotated else number_text(count) for count in counts]


def _biases(shifts: MeasuredShifts) -> list[str]:
    if not shifts.rows:
        return [page.paragraph(tr("The maps have too few common landmarks to measure offsets."))]
    along = [tr("Right"), tr("Down")] if shifts.in_image else [tr("East"), tr("North")]
    columns = [
        (tr("Class"), lambda row: row.name),
        (tr("Landmarks in both maps"), lambda row: number_text(row.pairs)),
        (along[0], lambda row: f"{shown(row.along[0], '+.2f')} {shifts.unit}"),
        (along[1], lambda row: f"{shown(row.along[1], '+.2f')} {shifts.unit}"),
        (tr("Standard error"), lambda row: f"± {shown(row.deviation, '.2f')} {shifts.unit}"),
        (tr("Standard deviation"), lambda row: page.number(row.spread, shifts.unit)),
    ]
    text = tr(
        "Mean offset of the predicted landmarks from the annotated ones, measured in pieces of {edge} pixels. It "
        "shifts the position of an image by the same amount, and residuals do not show it. Standard deviation: "
        "variation between pieces along each axis."
    )
    return [page.records(shifts.rows, columns, range(1, 6)), page.paragraph(text.format(edge=PIECE_PX))]


def _accuracy(shifts: MeasuredShifts) -> list[str]:
    found = shifts.displacement
    if found is None:
        return []
    text = tr(
        "{count} landmarks are on both maps; {moved} of them moved. The standard deviation of the positions along each "
        "axis is {deviation}, for the moved landmarks {of_moved}. If the maps show two dates, use {deviation} as map "
        "accuracy in “Build reference database”."
    ).format(
        count=number_text(found.pairs),
        moved=page.percent(found.moved, 0),
        deviation=page.number(found.deviation, shifts.unit, 2),
        of_moved=page.number(found.moved_deviation, shifts.unit, 2),
    )
    if not found.correlations:
        return [page.paragraph(text)]
    rows = [[f"{near:g}–{far:g} {shifts.unit}", shown(share, ".2f")] for near, far, share in found.correlations]
    header = [tr("Distance of two moved landmarks"), tr("Correlation of their displacements")]
    return [page.paragraph(text), page.table(header, rows, (1,))]
