"""The report of an assessment: the map, success by footprint, why it fails, landmarks, and what was assumed."""

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
    RoadSummary,
    brier_score,
    calibration,
    road_summaries,
    success_by_landmarks,
)
from ...core.evaluation.trial import Trial
from ...core.localization import Status
from ...core.simulation.conditions import Conditions
from ..layers.assessment_styles import success_classes
from ..messages.numbers import Local, shown
from ..messages.numbers import count as number_text
from ..translation import tr
from . import charts, page, parts
from .charts import rate_series
from .maps import cell_map, success_legend

ENOUGH_GROUND = 0.8
"""Share of the ground that is good enough, below which the report says what helps."""


@dataclass(frozen=True)
class AssessedFootprint:
    """A footprint's estimates, and the trials that they come from; correlated: those of map correlation, by number."""

    footprint: float
    estimates: Estimates
    trials: Sequence[Trial]
    correlated: dict[int, Trial]
    model: SuccessModel

    def title(self) -> str:
        return tr("Footprint {footprint:g}").format(footprint=Local(self.footprint))


@dataclass(frozen=True)
class AssessmentReport:
    """What the report is made from; settings: (what, value) as they are shown."""

    database: ReferenceDatabase
    cells: Cells
    results: Sequence[AssessedFootprint]
    conditions: Conditions
    threshold: float
    correlation: bool
    settings: Sequence[tuple[str, str]]

    def html(self, name: str) -> str:
        """The whole page; ``name``: the database's."""
        return page.page(
            tr("Assessment of a reference database"),
            name,
            self._key_figures(self.results[0]),
            parts.next_steps(self._next()),
            page.paragraph(assumed(self.conditions, self.correlation)),
            page.section(tr("Where it will localize"), *self._maps()),
            page.section(tr("By footprint"), self._footprints(), self._landmarks_chart()),
            page.section(tr("Why it fails"), self._reasons()),
            page.section(tr("Landmarks"), self._landmarks()),
            parts.road_section(self._roads()),
            page.section(tr("How far this can be trusted"), *trust(self.results)),
            parts.settings_section(self.settings),
        )

    def _key_figures(self, first: AssessedFootprint) -> str:
        success = first.estimates.success
        wrong = rate_of(trial.is_wrong for trial in first.trials)
        at_least = tr("{threshold} or more expected").format(threshold=page.percent(self.threshold, 0))
        return page.key_figures(
            [
                (page.percent(float((success >= self.threshold).mean())), tr("of the ground localizable"), at_least),
                (page.percent(float(success.mean())), tr("expected success"), tr("mean over the ground")),
                (page.number(_median(first.estimates.error), "m"), tr("expected error"), tr("of right fixes, median")),
                (page.percent(wrong.share), tr("wrong fixes simulated"), page.interval_text(wrong)),
            ]
        ) + (page.paragraph(first.title() + ".") if len(self.results) > 1 else "")

    def _next(self) -> list[str]:
        good = float((self.results[0].estimates.success >= self.threshold).mean())
        steps = [tr("Plan routes over the bright squares, and try them with “Assess route”.")] if good else []
        if good < ENOUGH_GROUND:
            steps.append(
                tr(
                    "Where squares are dark, more landmarks in view help: a larger footprint (fly higher), a smaller "
                    "minimum area, or further reference classes for “Build reference database”."
                )
            )
        steps.append(
            tr("Try it with images of another date by “Evaluate localization”: noise that is understated flatters.")
        )
        return steps

    def _maps(self) -> list[str]:
        classes = success_classes(self.threshold)
        maps = [
            page.figure(
                cell_map(self.cells.columns, self.cells.rows, r.estimates.success, classes, r.title()),
                tr("{footprint}: expected success. A square is {size:g} map units wide; north is up.").format(
                    footprint=r.title(), size=Local(self.cells.size)
                ),
            )
            for r in self.results
        ]
        return [success_legend(classes), *maps]

    def _footprints(self) -> str:
        columns = [
            (tr("Footprint"), lambda r: shown(r.footprint, "g")),
            (tr("localizable"), lambda r: page.percent(float((r.estimates.success >= self.threshold).mean()))),
            (tr("expected success"), lambda r: page.percent(float(r.estimates.success.mean()))),
            (tr("expected error"), lambda r: page.number(_median(r.estimates.error), "m")),
            (tr("landmarks in view"), lambda r: _middle(r.estimates.landmarks)),
            (tr("simulated: right"), lambda r: page.rate_text(rate_of(trial.is_right for trial in r.trials))),
            (tr("simulated: wrong"), lambda r: page.rate_text(rate_of(trial.is_wrong for trial in r.trials))),
        ]
        note = tr("Landmarks in view: median and, in brackets, range of the middle 80 % of the ground.")
        return page.records(self.results, columns) + page.paragraph(note)

    def _landmarks_chart(self) -> str:
        found = {r.title(): success_by_landmarks(r.trials, IN_VIEW_BINS) for r in self.results}
        caption = tr("Simulated images by the landmarks that the map has whole in them; lines: 95 % intervals.")
        return parts.landmarks_chart(found, tr("landmarks in view"), caption)

    def _reasons(self) -> str:
        # Where no image nearby failed, what is expected comes from places alike.
        titles = {"": tr("as at places alike; none nearby failed"), **reason_titles()}
        rows = []
        for r in self.results:
            poor = np.flatnonzero(r.estimates.success < self.threshold)
            counts = Counter(r.estimates.reasons[n] for n in poor.tolist())
            rows += [
                [r.title(), titles[reason], page.percent(count / len(r.estimates.success))]
                for reason, count in counts.most_common()
            ]
        text = tr("What keeps most images from a fix where expected success is below {threshold}:")
        if not rows:
            return page.paragraph(tr("Expected success is good enough everywhere."))
        return page.paragraph(text.format(threshold=page.percent(self.threshold, 0))) + page.table(
            [tr("Footprint"), tr("Reason"), tr("share of the ground")], rows, [2]
        )

    def _roads(self) -> dict[str, list[RoadSummary]]:
        return {r.title(): road_summaries([*r.trials, *r.correlated.values()]) for r in self.results}

    def _landmarks(self) -> str:
        references = self.database.references
        areas = {c: references.areas_m2[references.classes == c.value] for c in self.database.class_table.references}
        columns = [
            (tr("Class"), lambda c: c.name),
            (tr("landmarks"), lambda c: number_text(len(areas[c]))),
            (tr("share"), lambda c: page.percent(len(areas[c]) / len(references))),
            (tr("median area"), lambda c: page.number(_median(areas[c]), "m²")),
        ]
        return page.records(areas, columns, [1, 2, 3])


