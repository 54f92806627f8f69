"""Records of images on board: read an image, localize it, and return time, place and reason."""

from __future__ import annotations

import logging
import os
import time
from dataclasses import dataclass, field
from datetime import datetime, timezone
from typing import Any

import numpy as np

from ..errors import ParameterError, SemRefError, reason_of
from ..geometry.camera import Camera
from ..labels.class_shares import SeenLabels
from ..labels.class_table import ClassTable
from ..labels.image_files import read_label_image
from ..localization import Localization
from ..localizer.record import record
from ..pipeline import LabelReader, Pipeline
from ..segmentation.devices import AUTO
from ..segmentation.model import SegmentationModel
from ..segmentation.photo_labels import PhotoReader
from ..sentences import english
from .cameras import Cameras
from .format import OnboardDatabase
from .log import log_event

ERROR = "error"
"""Status of an image that can't be read, as in the plugin."""


def label_reader(model_path: str | None, threads: int, table: ClassTable, device: str = AUTO) -> LabelReader:
    """Return a reader of label images, or of photos with a network.

    Args:
        model_path: Of the network; None for label images.

    Raises:
        SemRefError: The network can't be used.
    """
    if not model_path:

        def read(path: str, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
            if path.lower().endswith((".jpg", ".jpeg")):
                reason = "The image is a photo, but no model is selected. Its colors are read as class colors."
                log_event(logging.WARNING, "no_model", image=path, reason=reason)
            return SeenLabels(read_label_image(path, table))

        return read
    model = SegmentationModel(model_path, threads, device=device)
    for fallback in model.fallbacks:
        log_event(logging.WARNING, "device", reason=english(fallback))
    log_event(logging.INFO, "model", model=model_path, device=model.device.title)
    return PhotoReader(model, table)


@dataclass
class ImageFinder:
    """Localizes images one by one.

    Attributes:
        pipeline: With the onboard database and the method.
    """

    onboard: OnboardDatabase
    pipeline: Pipeline
    cameras: Cameras = field(default_factory=Cameras)

    def localize(self, path: str) -> dict[str, Any]:
        """Return the columns of the record of an image. Raises SemRefError."""
        return self.as_record(self.pipeline.run(path, self.cameras.of(path)).localization)

    def as_record(self, result: Localization) -> dict[str, Any]:
        """Return a result as a record, with longitude and latitude if they are known."""
        found = record(result)
        if result.position is not None and self.onboard.lon_lat is not None:
            longitudes, latitudes = self.onboard.lon_lat(np.array([result.position]))
            found.update(longitude=float(longitudes[0]), latitude=float(latitudes[0]))
        return found

    def __call__(self, path: str) -> dict[str, Any]:
        """Return the record of an image; an error of one image does not affect others."""
        started = time.perf_counter()
        found: dict[str, Any] = {"image": path, "time": None}
        try:
            found["time"] = time_of(path).isoformat()
            found.update(self.localize(path))
        except SemRefError as error:
            found.update(status=ERROR, reason=str(error))
        except Exception as error:
            # A program error does not stop other images either; the log contains its traceback.
            log_event(logging.ERROR, "fault", traceback=True, image=path)
            found.update(status=ERROR, reason=f"{type(error).__name__}: {error}")
        level = logging.WARNING if found["status"] == ERROR else logging.INFO
        seconds = round(time.perf_counter() - started, 3)
        log_event(level, "image", image=path, status=found["status"], reason=found["reason"], seconds=seconds)
        return found


def time_of(path: str) -> datetime:
    """Return the time at which an image was written, which cameras do at capture.

    Raises:
        ParameterError: The time is unknown.
    """
    try:
        return datetime.fromtimestamp(os.stat(path).st_mtime, timezone.utc)
    except (OSError, OverflowError, ValueError) as error:
        # A file system may contain years that no calendar has.
        raise ParameterError("Image {path} can't be read: {reason}.", path=path, reason=reason_of(error)) from None
