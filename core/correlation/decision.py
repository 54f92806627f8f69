"""Map correlation's verdict: is the best place *the* place (docs/method.md#map-correlation)?

Two opponents: the best other place of the map, and the best place of the mirrored image. The first tells whether the
map has two places alike; the second what chance gives for an image with these classes on this map. The thresholds and
curves were fitted on trials in the northern half of Liechtenstein and frozen before the southern half was tried
(tools/measure_correlation.py).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Tuple

import numpy as np

FIX = "fix"
AMBIGUOUS = "ambiguous"
NO_MATCH = "no_match"

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


@dataclass(frozen=True)
class Evidence:
    """Correlations −1…1 of the best place, the best other place and the mirrored image's best place."""

    score: float
    runner_up: float
    decoy: float

    @property
    def over_runner_up(self) -> float:
        """Lead over the best other place in Fisher's z."""
        return fisher_z(self.score) - fisher_z(self.runner_up)

    @property
    def over_decoy(self) -> float:
        """Lead over the mirrored image in Fisher's z."""
        return fisher_z(self.score) - fisher_z(self.decoy)

    @property
    def margin(self) -> float:
        """The smaller lead."""
        return min(self.over_runner_up, self.over_decoy)


def fisher_z(correlation: float) -> float:
    """artanh, bounded: makes the spread of correlations by chance alike whatever their size (Fisher 1915)."""
    return float(np.arctanh(np.clip(correlation, 0.0, 0.999)))


def decide(evidence: Evidence) -> Tuple[str, str]:
    """Status and reason (one sentence, empty for a fix)."""
    if evidence.score < LEAST_SCORE:
        return NO_MATCH, (
            f"The best place agrees with the image only by {evidence.score:.2f}; at least {LEAST_SCORE:.2f} is needed."
        )
    if evidence.over_decoy < LEAST_MARGIN:
        return NO_MATCH, (
            f"The best place ({evidence.score:.2f}) agrees hardly better than the mirrored image does by chance "
            f"({evidence.decoy:.2f})."
        )
    if evidence.over_runner_up < LEAST_MARGIN:
        return AMBIGUOUS, (
            f"Two places agree almost equally well ({evidence.score:.2f} and {evidence.runner_up:.2f}); "
            "a prior position could tell them apart."
        )
    return FIX, ""


def exact_enough(error_95_m: float, diagonal_m: float) -> Tuple[str, str]:
    """Status and reason (empty for a fix) of the only place that agrees, by how closely it is known."""
    if error_95_m <= LARGEST_ERROR * diagonal_m:
        return FIX, ""
    if not np.isfinite(error_95_m):
        return AMBIGUOUS, "One place agrees, but the image doesn't tell its position in all directions."
    return AMBIGUOUS, (
        f"One place agrees, but its position is known only within {error_95_m:.3g} m; "
        f"an image of this size needs {LARGEST_ERROR * diagonal_m:.3g} m."
    )


def confidence_of(evidence: Evidence) -> float:
    """Chance, 0–1, that the best place is the right one, from the margin."""
    offset, slope = CONFIDENCE_CURVE
    chance = 1 / (1 + np.exp(-np.clip(offset + slope * evidence.margin, -30, 30)))
    return float(chance * min(1.0, max(0.0, evidence.score / LEAST_SCORE)))


def position_error_95(covariance_m2: np.ndarray, score: float, overview_pixel_m: float) -> float:
    """Radius in meters that holds the true position in 95 % of fixes, from the (2, 2) covariance of the position and
    the correlation."""
    if not np.isfinite(covariance_m2).all():
        return float("inf")
    deviation = float(np.sqrt(max(np.linalg.eigvalsh(covariance_m2).max(), 0.0)))
    noise = max(1 / max(score, 0.1) ** 2 - 1, LEAST_NOISE)
    return float(np.hypot(ERROR_FACTOR * noise * deviation, ERROR_FLOOR_PX * overview_pixel_m))
