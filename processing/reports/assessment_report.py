"""Report of an assessment: map, success by footprint width, reasons of failures, landmarks, assumptions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...core.assessment.assessment import WRONG, Estimates
from ...core.assessment.cells import Cells
from ...core.assessment.model import SuccessModel
from ...core.database.model import ReferenceDatabase
from ...core.evaluation.rates import rate_of
from ...core.evaluation.summary import (
    IN_VIEW_BINS,
    AccuracySummary,
    accuracy_summaries,
    brier_score,
    calibration,
    success_by_landmarks,
)
from ...core.evaluation.trial import Trial
from ...core.localization import Status
from ...core.simulation.conditions import Conditions
from ..layers.class_styles import success_classes
from ..messages.numbers import Local, shown
from ..messages.numbers import count as number_text
from ..translation import tr
from . import charts, page, parts
from .charts import rate_series
from .maps import cell_map, success_legend

ENOUGH_GROUND = 0.8
"""If a smaller share of the map reaches the threshold, the report suggests improvements."""


@dataclass(frozen=True)
class AssessedFootprint:
    """Estimates for a footprint width and their trials; ``correlated``: trials of map correlation by number."""

    footprint: float
    estimates: Estimates
    trials: Sequence[Trial]
    correlated: dict[int, Trial]
    model: SuccessModel

    def title(self) -> str:
        return tr("Footprint {footprint:g} m").format(footprint=Local(self.footprint))


@dataclass(frozen=True)
class AssessmentReport:
    """Data of the report; ``settings``: (name, value) as shown."""

    database: ReferenceDatabase
    cells: Cells
    results: Sequence[AssessedFootprint]
    conditions: Conditions
    threshold: float
    correlation: bool
    settings: Sequence[tuple[str, str]]

    def html(self, name: str) -> str:
        """Return the page; ``name``: name of the database."""
        return page.page(
            tr("Assessment of a reference database"),
            name,
            self._key_figures(self.results[0]),
            parts.next_steps(self._next()),
            page.paragraph(assumptions(self.conditions, self.correlation)),
            page.section(tr("Map of expected success"), *self._maps()),
            page.section(tr("Results by footprint width"), self._footprints(), self._landmarks_table()),
            page.section(tr("Reasons for failures"), self._reasons()),
            page.section(tr("Landmarks"), self._landmarks()),
            parts.accuracy_section(self._accuracy()),
            page.section(tr("Validation of expected success"), *trust(self.results)),
            parts.settings_section(self.settings),
        )

    def _key_figures(self, first: AssessedFootprint) -> str:
        success = first.estimates.success
        wrong = rate_of(trial.is_wrong for trial in first.trials)
        at_least = tr("expected success {threshold} or more").format(threshold=page.percent(self.threshold, 0))
        return page.key_figures(
            [
                (page.percent(float((success >= self.threshold).mean())), tr("Localizable area"), at_least),
                (page.percent(float(success.mean())), tr("Expected success"), tr("mean of the map")),
                (
                    page.number(_median(first.estimates.error), "m"),
                    tr("Expected error"),
                    tr("median of correct positions"),
                ),
                (page.percent(wrong.share), tr("Wrong positions in the simulation"), page.interval_text(wrong)),
            ]
        ) + (page.paragraph(first.title() + ".") if len(self.results) > 1 else "")

    def _next(self) -> list[str]:
        good = float((self.results[0].estimates.success >= self.threshold).mean())
        steps = [tr("Plan routes over bright squares, and check them with “Assess route”.")] if good else []
        if good < ENOUGH_GROUND:
            steps.append(
                tr(
                    "Dark squares need more landmarks in view: use a larger footprint (fly higher), a smaller minimum "
                    "area, or more reference classes in “Build reference database”."
                )
            )
        steps.append(
            tr(
                "Test with images of another date in “Evaluate localization”. If the assumed noise is too low, the "
                "expected success is too high."
            )
        )
        return steps

    def _maps(self) -> list[str]:
        classes = success_classes(self.threshold)
        maps = [
            page.figure(
                cell_map(self.cells.columns, self.cells.rows, r.estimates.success, classes, r.title()),
                tr("{footprint}: expected success. Each square is {size:g} m wide. North is up.").format(
                    footprint=r.title(), size=Local(self.cells.size)
                ),
            )
            for r in self.results
        ]
        return [success_legend(classes), *maps]

    def _footprints(self) -> str:
        columns = [
            (tr("Footprint (m)"), lambda r: shown(r.footprint, "g")),
            (tr("Localizable area"), lambda r: page.percent(float((r.estimates.success >= self.threshold).mean()))),
            (tr("Expected success"), lambda r: page.percent(float(r.estimates.success.mean()))),
            (tr("Expected error"), lambda r: page.number(_median(r.estimates.error), "m")),
            (tr("Landmarks in view"), lambda r: _middle(r.estimates.landmarks)),
            (tr("Correct in the simulation"), lambda r: page.rate_text(rate_of(trial.is_right for trial in r.trials))),
            (tr("Wrong in the simulation"), lambda r: page.rate_text(rate_of(trial.is_wrong for trial in r.trials))),
        ]
        note = tr(
            "Landmarks in view: median, and in brackets the range from the 10th to the 90th percentile of the map."
        )
        return page.records(self.results, columns) + page.paragraph(note)

    def _landmarks_table(self) -> str:
        found = {r.title(): success_by_landmarks(r.trials, IN_VIEW_BINS) for r in self.results}
        caption = tr("Correct positions by the number of map landmarks that are completely in view.")
        return parts.landmarks_table(found, tr("Landmarks in view"), caption)

    def _reasons(self) -> str:
        # Without failed images nearby, the expectation is from similar places.
        titles = {"": tr("no failed image nearby; estimated from similar places"), **reason_titles()}
        rows = []
        for r in self.results:
            poor = np.flatnonzero(r.estimates.success < self.threshold)
            counts = Counter(r.estimates.reasons[n] for n in poor.tolist())
            rows += [
                [r.title(), titles[reason], page.percent(count / len(r.estimates.success))]
                for reason, count in counts.most_common()
            ]
        text = tr("Most frequent reason for no correct position in squares with an expected success below {threshold}:")
        if not rows:
            return page.paragraph(tr("Expected success reaches the threshold everywhere."))
        return page.paragraph(text.format(threshold=page.percent(self.threshold, 0))) + page.table(
            [tr("Footprint"), tr("Reason"), tr("Share of the map")], rows, [2]
        )

    def _accuracy(self) -> dict[str, list[AccuracySummary]]:
        return {r.title(): accuracy_summaries([*r.trials, *r.correlated.values()]) for r in self.results}

    def _landmarks(self) -> str:
        references = self.database.references
        areas = {c: references.areas_m2[references.classes == c.value] for c in self.database.class_table.references}
        columns = [
            (tr("Class"), lambda c: c.name),
            (tr("Landmarks"), lambda c: number_text(len(areas[c]))),
            (tr("Share"), lambda c: page.percent(len(areas[c]) / len(references))),
            (tr("Median area"), lambda c: page.number(_median(areas[c]), "m²")),
        ]
        return page.records(areas, columns, [1, 2, 3])


def trust(results: Sequence[AssessedFootprint]) -> list[str]:
    """Return the chart of expected against simulated success; each image is predicted from all others."""
    series, scores = [], []
    for r in results:
        right = r.model.successes > 0
        series.append(rate_series(r.title(), calibration(r.model.left_out, right)))
        scores.append(page.number(brier_score(r.model.left_out, right)))
    axes = charts.percent_axis(tr("Expected success")), charts.percent_axis(tr("Correct positions"))
    chart = charts.line_chart(series, *axes, tr("Expected and simulated success"), diagonal=True)
    text = tr(
        "The success of each simulated image is predicted from all other images. On the diagonal, expected and "
        "simulated success are equal. Brier score (0 is best; a constant prediction of 50 % has 0.25): {scores}. This "
        "validates the expected success with simulated images. It does not validate the assumed noise."
    )
    return [page.figure(chart, text.format(scores="; ".join(scores)))]


def assumptions(conditions: Conditions, correlation: bool) -> str:
    noise = conditions.noise
    text = tr(
        "Assumptions: {missed} missed, {spurious} spurious and {mislabeled} mislabeled landmarks. {background} of the "
        "background is mislabeled. Standard deviations: boundary jitter {jitter:g} m, map displacement {displaced:g} m "
        "per axis (similar for neighbors). Class offset {shifted:g} m in any direction, building lean {leaning}, lens "
        "distortion {lens}, camera tilt {tilt:g}°. Any heading, no prior position. A position is correct if its error "
        "is at most 2 % of the footprint width. Method: {method}."
    )
    method = tr("Constellation, then Map correlation") if correlation else tr("Constellation only")
    return text.format(
        missed=page.percent(noise.missed, 0),
        spurious=page.percent(noise.spurious, 0),
        mislabeled=page.percent(noise.mislabeled, 0),
        background=page.percent(noise.background, 0),
        jitter=Local(noise.jitter),
        displaced=Local(noise.displaced),
        shifted=Local(conditions.class_shift),
        leaning=page.percent(noise.leaning),
        lens=page.percent(conditions.lens),
        tilt=Local(conditions.tilt_deg),
        method=method,
    )


def reason_titles() -> dict[str, str]:
    """Return titles of reasons by status, and of wrong positions."""
    return {
        Status.TOO_FEW_REFERENCES.key: tr("too few landmarks"),
        Status.AMBIGUOUS.key: tr("similar places"),
        Status.NO_MATCH.key: tr("too little evidence"),
        WRONG: tr("wrong position"),
    }


def _middle(landmarks: np.ndarray) -> str:
    """Return the median, and in brackets the 10th and 90th percentile."""
    low, median, high = np.percentile(landmarks, (10, 50, 90))
    return f"{median:.0f} ({low:.0f}{page.DASH}{high:.0f})"


def _median(errors: np.ndarray):
    """Return the median of finite errors; None without any."""
    known = errors[np.isfinite(errors)]
    return float(np.median(known)) if len(known) else None
