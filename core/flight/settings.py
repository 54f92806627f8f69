"""What was chosen for flights.

In brackets: what a value was set on; the trials that set it or ran with it, by the name under which docs/calibration.md
has their command.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..localization import RISK


@dataclass(frozen=True)
class FlightSettings:
    """Settings of the joint answer of a flight (docs/method.md#flights).

    Attributes:
        allowed_risk: Probability of being wrong up to which a track is told [what a navigator asks].
        candidates: Best places of an image by itself that hypotheses start from [by hand, for the time; flights].
        added: The same of later images, where others are held already [by hand, for the time; flights].
        hypotheses: That are held at a time [by hand, for the time; flights].
        window: Images whose evidence counts together: bounds memory, and lets a track that fails be lost
            [by hand; flights].
        nulls: Random places that tell what chance gives for an image [by hand, for the time].
        evidence_curve: What an image's agreement at an expected place is worth, ln of the likelihood ratio: offset,
            slope a deviation of what chance gives, least, most [by hand; flights].
        overlap_share: Least weight of an image that shows hardly new ground [reasoning].
        own_most: Log odds of an image's own best place count up to so much: the flight can outvote it [reasoning].
        risk_curve: ln of the odds that a track is right, from its lead over the strongest opponent: offset, slope
            [by hand; flights].
        lost_evidence: A track whose last images' evidence falls below is lost [by hand; flights].
        recent: Images that this counts [by hand; flights].
        apart: Tracks are different from this share of the image's edge on the ground on [as of map correlation].
        search_first: So many images of a flight are searched on the whole map … [by hand, for the time]
        search_every: … then one of so many before a track is held, and one of so many while one is
            [by hand, for the time].
        search_noise: Of a refined place of the first look: deviation in its pixels, degrees, ln pixel size
            [by hand; flights].
        start_noise: Of a track's first place before it is measured, in the same units: a hypothesis is known to a
            pixel of the first look, however often that has looked [reasoning; flights].
        assumed: Deviations of a link that is assumed: share of the distance, degrees, ln pixel size [reasoning].
        size_range: Ratio to either side that a pixel size is searched in around what is known [reasoning].
        map_length: Length over which errors of the map and of labels on it are shared along the track, meters
            [shared errors].
        shared_share: Share of a measurement's variance that its neighbors have alike [by hand; flights].
        measured_factor: What deviations of class areas' fits are multiplied with – a single image's are told with room
            for one that is not known to be near its place –, the edge on the ground in meters that this holds from,
            and the power that they grow with below [flight measurements].
        comparisons: Independent parts that an image's agreement is worth: tells places near each other apart
            [flight measurements].
        least_score: An image that agrees less with the map where it is expected measures nothing there
            [flight measurements].
        loosest: Measurements whose deviation is more than this share of the image's edge on the ground tell nothing
            [reasoning].
        wrong_share: A pose that is farther off than this share of the image's edge is wrong: the risk of a single one
            [as the benches judge].
        loosest_pose: An image whose 95 % radius is larger than this share of its edge is left without a place
            [reasoning].
        gate: Measurements farther from what the flight expects than so many deviations are outvoted [reasoning].
        drift: Deviation of a flight's constant errors of links: share of the distance along and, in radians, across
            [reasoning].
    """

    allowed_risk: float = RISK
    candidates: int = 200
    added: int = 40
    hypotheses: int = 160
    window: int = 10
    nulls: int = 100
    evidence_curve: tuple[float, float, float, float] = (-2.0, 1.2, -2.0, 10.0)
    overlap_share: float = 0.35
    own_most: float = 12.0
    risk_curve: tuple[float, float] = (-1.0, 1.6)
    lost_evidence: float = -3.0
    recent: int = 5
    apart: float = 0.25
    search_first: int = 4
    search_every: tuple[int, int] = (2, 5)
    search_noise: tuple[float, float, float] = (0.4, 2.5, 0.04)
    start_noise: tuple[float, float, float] = (1.0, 5.0, 0.08)
    assumed: tuple[float, float, float] = (0.4, 20.0, 0.1)
    size_range: float = 1.15
    map_length: float = 800.0
    shared_share: float = 0.4
    measured_factor: tuple[float, float, float] = (0.6, 640.0, 0.7)
    comparisons: float = 80.0
    least_score: float = 0.2
    loosest: float = 0.05
    wrong_share: float = 0.1
    loosest_pose: float = 0.5
    gate: float = 4.0
    drift: float = 0.01


FLIGHT = FlightSettings()
"""As calibrated; what every flight uses that is told nothing else."""
