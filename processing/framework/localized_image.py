"""An image and what localization made of it: its rows in the outputs, and what the log says."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from typing import Optional, Tuple

from ..translation import tr

ERROR = "error"
"""Status of an image that could not be read; the others come from the localizer."""

FIELDS = (
    ("image", "text"),
    ("status", "text"),
    ("x", "real"),
    ("y", "real"),
    ("longitude", "real"),
    ("latitude", "real"),
    ("heading", "real"),
    ("pixel_size", "real"),
    ("confidence", "real"),
    ("distance", "real"),
    ("inliers", "integer"),
    ("references", "integer"),
    ("log_odds", "real"),
    ("error_95", "real"),
    ("window", "text"),
    ("method", "text"),
    ("reason", "text"),
    ("camera_x", "real"),
    ("camera_y", "real"),
    ("jump", "boolean"),
    ("error_95_minor", "real"),
    ("error_95_direction", "real"),
    ("heading_deviation", "real"),
    ("pixel_size_deviation", "real"),
)
FOOTPRINT_FIELDS = (
    ("image", "text"),
    ("status", "text"),
    ("confidence", "real"),
    ("window", "text"),
    ("method", "text"),
)
ALTERNATIVE_FIELDS = (("image", "text"), ("rank", "integer"), ("heading", "real"), ("pixel_size", "real"))


@dataclass(frozen=True)
class LocalizedImage:
    """One image and its result; ``error`` instead when it could not be read.

    footprint: (4, 2) map coordinates of a leveled image's corners; nadir: of the point straight below its camera;
    remark: about its leveling; jump: whether it could not have been reached in time, None if that was not checked.
    """

    path: str
    result: Optional[object] = None
    error: str = ""
    shape_hw: Tuple[int, int] = (0, 0)
    footprint: Optional[object] = None
    nadir: Optional[Tuple[float, float]] = None
    remark: str = ""
    jump: Optional[bool] = None


def with_jumps(localized, times_s, windows, speed, feedback):
    """The images, fixes of known time marked as jumps or not; says what was found."""
    import numpy as np

    from ...core.localizer.track import jumps

    timed = [n for n, item in enumerate(localized) if item.result and item.result.position and times_s[n] is not None]
    results = [localized[n].result for n in timed]
    # An image matched with a window may lie anywhere in it.
    errors = [windows.sizes[r.window_index] / 2 if r.error_95_m is None else r.error_95_m for r in results]
    flags = jumps(
        np.array([times_s[n] for n in timed]),
        np.array([localized[n].nadir or localized[n].result.position for n in timed]),
        np.array(errors),
        np.array([result.confidence for result in results]),
        speed,
    )
    reason = tr("It can’t be reached at {speed:g} map units per second from the fixes before and after it.")
    reason = reason.format(speed=speed)
    checked = list(localized)
    for n, jumped in zip(timed, flags.tolist()):
        checked[n] = replace(checked[n], jump=jumped)
        if jumped:
            checked[n] = replace(checked[n], result=replace(checked[n].result, reason=reason))
            feedback.pushWarning(f"{os.path.basename(checked[n].path)}: {reason}")
    summary = tr("{jumps} of {checked} fixes with a time are jumps.")
    feedback.pushInfo(summary.format(jumps=int(flags.sum()), checked=len(timed)))
    return checked


def corners(item, windows):
    """(4, 2) map coordinates of what an image with a fix shows, else None."""
    from ...core.geometry.footprint import image_corners

    result = item.result
    if item.footprint is not None:
        return item.footprint
    if result is None or result.position is None:
        return None
    if result.window_index is not None:
        size = float(windows.sizes[result.window_index])
        return image_corners(tuple(windows.centers[result.window_index]), 0.0, size, 1, 1)
    height, width = item.shape_hw
    return image_corners(result.position, result.heading_deg, result.pixel_size_m, width, height)


def row(item) -> dict:
    """Values of FIELDS by name, without longitude and latitude."""
    result = item.result
    if result is None:
        return {"image": item.path, "status": ERROR, "reason": item.error}
    from ...core.localizer.record import record

    return {
        "image": item.path,
        **record(result),
        "camera_x": item.nadir and item.nadir[0],
        "camera_y": item.nadir and item.nadir[1],
        "jump": item.jump,
    }


def alternatives(item) -> list:
    """((4, 2) map coordinates, values of ALTERNATIVE_FIELDS) of each place that an image without a fix may show."""
    from ...core.geometry.footprint import image_corners

    places = item.result.alternatives if item.result is not None else ()
    height, width = item.shape_hw
    return [
        (
            image_corners(place.position, place.heading_deg, place.pixel_size_m, width, height),
            {"image": item.path, "rank": n, "heading": place.heading_deg, "pixel_size": place.pixel_size_m},
        )
        for n, place in enumerate(places, start=1)
    ]


def say(item, feedback) -> None:
    name = os.path.basename(item.path)
    if item.result is None:
        feedback.reportError(f"{name}: {item.error}", False)
        return
    if item.remark:
        feedback.pushInfo(f"{name}: {item.remark}")
    result = item.result
    if result.position is None:
        feedback.pushInfo(f"{name}: {result.status}. {result.reason}")
        return
    details = (
        (result.window, tr("window {value}")),
        (result.distance, tr("distance {value:.4f}")),
        (result.heading_deg, tr("heading {value:.1f}°")),
        (result.pixel_size_m, tr("pixel size {value:.3g} m")),
        (result.error_95_m, tr("within {value:.2f} m (95 %)")),
        (result.confidence, tr("confidence {value:.2f}")),
    )
    texts = [text.format(value=value) for value, text in details if value is not None]
    x, y = result.position
    feedback.pushInfo(f"{name}: {x:.1f} {y:.1f}, {', '.join(texts)}")
