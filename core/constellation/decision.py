"""The constellation's verdict: how likely is the best place wrong, and is that little enough for a fix?

Told in docs/explanation/method.md#constellation; the constants in docs/reference/settings.md.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..localization import MORE_LIKELY_WRONG, Status, risk_of
from ..sentences import Sentence
from .settings import Decision

LANDMARKS_CALIBRATED = 10_000
"""Size of the map that the risk was calibrated on; one of more landmarks has so many times more wrong places."""


@dataclass(frozen=True)
class Opponents:
    """What the best place is compared with.

    Attributes:
        log_odds: Of the best place.
        runner_up: Log odds of the best other place, −inf without one.
        mirror: Log odds of the best place of the mirrored image, which can't be right; 0 at least.
        landmarks: On the map.
        is_capped: The search left something out.
    """

    log_odds: float
    runner_up: float
    mirror: float
    landmarks: int
    is_capped: bool

    @property
    def strongest(self) -> float:
        """Log odds of the strongest opponent."""
        return max(self.runner_up, self.mirror)


def risk_against(opponents: Opponents, rival: float, settings: Decision) -> float:
    """Probability that the best place is wrong if its strongest opponent has the log odds ``rival``.

    By chance log odds have an exponential tail, so that ln of the odds of being right grows with them and with their
    lead; slower the larger they are, because there are mistakes that no chance explains (``confidence_scale``).

    Args:
        opponents: The best place and the map.
        rival: Log odds; below 0 counts as 0.
    """
    larger = np.log(max(opponents.landmarks, 1) / LANDMARKS_CALIBRATED)
    own = opponents.log_odds - max(float(larger), 0.0) - (settings.capped_log_odds if opponents.is_capped else 0.0)
    lead = min(own, own - max(rival, 0.0) * settings.rival_weight)
    scale = settings.confidence_scale
    grown = scale * np.log1p(lead / scale) if lead > 0 else lead
    return risk_of(settings.confidence_offset + settings.confidence_slope * grown)


def risk_of_best(opponents: Opponents, settings: Decision) -> float:
    """Probability that the best place is wrong."""
    return risk_against(opponents, opponents.strongest, settings)


def may_be_a_fix(opponents: Opponents, allowed: float, settings: Decision) -> bool:
    """Return whether the best place would be a fix without any opponent."""
    return risk_against(opponents, 0.0, settings) <= allowed


def verdict(opponents: Opponents, rivals: int, allowed: float, settings: Decision) -> tuple[Status, Sentence | None]:
    """Return whether the evidence is enough for a fix, and why not.

    Args:
        opponents: The best place and what it is compared with.
        rivals: How many other places are too near to the best one.
        allowed: Risk below which it is a fix.
    """
    risk = risk_of_best(opponents, settings)
    if risk <= allowed:
        return Status.FIX, None
    if not may_be_a_fix(opponents, allowed, settings):
        log_odds = opponents.log_odds
        return Status.NO_MATCH, Sentence(
            "The best place (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; at most {allowed:.2g} "
            "is allowed.",
            log_odds=log_odds,
            risk=risk,
            allowed=allowed,
        )
    if rivals and risk_against(opponents, opponents.mirror, settings) <= MORE_LIKELY_WRONG:
        return Status.AMBIGUOUS, Sentence(
            "{count} other place fits almost as well as the best one."
            if rivals == 1
            else "{count} other places fit almost as well as the best one.",
            count=rivals,
        )
    return Status.NO_MATCH, Sentence("The mirrored image fits almost as well, so the pattern is too regular.")
