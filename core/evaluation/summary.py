"""Summaries of an evaluation's trials: rates with intervals, errors, curves."""

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
    """Results of one method over all trials. None if unknown.

    Attributes:
        right: Fixes at the right place, of the images of the map.
        wrong: Fixes at a wrong place, of the same images.
        false_accepts: Fixes of mirrored images.
        likely: Likely positions at the right place, of all likely positions of images of the map. They are not fixes.
        median_error: 50th percentile of right fixes (CEP50), m.
        error_95: 95th percentile of right fixes (CEP95), m.
        heading_error_deg: Median of right fixes.
        scale_error: Median of right fixes, relative.
        covered: Right fixes within their 95 % ellipse.
        statuses: Images of the map by status.
    """

    method: str
    right: Rate
    wrong: Rate
    false_accepts: Rate
    likely: Rate
    median_error: float | None
    error_95: float | None
    heading_error_deg: float | None
    scale_error: float | None
    covered: Rate
    statuses: dict[str, int]


def of_method(trials: Sequence[Trial], method: str, *kinds: str) -> list[Trial]:
    """Return the trials of a method with some kinds of queries."""
    return [t for t in trials if t.method == method and t.query.kind in kinds]


def summarize(trials: Sequence[Trial], method: str) -> MethodSummary:
    """Return the summary of a method's trials, with images of the map and mirrored ones."""
    tried = of_method(trials, method, MAP)
    right = [t for t in tried if t.is_right]
    return MethodSummary(
        method,
        rate_of(t.is_right for t in tried),
        rate_of(t.is_wrong for t in tried),
        rate_of(t.is_fix for t in of_method(trials, method, MIRRORED)),
        rate_of(t.is_likely_right for t in tried if t.result.is_likely),
        percentile([t.error for t in right], 50),
        percentile([t.error for t in right], 95),
        percentile([t.heading_error_deg for t in right], 50),
        percentile([t.scale_error for t in right], 50),
        covered(right),
        dict(sorted(Counter(t.status for t in tried).items())),
    )


def covered(trials: Sequence[Trial]) -> Rate:
    """Return the rate of errors within the 95 % ellipse or circle, of the trials that have one."""
    return rate_of(t.radius_ratio <= 1 for t in trials if t.radius_ratio is not None)


def held_shares(trials: Sequence[Trial]) -> tuple[Rate, ...]:
    """Return the rates of errors within their 50, 95 and 99 % ellipses or circles, of the trials that have one."""
    # The ellipse of a share has a radius of √(−2 ln(1 − share)) standard deviations.
    at_95 = math.sqrt(-2 * math.log(0.05))
    ratios = [t.radius_ratio * at_95 for t in trials if t.radius_ratio is not None]
    return tuple(rate_of(r <= math.sqrt(-2 * math.log(1 - share)) for r in ratios) for share in HELD_SHARES)


@dataclass(frozen=True)
class AccuracySummary:
    """Stated accuracy of the fixes that one method found, against the ground truth. None if unknown.

    Attributes:
        right: Fixes at the right place, of all fixes.
        confidence: Mean of the fixes.
        calibration_error: Mean difference of confidence and rate of right fixes, over bins.
        contained: Right fixes within their 50, 95 and 99 % ellipses.
        median_radius: Stated 95 % radius of right fixes, m.
        median_error: Of right fixes, m.
    """

    method: Method
    right: Rate
    confidence: float | None
    calibration_error: float | None
    contained: tuple[Rate, ...]
    median_radius: float | None
    median_error: float | None


def accuracy_summaries(trials: Sequence[Trial]) -> list[AccuracySummary]:
    """Return a summary for each method that gave fixes, whatever method was requested; mirrored images count."""
    by_method: dict[Method, list[Trial]] = {}
    for trial in trials:
        if trial.is_fix:
            by_method.setdefault(trial.result.method, []).append(trial)
    return [_accuracy(method, by_method[method]) for method in Method if method in by_method]


def _accuracy(method: Method, fixes: Sequence[Trial]) -> AccuracySummary:
    right = [t for t in fixes if t.is_right]
    confidences = [t.result.confidence or 0.0 for t in fixes]
    bins = binned(confidences, [t.is_right for t in fixes], CONFIDENCE_BINS)
    apart = sum(abs(one.at - one.rate.successes / one.rate.trials) * one.rate.trials for one in bins)
    return AccuracySummary(
        method,
        rate_of(t.is_right for t in fixes),
        sum(confidences) / len(confidences),
        apart / len(fixes),
        held_shares(right),
        percentile([t.result.error_95_m for t in right], 50),
        percentile([t.error for t in right], 50),
    )


def percentile(values: Sequence[float | None], percent: float) -> float | None:
    """Return a percentile of the known values; None without any."""
    known = [value for value in values if value is not None]
    return float(np.percentile(known, percent)) if known else None


def success_by_offset(trials: Sequence[Trial], method: str) -> list[RateAt]:
    """Return the rates of right fixes of windows shifted by each of OFFSETS."""
    moved = of_method(trials, method, OFFSET)
    offsets = [round(cast(WindowQuery, t.query).offset, 6) for t in moved]
    return binned(offsets, [t.is_right for t in moved], (*OFFSETS, np.inf))


def success_by_landmarks(trials: Sequence[Trial], edges: Sequence[float] = LANDMARK_BINS) -> list[RateAt]:
    """Return the rates of right fixes by number of landmarks, from each edge to the next, the last without end."""
    counted = [t for t in trials if t.landmarks is not None]
    return binned([t.landmarks or 0 for t in counted], [t.is_right for t in counted], (*edges, np.inf))


def reliability(trials: Sequence[Trial], method: str) -> list[RateAt]:
    """Return the rates of right fixes by confidence, mirrored images included."""
    fixes = [t for t in of_method(trials, method, MAP, MIRRORED) if t.is_fix]
    return calibration(np.array([t.result.confidence or 0.0 for t in fixes]), np.array([t.is_right for t in fixes]))


def calibration(predicted: np.ndarray, right: np.ndarray) -> list[RateAt]:
    """Return the rates of right images by their predicted success (n,) 0…1; NaN is left out."""
    known = np.isfinite(predicted)
    return binned(predicted[known], np.asarray(right, bool)[known], CONFIDENCE_BINS)


def brier_score(predicted: np.ndarray, right: np.ndarray) -> float | None:
    """Return the mean squared difference of predicted and actual success (1 or 0); None without predictions."""
    known = np.isfinite(predicted)
    if not known.any():
        return None
    return float(((predicted[known] - np.asarray(right, float)[known]) ** 2).mean())


def error_curve(trials: Sequence[Trial], method: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the sorted errors of all fixes (n,), and the share of images with a fix of at most that error (n,)."""
    tried = of_method(trials, method, MAP)
    errors = np.sort([t.error for t in tried if t.is_fix])
    return errors, np.arange(1, len(errors) + 1) / max(len(tried), 1)


def noise_rates(trials: Sequence[Trial]) -> list[list[Rate]]:
    """Return the rates of right fixes of the noise grid: rows by level of missed, columns of spurious landmarks."""
    tried = [t for t in trials if t.query.kind == NOISE]
    levels = [level / 100 for level in NOISE_LEVELS]
    return [
        [rate_of(t.is_right for t in tried if (t.query.noise.missed, t.query.noise.spurious) == pair) for pair in row]
        for row in ([(missed, spurious) for spurious in levels] for missed in levels)
    ]
