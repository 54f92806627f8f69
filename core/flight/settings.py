"""What was chosen for flights, and may be chosen otherwise to calibrate them.

In brackets: the data that a value was set on, and the trials that set it or used it, by their names in
docs/reference/settings.md.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..localization import RISK


@dataclass(frozen=True)
class FlightSettings:
    """Settings of the joint answer of a flight (docs/explanation/method.md#flights).

    Attributes:
        allowed_risk: Error probability up to which a track is reported [what a navigator asks].
        candidates: Best places of an image by itself that hypotheses start from [by hand, for the time; flights].
        added: The same of later images, where others are held already [by hand, for the time; flights].
        hypotheses: That are held at a time [by hand, for the time; flights].
        window: Images whose evidence counts together: bounds memory, and lets a track that fails be lost [by hand;
            flights].
        nulls: Random places that tell what chance gives for an image [by hand, for the time].
        evidence_curve: What an image's agreement at an expected place is worth, ln of the likelihood ratio: offset,
            slope a deviation of what chance gives, least, most [by hand; flights].
        risk_curve: ln of the odds that a track is right, from its lead over the strongest opponent: offset, slope [by
            hand; flights].
        lost_evidence: A track whose last images' evidence falls below is lost [by hand; flights].
        recent: Images that this counts [by hand; flights].
        search_noise: Of a refined place of the first look: deviation in its pixels, degrees, ln pixel size [by hand;
            flights].
        start_noise: Of a track's first place before it is measured, in the same units: a hypothesis is known to a pixel
            of the first look, however often that has looked [reasoning; flights].
        map_length: Length over which errors of the map and of labels on it are shared along the track, meters [shared
            errors].
        shared_share: Share of a measurement's variance that its neighbors have alike [by hand; flights].
        measured_factor: What deviations of class areas' fits are multiplied with – a single image's have room for one
            that is not known to be near its place –, the edge on the ground in meters that this holds from, and the
            power that they grow with below. Errors over deviations that are not multiplied, 95 %: 2.51 at 320 m, 1.79
            at 450 m, 1.52 at 640 m; 2.45 would be right [flight measurements].
        comparisons: Independent parts that an image's agreement is worth; it separates places near each other.
            Likeliest: 83 at 320 m, 215 at 640 m, flat from 80 on [flight measurements].
        least_score: An image that agrees less with the map where it is expected measures nothing there [flight
            measurements].
    """

    allowed_risk: float = RISK
    candidates: int = 200
    added: int = 40
    hypotheses: int = 160
    window: int = 10
    nulls: int = 100
    evidence_curve: tuple[float, float, float, float] = (-2.0, 1.2, -2.0, 10.0)
    risk_curve: tuple[float, float] = (-1.0, 1.6)
    lost_evidence: float = -3.0
    recent: int = 5
    search_noise: tuple[float, float, float] = (0.4, 2.5, 0.04)
    start_noise: tuple[float, float, float] = (1.0, 5.0, 0.08)
    map_length: float = 800.0
    shared_share: float = 0.4
    measured_factor: tuple[float, float, float] = (0.6, 640.0, 0.7)
    comparisons: float = 80.0
    least_score: float = 0.2


FLIGHT = FlightSettings()
"""As calibrated: the default of every flight."""
