"""Label photos with a network, for QGIS, the command line on board and the tools."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Callable

import numpy as np

from ..geometry.camera import Camera
from ..labels.class_shares import ClassShares, SeenLabels
from ..labels.class_table import ClassTable
from ..labels.image_files import read_photo
from ..labels.image_source import ArrayImage, ImageSource, Photo
from .certainty import Certainty
from .class_bias import known_biases
from .model import SegmentationModel
from .resampling import at_resolution
from .score_shares import ScoreShares, grid_of
from .tiling import nearest_labels, segment

MOST_ENLARGED = 4.0
"""Largest enlargement of a photo by camera height: a larger one would gain nothing and take hours."""


class PhotoLabels:
    """Labels of a photo on its own pixels, from a network at its own resolution.

    Iterate ``steps()``, then read ``labels_hw`` and ``shares``. ``shares`` are the probable shares of classes; None for
    a model that does not state the temperature of its scores.

    Attributes:
        image: The photo at the network's resolution.
        camera_pixel_size_m: Ground meters per pixel from height and lens, if they set the resolution.
    """

    def __init__(
        self,
        model: SegmentationModel,
        photo: ImageSource,
        values: Sequence[int],
        pixel_size_m: tuple[float, float] | None = None,
        camera: Camera | None = None,
    ) -> None:
        """Read nothing yet.

        Args:
            values: (C,) class value of each of the model's channels.
            pixel_size_m: Ground meters along a row and along a column of a pixel; None if the photo does not state it.
            camera: Of the photo; its height and lens give the pixel size if the photo does not state it.

        Raises:
            ImageError: The photo has no pixel left at the model's resolution.
        """
        self._model = model
        self._shape_hw = photo.shape_hw
        self._values = values
        resolution_m = model.settings.resolution_m
        self.camera_pixel_size_m: float | None = None
        if pixel_size_m is None and camera is not None and resolution_m:
            size = _plausible(camera.pixel_size(photo.shape_hw), resolution_m)
            self.camera_pixel_size_m, pixel_size_m = size, None if size is None else (size, size)
        self.image = at_resolution(photo, pixel_size_m, resolution_m)
        self.labels_hw = np.empty((0, 0), np.uint8)
        self.shares: ClassShares | None = None

    def steps(self) -> Iterator[float]:
        """Yield the share done (0…1) tile by tile; raise what ``tiling.segment`` raises."""
        found, sums = [], self._sums()
        wanted = Certainty(of_each=sums is not None)
        for share, rows in segment(self._model, self.image, self._values, self._model.settings.overlap, wanted):
            if rows is not None:
                found.append(rows.labels_hw)
                if sums is not None:
                    sums.add(rows)
            yield share
        self.labels_hw = nearest_labels(np.concatenate(found), self._shape_hw)
        self.shares = None if sums is None else sums.found()

    def _sums(self) -> ScoreShares | None:
        if self._model.temperature is None:
            return None
        shape_hw = self.image.shape_hw
        return ScoreShares(self._values, shape_hw, grid_of(shape_hw))

    def found(self) -> np.ndarray:
        """Return (H, W) uint8 labels, for callers that do not need the steps."""
        return self.seen().labels_hw

    def seen(self) -> SeenLabels:
        """Return labels and shares, for callers that do not need the steps."""
        for _ in self.steps():
            continue
        return self.seen_labels

    @property
    def seen_labels(self) -> SeenLabels:
        """Labels and shares, after the steps."""
        return SeenLabels(self.labels_hw, self.shares, self._model.trained_on)


class PhotoReader:
    """Reads photos as labels in the classes of a database."""

    def __init__(
        self,
        model: SegmentationModel,
        table: ClassTable,
        open_photo: Callable[[str], Photo] = read_photo,
        follow: Callable[[str, ImageSource, PhotoLabels], Iterable[float]] | None = None,
    ) -> None:
        """Match the network's classes with the database's.

        Args:
            open_photo: Opens a file.
            follow: Iterates over the steps of a photo; None for callers that do not need them.

        Raises:
            ModelError: The network lacks a landmark class of the database.
        """
        self._model, self._open, self._follow = model, open_photo, follow
        self._values = model.classes.values_in(table, model.path)
        self._biases = known_biases(model.class_bias, table)

    def __call__(self, path: str, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
        """Read a photo, see ``pipeline.LabelReader``; with pixels it is read once, completely into memory."""
        return self.read(path, self._open(path), camera, with_pixels)

    def read(self, path: str, photo: Photo, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
        """Return the labels of an open photo.

        Args:
            photo: Its pixels and their size.
            camera: Of the photo.
            with_pixels: Whether the caller also needs its pixels.
        """
        pixels, image = None, photo.image
        if with_pixels:
            height, width = image.shape_hw
            pixels = image.read(0, 0, width, height)
            image = ArrayImage(*pixels)
        labels = PhotoLabels(self._model, image, self._values, photo.pixel_size_m, camera)
        for _ in labels.steps() if self._follow is None else self._follow(path, photo.image, labels):
            continue
        return replace(labels.seen_labels, biases=self._biases, pixels=pixels)


def _plausible(pixel_size_m: float | None, resolution_m: float) -> float | None:
    return pixel_size_m if pixel_size_m is not None and pixel_size_m <= MOST_ENLARGED * resolution_m else None
