"""Report of an evaluation: rates, errors, false accepts, reliability, and the two tables of the paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...core.evaluation.evaluation import MAP, MIRRORED, NOISE_LEVELS, ROTATION, SCALING
from ...core.evaluation.rates import Rate
from ...core.evaluation.summary import (
    AccuracySummary,
    MethodSummary,
    accuracy_summaries,
    error_curve,
    noise_rates,
    of_method,
    reliability,
    success_by_landmarks,
    success_by_offset,
    summarize,
)
from ...core.evaluation.trial import Trial
from ...core.localization import Status
from ..messages.numbers import count as number_text
from ..messages.numbers import shown
from ..messages.sentences import worded
from ..translation import tr
from . import charts, page, parts
from .charts import Series, rate_series


def tried_ground(windows: Rate, minimum_references: int) -> str:
    """Return a sentence for report and log about the tested part of the map."""
    if windows.successes == windows.trials:
        return tr("The images cover all {count} windows.").format(count=number_text(windows.trials))
    return tr(
        "The images cover {tried} of {count} windows ({share}): those with at least {minimum} landmarks on the label "
        "map. The rates are not valid for other windows."
    ).format(
        tried=number_text(windows.successes),
        count=number_text(windows.trials),
        share=page.percent(windows.share),
        minimum=number_text(minimum_references),
    )


@dataclass(frozen=True)
class EvaluationReport:
    """Data of the report.

    Attributes:
        methods: Titles of the methods by key, the most important one first.
        settings: (name, value) as shown.
        ground: Result of ``tried_ground``.
    """

    database: str
    labels: str
    trials: Sequence[Trial]
    methods: dict[str, str]
    settings: Sequence[tuple[str, str]]
    ground: str

    def html(self) -> str:
        summaries = [summarize(self.trials, method) for method in self.methods]
        return page.page(
            tr("Evaluation of localization"),
            tr("Database {database}, images from {labels}").format(database=self.database, labels=self.labels),
            self._key_figures(summaries[0]),
            parts.next_steps(_next(summaries)),
            page.section(tr("Comparison of methods"), self._methods_table(summaries), page.paragraph(_definitions())),
            page.section(
                tr("Success by offset and landmarks"),
                page.columns(
                    self._offset_chart(),
                    self._landmarks_table(),
                ),
            ),
            page.section(tr("Errors and noise"), page.columns(self._error_chart(), self._noise_map())),
            page.section(
                tr("Reliability of the confidence"), page.columns(self._reliability_chart(), self._statuses(summaries))
            ),
            parts.accuracy_section(self._accuracy()),
            page.section(
                tr("Scale (Table 4 of He & Wu 2025)"),
                page.paragraph(
                    tr(
                        "Windows scaled by 2 to 0.5, without noise. The published method compares vectors; a distance "
                        "above 2 is not a match."
                    )
                ),
                self._paper_table(SCALING, tr("Scale"), lambda query: shown(query.scale, ".2f")),
            ),
            page.section(
                tr("Rotation (Table 5 of He & Wu 2025)"),
                page.paragraph(tr("The same windows, rotated about their centers.")),
                self._paper_table(ROTATION, tr("Rotation"), lambda query: f"{query.view.heading_deg:.0f}°"),
            ),
            parts.settings_section(self.settings),
        )

    def _key_figures(self, first: MethodSummary) -> str:
        note = page.interval_text
        found = [
            (page.percent(first.right.share), tr("Correct positions"), note(first.right)),
            (page.percent(first.wrong.share), tr("Wrong positions"), note(first.wrong)),
            (page.percent(first.false_accepts.share), tr("False accepts"), note(first.false_accepts)),
            (page.number(first.median_error, "m"), tr("Median error"), tr("of correct positions")),
        ]
        title = tr("Method: {method}. The small numbers are 95 % intervals and counts.")
        about = f"{title.format(method=self.methods[first.method])} {self.ground}"
        return page.key_figures(found) + page.paragraph(about)

    def _methods_table(self, summaries: Sequence[MethodSummary]) -> str:
        columns = [
            (tr("Method"), lambda s: self.methods[s.method]),
            (tr("Correct positions"), lambda s: page.rate_text(s.right)),
            (tr("Wrong positions"), lambda s: page.rate_text(s.wrong)),
            (tr("False accepts"), lambda s: page.rate_text(s.false_accepts)),
            (tr("Correct likely positions"), lambda s: page.rate_text(s.likely)),
            ("CEP50", lambda s: page.number(s.median_error, "m")),
            ("CEP95", lambda s: page.number(s.error_95, "m")),
            (tr("Heading error"), lambda s: page.number(s.heading_error_deg, "°", 2)),
            (tr("Scale error"), lambda s: page.percent(s.scale_error, 2)),
            (tr("In the 95 % ellipse"), lambda s: page.rate_text(s.covered)),
        ]
        return page.records(summaries, columns)

    def _offset_chart(self) -> str:
        series = [rate_series(title, success_by_offset(self.trials, method)) for method, title in self.methods.items()]
        x_axis = charts.linear_axis(tr("Offset from the nearest window, share of the stride"), 0.5)
        y_axis = charts.percent_axis(tr("Correct positions"))
        chart = charts.line_chart(series, x_axis, y_axis, tr("Success against offset"))
        text = tr("Correct positions of shifted windows, without noise, scaling or rotation. Bands: 95 % intervals.")
        return page.figure(chart, text)

    def _landmarks_table(self) -> str:
        found = {
            title: success_by_landmarks(of_method(self.trials, method, MAP)) for method, title in self.methods.items()
        }
        caption = tr("Correct positions by the number of landmarks in the window.")
        return parts.landmarks_table(found, tr("Landmarks in the window"), caption)

    def _error_chart(self) -> str:
        curves = {method: error_curve(self.trials, method) for method in self.methods}
        errors = np.concatenate([errors for errors, _ in curves.values()])
        errors = np.maximum(errors, 0.01) if len(errors) else np.array([0.1, 10.0])
        series = [
            Series(title, *_thin(*curves[method]), marked=False, stepped=True) for method, title in self.methods.items()
        ]
        x_axis = charts.logarithmic_axis(tr("Error (m)"), errors.min(), errors.max())
        chart = charts.line_chart(series, x_axis, charts.percent_axis(tr("Images with a position")), tr("Errors"))
        return page.figure(
            chart, tr("Cumulative share of images with a position by error, correct and wrong positions.")
        )

    def _noise_map(self) -> str:
        rates = noise_rates(self.trials)
        names = [f"{level:.0f} %" for level in NOISE_LEVELS]
        cells = [[page.Shaded(page.percent(rate.share, 0), rate.share) for rate in row] for row in rates]
        header = [f"{tr('Missed landmarks')} ↓ {tr('Spurious landmarks')} →", *names]
        matrix = page.table(header, [[name, *row] for name, row in zip(names, cells)], range(1, len(header)))
        caption = tr("Correct positions of {method} with {count} images per cell. Other noise as in the settings.")
        method = next(iter(self.methods.values()))
        return page.figure(matrix, caption.format(method=method, count=rates[0][0].trials))

    def _reliability_chart(self) -> str:
        series = [rate_series(title, reliability(self.trials, method)) for method, title in self.methods.items()]
        axes = charts.percent_axis(tr("Stated confidence")), charts.percent_axis(tr("Correct positions"))
        chart = charts.line_chart(series, *axes, tr("Reliability of the confidence"), diagonal=True)
        caption = tr(
            "On the diagonal, the confidence equals the share of correct positions. Below it, the confidence is too "
            "high."
        )
        return page.figure(chart, caption)

    def _accuracy(self) -> dict[str, list[AccuracySummary]]:
        """Return summaries by method, including positions of mirrored images, which are always wrong."""
        tried = {title: of_method(self.trials, method, MAP, MIRRORED) for method, title in self.methods.items()}
        return {title: accuracy_summaries(trials) for title, trials in tried.items()}

    def _statuses(self, summaries: Sequence[MethodSummary]) -> str:
        found = [status for status in Status if any(status.key in s.statuses for s in summaries)]
        rows = [
            [worded(status.title), *(number_text(s.statuses.get(status.key, 0)) for s in summaries)] for status in found
        ]
        titles = [self.methods[s.method] for s in summaries]
        return page.paragraph(tr("Status of the images of the map:")) + page.table(
            [tr("Status"), *titles], rows, range(1, len(titles) + 1)
        )

    def _paper_table(self, part: str, title: str, value_of) -> str:
        """Return a table with a row per scale or rotation and window; for each method result, error and confidence."""
        by_method = [of_method(self.trials, method, part) for method in self.methods]
        header, numbers = [title, tr("Window")], []
        for name, trials in zip(self.methods.values(), by_method):
            added = [tr("Error"), *([tr("Distance")] if _has_distances(trials) else []), tr("Confidence")]
            numbers += range(len(header) + 1, len(header) + 1 + len(added))
            header += [name, *added]
        # By descending scale and ascending angle, as in the paper.
        order = {id(o): (-o.query.scale, o.query.view.heading_deg, n) for n, o in enumerate(by_method[0])}
        rows = [
            [value_of(same[0].query), same[0].query.window, *self._result_cells(same, by_method)]
            for same in sorted(zip(*by_method), key=lambda same: order[id(same[0])])
        ]
        return page.table(header, rows, numbers)

    def _result_cells(self, same: Sequence[Trial], by_method: Sequence[Sequence[Trial]]) -> list[str]:
        cells = []
        for one, trials in zip(same, by_method):
            result = one.result
            found = (
                page.Marked(f"{'✓' if one.is_right else '✗'} {one.window}", one.is_right)
                if one.is_fix
                else worded(result.status.title)
            )
            distance = [page.fixed(result.distance, ".3f")] if _has_distances(trials) else []
            confidence = page.fixed(result.confidence if one.is_fix else None, ".2f")
            cells += [found, page.number(one.error, "m"), *distance, confidence]
        return cells


def _next(summaries: Sequence[MethodSummary]) -> list[str]:
    first = summaries[0]
    steps = []
    if first.false_accepts.successes or first.wrong.successes:
        steps.append(tr("Some positions are wrong. Use a lower “Maximum error probability” for localization."))
    best = max(summaries, key=lambda one: one.right.share or 0.0)
    if best is not first:
        steps.append(tr("Another method found more positions. Compare the methods in the table below."))
    steps.append(tr("Run “Assess reference database” to see where on the map localization will succeed."))
    return steps


def _definitions() -> str:
    return tr(
        "A position is correct within the distance under “Settings”. With the published method, which finds only "
        "windows, it is correct if it is the window nearest to the image’s center. False accepts are positions of "
        "mirrored images, which are always wrong. Likely positions are neither correct nor wrong positions; the table "
        "shows how many of them are correct. CEP50 and CEP95: 50 % and 95 % of the correct positions have at most "
        "this error. Heading and scale: median errors of correct positions."
    )


def _has_distances(trials: Sequence[Trial]) -> bool:
    """Whether a method compares vectors."""
    return any(one.result.distance is not None for one in trials)


def _thin(x: np.ndarray, y: np.ndarray, most: int = 400) -> tuple[np.ndarray, np.ndarray]:
    """Return at most ``most`` points with the first and the last one, to keep reports small."""
    index = np.unique(np.linspace(0, len(x) - 1, min(len(x), most)).round().astype(int)) if len(x) else []
    return np.maximum(x[index], 0.01) if len(x) else x, y[index] if len(x) else y
