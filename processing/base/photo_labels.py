"""Label images of photos: what a network sees in them, in the classes of a database."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingFeedback, QgsProcessingOutputNumber, QgsProcessingOutputString

from ...core.labels.class_table import ClassTable
from ..messages.sentences import worded
from ..packages.components import ONNXRUNTIME, require
from ..packages.devices import chosen_device
from ..threads import worker_threads
from ..translation import tr
from .algorithm import check_canceled

if TYPE_CHECKING:
    from ...core.geometry.camera import Camera
    from ...core.labels.class_shares import SeenLabels
    from ...core.labels.image_source import Photo
    from ...core.segmentation.model import SegmentationModel
    from ...core.segmentation.photo_labels import PhotoLabels
    from ...storage.images import GdalImage

DEVICE, TILES_PER_SECOND = "DEVICE", "TILES_PER_SECOND"
"""Keys of what algorithms tell of a network's run."""


def open_model(path: str, table: ClassTable | None = None) -> SegmentationModel:
    """A network on the device of the options. Raises ModelError."""
    from ...core.segmentation.model import SegmentationModel

    return SegmentationModel(path, worker_threads(), table, chosen_device())


def pace_results() -> tuple[QgsProcessingOutputString, QgsProcessingOutputNumber]:
    """What algorithms tell of a network's run, beside what they write."""
    return (
        QgsProcessingOutputString(DEVICE, tr("What ran the network")),
        QgsProcessingOutputNumber(TILES_PER_SECOND, tr("Tiles a second")),
    )


@dataclass(frozen=True)
class NetworkPace:
    """What ran a network, and how fast.

    Attributes:
        seconds: That it took, with reading images and putting tiles together.
    """

    model: SegmentationModel
    seconds: float

    @property
    def results(self) -> dict[str, Any]:
        """What algorithms tell, by key."""
        why = " ".join(map(worded, self.model.fallbacks))
        device = self.model.device.title
        return {DEVICE: f"{device} ({why})" if why else device, TILES_PER_SECOND: self._rate}

    @property
    def _rate(self) -> float:
        return self.model.tiles_seen / self.seconds if self.seconds else 0.0

    def sentence(self) -> str:
        """One sentence in the user's language."""
        text = tr("{tiles} tiles in {seconds:.1f} s, {rate:.3g} a second on {device}.")
        rate, device = self._rate, self.model.device.title
        return text.format(tiles=self.model.tiles_seen, seconds=self.seconds, rate=rate, device=device)


class PhotoLabelReader:
    """Reads photos, as ``pipeline.LabelReader``; says what the network is and how fast it ran.

    Raises ModelError when the model is unusable or does not know a reference class of ``table``, and Canceled.
    """

    def __init__(self, model_path: str, table: ClassTable, feedback: QgsProcessingFeedback) -> None:
        require([ONNXRUNTIME])
        from ...core.segmentation.photo_labels import PhotoReader

        self._model = open_model(model_path)
        self._read = PhotoReader(self._model, table, _open_photo, self._follow)
        self._feedback = feedback
        self._is_described = False
        self._seconds = 0.0

    @property
    def resolution_m(self) -> float | None:
        """Pixel size that the network was trained on; None where it does not say."""
        return self._model.settings.resolution_m

    @property
    def stated_biases(self) -> str:
        """What label maps that the model makes carry along."""
        from ...core.segmentation.class_bias import class_bias_text

        return class_bias_text(self._model.class_bias)

    def __call__(self, path: str, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
        return self._read(path, camera, with_pixels)

    def _follow(self, path: str, photo: GdalImage, labels: PhotoLabels) -> Iterator[float]:
        """Goes through the steps of a photo."""
        if not self._is_described:
            describe(self._model, photo, self._feedback)
            self._is_described = True
            self._log_pixel_size(path, labels)
        begun = time.perf_counter()
        for share in labels.steps():
            check_canceled(self._feedback)
            yield share
        self._seconds += time.perf_counter() - begun

    def _log_pixel_size(self, path: str, labels: PhotoLabels) -> None:
        """Of the first photo: the others are of the same flight."""
        if labels.camera_pixel_size_m is None:
            return
        text = tr(
            "{image}: a pixel shows {size:.3g} cm of the ground, by the camera’s height and lens; the network sees "
            "the photo at {resolution:.3g} cm a pixel, as it was trained."
        )
        size, resolution = 100 * labels.camera_pixel_size_m, 100 * (self.resolution_m or 0.0)
        self._feedback.pushInfo(text.format(image=os.path.basename(path), size=size, resolution=resolution))

    @property
    def pace(self) -> NetworkPace:
        """What ran, and how fast."""
        return NetworkPace(self._model, self._seconds)


def _open_photo(path: str) -> Photo:
    from ...core.labels.image_source import Photo
    from ...storage.label_images import open_photo
    from ..layers.images import pixel_size_m, stated_crs

    photo = open_photo(path)
    return Photo(photo, pixel_size_m(photo, stated_crs(path)))


def describe(model: SegmentationModel, image: GdalImage, feedback: QgsProcessingFeedback) -> None:
    """Says what runs, which bands it sees, and what of the model's metadata was overruled."""
    text = tr("{model}: {classes}; run by {provider}, tiles of {width} × {height} pixels.")
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
        text = tr("{name}: shown {east:+.2f} m east and {north:+.2f} m north of where it is, as the model says.")
        feedback.pushInfo(text.format(name=name, east=east, north=north))
    for note in model.notes:
        feedback.pushWarning(worded(note))
