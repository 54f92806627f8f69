"""Decision of map correlation: is the best place right (docs/explanation/method.md#map-correlation)?

A place has two opponents: chance, and the best other place on the map. The best place of the mirrored image shows what
chance reaches for an image with these classes on this map. The best other place shows whether the map has two similar
places. Both are weighted by the overall agreement of class areas, by which the place was chosen, by the agreement in
detail, which the search did not use, and, for a photo, by that of its edges with the map's outlines. The curve was
fitted to photos of unseen places and to simulated labels, and tested on each place left out (reference page of the
settings).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..geometry.radius import CIRCLE_95
from ..localization import LIKELY_RISK, RISK, CorrelationPeaks, Status, risk_of
from ..sentences import Sentence
from .settings import CORRELATION, CorrelationSettings

LEAST_CHANCE = 0.1
"""Least Fisher's z as the unit of a lead: without any other match, chance would be zero."""

DETAIL_ALONE = 4.0
"""Largest surprise of the detail that counts without a lead: wrong places with a lead near 0 had surprises of 6 to 11
(photos of Kenya, parts of Liechtenstein)."""


def fisher_z(correlation: float) -> float:
    """Return artanh, bounded: gives correlations by chance the same spread at every size (Fisher 1915)."""
    return float(np.arctanh(np.clip(correlation, 0.0, 0.999)))


@dataclass(frozen=True)
class Measured:
    """Agreement of image and map at one place.

    Attributes:
        score: Correlation of class areas, −1 to 1.
        detail: How far the detail agrees better than with the image shifted (``solver.measure``).
        outlines: Of ``outlines.agreement``; None for an image of labels.
    """

    score: float
    detail: float
    outlines: float | None = None


def surprises(details: Sequence[float], others: Sequence[float], usual: tuple[float, float, float]) -> list[float]:
    """Return for each place how far its detail exceeds that of all others: −ln of Student's density, signed.

    Mean and spread of the few others are averaged with the usual values: the posterior predictive distribution of a
    normal one (Gelman et al., Bayesian Data Analysis, 3.3), 0 at its mean. One outlier among them enlarges the spread,
    so that neither of two outstanding places surprises.

    Args:
        details: Of the image's places; or of their outlines.
        others: Of the mirrored image's places, which can't be right.
        usual: Mean and standard deviation at wrong places, and their weight in numbers of places.
    """
    mean_of_all, spread, weight = usual
    found = []
    for number, detail in enumerate(details):
        rest = np.array([*details[:number], *details[number + 1 :], *others])
        count = len(rest) + weight
        mean = (rest.sum() + weight * mean_of_all) / count
        freedom = count - 1
        squares = ((rest - mean) ** 2).sum() + weight * (spread**2 + (mean_of_all - mean) ** 2)
        units = (detail - mean) / np.sqrt(squares / freedom * (1 + 1 / count))
        found.append(float(np.sign(units) * (freedom + 1) / 2 * np.log1p(units**2 / freedom)))
    return found


def rank(
    places: Sequence[Measured], mirrored: Sequence[Measured], settings: CorrelationSettings = CORRELATION
) -> tuple[list[int], CorrelationPeaks]:
    """Return the numbers of the places, most probable first, and the figures that decide about the first.

    Args:
        places: Highest score first, at least one.
        mirrored: Of the mirrored image.
    """
    scores = [place.score for place in places]
    details = surprises([p.detail for p in places], [p.detail for p in mirrored], settings.usual_detail)
    mirror = mirrored[0].score if mirrored else 0.0
    chance = max(fisher_z(score) for score in (*scores[1:2], mirror, np.tanh(LEAST_CHANCE)))
    weights = [worth_of(fisher_z(score) / chance - 1, detail, settings) for score, detail in zip(scores, details)]
    edges = _surprising_outlines(places, mirrored, settings)
    if edges is not None:
        weights = [weight + worth_of_outlines(one, settings) for weight, one in zip(weights, edges)]
    best, *others = order = [int(n) for n in np.argsort([-value for value in weights], kind="stable")]
    other_score, other_detail = (max((kind[n] for n in others), default=0.0) for kind in (scores, details))
    peaks = CorrelationPeaks(scores[best], other_score, mirror, details[best], other_detail)
    if edges is not None:
        other_outlines = max((edges[n] for n in others), default=0.0)
        peaks = replace(peaks, outlines=edges[best], runner_up_outlines=other_outlines)
    return order, peaks


def _surprising_outlines(
    places: Sequence[Measured], mirrored: Sequence[Measured], settings: CorrelationSettings
) -> list[float] | None:
    """Return the surprise of the outlines of each place; None for an image of labels."""
    seen, unseen = ([p.outlines for p in some if p.outlines is not None] for some in (places, mirrored))
    return surprises(seen, unseen, settings.usual_outlines) if seen else None


def lead(peaks: CorrelationPeaks) -> float:
    """Return the lead over the stronger opponent in Fisher's z, in units of that opponent's z."""
    chance = max(fisher_z(peaks.runner_up), fisher_z(peaks.mirror), LEAST_CHANCE)
    return fisher_z(peaks.score) / chance - 1


def worth_of(lead: float, detail: float, settings: CorrelationSettings = CORRELATION) -> float:
    """Return ln of the odds of a place by its lead over the strongest opponent and by its detail, without the offset.

    Of many wrong places some agree very well in detail by chance, so much detail counts only together with a lead.
    """
    _, by_lead, by_detail, by_both = settings.confidence_curve
    alone = min(detail, DETAIL_ALONE)
    return by_lead * lead + by_detail * alone + by_both * max(lead, 0.0) * max(detail, 0.0)


