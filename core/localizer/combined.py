"""Method *Automatic*: constellation and map correlation, each checked with the other's evidence.

See docs/explanation/method.md#automatic.

Centers of gravity and class areas fail for different reasons, so both methods rarely find the same wrong position by
chance. A position of the constellation is kept unless class areas contradict it. The opposite is no test: with poor
labels landmarks are not complete, and they disagree at right positions as well as at wrong ones.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..correlation.decision import worth_of_outlines
from ..localization import (
    LIKELY_RISK,
    MORE_LIKELY_WRONG,
    Localization,
    Place,
    Prior,
    Status,
    log_odds_of,
    only_likely,
    risk_of,
)
from ..sentences import Sentence
from .settings import LOCALIZER, LocalizerSettings


def check_by_areas(
    found: Localization, agreement: float | None, settings: LocalizerSettings = LOCALIZER
) -> Localization:
    """Check the constellation's candidate with class areas, which may reject a fix or make it one.

    The constellation searched for agreeing landmarks; nothing searched for agreeing class areas at its candidate, so
    they are independent evidence (``agreement_curve``).

    Args:
        found: Of the constellation.
        agreement: Correlation of class areas at its best candidate; None if unknown.
    """
    if agreement is None or found.risk is None:
        return found
    risk = risk_of(log_odds_of(found.risk) + worth_of(agreement, settings))
    found = replace(found, risk=risk)
    if found.is_fix and risk > settings.allowed_risk:
        reason = Sentence(
            "Landmarks match at one position, but class areas agree too little there (correlation {agreement:.2f}): "
            "the error probability is {risk:.2g}; at most {allowed:.2g} is allowed.",
            agreement=agreement,
            risk=risk,
            allowed=settings.allowed_risk,
        )
        return _doubted(found, reason, risk)
    return _as_fix(found, risk) if found.is_fix or found.is_doubted and risk <= settings.allowed_risk else found


def worth_of(agreement: float, settings: LocalizerSettings = LOCALIZER) -> float:
    """Return ln of the likelihood ratio of right against wrong candidates for a correlation of class areas.

    Args:
        agreement: Correlation, −1 to 1.
        settings: Offset and slope per unit of Fisher's z, minimum and maximum.
    """
    offset, slope, least, most = settings.agreement_curve
    return float(np.clip(offset + slope * np.arctanh(np.clip(agreement, -0.999, 0.999)), least, most))


def combine_agreeing(
    objects: Localization, areas: Localization, shorter_edge_px: int, settings: LocalizerSettings = LOCALIZER
) -> Localization | None:
    """Return the fix of two methods that searched the whole map independently and found the same position, or None.

    Two wrong positions are rarely the same one, so agreement is evidence of its own (``agreement_worth``).

    Args:
        objects: Of the constellation, without class areas.
        areas: Of map correlation.
    """
    risk = _risk_of_agreement(objects, areas, shorter_edge_px, settings)
    if risk is None or risk > settings.allowed_risk:
        return None
    fix = _as_fix(objects if objects.is_doubted else replace(areas, references=objects.references), risk)
    return replace(fix, reason=fix.reason or (areas.reason if areas.is_fix else None), peaks=areas.peaks)


def _risk_of_agreement(
    objects: Localization, areas: Localization, shorter_edge_px: int, settings: LocalizerSettings
) -> float | None:
    """Return the error probability of a position that both methods found; None if they did not."""
    if objects.best is None or objects.risk is None or areas.risk is None:
        return None
    if not (objects.is_doubted or areas.is_doubted or areas.is_fix):
        return None
    if not _same(objects.best, areas, shorter_edge_px, settings):
        return None
    return risk_of(log_odds_of(objects.risk) + log_odds_of(areas.risk) + settings.agreement_worth)


def confirm_by_earlier(
    found: Localization, earlier: Localization, shorter_edge_px: int, settings: LocalizerSettings = LOCALIZER
) -> Localization:
    """Return a result with the evidence of an earlier look at the same photo, whose labels have other errors.

    Wrong places differ between the looks more often than right ones, so the same place is evidence (``looks_curve``).
    Another place is none: the later labels are better. The photo's edges are the same in both and count once.

    Args:
        found: From labels averaged over all orientations, not yet shown as likely.
        earlier: From the labels of one orientation, without a fix.
    """
    if earlier.risk is None or found.risk is None or found.best is None:
        return found
    if not earlier.is_doubted or not (found.is_fix or found.is_doubted):
        return found
    # The radii of two looks at one photo say nothing about their distance.
    if not _same(found.best, replace(earlier, error_95_m=None), shorter_edge_px, settings):
        return found
    offset, slope = settings.looks_curve
    alone, before = log_odds_of(found.risk), log_odds_of(earlier.risk)
    edges, edges_before = (
        0.0 if one.peaks is None else worth_of_outlines(one.peaks.outlines, settings.correlation)
        for one in (found, earlier)
    )
    risk = risk_of(max(alone, offset + slope * (alone - edges + before - edges_before) + edges))
    return _as_fix(found, risk) if risk <= settings.allowed_risk else replace(found, risk=risk)


def _doubted(found: Localization, reason: Sentence, risk: float) -> Localization:
    """Return a fix as a candidate with an error probability that is not allowed."""
    status = Status.NO_MATCH if risk > MORE_LIKELY_WRONG else Status.AMBIGUOUS
    places = () if found.best is None or status is Status.NO_MATCH else (found.best,)
    return replace(
        found, status=status, reason=reason, confidence=None, risk=risk, is_doubted=True, alternatives=places
    )


def _as_fix(found: Localization, risk: float) -> Localization:
    """Return a candidate as a fix with an error probability; a remark about a part of the image is kept."""
    remark = found.reason if found.is_fix else None
    return replace(
        found, status=Status.FIX, reason=remark, confidence=1 - risk, risk=risk, is_doubted=False, alternatives=()
    )


def _same(place: Place, areas: Localization, shorter_edge_px: int, settings: LocalizerSettings) -> bool:
    """Return whether a candidate is that of map correlation, within its uncertainty."""
    if areas.best is None:
        return False
    heading_deg, pixel_size = place.oriented
    other_deg, other_size = areas.best.oriented
    reach = max(settings.near_errors * (areas.error_95_m or 0.0), settings.near_share * shorter_edge_px * other_size)
    turned = abs((heading_deg - other_deg + 180) % 360 - 180)
    ratio = max(pixel_size / other_size, other_size / pixel_size)
    apart = float(np.hypot(*np.subtract(place.position, areas.best.position)))
    return apart <= reach and turned <= settings.near_heading_deg and ratio <= settings.near_ratio


def prior_near(fix: Localization, prior: Prior, shorter_edge_px: int, settings: LocalizerSettings = LOCALIZER) -> Prior:
    """Return the prior with which the constellation can confirm map correlation's fix: its pose and uncertainty.

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


