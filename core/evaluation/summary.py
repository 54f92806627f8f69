"""What the trials of an evaluation say: rates with intervals, errors, curves."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np

from ..localization import Method
from .evaluation import MAP, MIRRORED, NOISE, NOISE_LEVELS, OFFSET, OFFSETS, WindowQuery
from .rates import Rate, RateAt, binned, rate_of
from .trial import Trial

HELD_SHARES = (0.5, 0.95, 0.99)
CONFIDENCE_BINS = tuple(np.linspace(0, 1, 11).tolist())
LANDMARK_BINS = (0, 5, 10, 20, 40, 80)
"""Landmarks of the window that contains the image's center."""

IN_VIEW_BINS = (0, 3, 6, 10, 15, 20, 40, 80)
"""Whole landmarks in view."""


@dataclass(frozen=True)
class MethodSummary:
    """One method over all trials. None where nothing is known.

    Attributes:
        right: fixes at the right place, of the images of the map
        wrong: fixes at a wrong place, of the same
        false_accepts: fixes of mirrored images
        median_error: 50th percentile of right fixes (CEP50), map units
        error_95: 95th percentile of right fixes (CEP95), map units
        heading_error_deg: median of right fixes
        scale_error: median of right fixes, relative
        covered: right fixes within their 95 % ellipse
        statuses: number of images of the map a status
    """

    method: str
    right: Rate
    wrong: Rate
    false_accepts: Rate
    median_error: float | None
    error_95: float | None
    heading_error_deg: float | None
    scale_error: float | None
    covered: Rate
    statuses: dict[str, int]


def of_method(trials: Sequence[Trial], method: str, *kinds: str) -> list[Trial]:
    """The trials of a method with some kinds of queries."""
    return [t for t in trials if t.method == method and t.query.kind in kinds]


def summarize(trials: Sequence[Trial], method: str) -> MethodSummary:
    """Sums up a method's trials, images of the map and mirrored ones."""
    tried = of_method(trials, method, MAP)
    right = [t for t in tried if t.is_right]
    return MethodSummary(
        method,
        rate_of(t.is_right for t in tried),
        rate_of(t.is_wrong for t in tried),
        rate_of(t.is_fix for t in of_method(trials, method, MIRRORED)),
        percentile([t.error for t in right], 50),
        percentile([t.error for t in right], 95),
        percentile([t.heading_error_deg for t in right], 50),
        percentile([t.scale_error for t in right], 50),
        covered(right),
        dict(sorted(Counter(t.status for t in tried).items())),
    )


def covered(trials: Sequence[Trial]) -> Rate:
    """Errors within the 95 % ellipse, or circle, among the trials that have one."""
    return rate_of(t.radius_ratio <= 1 for t in trials if t.radius_ratio is not None)


def held_shares(trials: Sequence[Trial]) -> tuple[Rate, ...]:
    """Errors within their 50, 95 and 99 % ellipses, or circles, among the trials that have one."""
    # The ellipse that holds a share reaches √(−2 ln(1 − share)) deviations.
    at_95 = math.sqrt(-2 * math.log(0.05))
    ratios = [t.radius_ratio * at_95 for t in trials if t.radius_ratio is not None]
    return tuple(rate_of(r <= math.sqrt(-2 * math.log(1 - share)) for r in ratios) for share in HELD_SHARES)


@dataclass(frozen=True)
class RoadSummary:
    """What a road says of its fixes, against the truth. None where nothing is known.

    Attributes:
        road: method that gave them
        right: fixes at the right place, of all fixes
        told: mean confidence
        calibration_error: mean difference of confidence and share of right ones, bin by bin
        held: right fixes within their 50, 95 and 99 % ellipses
        median_radius: stated 95 % radius of right fixes, map units
        median_error: of right fixes, map units
    """

    road: Method
    right: Rate
    told: float | None
    calibration_error: float | None
    held: tuple[Rate, ...]
    median_radius: float | None
    median_error: float | None


