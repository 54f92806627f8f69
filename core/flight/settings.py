"""Settings of flights, which calibration can change.

In brackets: the data that a value was set on, and the trials that set it or used it, by their names in
docs/reference/settings.md.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..localization import RISK


@dataclass(frozen=True)
class FlightSettings:
    """Settings of the joint localization of a flight (docs/explanation/method.md#flights).

    Attributes:
        allowed_risk: Maximum error probability of a reported track [what a navigator asks].
        candidates: Best places of the first images by themselves, at which hypotheses begin [by hand, for the time;
            flights].
        added: Best places of later images, while the pool has hypotheses already [by hand, for the time; flights].
        hypotheses: Most hypotheses at a time [by hand, for the time; flights].
        window: Images with joint evidence: limits memory, and lets a wrong track end [by hand; flights].
        nulls: Random places that show what chance gives for an image [by hand, for the time].
        evidence_curve: Logarithm of the likelihood ratio of an image's agreement at an expected place: offset, slope
            per standard deviation of chance, least, most [by hand; flights].
        risk_curve: Logarithm of the odds that a track is right, from its lead over the strongest opponent: offset,
            slope. With −1 and 1.6, two of five likely tracks of photos were wrong [photo flights; flights].
        lost_evidence: A track ends if the evidence of its last images is below this [by hand; flights].
        recent: Number of these last images [by hand; flights].
        search_noise: Standard deviations of a refined place of the first look: its pixels, degrees, ln pixel size [by
            hand; flights].
        start_noise: Standard deviations of a track's first place before it is measured, in the same units. A hypothesis
            is known to one pixel of the first look after any number of looks [reasoning; flights].
        map_length: Distance along the track over which errors of map and labels correlate, meters [shared errors].
        shared_share: Share of a measurement's variance that its neighbors have in common, unless map and classes have
            more [by hand; flights].
        comparisons: Number of independent parts in an image's agreement; it separates places near each other. Most
            likely: 83 at 320 m, 215 at 640 m, flat from 80 on [flight measurements].
        least_score: An image with less agreement at its expected place is not measured there. With 0.2, 7 of 228
            positions over Andorra on a map that was seven years older were wrong; with 0.25, none [other flights].
        least_trusted: Least share of the slopes' information that is not taken for noise in a measurement; smaller
            than for single images, because images that get no position by themselves are measured, too. With 0.1 the
            95 % ellipses of these flights contained 70 %, with 0.03 95 % [other flights].
    """

    allowed_risk: float = RISK
    candidates: int = 200
    added: int = 40
    hypotheses: int = 160
    window: int = 10
    nulls: int = 100
    evidence_curve: tuple[float, float, float, float] = (-2.0, 1.2, -2.0, 10.0)
    risk_curve: tuple[float, float] = (-2.4, 1.8)
    lost_evidence: float = -3.0
    recent: int = 5
    search_noise: tuple[float, float, float] = (0.4, 2.5, 0.04)
    start_noise: tuple[float, float, float] = (1.0, 5.0, 0.08)
    map_length: float = 800.0
    shared_share: float = 0.4
    comparisons: float = 80.0
    least_score: float = 0.25
    least_trusted: float = 0.03


FLIGHT = FlightSettings()
"""Calibrated settings: the default of every flight."""
