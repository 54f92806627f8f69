"""Settings of the localizer: of each method, and of their combination.

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
    """Settings of a localizer; most of its own are for *Automatic* (docs/explanation/method.md#automatic).

    Attributes:
        constellation: Of the constellation [the table above].
        correlation: Of map correlation [the table above].
        allowed_risk: Maximum error probability of a position: RISK of *Localize images* [a navigator's
            requirement].
        agreement_curve: Weight of the correlation of class areas at the constellation's candidate, ln of the
            likelihood ratio of right against wrong candidates: offset, slope per unit of Fisher's z, minimum, maximum
            [Liechtenstein, north; probability].
        agreement_worth: Additional log odds of a position that both methods found independently. Of 179 such positions
            all were right, also 20 with an error probability above 0.5 by the constellation [photos of Uganda,
            parts of Liechtenstein; probability on photos].
        looks_curve: Log odds of a position at which two looks at a photo agree, as offset and slope of the sum of both.
            The errors of the looks are not independent. A logistic curve has 2.3 and 0.67. The offset is lower because
            all its photos show ground of the map, and with 1.8 three more positions in Dubai were 13 to 34 m off, all
            at the right place [photos, Dubai; two looks].
        near_errors: Largest distance between the positions of both methods for equal poses, in 95 % radii of map
            correlation [Liechtenstein, north; automatic, north, with evidence].
        near_share: Smallest limit of that distance, as a share of the image's ground [the definition of a right
            position; automatic, north, with evidence].
        near_heading_deg: The same for heading, degrees [Liechtenstein, north; automatic, north, with evidence].
        near_ratio: The same for pixel size, as a ratio [Liechtenstein, north; automatic, north, with evidence].
        errors: Of the uncertainty of a position [the table below].
    """

    constellation: ConstellationSettings = ConstellationSettings()
    correlation: CorrelationSettings = CorrelationSettings()
    allowed_risk: float = RISK
    agreement_curve: tuple[float, float, float, float] = (-25.0, 50.0, -30.0, 4.0)
    agreement_worth: float = 4.0
    looks_curve: tuple[float, float] = (0.6, 0.67)
    near_errors: float = 1.25
    near_share: float = 0.02
    near_heading_deg: float = 5.0
    near_ratio: float = 1.05
    errors: ErrorSettings = ErrorSettings()


LOCALIZER = LocalizerSettings()
"""Calibrated settings, the default of every localization."""
