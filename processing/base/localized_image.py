"""An image with its localization: its rows in the outputs, and its log messages."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransformContext, QgsProcessingFeedback

from ...core.labels.class_table import ClassTable
from ...core.localization import Localization, Status
from ...core.sentences import Sentence
from ..messages.numbers import shown
from ..messages.sentences import worded
from ..translation import tr
from .algorithm import check_canceled

if TYPE_CHECKING:
    import numpy as np

    from ...core.database.model import ReferenceDatabase, Windows

PlacedRow = tuple[Any, dict[str, Any]]
"""(map coordinates of a point or of corners, values by field name)."""

ERROR = "error"
"""Status of an image that cannot be read; the localizer gives the others."""

FAR_M = 1000.0
"""Distance from the border of the ground; nearer, a tilted camera may see it."""

LOOKED_AT = 5
"""Largest number of images whose colors are counted, if their names are not those of photos."""

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
    ("search_capped", "boolean"),
    ("sigma_east", "real"),
    ("sigma_north", "real"),
    ("correlation", "real"),
    ("sigma_heading", "real"),
    ("sigma_scale", "real"),
    ("camera", "text"),
    ("gps_distance", "real"),
)
FOOTPRINT_FIELDS = (
    ("image", "text"),
    ("status", "text"),
    ("confidence", "real"),
    ("window", "text"),
    ("method", "text"),
)
ALTERNATIVE_FIELDS = (("image", "text"), ("rank", "integer"), ("heading", "real"), ("pixel_size", "real"))
MATCH_FIELDS = (
    ("image", "text"),
    ("number", "integer"),
    ("class", "integer"),
    ("class_name", "text"),
    ("image_column", "real"),
    ("image_row", "real"),
    ("seen_x", "real"),
    ("seen_y", "real"),
    ("residual", "real"),
)


@dataclass(frozen=True)
class LocalizedImage:
    """One image and its result, or ``error`` if it cannot be read.

    Attributes:
        remark: Sentence about its leveling.
        jump: Whether it could not have been reached in time; None if this was not checked.
        camera: Camera data that were read.
        gps_distance_m: Distance from the database's ground by the GPS position of the photo, if it is far.
    """

    path: str
    result: Localization | None = None
    error: str = ""
    shape_hw: tuple[int, int] = (0, 0)
    remark: str = ""
    jump: bool | None = None
    camera: str = ""
    gps_distance_m: float | None = None


def is_photo(path: str) -> bool:
    """Return whether a file has a format of cameras, which label images do not have."""
    return path.lower().endswith((".jpg", ".jpeg"))


def has_photos(paths: Sequence[str]) -> bool:
    """Return whether some of the images are photos, by their names or their colors."""
    from ...storage.label_images import has_photo_colors

    return any(map(is_photo, paths)) or any(map(has_photo_colors, paths[:LOOKED_AT]))


class LabelImages:
    """A folder of label images, named after their images; called with an image's path and its (H, W) labels.

    Without a folder (an empty path) nothing is written.
    """

    def __init__(self, folder: str, paths: Sequence[str], table: ClassTable, class_bias: str = "") -> None:
        self._folder, self._table, self._class_bias = folder, table, class_bias
        self._names = label_image_names(paths)

    def __call__(self, path: str, labels_hw: np.ndarray) -> None:
        from ...storage.label_map_file import LabelMapFile

        if not self._folder:
            return
        height, width = labels_hw.shape
        target = os.path.join(self._folder, self._names[path])
        with LabelMapFile(target, width, height, None, "", self._table, self._class_bias) as label_map:
            label_map.write_rows(0, labels_hw)


def label_image_names(paths: Sequence[str]) -> dict[str, str]:
    """Return the file names of the label images by the images' paths, as ``unique_names`` does."""
    return unique_names(paths, ".tif")


