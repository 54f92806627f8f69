"""Map correlation's verdict: is the best place *the* place (docs/method.md#map-correlation)?

Two opponents: the best other place of the map, and the best place of the mirrored image. The first tells whether the
map has two places alike; the second what chance gives for an image with these classes on this map. The thresholds and
curves were fitted on trials in the northern half of Liechtenstein and frozen before the southern half was tried
(docs/calibration.md).
"""

from __future__ import annotations

import numpy as np

from ..localization import RISK, CorrelationPeaks, Status, risk_of
from ..sentences import Sentence
from .settings import CORRELATION, CorrelationSettings


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


def decide(
    peaks: CorrelationPeaks, allowed_risk: float = RISK, settings: CorrelationSettings = CORRELATION
) -> tuple[Status, Sentence | None]:
    """Status, and the reason unless that is a fix.

    Args:
        peaks: How well the best places agree.
        allowed_risk: Probability of being wrong up to which the best place is a fix.
        settings: The curve.
    """
    score = peaks.score
    risk = risk_of_peaks(peaks, settings)
    if risk <= allowed_risk:
        return Status.FIX, None
    alone = CorrelationPeaks(score, 0.0, 0.0)
    if risk_of_peaks(alone, settings) > allowed_risk:
        reason = Sentence("localization.agreement_too_low", score=score, risk=risk, allowed=allowed_risk)
        return Status.NO_MATCH, reason
    if peaks.mirror >= peaks.runner_up:
        mirror = peaks.mirror
        reason = Sentence("localization.mirror_agrees", score=score, mirror=mirror, risk=risk, allowed=allowed_risk)
        return Status.NO_MATCH, reason
    runner_up = peaks.runner_up
    return Status.AMBIGUOUS, Sentence("localization.two_places_agree", score=score, runner_up=runner_up, risk=risk)


def exact_enough(
    error_95_m: float, diagonal_m: float, settings: CorrelationSettings = CORRELATION
) -> tuple[Status, Sentence | None]:
    """Status of the only place that agrees, by how closely it is known, and the reason unless that is a fix."""
    needed_m = settings.largest_error * diagonal_m
    if error_95_m <= needed_m:
        return Status.FIX, None
    if not np.isfinite(error_95_m):
        return Status.AMBIGUOUS, Sentence("localization.direction_unknown")
    return Status.AMBIGUOUS, Sentence("localization.error_too_large", error_95_m=error_95_m, needed_m=needed_m)


def risk_of_peaks(peaks: CorrelationPeaks, settings: CorrelationSettings = CORRELATION) -> float:
    """Probability that the best place is wrong, from its lead and from how well it agrees at all."""
    offset, slope, own = settings.confidence_curve
    return risk_of(offset + slope * smaller_lead(peaks) + own * fisher_z(peaks.score))


def position_error_95(
    covariance_m2: np.ndarray, score: float, overview_pixel_m: float, settings: CorrelationSettings = CORRELATION
) -> float:
    """Radius in meters that holds the true position in 95 % of fixes.

    Args:
        covariance_m2: (2, 2) of the position.
        score: Correlation there.
        overview_pixel_m: Pixel of the map's overview.
        settings: Of map correlation.
    """
    if not np.isfinite(covariance_m2).all():
        return float("inf")
    deviation = float(np.sqrt(max(np.linalg.eigvalsh(covariance_m2).max(), 0.0)))
    noise = max(1 / max(score, 0.1) ** 2 - 1, settings.least_noise)
    return float(np.hypot(settings.error_factor * noise * deviation, settings.error_floor_px * overview_pixel_m))
