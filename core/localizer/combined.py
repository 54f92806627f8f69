"""METHOD 0: two roads to one fix, constellation and map correlation, each checked by the other's evidence.

Told in docs/method.md#automatic.

Centers of gravity and class areas fail for different reasons, so that one road's place is hardly ever the other's by
chance. A constellation's fix stands unless class areas speak against it. The opposite is no test: where labels are poor
landmarks do not come out whole, and they disagree at right places as at wrong ones.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Optional

import numpy as np

from ..localization import Localization, Prior, Status
from ..sentences import Sentence
from .settings import LOCALIZER, LocalizerSettings


def checked_by_areas(
    fix: Localization, agreement: Optional[float], settings: LocalizerSettings = LOCALIZER
) -> Localization:
    """A constellation's fix, or why it is none; ``agreement``: correlation of class areas there, None: can't tell.

    A fix that class areas speak against is an alternative.
    """
    if agreement is None or agreement >= settings.least_agreement:
        return fix
    return Localization(
        Status.AMBIGUOUS,
        fix.method,
        fix.references,
        Sentence("localization.areas_speak_against", agreement=agreement, least=settings.least_agreement),
        alternatives=(fix.best,),
        search_capped=fix.search_capped,
    )


def near(fix: Localization, prior: Prior, shorter_edge_px: int, settings: LocalizerSettings = LOCALIZER) -> Prior:
    """What the constellation looks for to confirm map correlation's fix: the same pose, as exactly as that is known."""
    radius = max(settings.near_errors * fix.error_95_m, settings.near_share * shorter_edge_px * fix.pixel_size_m)
    sizes = fix.pixel_size_m / settings.near_ratio, fix.pixel_size_m * settings.near_ratio
    return replace(
        prior,
        position=fix.position,
        radius=radius,
        heading_deg=fix.heading_deg,
        heading_range_deg=settings.near_heading_deg,
        pixel_size_range=sizes,
    )


def confirmed(areas: Localization, objects: Localization, radius: float) -> Optional[Localization]:
    """The fix at the constellation's finer pose, when that is map correlation's too; else None.

    ``areas``: a fix of map correlation; ``objects``: what the constellation found ``near`` it, ``radius`` around. Where
    several places are alike for the constellation, map correlation may tell which it is.
    """
    places = [objects.best] if objects.is_fix else list(objects.alternatives)
    here = [np.hypot(*np.subtract(place.position, areas.position)) <= radius for place in places]
    if not any(here[:1]) or any(here[1:]) or not objects.is_fix and len(here) < 2:
        return None
    exactness = objects if objects.is_fix else areas
    return replace(
        objects,
        status=Status.FIX,
        reason=None,
        # Both would have to be wrong.
        confidence=1 - (1 - areas.confidence) * (1 - objects.confidence),
        error_95_m=exactness.error_95_m,
        covariance=exactness.covariance,
        alternatives=(),
        peaks=areas.peaks,
    )


def neither(
    objects: Localization, areas: Localization, shorter_edge_px: int, settings: LocalizerSettings = LOCALIZER
) -> Localization:
    """No fix by the constellation (``objects``) nor by map correlation (``areas``): one result with both reasons.

    A place that both found is told once, as the constellation has it.
    """
    known = [place.position for place in objects.alternatives]
    others = tuple(
        place
        for place in areas.alternatives
        if all(
            np.hypot(*np.subtract(place.position, other)) > settings.near_share * shorter_edge_px * place.pixel_size_m
            for other in known
        )
    )
    return replace(
        objects,
        status=Status.AMBIGUOUS if areas.status is Status.AMBIGUOUS else objects.status,
        reason=Sentence("localization.neither_road", constellation=objects.reason, correlation=areas.reason),
        alternatives=objects.alternatives + others,
        peaks=areas.peaks,
    )
