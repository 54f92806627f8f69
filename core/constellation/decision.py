"""Decision of the constellation: error probability of the best candidate, and whether it is small enough for a fix.

See docs/explanation/method.md#constellation; the constants in docs/reference/settings.md.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..localization import MORE_LIKELY_WRONG, Status, risk_of
from ..sentences import Sentence
from .settings import Decision

LANDMARKS_CALIBRATED = 10_000
"""Map size that the error probability was calibrated on; wrong candidates grow in proportion to the landmarks."""


@dataclass(frozen=True)
class Opponents:
    """The best candidate and what it is compared with.

    Attributes:
        log_odds: Of the best candidate.
        runner_up: Log odds of the second candidate, −inf without one.
        mirror: Log odds of the best candidate of the mirrored image, which has no right position; at least 0.
        landmarks: On the map.
        is_capped: The search omitted something.
    """

    log_odds: float
    runner_up: float
    mirror: float
    landmarks: int
    is_capped: bool

    @property
    def strongest(self) -> float:
        """Log odds of the strongest alternative."""
        return max(self.runner_up, self.mirror)


def risk_against(opponents: Opponents, rival: float, settings: Decision) -> float:
    """Return the error probability of the best candidate if its strongest alternative has the log odds ``rival``.

    By chance log odds have an exponential tail, so ln of the odds of being right grows with them and with their lead.
    The growth slows down for large leads, because some errors are not due to chance (``confidence_scale``).

    Args:
        rival: Log odds; negative ones count as 0.
    """
    larger = np.log(max(opponents.landmarks, 1) / LANDMARKS_CALIBRATED)
    own = opponents.log_odds - max(float(larger), 0.0) - (settings.capped_log_odds if opponents.is_capped else 0.0)
    lead = min(own, own - max(rival, 0.0) * settings.rival_weight)
    scale = settings.confidence_scale
    grown = scale * np.log1p(lead / scale) if lead > 0 else lead
    return risk_of(settings.confidence_offset + settings.confidence_slope * grown)


def risk_of_best(opponents: Opponents, settings: Decision) -> float:
    """Return the error probability of the best candidate."""
    return risk_against(opponents, opponents.strongest, settings)


def may_be_a_fix(opponents: Opponents, allowed: float, settings: Decision) -> bool:
    """Return whether the best candidate would be a fix without any alternative."""
    return risk_against(opponents, 0.0, settings) <= allowed


def verdict(opponents: Opponents, rivals: int, allowed: float, settings: Decision) -> tuple[Status, Sentence | None]:
    """Return whether the evidence is enough for a fix, and the reason if not.

    Args:
        rivals: Number of other candidates that are too close to the best one.
        allowed: Maximum error probability of a fix.
    """
    risk = risk_of_best(opponents, settings)
    if risk <= allowed:
        return Status.FIX, None
    if not may_be_a_fix(opponents, allowed, settings):
        log_odds = opponents.log_odds
        return Status.NO_MATCH, Sentence(
            "The best candidate position (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; at most "
            "{allowed:.2g} is allowed.",
            log_odds=log_odds,
            risk=risk,
            allowed=allowed,
        )
    if rivals and risk_against(opponents, opponents.mirror, settings) <= MORE_LIKELY_WRONG:
        return Status.AMBIGUOUS, Sentence(
            "{count} other position fits almost as well as the best one."
            if rivals == 1
            else "{count} other positions fit almost as well as the best one.",
            count=rivals,
        )
    return Status.NO_MATCH, Sentence(
        "The mirrored image matches almost as well; the pattern of landmarks is too regular."
    )