def unique_names(paths: Sequence[str], suffix: str = "") -> dict[str, str]:
    """Return file names by image path: the stem, numbered (``stem_2``) if several images share it, and ``suffix``.

    Without a suffix the image's own is used. The same images in the same order get the same names.
    """
    names: dict[str, str] = {}
    taken = set()
    for path in paths:
        if path in names:
            continue
        stem = os.path.splitext(os.path.basename(path))[0]
        name, number = stem, 1
        while name.lower() in taken:
            number += 1
            name = f"{stem}_{number}"
        taken.add(name.lower())
        names[path] = name + (suffix or os.path.splitext(path)[1])
    return names


def with_jumps(
    localized: Sequence[LocalizedImage],
    times_s: Sequence[float | None],
    windows: Windows,
    speed: float,
    feedback: QgsProcessingFeedback,
) -> list[LocalizedImage]:
    """Mark positions of known time as jumps or not, and log the result. Likely positions are not checked."""
    import numpy as np

    from ...core.localizer.track import jumps

    timed = [n for n, item in enumerate(localized) if item.result and item.result.is_fix and times_s[n] is not None]
    results = [localized[n].result for n in timed]
    # An image that matches a window may be anywhere in it.
    errors = [windows.sizes[r.window_index] / 2 if r.error_95_m is None else r.error_95_m for r in results]
    flags = jumps(
        np.array([times_s[n] for n in timed]),
        np.array([localized[n].result.nadir or localized[n].result.position for n in timed]),
        np.array(errors),
        np.array([result.confidence or 0.0 for result in results]),
        speed,
    )
    reason = Sentence(
        "This position cannot be reached at {speed:g} m/s from the positions before and after it.", speed=speed
    )
    checked = list(localized)
    for n, jumped in zip(timed, flags.tolist()):
        checked[n] = replace(checked[n], jump=jumped)
        if jumped:
            checked[n] = replace(checked[n], result=replace(checked[n].result, reason=reason))
            feedback.pushWarning(f"{os.path.basename(checked[n].path)}: {worded(reason)}")
    summary = tr("{jumps} of {checked} positions with a time are jumps.")
    feedback.pushInfo(summary.format(jumps=int(flags.sum()), checked=len(timed)))
    return checked


def with_far_photos(
    localized: Sequence[LocalizedImage],
    database: ReferenceDatabase,
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
    feedback: QgsProcessingFeedback,
) -> list[LocalizedImage]:
    """Add the distance of photos with a GPS position far from the database's ground, and log it.

    Localization never uses GPS positions. ``crs`` is the CRS of the database.
    """
    from ...storage.photo_position import photo_lon_lat
    from ..layers.reference_systems import meters_from

    checked = []
    for item in localized:
        check_canceled(feedback)
        place = None if item.result is None else photo_lon_lat(item.path)
        away = None if place is None else meters_from(place, database.parameters.extent, crs, context)
        if away is not None and away > FAR_M:
            item = replace(item, gps_distance_m=away)
            feedback.pushWarning(f"{os.path.basename(item.path)}: {far_sentence(away)}")
        checked.append(item)
    return checked


def row(item: LocalizedImage) -> dict[str, Any]:
    """Return the values of FIELDS by name, without longitude and latitude."""
    result = item.result
    if result is None:
        return {"image": item.path, "status": ERROR, "reason": item.error}
    from ...core.localizer.record import record

    values = record(result, worded)
    if item.gps_distance_m is not None:
        values["reason"] = " ".join(filter(None, (far_sentence(item.gps_distance_m), values["reason"])))
    return {
        "image": item.path,
        **values,
        "camera_x": result.nadir and result.nadir[0],
        "camera_y": result.nadir and result.nadir[1],
        "jump": item.jump,
        "search_capped": result.search_capped,
        "camera": item.camera or None,
        "gps_distance": item.gps_distance_m,
    }


def far_sentence(meters: float) -> str:
    """Return a sentence about a photo that was taken far from the database's ground.

    Args:
        meters: Distance from the border of the ground.
    """
    kilometers = shown(meters / 1000, ".1f" if meters < 10_000 else ",.0f")
    text = tr("The GPS position of this photo is {distance} km from the ground of the database.")
    return text.format(distance=kilometers)


