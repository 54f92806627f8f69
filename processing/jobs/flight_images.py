"""The images of a flight: ordered, read, leveled and localized one by one, then placed by the flight."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import cast

from qgis.core import QgsProcessingFeedback

from ...core.errors import ParameterError, SemRefError
from ...core.flight.cameras import complete_camera
from ...core.flight.model import FlightImage, FlightPose
from ...core.flight.motion import Link
from ...core.flight.odometry import OdometryRow, odometry_links
from ...core.flight.pixel_features import Features, features_of
from ...core.flight.pixel_links import PixelLinks
from ...core.flight.telemetry import Telemetry, log_cameras, log_links
from ...core.geometry.camera import Camera
from ...core.localization import Localization
from ...core.localizer.reach import Reach
from ...core.pipeline import ImageResult, Pipeline, localize_again
from ...core.tables import stem_of
from ..layers.localized_image import LocalizedImage
from ..messages.camera_messages import camera_remark
from ..messages.sentences import worded
from ..translation import tr
from .image_results import LabelImages
from .localizing import found_within_reach

_SOURCES = {"pixels": "pixels", "table": "odometry", "log": "log"}
"""Sources of links, by their placeholders in the log."""


@dataclass(frozen=True)
class TakenImage:
    """An image before the flight is solved.

    Attributes:
        result: Result of the image alone; None with an error.
        flown: Input of the flight: leveled labels and the result of the image alone; None with an error.
    """

    path: str
    camera: Camera
    result: ImageResult | None = None
    flown: FlightImage | None = None
    remark: str = ""
    error: str = ""


def in_order(paths: Sequence[str], cameras: Sequence[Camera]) -> tuple[list[str], list[Camera]]:
    """Return images by time if all times are known, otherwise by name (10 after 9)."""
    if all(camera.time_s is not None for camera in cameras):
        order = sorted(range(len(paths)), key=lambda n: (cameras[n].time_s, by_name(paths[n])))
    else:
        order = sorted(range(len(paths)), key=lambda n: by_name(paths[n]))
    return [paths[n] for n in order], [cameras[n] for n in order]


def by_name(path: str) -> tuple[list[tuple[int, str]], str]:
    """Return the sort key of names, with numbers in them as numbers."""
    parts = re.split(r"(\d+)", os.path.basename(path).lower())
    return [(int(part), "") if part.isdecimal() else (-1, part) for part in parts], path


def with_log(
    cameras: Sequence[Camera], log: Telemetry | None, paths: Sequence[str], with_attitude: bool
) -> list[Camera]:
    """Add the data of a flight log to cameras that lack them.

    Args:
        log: The flight log; None without one.

    Raises:
        ParameterError: The log contains nothing about these images.
    """
    if log is None:
        return list(cameras)
    names, times_s = [stem_of(path) for path in paths], [camera.time_s for camera in cameras]
    logged = log_cameras(log, names, times_s)
    if all(one == Camera() for one in logged) and not log_links(log, names, times_s):
        raise ParameterError(
            "The flight log contains no entry for these images, for example {image}, by name or by time. Select the "
            "log of this flight, or a camera table with times.",
            image=os.path.basename(paths[0]),
        )
    return [complete_camera(camera, one, with_attitude) for camera, one in zip(cameras, logged)]


class FlightReader:
    """Reads the images of a flight and measures the motion between neighbors."""

    def __init__(self, pipeline: Pipeline, keep: LabelImages) -> None:
        self._pipeline, self._keep = pipeline, keep
        self.taken: list[TakenImage] = []
        self._pixels = PixelLinks()

    @property
    def flown(self) -> list[FlightImage]:
        """Images that could be read, in order; links count these."""
        return [one.flown for one in self.taken if one.flown is not None]

    def read(self, path: str, camera: Camera) -> tuple[TakenImage, Features | None]:
        """Read an image and localize it alone; an error of one image does not stop the flight."""
        try:
            result = self._pipeline.run(path, camera, with_pixels=True)
            seen = result.seen
            flown = FlightImage.of(os.path.basename(path), result, camera.time_s)
            features = features_of(seen.labels_hw, seen.pixels, result.leveling)
        except SemRefError as error:
            return TakenImage(path, camera, error=worded(error)), None
        # All photos of a flight together would fill the memory.
        result = replace(result, seen=replace(seen, pixels=None))
        return TakenImage(path, camera, result, flown, camera_remark(camera, result.shape_hw)), features

    def take(self, taken: TakenImage, features: Features | None) -> None:
        """Add what ``read`` returned, in the order of the flight, and link it to the previous image."""
        if taken.result is not None and taken.flown is not None and features is not None:
            self._keep(taken.path, taken.result.labels_hw)
            taken = replace(taken, flown=replace(taken.flown, is_apart=self._pixels.add(features)))
        self.taken.append(taken)

    def search_within_reach(self, speed: float, feedback: QgsProcessingFeedback) -> None:
        """Search the images that have no position by themselves within reach of the others; see ``Reach``."""
        localizer, search = self._pipeline.localizer, self._pipeline.search
        again: dict[int, ImageResult] = {}

        def ask(n: int, reach: Reach) -> Localization | None:
            result = cast(ImageResult, self.taken[n].result)
            prior = reach.narrow(result.prior)
            if prior is None:
                return None
            again[n] = localize_again(localizer.with_risk(reach.allowed_risk), search, result, prior)
            return again[n].level

        results = [None if one.result is None else one.result.level for one in self.taken]
        times_s, limits = [one.camera.time_s for one in self.taken], (speed, localizer.settings.allowed_risk)
        found = found_within_reach([one.path for one in self.taken], results, times_s, limits, ask, feedback)
        for n, level in found.items():
            taken, result = self.taken[n], again[n]
            flown = replace(cast(FlightImage, taken.flown), own=level, prior=result.prior)
            self.taken[n] = replace(taken, result=replace(result, level=level), flown=flown)

    def links_with(self, steps: Sequence[OdometryRow], log: Telemetry | None) -> list[Link]:
        """Return all links: of the odometry table, otherwise of pixels, otherwise of the log."""
        names = [image.name for image in self.flown]
        links = {(link.first, link.second): link for link in odometry_links(steps, names)}
        logged = []
        if log is not None:
            logged = log_links(log, [stem_of(name) for name in names], [image.time_s for image in self.flown])
        for link in (*self._pixels.links, *logged):
            links.setdefault((link.first, link.second), link)
        return sorted(links.values(), key=lambda link: (link.second, link.first))

    def motion_sentences(self, links: Sequence[Link]) -> list[str]:
        """Return sentences about the sources of the motion, and why it is unknown."""
        pairs = max(len(self.flown) - 1, 0)
        linked = {link.second: str(link.source) for link in links if link.second == link.first + 1}
        sources = list(linked.values())
        text = tr(
            "Motion between {pairs} pairs of neighboring images: {pixels} from pixels, {table} from the odometry "
            "table, {log} from the log, {unknown} unknown."
        )
        counts = {key: sources.count(source) for key, source in _SOURCES.items()}
        said = [text.format(pairs=pairs, unknown=pairs - len(linked), **counts)]
        names = [image.name for image in self.flown]
        for number, reason in self._pixels.unlinked:
            if number not in linked:
                said.append(f"{names[number - 1]} – {names[number]}: {worded(reason)}")
        return said


def with_pose(taken: TakenImage, pose: FlightPose | None) -> LocalizedImage:
    """Return the result of the flight for an image as it was taken, without leveling."""
    time_s = taken.camera.time_s
    if pose is None or taken.result is None:
        return LocalizedImage(taken.path, error=taken.error, time_s=time_s)
    found, shape_hw = taken.result.as_taken(pose.localization()), taken.result.shape_hw
    return LocalizedImage(taken.path, found, "", shape_hw, taken.remark, time_s=time_s, pose=pose)
