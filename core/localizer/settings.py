"""What was chosen for the localizer: of each solver, and of the two together.

In brackets: the data that a value was set on, and the trials that set it or used it, by their names in
docs/reference/settings.md.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..constellation.settings import ConstellationSettings
from ..correlation.settings import CorrelationSettings
from ..geometry.error_settings import ErrorSettings
from ..localization import RISK


@dataclass(frozen=True)
class LocalizerSettings:
    """Settings of a localizer; those beside the solvers' own are METHOD 0's (docs/explanation/method.md#automatic).

    Attributes:
        constellation: Of the constellation [the table above].
        correlation: Of map correlation [the table above].
        allowed_risk: Probability of being wrong up to which a place is a fix: RISK of *Localize images* [what a
            navigator asks].
        agreement_curve: What the correlation of class areas at the constellation's place is worth, ln of the
            likelihood ratio of right against wrong places: offset, slope a unit of Fisher's z, least, most
            [Liechtenstein, north; probability].
        near_errors: Poses of both roads are the same when they differ in position by at most this many times map
            correlation's 95 % radius … [Liechtenstein, north; automatic, north, with evidence]
        near_share: … or this share of the image's ground, if that is more [what counts as right; automatic, north, with
            evidence].
        near_heading_deg: The same of heading, degrees [Liechtenstein, north; automatic, north, with evidence].
        near_ratio: The same of pixel size, as a ratio [Liechtenstein, north; automatic, north, with evidence].
        errors: Of how exactly a place is known [the table below].
    """

    constellation: ConstellationSettings = ConstellationSettings()
    correlation: CorrelationSettings = CorrelationSettings()
    allowed_risk: float = RISK
    agreement_curve: tuple[float, float, float, float] = (-25.0, 50.0, -30.0, 4.0)
    near_errors: float = 1.25
    near_share: float = 0.02
    near_heading_deg: float = 5.0
    near_ratio: float = 1.05
    errors: ErrorSettings = ErrorSettings()


LOCALIZER = LocalizerSettings()
"""Calibrated settings, the default of every localization."""