def road_summaries(trials: Sequence[Trial]) -> list[RoadSummary]:
    """A summary for each method that gave fixes, whatever method was asked for; images that can't be right count."""
    by_road: dict[Method, list[Trial]] = {}
    for trial in trials:
        if trial.is_fix:
            by_road.setdefault(trial.result.method, []).append(trial)
    return [_road(road, by_road[road]) for road in Method if road in by_road]


def _road(road: Method, fixes: Sequence[Trial]) -> RoadSummary:
    right = [t for t in fixes if t.is_right]
    told = [t.result.confidence or 0.0 for t in fixes]
    bins = binned(told, [t.is_right for t in fixes], CONFIDENCE_BINS)
    apart = sum(abs(one.at - one.rate.successes / one.rate.trials) * one.rate.trials for one in bins)
    return RoadSummary(
        road,
        rate_of(t.is_right for t in fixes),
        sum(told) / len(told),
        apart / len(fixes),
        held_shares(right),
        percentile([t.result.error_95_m for t in right], 50),
        percentile([t.error for t in right], 50),
    )


def percentile(values: Sequence[float | None], percent: float) -> float | None:
    """Percentile of the values that are known; None when none is."""
    known = [value for value in values if value is not None]
    return float(np.percentile(known, percent)) if known else None


def success_by_offset(trials: Sequence[Trial], method: str) -> list[RateAt]:
    """Right fixes of windows that were moved by each of OFFSETS."""
    moved = of_method(trials, method, OFFSET)
    offsets = [round(cast(WindowQuery, t.query).offset, 6) for t in moved]
    return binned(offsets, [t.is_right for t in moved], (*OFFSETS, np.inf))


def success_by_landmarks(trials: Sequence[Trial], edges: Sequence[float] = LANDMARK_BINS) -> list[RateAt]:
    """Right ones among the trials whose landmarks were counted, from each edge to the next, the last without end."""
    counted = [t for t in trials if t.landmarks is not None]
    return binned([t.landmarks or 0 for t in counted], [t.is_right for t in counted], (*edges, np.inf))


def reliability(trials: Sequence[Trial], method: str) -> list[RateAt]:
    """Share of right ones among the fixes of a confidence, mirrored images among them."""
    fixes = [t for t in of_method(trials, method, MAP, MIRRORED) if t.is_fix]
    return calibration(np.array([t.result.confidence or 0.0 for t in fixes]), np.array([t.is_right for t in fixes]))


def calibration(predicted: np.ndarray, right: np.ndarray) -> list[RateAt]:
    """Right ones among images by their predicted success (n,) 0…1; NaN is left out."""
    known = np.isfinite(predicted)
    return binned(predicted[known], np.asarray(right, bool)[known], CONFIDENCE_BINS)


def brier_score(predicted: np.ndarray, right: np.ndarray) -> float | None:
    """Mean squared difference of predicted success and what came of it (1 right, 0 not); None without predictions."""
    known = np.isfinite(predicted)
    if not known.any():
        return None
    return float(((predicted[known] - np.asarray(right, float)[known]) ** 2).mean())


def error_curve(trials: Sequence[Trial], method: str) -> tuple[np.ndarray, np.ndarray]:
    """Errors of all fixes in order (n,), and the share of the map's images with a fix at most so far off (n,)."""
    tried = of_method(trials, method, MAP)
    errors = np.sort([t.error for t in tried if t.is_fix])
    return errors, np.arange(1, len(errors) + 1) / max(len(tried), 1)


def noise_rates(trials: Sequence[Trial]) -> list[list[Rate]]:
    """Right fixes of the noise grid: a row for each level missed, a column for each level spurious."""
    tried = [t for t in trials if t.query.kind == NOISE]
    levels = [level / 100 for level in NOISE_LEVELS]
    return [
        [rate_of(t.is_right for t in tried if (t.query.noise.missed, t.query.noise.spurious) == pair) for pair in row]
        for row in ([(missed, spurious) for spurious in levels] for missed in levels)
    ]