def confirm(areas: Localization, objects: Localization, closer: Prior) -> Localization | None:
    """Return map correlation's fix with the constellation's finer pose if both agree, or None.

    If several candidates are equal for the constellation, map correlation may select one of them.

    Args:
        areas: A fix of map correlation.
        objects: Result of the constellation with the prior ``closer``.
        closer: Result of ``prior_near``.
    """
    places = objects.alternatives if objects.place is None else (objects.place,)
    here = [_within(place, closer) for place in places]
    if not any(here[:1]) or any(here[1:]) or not objects.is_fix and len(here) < 2:
        return None
    if areas.risk is None:
        return None
    exactness = objects if objects.is_fix else areas
    # The constellation searched there only, so landmarks are no independent evidence: the error probability stays.
    fix = _as_fix(objects, areas.risk)
    return replace(
        fix,
        reason=fix.reason or areas.reason,
        error_95_m=exactness.error_95_m,
        covariance=exactness.covariance,
        peaks=areas.peaks,
    )


def combine_without_fix(
    objects: Localization, areas: Localization, shorter_edge_px: int, settings: LocalizerSettings = LOCALIZER
) -> Localization:
    """Return one result with both reasons if neither method has a fix: the more probable candidate.

    A candidate that both methods found is listed once, as the constellation found it. Of two different candidates at
    most one is right, so each makes the other less probable.

    Args:
        objects: Of the constellation.
        areas: Of map correlation.
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
    risk, best = _risk_of_agreement(objects, areas, shorter_edge_px, settings), objects
    if risk is None:
        other, best = sorted((areas, objects), key=_odds)
        risk = (1 + _odds(other)) / (1 + _odds(other) + _odds(best)) if best.is_doubted else best.risk
    best = best if best.is_doubted or not areas.is_doubted else areas
    return replace(
        best,
        references=objects.references,
        risk=risk,
        status=Status.AMBIGUOUS if areas.status is Status.AMBIGUOUS else objects.status,
        reason=Sentence(
            "{constellation} Map correlation found no position either: {correlation:clause}",
            constellation=objects.reason,
            correlation=areas.reason,
        ),
        alternatives=objects.alternatives + others,
        peaks=areas.peaks,
    )


def share_on_map(prior: Prior, extent: tuple[float, float, float, float]) -> float:
    """Return the share of the search area, a square, that is on the map; 1 if it contains the whole map.

    Args:
        extent: Of the map (x_min, y_min, x_max, y_max).
    """
    if prior.position is None or not prior.radius:
        return 1.0
    (x, y), radius = prior.position, prior.radius
    x_min, y_min, x_max, y_max = extent
    width = max(min(x + radius, x_max) - max(x - radius, x_min), 0.0)
    height = max(min(y + radius, y_max) - max(y - radius, y_min), 0.0)
    return width * height / min((2 * radius) ** 2, (x_max - x_min) * (y_max - y_min))


def doubt_outside(found: Localization, on_map: float, settings: LocalizerSettings = LOCALIZER) -> Localization:
    """Return a candidate with the probability that the true place is in the part of the search area outside the map.

    The methods compare places on the map only, as if the true one were among them.

    Args:
        found: Not yet shown as likely.
        on_map: Share of the search area on the map; from a half on, it makes no candidate less probable.
    """
    if found.risk is None or on_map >= 0.5:
        return found
    risk = risk_of(log_odds_of(found.risk) + float(np.log(on_map / (1 - on_map))) if on_map > 0 else -np.inf)
    if not found.is_fix:
        return replace(found, risk=risk)
    if risk <= settings.allowed_risk:
        return _as_fix(found, risk)
    reason = Sentence(
        "The position can be wrong, because most of the search area is outside the map: the error probability is "
        "{risk:.2g}; at most {allowed:.2g} is allowed.",
        risk=risk,
        allowed=settings.allowed_risk,
    )
    return _doubted(found, reason, risk)


def show_likely(found: Localization, settings: LocalizerSettings = LOCALIZER) -> Localization:
    """Return a candidate as a likely position if only its error probability, at most LIKELY_RISK, prevents a fix."""
    if not found.is_doubted or found.risk is None or found.risk > LIKELY_RISK:
        return found
    reason = only_likely(found.risk, settings.allowed_risk)
    return replace(found, status=Status.LIKELY, reason=reason, confidence=1 - found.risk, alternatives=())


def _odds(found: Localization) -> float:
    """Return the odds that a doubted candidate is right; 0 for others."""
    return float(np.exp(log_odds_of(found.risk))) if found.is_doubted and found.risk is not None else 0.0


def _within(place: Place, prior: Prior) -> bool:
    """Return whether a candidate is within the search radius of a prior."""
    if prior.position is None or prior.radius is None:
        return True
    return bool(np.hypot(*np.subtract(place.position, prior.position)) <= prior.radius)


def with_search_range(found: Localization, reason: Sentence, sizes: tuple[float, float], prior: Prior) -> Localization:
    """Return the result with a reason that states the searched pixel sizes, headings and area."""
    headings, ground = Sentence("all headings"), Sentence("the whole map")
    if prior.heading_deg is not None and prior.heading_range_deg < 180:
        spread, heading = prior.heading_range_deg, prior.heading_deg % 360
        headings = Sentence("headings within {spread:g}° of {heading:g}°", spread=spread, heading=heading)
    if prior.position is not None and prior.radius is not None:
        x, y = prior.position
        ground = Sentence("the ground within {radius:g} m of {x:.0f}, {y:.0f}", radius=prior.radius, x=x, y=y)
    return replace(
        found,
        reason=Sentence(
            "{reason} Searched: pixel sizes {smallest:.3g}–{largest:.3g} m, {headings}, {ground}.",
            reason=reason,
            smallest=sizes[0],
            largest=sizes[1],
            headings=headings,
            ground=ground,
        ),
    )
