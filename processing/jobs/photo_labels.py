"""Label images of photos: the output of a network in the classes of a database."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from threading import Lock
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingFeedback, QgsProcessingOutputNumber, QgsProcessingOutputString

from ...core.labels.class_table import ClassTable
from ...core.steps import advance
from ..base.algorithm import check_canceled
from ..messages.sentences import worded
from ..packages.components import ONNXRUNTIME, require
from ..packages.devices import chosen_device
from ..threads import worker_threads
from ..translation import tr

if TYPE_CHECKING:
    from ...core.geometry.camera import Camera
    from ...core.labels.class_shares import SeenLabels
    from ...core.labels.image_source import Photo
    from ...core.segmentation.model import SegmentationModel
    from ...core.segmentation.photo_labels import PhotoLabels
    from ...storage.images import GdalImage

DEVICE, TILES_PER_SECOND = "DEVICE", "TILES_PER_SECOND"
"""Keys of the results about a network's run."""


def open_model(path: str, table: ClassTable | None = None) -> SegmentationModel:
    """Open a network on the device of the options. Raises ModelError."""
    from ...core.segmentation.model import SegmentationModel

    return SegmentationModel(path, worker_threads(), table, chosen_device())


def pace_results() -> tuple[QgsProcessingOutputString, QgsProcessingOutputNumber]:
    """Return the result numbers of a network's run."""
    return (
        QgsProcessingOutputString(DEVICE, "Device of the network"),
        QgsProcessingOutputNumber(TILES_PER_SECOND, "Tiles per second"),
    )


def log_pace(model: SegmentationModel, seconds: float, feedback: QgsProcessingFeedback) -> dict[str, Any]:
    """Log device and speed of a network's run, and return them as result numbers.

    Args:
        seconds: Duration, with reading images and joining tiles.
    """
    tiles, device = model.tiles_seen, model.device.title
    rate = tiles / seconds if seconds else 0.0
    text = tr("{tiles} tiles in {seconds:.1f} s ({rate:.3g} per second) on {device}.")
    feedback.pushInfo(text.format(tiles=tiles, seconds=seconds, rate=rate, device=device))
    why = " ".join(map(worded, model.fallbacks))
    return {DEVICE: f"{device} ({why})" if why else device, TILES_PER_SECOND: rate}


class PhotoLabelReader:
    """Reads photos, as ``pipeline.LabelReader``; logs the network and its speed.

    Raises Canceled, and ModelError if the model is unusable or lacks a reference class of ``table``.
    """

    def __init__(self, model_path: str, table: ClassTable, feedback: QgsProcessingFeedback) -> None:
        require([ONNXRUNTIME])
        from ...core.segmentation.photo_labels import PhotoReader

        self._model = open_model(model_path)
        self._read = PhotoReader(self._model, table, open_photo_file, self._follow)
        self._feedback = feedback
        self._is_described = False
        self._seconds, self._begun, self._working, self._counting = 0.0, 0.0, 0, Lock()

    @property
    def resolution_m(self) -> float | None:
        """Pixel size that the network was trained on; None if its metadata lack it."""
        return self._model.settings.resolution_m

    @property
    def stated_biases(self) -> str:
        """Class offsets for the metadata of label maps of this model."""
        from ...core.segmentation.class_bias import class_bias_text

        return class_bias_text(self._model.class_bias)

    def __call__(self, path: str, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
        return self._read(path, camera, with_pixels)

    def _follow(self, path: str, photo: GdalImage, labels: PhotoLabels) -> SeenLabels:
        """Label a photo. Raises Canceled."""
        check_canceled(self._feedback)
        with self._counting:
            is_first, self._is_described = not self._is_described, True
        if is_first:
            describe(self._model, photo, self._feedback)
            self._log_pixel_size(path, labels)
        if labels.is_thorough:
            text = tr("{image}: no position. The network segments it again, turned and mirrored.")
            self._feedback.pushInfo(text.format(image=os.path.basename(path)))
        with self._timed(), closing(labels.steps()) as steps:
            share, found = advance(steps)
            while share is not None:
                check_canceled(self._feedback)
                share, found = advance(steps)
        return found

    @contextmanager
    def _timed(self) -> Iterator[None]:
        """Add to the seconds in which at least one thread labels a photo."""
        with self._counting:
            self._begun = self._begun if self._working else time.perf_counter()
            self._working += 1
        try:
            yield
        finally:
            with self._counting:
                self._working -= 1
                self._seconds += 0.0 if self._working else time.perf_counter() - self._begun

    def _log_pixel_size(self, path: str, labels: PhotoLabels) -> None:
        """Log the pixel size of the first photo only, because the others are of the same flight."""
        if labels.camera_pixel_size_m is None:
            return
        text = tr(
            "{image}: the ground sampling distance is {size:.3g} cm, from the height and the lens of the camera. The "
            "network uses the photo at {resolution:.3g} cm, as in its training."
        )
        size, resolution = 100 * labels.camera_pixel_size_m, 100 * (self.resolution_m or 0.0)
        self._feedback.pushInfo(text.format(image=os.path.basename(path), size=size, resolution=resolution))

    def log_pace(self) -> dict[str, Any]:
        """Log and return ``log_pace`` of the run; nothing if the network saw no photo."""
        return log_pace(self._model, self._seconds, self._feedback) if self._model.tiles_seen else {}


def open_photo_file(path: str) -> Photo:
    """Open a photo with the ground size of its pixels. Raises ImageError."""
    from ...core.labels.image_source import Photo
    from ...storage.label_images import open_photo
    from ..layers.layer_inputs import pixel_size_m, stated_crs

    photo = open_photo(path)
    return Photo(photo, pixel_size_m(photo, stated_crs(path)))


def describe(model: SegmentationModel, image: GdalImage, feedback: QgsProcessingFeedback) -> None:
    """Log the network, the device, the bands, and which metadata of the model were not used."""
    text = tr("{model}: {classes}. Device: {provider}, tiles of {width} × {height} pixels.")
    classes = ", ".join(model.classes.names)
    provider = model.device.title
    height, width = model.tile_hw
    feedback.pushInfo(text.format(model=model.path, classes=classes, provider=provider, width=width, height=height))
    for fallback in model.fallbacks:
        feedback.pushWarning(worded(fallback))
    red, green, blue = image.bands
    feedback.pushInfo(tr("Red, green and blue: bands {red}, {green}, {blue}.").format(red=red, green=green, blue=blue))
    if image.stretch is not None:
        limits = ", ".join(f"{least:g}–{most:g}" for least, most in image.stretch)
        feedback.pushInfo(tr("Stretched to 8 bits from {limits}.").format(limits=limits))
    for name, bias in model.class_bias.items():
        east, north = bias.east, bias.north
        text = tr(
            "{name}: the metadata of the model contain a class offset of {east:+.2f} m east and {north:+.2f} m north."
        )
        feedback.pushInfo(text.format(name=name, east=east, north=north))
    for note in model.notes:
        feedback.pushWarning(worded(note))
