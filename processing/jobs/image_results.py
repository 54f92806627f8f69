"""The results of images: checks of their positions, their labels, and log messages."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransformContext, QgsProcessingFeedback

from ...core.labels.class_table import ClassTable
from ...core.localization import Status
from ...core.sentences import Sentence
from ..base.algorithm import check_canceled
from ..layers.localized_image import LocalizedImage, far_sentence
from ..messages.sentences import error_probability, worded
from ..translation import tr

if TYPE_CHECKING:
    import numpy as np

    from ...core.database.model import ReferenceDatabase, Windows

FAR_M = 1000.0
"""Distance from the border of the ground; nearer, a tilted camera may see it."""

LABELS_SUFFIX = ".tif"
"""Suffix of label images, which have the names of their images, see ``unique_names``."""

LOOKED_AT = 5
"""Largest number of images whose colors are counted, if their names are not those of photos."""


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
        self._names = unique_names(paths, LABELS_SUFFIX)

    def __call__(self, path: str, labels_hw: np.ndarray) -> None:
        from ...core.geometry.frame import MapFrame
        from ...storage.label_map_file import LabelMapFile

        if not self._folder:
            return
        target = os.path.join(self._folder, self._names[path])
        with LabelMapFile(target, MapFrame("", (), labels_hw.shape), self._table, self._class_bias) as label_map:
            label_map.write_rows(0, labels_hw)


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
    localized: Sequence[LocalizedImage], windows: Windows, speed: float, feedback: QgsProcessingFeedback
) -> list[LocalizedImage]:
    """Mark positions of known time as jumps or not, and log the result. Likely positions are not checked."""
    import numpy as np

    from ...core.localizer.reach import jumps

    timed = [n for n, one in enumerate(localized) if one.result and one.result.is_fix and one.time_s is not None]
    results = [localized[n].result for n in timed]
    # An image that matches a window may be anywhere in it.
    errors = [windows.sizes[r.window_index] / 2 if r.error_95_m is None else r.error_95_m for r in results]
    flags = jumps(
        np.array([localized[n].time_s for n in timed]),
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
            feedback.pushWarning(f"{checked[n].name}: {worded(reason)}")
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
            feedback.pushWarning(f"{item.name}: {far_sentence(away)}")
        checked.append(item)
    return checked


def count_sentence(statuses: Sequence[str]) -> str:
    """Return a sentence on how many images have a position, with the likely positions apart."""
    fixes = statuses.count(Status.FIX)
    if len(statuses) == 1:
        text = tr("The image has a position.") if fixes else tr("The image has no position.")
    elif fixes == 1:
        text = tr("1 of {images} images has a position.").format(images=len(statuses))
    else:
        text = tr("{fixes} of {images} images have a position.").format(fixes=fixes, images=len(statuses))
    likely = statuses.count(Status.LIKELY)
    return f"{text} {tr('Likely positions: {likely}.').format(likely=likely)}" if likely else text


def log_result(item: LocalizedImage, feedback: QgsProcessingFeedback) -> None:
    from ...core.localizer.record import radius_parts

    name = item.name
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
    if item.is_outvoted:
        text = tr("{image}: its own position contradicts the flight and was outvoted.")
        feedback.pushWarning(text.format(image=name))
