"""An image with its localization: the checks of its position, its labels, and its log messages."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

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
    from ...core.flight.model import FlightPose
    from ...core.geometry.pose import Ellipse

ERROR = "error"
"""Status of an image that cannot be read; the localizer gives the others."""

FAR_M = 1000.0
"""Distance from the border of the ground; nearer, a tilted camera may see it."""

LABELS_SUFFIX = ".tif"
"""Suffix of label images, which have the names of their images, see ``unique_names``."""

LOOKED_AT = 5
"""Largest number of images whose colors are counted, if their names are not those of photos."""


@dataclass(frozen=True)
class LocalizedImage:
    """One image and its result, or ``error`` if it cannot be read.

    Attributes:
        result: Of a flight, its result for this image.
        remark: Sentence about its leveling.
        jump: Whether it could not have been reached in time; None if this was not checked.
        camera: Camera data that were read.
        gps_distance_m: Distance from the database's ground by the GPS position of the photo, if it is far.
        time_s: When it was taken, in seconds since 1970 (UTC) or since any moment; None if unknown.
        pose: Pose that the flight gives it; None for a single image, and for an image that cannot be read.
    """

    path: str
    result: Localization | None = None
    error: str = ""
    shape_hw: tuple[int, int] = (0, 0)
    remark: str = ""
    jump: bool | None = None
    camera: str = ""
    gps_distance_m: float | None = None
    time_s: float | None = None
    pose: FlightPose | None = None

    @property
    def name(self) -> str:
        """File name."""
        return os.path.basename(self.path)

    @property
    def position(self) -> tuple[float, float] | None:
        """Map (x, y); None without a position."""
        return self.result and self.result.position

    @property
    def ellipse(self) -> Ellipse | None:
        """95 % ellipse of the position; None if it is unknown."""
        known = self.result and self.result.covariance
        return known and known.ellipse_95

    @property
    def is_placed(self) -> bool:
        """Whether the flight places it."""
        return self.pose is not None and self.pose.is_fix

    @property
    def source(self) -> str | None:
        """Key of the source of its position in the flight; None without one."""
        return str(self.pose.source) if self.is_placed else None

    @property
    def is_outvoted(self) -> bool:
        """Whether its own position contradicts the flight."""
        return self.pose is not None and self.pose.is_outvoted

    @property
    def reason(self) -> str:
        """Why it has no position, or for what a position is not valid, and its error budget."""
        from ...core.localizer.record import record

        if self.result is None:
            return self.error
        far = "" if self.gps_distance_m is None else far_sentence(self.gps_distance_m)
        return " ".join(filter(None, (far, record(self.result, worded)["reason"])))


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
        from ...storage.label_map_file import LabelMapFile

        if not self._folder:
            return
        height, width = labels_hw.shape
        target = os.path.join(self._folder, self._names[path])
        with LabelMapFile(target, width, height, None, "", self._table, self._class_bias) as label_map:
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

    from ...core.localizer.track import jumps

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


def far_sentence(meters: float) -> str:
    """Return a sentence about a photo that was taken far from the database's ground.

    Args:
        meters: Distance from the border of the ground.
    """
    kilometers = shown(meters / 1000, ".1f" if meters < 10_000 else ",.0f")
    text = tr("The GPS position of this photo is {distance} km from the ground of the database.")
    return text.format(distance=kilometers)


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
