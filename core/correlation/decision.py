"""Map correlation's verdict: is the best place *the* place (docs/method.md#map-correlation)?

Two opponents: the best other place of the map, and the best place of the mirrored image. The first tells whether the
map has two places alike; the second what chance gives for an image with these classes on this map. The thresholds and
curves were fitted on trials in the northern half of Liechtenstein and frozen before the southern half was tried
(tools/measure_correlation.py).
"""

from __future__ import annotations

from typing import Optional, Tuple

import numpy as np

from ..localization import CorrelationPeaks, Status
from ..sentences import Sentence

LEAST_SCORE = 0.25
"""Correlation below which nothing is accepted, however lonely the peak."""

LEAST_MARGIN = 0.13
"""How far the best place has to be above both opponents, in units of Fisher's z = artanh(correlation). Of 129 wrong
places of the northern trials the highest leads were 0.09, 0.08 and 0.08, of 136 right ones the lowest 0.02 to 0.13."""

CONFIDENCE_CURVE = (-4.3, 46.0)
"""Logistic curve of the margin: offset, slope a unit of z."""

ERROR_FACTOR = 4.0
LEAST_NOISE = 0.4
"""95 % radius in units of the larger axis' standard deviation, as the refinement gives it, times the ratio of noise to
signal that a correlation s tells, 1/s² − 1 (or LEAST_NOISE): the worse the labels, the farther their errors reach, and
the less they are independent as that deviation takes them to be. Set on aerial label maps: 95 % of the errors are below
2.9 of these units with modest noise, below 4.1 with strong. Photos of a town, poorly segmented: 2.1; of a shore whose
annotation and network disagree about where it runs: 6.0."""

LARGEST_ERROR = 0.025
"""A fix must have a 95 % radius within this share of the image's diagonal. Of poses refined from beside the right place
on aerial label maps it keeps 58 of 60 (modest noise) and 15 of 27 (strong) that are within 2 % of the image's edge, and
3 of 9 that are not; on Liechtenstein it refuses none."""

ERROR_FLOOR_PX = 0.15
"""Least 95 % radius, in overview pixels: the most frequent class of a block says no more."""


def over_runner_up(peaks: CorrelationPeaks) -> float:
    """Lead over the best other place in Fisher's z."""
    return fisher_z(peaks.score) - fisher_z(peaks.runner_up)


def over_mirror(peaks: CorrelationPeaks) -> float:
    """Lead over the mirrored image in Fisher's z."""
    return fisher_z(peaks.score) - fisher_z(peaks.mirror)


def smaller_lead(peaks: CorrelationPeaks) -> float:
    """Lead over the stronger of both opponents in Fisher's z."""
    return min(over_runner_up(peaks), over_mirror(peaks))


def fisher_z(correlation: float) -> float:
    """artanh, bounded: makes the spread of correlations by chance alike whatever their size (Fisher 1915)."""
    return float(np.arctanh(np.clip(correlation, 0.0, 0.999)))


def decide(peaks: CorrelationPeaks) -> Tuple[Status, Optional[Sentence]]:
    """Status, and the reason unless that is a fix."""
    score = peaks.score
    if score < LEAST_SCORE:
        return Status.NO_MATCH, Sentence("localization.agreement_too_low", score=score, least=LEAST_SCORE)
    if over_mirror(peaks) < LEAST_MARGIN:
        return Status.NO_MATCH, Sentence("localization.mirror_agrees", score=score, mirror=peaks.mirror)
    if over_runner_up(peaks) < LEAST_MARGIN:
        return Status.AMBIGUOUS, Sentence("localization.two_places_agree", score=score, runner_up=peaks.runner_up)
    return Status.FIX, None


def exact_enough(error_95_m: float, diagonal_m: float) -> Tuple[Status, Optional[Sentence]]:
    """Status of the only place that agrees, by how closely it is known, and the reason unless that is a fix."""
    needed_m = LARGEST_ERROR * diagonal_m
    if error_95_m <= needed_m:
        return Status.FIX, None
    if not np.isfinite(error_95_m):
        return Status.AMBIGUOUS, Sentence("localization.direction_unknown")
    return Status.AMBIGUOUS, Sentence("localization.error_too_large", error_95_m=error_95_m, needed_m=needed_m)


def confidence_of(peaks: CorrelationPeaks) -> float:
    """Chance, 0–1, that the best place is the right one, from the margin."""
    offset, slope = CONFIDENCE_CURVE
    chance = 1 / (1 + np.exp(-np.clip(offset + slope * smaller_lead(peaks), -30, 30)))
    return float(chance * min(1.0, max(0.0, peaks.score / LEAST_SCORE)))


def position_error_95(covariance_m2: np.ndarray, score: float, overview_pixel_m: float) -> float:
    """Radius in meters that holds the true position in 95 % of fixes, from the (2, 2) covariance of the position and
    the correlation."""
    if not np.isfinite(covariance_m2).all():
        return float("inf")
    deviation = float(np.sqrt(max(np.linalg.eigvalsh(covariance_m2).max(), 0.0)))
    noise = max(1 / max(score, 0.1) ** 2 - 1, LEAST_NOISE)
    return float(np.hypot(ERROR_FACTOR * noise * deviation, ERROR_FLOOR_PX * overview_pixel_m))
