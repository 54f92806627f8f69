"""Parts that several reports have: what fixes are worth, success by landmarks, how well classes are found, settings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Callable

import numpy as np

from ..messages.numbers import count
from ..messages.sentences import worded
from ..translation import tr
from . import charts, page

if TYPE_CHECKING:
    from ...core.evaluation.rates import RateAt
    from ...core.evaluation.summary import RoadSummary
    from ...core.labels.comparison import LabelComparison


def next_steps(steps: Sequence[str]) -> str:
    """What to do with what the page says, a sentence each."""
    return page.next_steps(tr("What to do next"), steps)


def settings_section(settings: Sequence[tuple[str, str]]) -> str:
    """What was chosen: (what, value)."""
    return page.section(tr("Settings"), page.table([tr("Setting"), tr("Value")], settings))


def road_section(summaries: Mapping[str, Sequence[RoadSummary]]) -> str:
    """How well stated radii and confidences agree with the truth, by method; keys name sets of fixes."""
    title = tr("What radius and confidence are worth")
    roads = [one for found in summaries.values() for one in found]
    if not roads:
        return page.section(title, page.paragraph(tr("No image has a fix.")))
    of = {id(one): f"{name}: " if len(summaries) > 1 else "" for name, found in summaries.items() for one in found}
    columns = [
        (tr("Fixes by"), lambda one: of[id(one)] + worded(one.road.title)),
        (tr("right"), lambda one: page.rate_text(one.right)),
        (tr("told to be right"), lambda one: page.percent(one.told, 2)),
        (tr("calibration error"), lambda one: page.percent(one.calibration_error, 2)),
        (tr("in the 50 % ellipse"), lambda one: page.rate_text(one.held[0])),
        (tr("in the 95 % ellipse"), lambda one: page.rate_text(one.held[1])),
        (tr("in the 99 % ellipse"), lambda one: page.rate_text(one.held[2])),
        (tr("median 95 % radius"), lambda one: page.number(one.median_radius, "m")),
        (tr("median error"), lambda one: page.number(one.median_error, "m")),
    ]
    text = tr(
        "By the method that gave the fix. Told to be right: the mean confidence, which should be the share of right "
        "fixes; calibration error: how far both are apart, tenth by tenth of the confidence. Ellipses: right fixes "
        "whose true place lies in the ellipse that was told; honest ones hold 50, 95 and 99 %."
    )
    return page.section(title, page.records(roads, columns, range(1, len(columns))), page.paragraph(text))


def landmarks_chart(rates: Mapping[str, Sequence[RateAt]], x_title: str, caption: str) -> str:
    """Right fixes by the number of landmarks, a series for each name."""
    bins = sorted({(one.low, one.high) for found in rates.values() for one in found})
    groups = [f"{low:.0f}–{high - 1:.0f}" if np.isfinite(high) else f"≥ {low:.0f}" for low, high in bins]
    series = [
        charts.rate_series(title, found, [bins.index((one.low, one.high)) for one in found])
        for title, found in rates.items()
    ]
    y_axis = charts.percent_axis(tr("right fixes"))
    return page.figure(charts.bar_chart(groups, series, x_title, y_axis, tr("Success by landmarks")), caption)


def class_table(found: LabelComparison, name: Callable[[int], str], values: Sequence[int]) -> str:
    """How well the classes of these values are found."""
    columns = [
        (tr("Class"), name),
        (tr("IoU"), lambda value: page.percent(found.iou(value))),
        (tr("found"), lambda value: page.percent(found.recall(value))),
        (tr("right where predicted"), lambda value: page.percent(found.precision(value))),
        (tr("annotated pixels"), lambda value: count(int(found.annotated[value]))),
    ]
    return page.records(values, columns, range(1, len(columns)))


def confusion_figure(found: LabelComparison, name: Callable[[int], str], columns: Sequence[int]) -> str:
    """Where the annotated pixels of each class went; ``columns``: values that were predicted."""
    rows = [value for value in found.values if found.annotated[value]]
    shares = [[float(found.counts[row, column] / found.annotated[row]) for column in columns] for row in rows]
    texts = [[page.percent(share, 0) if share else "" for share in line] for line in shares]
    names = ([name(value) for value in values] for values in (rows, columns))
    chart = charts.heat_map(shares, texts, *names, tr("annotated"), tr("predicted"), tr("Confusion matrix"))
    caption = tr("Where the annotated pixels of each class went, as shares of its row; the diagonal is right.")
    return page.figure(chart, caption)