def worth_of_outlines(outlines: float | None, settings: CorrelationSettings = CORRELATION) -> float:
    """Return ln of the likelihood ratio of a place by the surprise of its outlines; 0 for an image of labels.

    It is negative where they are as usual: at a right place they rarely are.
    """
    offset, slope = settings.outline_curve
    return 0.0 if outlines is None else offset + slope * outlines


def log_odds_over_chance(peaks: CorrelationPeaks, settings: CorrelationSettings = CORRELATION) -> float:
    """Return ln of the odds that the best place is right, against a match by chance."""
    there = worth_of(lead(peaks), peaks.detail, settings) + worth_of_outlines(peaks.outlines, settings)
    return settings.confidence_curve[0] + there


def log_odds_over_runner_up(peaks: CorrelationPeaks, settings: CorrelationSettings = CORRELATION) -> float:
    """Return ln of the odds against another place, with the best score, detail and outlines of all others."""
    chance = max(fisher_z(peaks.runner_up), fisher_z(peaks.mirror), LEAST_CHANCE)
    lead_there = fisher_z(peaks.runner_up) / chance - 1
    here = worth_of(lead(peaks), peaks.detail, settings) + worth_of_outlines(peaks.outlines, settings)
    there = worth_of(lead_there, peaks.runner_up_detail, settings)
    return here - there - worth_of_outlines(peaks.runner_up_outlines, settings)


def risk_of_peaks(peaks: CorrelationPeaks, settings: CorrelationSettings = CORRELATION) -> float:
    """Return the error probability of the best place: a match by chance, or another similar place."""
    over_chance, over_runner_up = log_odds_over_chance(peaks, settings), log_odds_over_runner_up(peaks, settings)
    return risk_of(-float(np.logaddexp(-over_chance, -over_runner_up)))


def decide(
    peaks: CorrelationPeaks, allowed_risk: float = RISK, settings: CorrelationSettings = CORRELATION
) -> tuple[Status, Sentence | None]:
    """Return the status, and the reason unless it is a fix.

    Args:
        peaks: Agreement of the best places.
    """
    score = peaks.score
    risk = risk_of_peaks(peaks, settings)
    if risk <= allowed_risk:
        return Status.FIX, None
    alone = replace(peaks, runner_up=0.0, mirror=0.0)
    is_chance = risk_of(log_odds_over_chance(alone, settings)) > allowed_risk
    if peaks.mirror >= peaks.runner_up and not is_chance:
        mirror = peaks.mirror
        reason = Sentence(
            "The match ({score:.2f}) is not significantly better than for the mirrored image ({mirror:.2f}): error "
            "probability {risk:.2g}; at most {allowed:.2g} is allowed.",
            score=score,
            mirror=mirror,
            risk=risk,
            allowed=allowed_risk,
        )
        return Status.NO_MATCH, reason
    over_chance = risk_of(log_odds_over_chance(replace(peaks, runner_up=0.0), settings))
    is_rival = risk_of(log_odds_over_runner_up(peaks, settings)) > LIKELY_RISK
    if is_chance or over_chance > LIKELY_RISK or not is_rival:
        reason = Sentence(
            "The best match ({score:.2f}) is not significantly better than chance: error probability {risk:.2g}; at "
            "most {allowed:.2g} is allowed.",
            score=score,
            risk=risk,
            allowed=allowed_risk,
        )
        return Status.NO_MATCH, reason
    runner_up = peaks.runner_up
    return Status.AMBIGUOUS, Sentence(
        "Two places match almost equally well ({score:.2f} and {runner_up:.2f}): error probability {risk:.2g} for the "
        "better one. Set a prior position to choose between them.",
        score=score,
        runner_up=runner_up,
        risk=risk,
    )


def decide_accuracy(
    error_95_m: float, diagonal_m: float, is_held: bool = False, settings: CorrelationSettings = CORRELATION
) -> tuple[Status, Sentence | None]:
    """Return the status of the only agreeing place from its accuracy, and the reason unless it is a fix.

    Args:
        error_95_m: 95 % radius of the image itself.
        diagonal_m: Of the image on the ground.
        is_held: The place is at the map's edge and would match better beyond it.
    """
    if is_held:
        return Status.AMBIGUOUS, Sentence(
            "One place matches, but more than half of the image is outside the map, so its position is not known."
        )
    needed_m = settings.largest_error * diagonal_m
    if error_95_m <= needed_m:
        return Status.FIX, None
    if not np.isfinite(error_95_m):
        return Status.AMBIGUOUS, Sentence(
            "One place matches, but the image does not determine the position in all directions."
        )
    return Status.AMBIGUOUS, Sentence(
        "One place matches, but its 95 % radius is {error_95_m:.3g} m; for this footprint, at most {needed_m:.3g} m is "
        "allowed.",
        error_95_m=error_95_m,
        needed_m=needed_m,
    )


def position_error_95(
    covariance_m2: np.ndarray, overview_pixel_m: float, settings: CorrelationSettings = CORRELATION
) -> float:
    """Return the 95 % radius of a position from its larger axis, m.

    Args:
        covariance_m2: (2, 2) of the position.
    """
    if not np.isfinite(covariance_m2).all():
        return float("inf")
    deviation = float(np.sqrt(max(np.linalg.eigvalsh(covariance_m2).max(), 0.0)))
    return float(np.hypot(CIRCLE_95 * deviation, settings.error_floor_px * overview_pixel_m))