def footprint_rows(item: LocalizedImage) -> list[PlacedRow]:
    """Return ((4, 2) map coordinates, values of FOOTPRINT_FIELDS) of an image with a position, otherwise nothing."""
    if item.result is None or item.result.footprint is None:
        return []
    values = row(item)
    return [(item.result.footprint, {name: values[name] for name, _ in FOOTPRINT_FIELDS})]


def match_rows(item: LocalizedImage, database: ReferenceDatabase) -> list[PlacedRow]:
    """Return (map position, values of MATCH_FIELDS) of each landmark of the map that matches one of the image."""
    if item.result is None or item.result.place is None or item.result.matches is None:
        return []
    found = item.result.matches
    names = {c.value: c.name for c in database.class_table}
    positions = database.references.positions[found.on_map].tolist()
    classes = database.references.classes[found.on_map].tolist()
    columns = found.pixels_xy.tolist(), found.seen_xy.tolist(), found.residuals.tolist()
    rows = []
    for n, (position, value, pixel, seen, residual) in enumerate(zip(positions, classes, *columns), start=1):
        values = item.path, n, value, names.get(value), *pixel, *seen, residual
        rows.append((position, {name: value for (name, _), value in zip(MATCH_FIELDS, values)}))
    return rows


def alternatives(item: LocalizedImage) -> list[PlacedRow]:
    """Return ((4, 2) map coordinates, values of ALTERNATIVE_FIELDS) of each possible place of an ambiguous image."""
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


def error_probability(confidence: float) -> str:
    """Return the error probability in the user's language: "1 in 1,200", or "below 1 in 10,000"."""
    from ...core.localizer import record

    return worded(record.error_probability(confidence))


def count_sentence(statuses: Sequence[str]) -> str:
    """Return a sentence on how many images have a position, with the likely positions apart.

    Args:
        statuses: Of all images.
    """
    counted = tr("{fixes} of {images} images have a position.")
    text = counted.format(fixes=statuses.count(Status.FIX), images=len(statuses))
    likely = statuses.count(Status.LIKELY)
    return f"{text} {tr('Likely positions: {likely}.').format(likely=likely)}" if likely else text


def log_result(item: LocalizedImage, feedback: QgsProcessingFeedback) -> None:
    from ...core.localizer.record import radius_parts

    name = os.path.basename(item.path)
    if item.result is None:
        feedback.reportError(f"{name}: {item.error}", False)
        return
    if item.camera:
        feedback.pushInfo(tr("{image}: camera: {camera}").format(image=name, camera=item.camera))
    if item.remark:
        feedback.pushInfo(f"{name}: {item.remark}")
    result = item.result
    if result.search_capped:
        capped = tr("The search was limited: common patterns were left out, so a better place may have been missed.")
        feedback.pushWarning(f"{name}: {capped}")
    if result.position is None:
        feedback.pushInfo(f"{name}: {worded(result.status.title)}. {worded(result.reason)}")
        return
    if result.reason is not None:
        title = f"{worded(result.status.title)}. " if result.is_likely else ""
        feedback.pushInfo(f"{name}: {title}{worded(result.reason)}")
    details = (
        (result.window, tr("window {value}")),
        (result.distance, tr("distance {value:.4f}")),
        (result.heading_deg, tr("heading {value:.1f}°")),
        (result.pixel_size_m, tr("pixel size {value:.3g} m")),
        (result.error_95_m, tr("95 % radius {value:.2f} m")),
        (result.confidence if result.risk is None else None, tr("confidence {value:.2f}")),
        (
            error_probability(result.confidence) if result.confidence and result.risk else None,
            tr("error probability {value}"),
        ),
    )
    texts = [text.format(value=value) for value, text in details if value is not None]
    x, y = result.position
    feedback.pushInfo(f"{name}: {x:.1f} {y:.1f}, {', '.join(texts)}")
    parts = result.covariance and radius_parts(result.covariance)
    if parts:
        feedback.pushInfo(worded(parts))