def trust(results: Sequence[AssessedFootprint]) -> list[str]:
    """Predicted against simulated success, each image predicted from all others."""
    series, scores = [], []
    for r in results:
        right = r.model.successes > 0
        series.append(rate_series(r.title(), calibration(r.model.left_out, right)))
        scores.append(page.number(brier_score(r.model.left_out, right)))
    chart = charts.reliability_diagram(
        series, tr("expected success"), tr("right fixes"), tr("Expected against simulated success")
    )
    text = tr(
        "Each simulated image was predicted from all the others by the landmarks it shows: on the diagonal the "
        "expectation means what it says. Brier score (0 is perfect; always saying one half has 0.25): {scores}. This "
        "tests the expectation against simulated images, not the noise that you stated against your own."
    )
    return [page.figure(chart, text.format(scores="; ".join(scores)))]


def assumed(conditions: Conditions, correlation: bool) -> str:
    """The sentence of what was assumed."""
    noise = conditions.noise
    text = tr(
        "Assumed: any heading; {missed} of the landmarks missed, {invented} invented, {misnamed} misnamed, "
        "{background} of the background misnamed; edges off by {ragged:g} map units (standard deviation), the map by "
        "{displaced:g} along each axis with neighbors alike, each class by {shifted:g}; roofs leaning by {leaning}; "
        "lens bent by {lens}; camera tilted by {tilt:g}°; no prior position. A fix counts as right "
        "within 2 % of the footprint. Method: {method}."
    )
    method = tr("constellation, then map correlation") if correlation else tr("constellation alone")
    return text.format(
        missed=page.percent(noise.missed, 0),
        invented=page.percent(noise.spurious, 0),
        misnamed=page.percent(noise.mislabeled, 0),
        background=page.percent(noise.background, 0),
        ragged=Local(noise.jitter),
        displaced=Local(noise.displaced),
        shifted=Local(conditions.class_shift),
        leaning=page.percent(noise.leaning),
        lens=page.percent(conditions.lens),
        tilt=Local(conditions.tilt_deg),
        method=method,
    )


def reason_titles() -> dict[str, str]:
    """By status, and of wrong fixes."""
    return {
        Status.TOO_FEW_REFERENCES.key: tr("too few landmarks"),
        Status.AMBIGUOUS.key: tr("look-alikes"),
        Status.NO_MATCH.key: tr("too little evidence"),
        WRONG: tr("wrong fixes"),
    }


def _middle(landmarks: np.ndarray) -> str:
    """Median and, in brackets, range of the middle 80 %."""
    low, median, high = np.percentile(landmarks, (10, 50, 90))
    return f"{median:.0f} ({low:.0f}{page.DASH}{high:.0f})"


def _median(errors: np.ndarray):
    """Of those that are known; None without any."""
    known = errors[np.isfinite(errors)]
    return float(np.median(known)) if len(known) else None
