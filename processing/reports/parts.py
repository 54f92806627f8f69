"""Common parts of reports: next steps, quality of positions, success by landmarks, classes, settings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Callable

import numpy as np

from ...core.evaluation.rates import Rate, RateAt
from ..messages.numbers import count
from ..messages.sentences import worded
from ..translation import tr
from . import page

if TYPE_CHECKING:
    from ...core.evaluation.summary import AccuracySummary
    from ...core.labels.comparison import LabelComparison


def next_steps(steps: Sequence[str]) -> str:
    """Return a box with one sentence for each step; empty without steps."""
    return page.macros().next_steps(tr("Next steps"), steps) if steps else ""


def settings_section(settings: Sequence[tuple[str, str]]) -> str:
    """Return the table of the settings: (name, value)."""
    return page.section(tr("Settings"), page.table([tr("Setting"), tr("Value")], settings))


def accuracy_section(summaries: Mapping[str, Sequence[AccuracySummary]]) -> str:
    """Return the comparison of stated radii and confidences with the truth; keys name sets of positions."""
    title = tr("Accuracy of radius and confidence")
    listed = [one for found in summaries.values() for one in found]
    if not listed:
        return page.section(title, page.paragraph(tr("No image has a position.")))
    of = {id(one): f"{name}: " if len(summaries) > 1 else "" for name, found in summaries.items() for one in found}
    columns = [
        (tr("Position by"), lambda one: of[id(one)] + worded(one.method.title)),
        (tr("Correct positions"), lambda one: page.rate_text(one.right)),
        (tr("Mean confidence"), lambda one: page.percent(one.confidence, 2)),
        (tr("Calibration error"), lambda one: page.percent(one.calibration_error, 2)),
        (tr("In the 50 % ellipse"), lambda one: page.rate_text(one.contained[0])),
        (tr("In the 95 % ellipse"), lambda one: page.rate_text(one.contained[1])),
        (tr("In the 99 % ellipse"), lambda one: page.rate_text(one.contained[2])),
        (tr("Median 95 % radius"), lambda one: page.number(one.median_radius, "m")),
        (tr("Median error"), lambda one: page.number(one.median_error, "m")),
    ]
    text = tr(
        "The mean confidence should equal the share of correct positions. Calibration error: difference between both "
        "in ten intervals of the confidence. Ellipses: share of correct positions with the true position inside the "
        "ellipse, which should be 50, 95 and 99 %."
    )
    return page.section(title, page.records(listed, columns, range(1, len(columns))), page.paragraph(text))


def landmarks_table(rates: Mapping[str, Sequence[RateAt]], title: str, caption: str) -> str:
    """Return a table of correct positions by the number of landmarks, with a column for each name."""
    bins = sorted({(one.low, one.high) for found in rates.values() for one in found})
    columns = [{(one.low, one.high): one.rate for one in found} for found in rates.values()]
    rows = []
    for low, high in bins:
        cells = [column.get((low, high), Rate(0, 0)) for column in columns]
        name = f"{low:.0f}–{high - 1:.0f}" if np.isfinite(high) else f"≥ {low:.0f}"
        rows.append([name, *(page.Shaded(page.rate_text(rate), rate.share) for rate in cells)])
    return page.figure(page.table([title, *rates], rows, range(1, len(rates) + 1)), caption)


def class_table(found: LabelComparison, name: Callable[[int], str], values: Sequence[int]) -> str:
    """Return a table with the quality of the classes with these values."""
    columns = [
        (tr("Class"), name),
        (tr("IoU"), lambda value: page.percent(found.iou(value))),
        (tr("Recall"), lambda value: page.percent(found.recall(value))),
        (tr("Precision"), lambda value: page.percent(found.precision(value))),
        (tr("Annotated pixels"), lambda value: count(int(found.annotated[value]))),
    ]
    return page.records(values, columns, range(1, len(columns)))


def confusion_figure(found: LabelComparison, name: Callable[[int], str], columns: Sequence[int]) -> str:
    """Return the confusion matrix; ``columns``: predicted values."""
    rows = [value for value in found.values if found.annotated[value]]
    shares = [[float(found.counts[row, column] / found.annotated[row]) for column in columns] for row in rows]
    cells = [[page.Shaded(page.percent(share, 0) if share else "", share) for share in line] for line in shares]
    header = [f"{tr('Annotated')} ↓ {tr('Predicted')} →", *map(name, columns)]
    matrix = page.table(header, [[name(row), *line] for row, line in zip(rows, cells)], range(1, len(header)))
    caption = tr("Share of the annotated pixels of each class (row) by predicted class. The diagonal is correct.")
    return page.figure(matrix, caption)
