"""METHOD 0: two roads to one fix, constellation and map correlation, each checked by the other's evidence.

Told in docs/method.md#automatic.

Centers of gravity and class areas fail for different reasons, so that one road's place is hardly ever the other's by
chance. A constellation's fix stands unless class areas speak against it. The opposite is no test: where labels are poor
landmarks do not come out whole, and they disagree at right places as at wrong ones.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..localization import Localization, Place, Prior, Status
from ..sentences import Sentence
from .settings import LOCALIZER, LocalizerSettings


def checked_by_areas(
    fix: Localization, agreement: float | None, settings: LocalizerSettings = LOCALIZER
) -> Localization:
    """A constellation's fix, or why it is none; a fix that class areas speak against is an alternative.

    Args:
        fix: Of the constellation.
        agreement: Correlation of class areas there; None where they can't tell.
        settings: The least agreement.
    """
    if agreement is None or agreement >= settings.least_agreement:
        return fix
    return Localization(
        Status.AMBIGUOUS,
        fix.method,
        fix.references,
        Sentence("localization.areas_speak_against", agreement=agreement, least=settings.least_agreement),
        alternatives=() if fix.best is None else (fix.best,),
        search_capped=fix.search_capped,
    )


def near(fix: Localization, prior: Prior, shorter_edge_px: int, settings: LocalizerSettings = LOCALIZER) -> Prior:
    """What the constellation looks for to confirm map correlation's fix: the same pose, as exactly as that is known.

    Args:
        fix: Of map correlation.
        prior: What is known of the image besides.
        shorter_edge_px: Of the image.
        settings: How near is near.

    Raises:
        ValueError: There is no fix.
    """
    if fix.place is None:
        raise ValueError("map correlation has no fix to confirm")
    heading_deg, pixel_size = fix.place.oriented
    radius = max(settings.near_errors * (fix.error_95_m or 0.0), settings.near_share * shorter_edge_px * pixel_size)
    sizes = pixel_size / settings.near_ratio, pixel_size * settings.near_ratio
    return replace(
        prior,
        position=fix.place.position,
        radius=radius,
        heading_deg=heading_deg,
        heading_range_deg=settings.near_heading_deg,
        pixel_size_range=sizes,
    )


def confirmed(areas: Localization, objects: Localization, closer: Prior) -> Localization | None:
    """The fix at the constellation's finer pose, when that is map correlation's too; else None.

    Where several places are alike for the constellation, map correlation may tell which it is.

    Args:
        areas: A fix of map correlation.
        objects: What the constellation found with the prior ``closer``.
        closer: Of ``near``.
    """
    places = objects.alternatives if objects.place is None else (objects.place,)
    here = [_within(place, closer) for place in places]
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
    """One result with both reasons where neither method has a fix.

    A place that both found is told once, as the constellation has it.

    Args:
        objects: Of the constellation.
        areas: Of map correlation.
        shorter_edge_px: Of the image.
        settings: How near two places are the same.
    """
    known = [place.position for place in objects.alternatives]
    others = tuple(
        place
        for place in areas.alternatives
        if all(
            np.hypot(*np.subtract(place.position, other)) > settings.near_share * shorter_edge_px * place.oriented[1]
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


def _within(place: Place, prior: Prior) -> bool:
    """Whether a place is as near to the expected position as a prior says."""
    if prior.position is None or prior.radius is None:
        return True
    return bool(np.hypot(*np.subtract(place.position, prior.position)) <= prior.radius)
