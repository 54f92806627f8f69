"""What is said of one image after the other: read, localized, as a record with its time, place and reason."""

from __future__ import annotations

import logging
import os
import time
from dataclasses import dataclass, field
from datetime import datetime, timezone
from typing import Any

import numpy as np

from ..errors import ParameterError, SemRefError
from ..geometry.camera import Camera
from ..labels.class_shares import SeenLabels
from ..labels.class_table import ClassTable
from ..labels.image_files import read_label_image, read_photo
from ..labels.image_source import ArrayImage
from ..localization import Localization, Method, Prior
from ..localizer.leveled import localize_leveled, prior_of
from ..localizer.localizer import Localizer
from ..localizer.network_reason import name_network
from ..localizer.record import record
from ..segmentation.class_bias import KnownBiases, known_biases
from ..segmentation.devices import AUTO
from ..sentences import english
from .cameras import Cameras
from .format import OnboardDatabase
from .log import say

ERROR = "error"
"""Status of an image that could not be read, as in the plugin."""


class LabelReader:
    """Labels of images: of label images as they are, of photos by a network.

    Attributes:
        known: How these labels are shifted.
        photo: The photo that was read last; None for label images.
    """

    def __init__(self, model_path: str | None, threads: int, table: ClassTable, device: str = AUTO) -> None:
        """Loads the network, if there is one.

        Args:
            model_path: Of the network; None for label images.
            threads: That it may use.
            table: Classes of the database.
            device: That it is run on.

        Raises:
            SemRefError: The network can't be used.
        """
        self._table, self.known = table, KnownBiases()
        self.photo: ArrayImage | None = None
        if not model_path:
            self._model = None
            return
        # onnxruntime is needed for photos only.
        from ..segmentation.model import SegmentationModel

        self._model = SegmentationModel(model_path, threads, device=device)
        for fallback in self._model.fallbacks:
            say(logging.WARNING, "device", reason=english(fallback))
        say(logging.INFO, "model", model=model_path, device=self._model.device.title)
        self._values = self._model.classes.values_in(table, model_path)
        self.known = known_biases(self._model.class_bias, table)

    def __call__(self, path: str, camera: Camera | None = None) -> SeenLabels:
        """What is seen in an image; by its camera a network knows how large to see a photo. Raises SemRefError."""
        if self._model is None:
            return SeenLabels(read_label_image(path, self._table))
        from ..segmentation.photo_labels import PhotoLabels

        photo = read_photo(path)
        self.photo = photo.image
        return PhotoLabels(self._model, photo.image, self._values, photo.pixel_size_m, camera).seen()


@dataclass(frozen=True)
class Finding:
    """How images are localized.

    Attributes:
        onboard: The database.
        localizer: In it.
        method: By which each image is looked at by itself.
        prior: What is known of all images.
        read_labels: Path → labels, with how sure a network is.
        cameras: Path → camera.
    """

    onboard: OnboardDatabase
    localizer: Localizer
    method: Method
    prior: Prior
    read_labels: LabelReader
    cameras: Cameras = field(default_factory=Cameras)

    def camera_of(self, path: str) -> Camera:
        """What is known of an image's camera; the published method takes images as they are."""
        camera = self.cameras.of(path)
        return camera.without_leveling() if self.method == Method.TOPOLOGY_VECTOR else camera

    def prior_of(self, camera: Camera, shape_hw: tuple[int, int]) -> Prior:
        """What is known of an image, with what its camera tells."""
        return prior_of(self.localizer, self.method, self.prior, camera, shape_hw)

    def localized(self, path: str) -> dict[str, Any]:
        """A record's columns for an image by itself. Raises SemRefError."""
        camera = self.camera_of(path)
        seen = self.read_labels(path, camera)
        height, width = seen.labels_hw.shape
        way, prior = camera.leveling((height, width)), self.prior_of(camera, (height, width))
        if way is None:
            found = self.localizer.localize(seen.labels_hw, self.method, prior, shares=seen.shares)
        else:
            found = localize_leveled(self.localizer, seen.labels_hw, self.method, prior, way, shares=seen.shares)
        return self.told(name_network(found, seen.trained_on, self.localizer.landmark_classes))

    def told(self, result: Localization) -> dict[str, Any]:
        """A result as a record, with longitude and latitude where they are known."""
        found = record(result)
        if result.position is not None and self.onboard.lon_lat is not None:
            longitudes, latitudes = self.onboard.lon_lat(np.array([result.position]))
            found.update(longitude=float(longitudes[0]), latitude=float(latitudes[0]))
        return found

    def __call__(self, path: str) -> dict[str, Any]:
        """What is said of an image: whatever is wrong with it, it stops no other."""
        started = time.perf_counter()
        found: dict[str, Any] = {"image": path, "time": None}
        try:
            found["time"] = time_of(path).isoformat()
            found.update(self.localized(path))
        except SemRefError as error:
            found.update(status=ERROR, reason=str(error))
        except Exception as error:
            # A fault of the program stops no other either; the log tells it with its traceback.
            say(logging.ERROR, "fault", traceback=True, image=path)
            found.update(status=ERROR, reason=f"{type(error).__name__}: {error}")
        level = logging.WARNING if found["status"] == ERROR else logging.INFO
        seconds = round(time.perf_counter() - started, 3)
        say(level, "image", image=path, status=found["status"], reason=found["reason"], seconds=seconds)
        return found


def time_of(path: str) -> datetime:
    """When an image was written, which a camera does when it was taken.

    Raises:
        ParameterError: Nobody can tell.
    """
    try:
        return datetime.fromtimestamp(os.stat(path).st_mtime, timezone.utc)
    except (OSError, OverflowError, ValueError) as error:
        # A file system may hold years that no calendar has.
        reason = getattr(error, "strerror", None) or str(error)
        raise ParameterError("labels.image_unreadable", path=path, reason=reason) from None
