"""Label photos with a network, for QGIS, the command line on board and the tools.

The network's scores become shares of classes on a coarse grid, row by row, so that no image of scores is stored. The
photo itself is kept on the same grid: map correlation compares its edges with the map's outlines.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Callable

import numpy as np

from ..geometry.camera import Camera
from ..labels.class_shares import FULL, ClassShares, SeenLabels
from ..labels.class_table import UNLABELED, ClassTable
from ..labels.image_files import read_photo
from ..labels.image_source import ArrayImage, ImageSource, Photo
from ..steps import Shares, result_of
from .certainty import NO_DATA, Certainty
from .class_bias import known_biases
from .grid_means import GridMeans, grid_of, picture_steps
from .model import SegmentationModel
from .resampling import at_resolution
from .tiling import SegmentedRows, nearest_labels, segment, tiles_of

MOST_ENLARGED = 4.0
"""Largest enlargement of a photo by camera height: a larger one would gain nothing and take hours."""

MOST_TILES_AGAIN = 16
"""Largest number of tiles of a photo that is labeled again if it has no position: a second look takes 8 times as long,
and large photos show so much ground that they need it less. Set by hand, for the time."""


class PhotoLabels:
    """Labels of a photo on its own pixels, from a network at its own resolution.

    Attributes:
        image: The photo at the network's resolution.
        camera_pixel_size_m: Ground meters per pixel from height and lens, if they set the resolution.
        is_thorough: Whether all orientations of a tile are averaged.
    """

    def __init__(  # noqa: PLR0913 - a network, a photo, and what is known of its scale
        self,
        model: SegmentationModel,
        photo: ImageSource,
        values: Sequence[int],
        pixel_size_m: tuple[float, float] | None = None,
        camera: Camera | None = None,
        is_thorough: bool = False,
    ) -> None:
        """Read nothing yet.

        Args:
            values: (C,) class value of each of the model's channels.
            pixel_size_m: Ground meters along a row and along a column of a pixel; None if the photo does not state it.
            camera: Of the photo; its height and lens give the pixel size if the photo does not state it.
            is_thorough: Whether to average all orientations of a tile, which takes 8 times as long.

        Raises:
            ImageError: The photo has no pixel left at the model's resolution.
        """
        self._model = model
        self._photo, self._shape_hw = photo, photo.shape_hw
        self._values = values
        self.is_thorough = is_thorough
        resolution_m = model.settings.resolution_m
        self.camera_pixel_size_m: float | None = None
        if pixel_size_m is None and camera is not None and resolution_m:
            size = camera.pixel_size(photo.shape_hw)
            if size is not None and size <= MOST_ENLARGED * resolution_m:
                self.camera_pixel_size_m, pixel_size_m = size, (size, size)
        self.image = at_resolution(photo, pixel_size_m, resolution_m)

    @property
    def tile_count(self) -> int:
        """Number of tiles of the photo. Raises ImageError if it has only a few pixels."""
        tiles = tiles_of(self._model, self.image.shape_hw, self._model.settings.overlap)
        return len(tiles.columns) * len(tiles.rows)

    def steps(self) -> Shares[SeenLabels]:
        """Yield the share done (0…1) tile by tile; raise what ``tiling.segment`` raises.

        Returns:
            Labels with the shares of classes: probable ones if the model states the temperature of its scores.
        """
        shape_hw = self.image.shape_hw
        size_wh = grid_of(shape_hw)
        found, sums = [], ScoreShares(self._values, shape_hw, size_wh)
        wanted, overlap = Certainty(of_each=self._model.temperature is not None), self._model.settings.overlap
        steps = segment(self._model, self.image, self._values, overlap, wanted, is_thorough=self.is_thorough)
        for share, rows in steps:
            if rows is not None:
                found.append(rows.labels_hw)
                sums.add(rows)
            yield share
        labels_hw = nearest_labels(np.concatenate(found), self._shape_hw)
        picture = yield from picture_steps(self._photo, size_wh)
        return SeenLabels(labels_hw, sums.found(picture), self._model.trained_on)

    def found(self) -> np.ndarray:
        """Return (H, W) uint8 labels, for callers that do not need the steps."""
        return self.seen().labels_hw

    def seen(self) -> SeenLabels:
        """Return labels and shares, for callers that do not need the steps."""
        return result_of(self.steps())


class PhotoReader:
    """Reads photos as labels in the classes of a database."""

    def __init__(
        self,
        model: SegmentationModel,
        table: ClassTable,
        open_photo: Callable[[str], Photo] = read_photo,
        follow: Callable[[str, ImageSource, PhotoLabels], SeenLabels] | None = None,
    ) -> None:
        """Match the network's classes with the database's.

        Args:
            follow: Returns the result of a photo's steps; None for callers that do not need the steps.

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
            with_pixels: Whether the caller also needs its pixels.
        """
        pixels, image = None, photo.image
        if with_pixels:
            height, width = image.shape_hw
            pixels = image.read(0, 0, width, height)
            image = ArrayImage(*pixels)

        def look(is_thorough: bool) -> SeenLabels:
            labels = PhotoLabels(self._model, image, self._values, photo.pixel_size_m, camera, is_thorough)
            seen = labels.seen() if self._follow is None else self._follow(path, photo.image, labels)
            is_worth_it = not is_thorough and labels.tile_count <= MOST_TILES_AGAIN
            look_again = partial(look, True) if is_worth_it else None
            return replace(seen, biases=self._biases, pixels=pixels, look_again=look_again)

        return look(is_thorough=False)


class ScoreShares:
    """Adds up the percents of rows; ``found`` returns the shares of classes on a grid, without their rows in memory."""

    def __init__(self, values: Sequence[int], shape_hw: tuple[int, int], size_wh: tuple[int, int]) -> None:
        """Start with empty sums.

        Args:
            values: (C,) class value of each channel; several may have the same one, 0 is not a class.
            shape_hw: (height, width) of the image at the network's resolution.
            size_wh: (w, h) of the grid, at most that of the image.
        """
        self._channels = np.asarray(values)
        self._values = np.unique(self._channels[self._channels != UNLABELED]).astype(np.uint8)
        self._means = GridMeans(shape_hw, size_wh, len(self._values))

    def add(self, rows: SegmentedRows) -> None:
        """Add rows. Pixels without data are unknown; labels without percents count as certain."""
        self._means.add(rows.first, (self._percents(rows, value) for value in self._values))

    def _percents(self, rows: SegmentedRows, value: int) -> np.ndarray:
        """Return (rows, W) float32 percents of a class."""
        if rows.percents_chw is None:
            return (rows.labels_hw == value) * np.float32(100)
        has_data = rows.percents_chw[0] != NO_DATA
        return rows.percents_chw[self._channels == value].sum(axis=0, dtype=np.float32) * has_data

    def found(self, picture: np.ndarray | None = None) -> ClassShares:
        """Return the shares, once all rows are added, with the photo on the same grid."""
        shares = np.rint(np.clip(self._means.found() / 100, 0, 1) * FULL).astype(np.uint8)
        return ClassShares(self._values, shares, picture)
