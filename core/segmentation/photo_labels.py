"""The one road from a photo to its label image: for QGIS, the command line on board and the tools."""

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
"""Heights by which a photo would be enlarged more are not believed: nothing is gained, and it would take hours."""


class PhotoLabels:
    """A photo's labels on its own pixels, seen by the network at its own resolution.

    Iterate ``steps()``, then take ``labels_hw`` and ``shares``. ``shares`` are the probable shares of classes; None of
    a model that doesn't state how to make probabilities of its scores.

    Attributes:
        image: The photo as the network sees it.
        told_pixel_size_m: Ground meters a pixel, where height and lens told how large the network has to see the photo.
    """

    def __init__(
        self,
        model: SegmentationModel,
        photo: ImageSource,
        values: Sequence[int],
        pixel_size_m: tuple[float, float] | None = None,
        camera: Camera | None = None,
    ) -> None:
        """Nothing is read yet.

        Args:
            values: (C,) class value of each of the model's channels.
            pixel_size_m: Ground meters along a row and along a column of a pixel; None where the photo doesn't say.
            camera: What is known of it; its height and lens count where the photo doesn't say.

        Raises:
            ImageError: Nothing is left of the photo at the model's resolution.
        """
        self._model = model
        self._shape_hw = photo.shape_hw
        self._values = values
        resolution_m = model.settings.resolution_m
        self.told_pixel_size_m: float | None = None
        if pixel_size_m is None and camera is not None and resolution_m:
            told = _believed(camera.pixel_size(photo.shape_hw), resolution_m)
            self.told_pixel_size_m, pixel_size_m = told, None if told is None else (told, told)
        self.image = at_resolution(photo, pixel_size_m, resolution_m)
        self.labels_hw = np.empty((0, 0), np.uint8)
        self.shares: ClassShares | None = None

    def steps(self) -> Iterator[float]:
        """Yield the share done (0…1) tile by tile; raises what ``tiling.segment`` raises."""
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
        """Return (H, W) uint8 labels, for who needn't follow the steps."""
        return self.seen().labels_hw

    def seen(self) -> SeenLabels:
        """Label and shares, for who needn't follow the steps."""
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
        """Matches the network's classes with the database's.

        Args:
            open_photo: Opens a file.
            follow: Goes through the steps of a photo; None for who needn't see them.

        Raises:
            ModelError: The network lacks a landmark class of the database.
        """
        self._model, self._open, self._follow = model, open_photo, follow
        self._values = model.classes.values_in(table, model.path)
        self._biases = known_biases(model.class_bias, table)

    def __call__(self, path: str, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
        """As ``pipeline.LabelReader``; a photo whose pixels are needed is read once, all in memory."""
        return self.read(path, self._open(path), camera, with_pixels)

    def read(self, path: str, photo: Photo, camera: Camera | None = None, with_pixels: bool = False) -> SeenLabels:
        """Return the same of a photo that is open.

        Args:
            photo: Its pixels, and how large they are.
            camera: What is known of it.
            with_pixels: Whether its pixels are needed besides.
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


def _believed(pixel_size_m: float | None, resolution_m: float) -> float | None:
    return pixel_size_m if pixel_size_m is not None and pixel_size_m <= MOST_ENLARGED * resolution_m else None
