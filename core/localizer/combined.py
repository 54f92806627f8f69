"""METHOD 0: two roads to one fix, constellation and map correlation, each checked by the other's evidence.

Told in docs/explanation/method.md#automatic.

Centers of gravity and class areas fail for different reasons, so that one road's place is hardly ever the other's by
chance. A constellation's fix stands unless class areas speak against it. The opposite is no test: where labels are poor
landmarks do not come out whole, and they disagree at right places as at wrong ones.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..localization import MORE_LIKELY_WRONG, Localization, Place, Prior, Status, log_odds_of, risk_of
from ..sentences import Sentence
from .settings import LOCALIZER, LocalizerSettings


def checked_by_areas(
    found: Localization, agreement: float | None, settings: LocalizerSettings = LOCALIZER
) -> Localization:
    """Return the constellation's place, judged by class areas there as well: they may speak against a fix, or make one.

    Where landmarks are, the constellation searched; how well class areas agree there, nobody searched for, so that it
    is evidence of its own (``agreement_curve``).

    Args:
        found: Of the constellation.
        agreement: Correlation of class areas at its best place; None where they can't tell.
        settings: What agreement is worth, and the risk that is allowed.
    """
    if agreement is None or found.risk is None:
        return found
    risk = risk_of(log_odds_of(found.risk) + worth_of(agreement, settings))
    found = replace(found, risk=risk)
    if found.is_fix and risk > settings.allowed_risk:
        reason = Sentence(
            "Landmarks match one place, but class areas there only by {agreement:.2f}: error probability {risk:.2g}; "
            "at most {allowed:.2g} is allowed.",
            agreement=agreement,
            risk=risk,
            allowed=settings.allowed_risk,
        )
        status = Status.NO_MATCH if risk > MORE_LIKELY_WRONG else Status.AMBIGUOUS
        places = () if found.best is None or status is Status.NO_MATCH else (found.best,)
        return replace(found, status=status, reason=reason, confidence=None, is_doubted=True, alternatives=places)
    return _as_fix(found, risk) if found.is_fix or found.is_doubted and risk <= settings.allowed_risk else found


def worth_of(agreement: float, settings: LocalizerSettings = LOCALIZER) -> float:
    """Return what a correlation of class areas is worth: logarithm of the likelihood ratio of right places against wrong ones.

    Args:
        agreement: Correlation, −1 to 1.
        settings: Offset and slope a unit of Fisher's z, least and most.
    """
    offset, slope, least, most = settings.agreement_curve
    return float(np.clip(offset + slope * np.arctanh(np.clip(agreement, -0.999, 0.999)), least, most))


def agreed(
    objects: Localization, areas: Localization, shorter_edge_px: int, settings: LocalizerSettings = LOCALIZER
) -> Localization | None:
    """Return the fix of two roads that searched the whole map on their own and found the same place; else None.

    Args:
        objects: Of the constellation, without class areas.
        areas: Of map correlation.
        settings: How near is the same place, and the risk that is allowed.
    """
    if objects.best is None or areas.best is None or objects.risk is None or areas.risk is None:
        return None
    if not (objects.is_doubted or areas.is_doubted or areas.is_fix) or not _same(
        objects.best, areas, shorter_edge_px, settings
    ):
        return None
    risk = risk_of(log_odds_of(objects.risk) + log_odds_of(areas.risk))
    if risk > settings.allowed_risk:
        return None
    exact = objects if objects.is_doubted else replace(areas, references=objects.references)
    fix = _as_fix(exact, risk)
    return replace(fix, reason=fix.reason or (areas.reason if areas.is_fix else None), peaks=areas.peaks)


def _as_fix(found: Localization, risk: float) -> Localization:
    """Return a place as a fix with the risk that all evidence together leaves; what a fix was said not to hold for stays."""
    said = found.reason if found.is_fix else None
    return replace(
        found, status=Status.FIX, reason=said, confidence=1 - risk, risk=risk, is_doubted=False, alternatives=()
    )


def _same(place: Place, areas: Localization, shorter_edge_px: int, settings: LocalizerSettings) -> bool:
    """Return whether a place is that of map correlation, as exactly as that is known."""
    if areas.best is None:
        return False
    heading_deg, pixel_size = place.oriented
    other_deg, other_size = areas.best.oriented
    reach = max(settings.near_errors * (areas.error_95_m or 0.0), settings.near_share * shorter_edge_px * other_size)
    turned = abs((heading_deg - other_deg + 180) % 360 - 180)
    ratio = max(pixel_size / other_size, other_size / pixel_size)
    apart = float(np.hypot(*np.subtract(place.position, areas.best.position)))
    return apart <= reach and turned <= settings.near_heading_deg and ratio <= settings.near_ratio


def near(fix: Localization, prior: Prior, shorter_edge_px: int, settings: LocalizerSettings = LOCALIZER) -> Prior:
    """Return what the constellation looks for to confirm map correlation's fix: the same pose, as exactly as that is known.

    Args:
        fix: Of map correlation.
        prior: What is known of the image besides.

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
    """Return the fix at the constellation's finer pose, when that is map correlation's too; else None.

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
    if areas.risk is None:
        return None
    exactness = objects if objects.is_fix else areas
    # Searched for at that place alone, landmarks are no evidence of their own: the risk stays map correlation's.
    fix = _as_fix(objects, areas.risk)
    return replace(
        fix,
        reason=fix.reason or areas.reason,
        error_95_m=exactness.error_95_m,
        covariance=exactness.covariance,
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
        reason=Sentence(
            "{constellation} Map correlation has no fix either: {correlation:clause}",
            constellation=objects.reason,
            correlation=areas.reason,
        ),
        alternatives=objects.alternatives + others,
        peaks=areas.peaks,
    )


def _within(place: Place, prior: Prior) -> bool:
    """Return whether a place is as near to the expected position as a prior says."""
    if prior.position is None or prior.radius is None:
        return True
    return bool(np.hypot(*np.subtract(place.position, prior.position)) <= prior.radius)


def saying_what_was_searched(
    found: Localization, reason: Sentence, sizes: tuple[float, float], prior: Prior
) -> Localization:
    """Return the result, its reason with the pixel sizes, headings and ground that were searched in vain."""
    headings, ground = Sentence("all headings"), Sentence("the whole map")
    if prior.heading_deg is not None and prior.heading_range_deg < 180:
        spread, heading = prior.heading_range_deg, prior.heading_deg % 360
        headings = Sentence("headings within {spread:g}° of {heading:g}°", spread=spread, heading=heading)
    if prior.position is not None and prior.radius is not None:
        x, y = prior.position
        ground = Sentence("the ground within {radius:g} of {x:.0f}, {y:.0f}", radius=prior.radius, x=x, y=y)
    return replace(
        found,
        reason=Sentence(
            "{reason} Searched: {smallest:.3g}–{largest:.3g} map units a pixel, {headings}, {ground}.",
            reason=reason,
            smallest=sizes[0],
            largest=sizes[1],
            headings=headings,
            ground=ground,
        ),
    )
