"""A localization as a row of a table or a line of JSON."""

from __future__ import annotations

from typing import Any, Callable

from ..geometry.pose import PoseCovariance
from ..geometry.shared_errors import AREAS, CLASSES, LANDMARKS, MAP, PIXELS, VIEW
from ..localization import LEAST_RISK, Localization
from ..sentences import Sentence, english


def record(result: Localization, wording: Callable[[Sentence], str] = english) -> dict[str, Any]:
    """Return a localization by the columns of *Localize images* (docs/reference/file_formats.md).

    Args:
        wording: Translates the reason.

    Returns:
        Values by column; None where a method does not find a value.
    """
    x, y = result.position or (None, None)
    best = result.best
    return {
        "status": result.status.key,
        "x": x,
        "y": y,
        "heading": result.heading_deg,
        "pixel_size": result.pixel_size_m,
        "confidence": result.confidence,
        "distance": result.distance,
        "inliers": best and best.inliers,
        "references": result.references,
        "log_odds": best and best.log_odds,
        "error_95": result.error_95_m if result.place else None,
        "window": result.window,
        "method": result.method.key,
        "reason": _reason(result, wording),
        **_deviations(result),
    }


TESTED = 10_000
"""Positions that the error probability was tested on: SemRef shows no smaller one. ``confidence`` keeps all digits."""


def error_probability(confidence: float) -> Sentence:
    """Return the error probability of a position in words: "1 in 1,200", or "below 1 in 10,000".

    Args:
        confidence: Probability that the position is right.
    """
    times = 1 / max(1 - confidence, LEAST_RISK)
    if times >= TESTED:
        return Sentence("below 1 in {count:,.0f}", count=TESTED)
    return Sentence("1 in {count:,.0f}", count=float(f"{times:.1e}"))


CAUSES = {
    LANDMARKS: Sentence("single landmarks"),
    AREAS: Sentence("class areas"),
    MAP: Sentence("map"),
    VIEW: Sentence("lens and tilt"),
    CLASSES: Sentence("class offset"),
    PIXELS: Sentence("pixel size"),
}
LISTED_SHARE = 0.2
"""Smallest part of the error budget that is listed, as a share of the largest one."""


def radius_parts(known: PoseCovariance) -> Sentence | None:
    """Return the error budget of the 95 % radius, its largest parts; None if unknown."""
    if not known.parts:
        return None
    least = LISTED_SHARE * known.parts[0][1]
    parts = [
        Sentence("{cause} {radius:.2g} m", cause=CAUSES[cause], radius=radius)
        for cause, radius in known.parts
        if radius >= least
    ]
    return Sentence("Error budget (95 %): {parts}.", parts=tuple(parts))


def _reason(result: Localization, wording: Callable[[Sentence], str]) -> str:
    """Return why there is no position; for a position the part of the image it is not valid for, and its budget."""
    parts = radius_parts(result.covariance) if result.place and result.covariance is not None else None
    return " ".join(wording(part) for part in (result.reason, parts) if part is not None)


DEVIATIONS = (
    *("error_95_minor", "error_95_direction", "heading_deviation", "pixel_size_deviation"),
    *("sigma_east", "sigma_north", "correlation", "sigma_heading", "sigma_scale"),
)
"""Columns of the uncertainty of a position, in addition to ``error_95``, its 95 % radius."""


def _deviations(result: Localization) -> dict[str, Any]:
    known = result.covariance
    if result.place is None or known is None or known.ellipse_95 is None:
        return dict.fromkeys(DEVIATIONS)
    ellipse, heading, size = known.ellipse_95, known.heading_deviation_deg, known.pixel_size_deviation
    scale = size / result.pixel_size_m if result.pixel_size_m else None
    of_ellipse = ellipse.semi_minor, ellipse.orientation_deg, heading, size
    return dict(zip(DEVIATIONS, (*of_ellipse, *known.deviations, known.correlation, heading, scale)))
