"""Pictures of an image and its labels, as the dock paints them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from qgis.PyQt.QtGui import QImage

from ....processing.inspection.image import ImageInspector, ImageQuery, InspectedImage, photo_rgba
from ...running.background import changed_at, latest_database

LONGEST_SHOWN_PX = 1600
"""Larger images are reduced, because a dock is a few hundred pixels wide."""

_PICTURES_KEPT = 4
"""Number of cached pictures, up to 20 MB each, for quick steps between images."""


@dataclass(frozen=True)
class ImagePicture:
    """Pictures of one image.

    Attributes:
        photo: Pixels; None for a label image.
        labels: Labels in the colors of the classes, possibly reduced.
        seen: Labels, landmarks and vector of the image.
        colors: '#rrggbb' by class value.
    """

    path: str
    photo: QImage | None
    labels: QImage
    seen: InspectedImage
    colors: Mapping[int, str]

    @property
    def size_wh(self) -> tuple[int, int]:
        """Width and height of the image in pixels."""
        height, width = self.seen.labels_hw.shape
        return width, height


class PictureShelf:
    """Creates pictures and caches the last few; for one background thread at a time."""

    def __init__(self) -> None:
        self._inspector = ImageInspector()
        self._kept = lru_cache(maxsize=_PICTURES_KEPT)(self._make)

    def read(self, query: ImageQuery, database: str) -> ImagePicture:
        """Return the picture of an image, with its vector for the windows of a database.

        Raises:
            SemRefError: Image, database or model can't be used.
        """
        files = query.image, query.labels, query.model, database
        return self._kept(query, database, *map(changed_at, files))

    def _make(self, query: ImageQuery, path: str, *_changed: float | None) -> ImagePicture:
        database = latest_database(path)
        table = database.class_table
        photo = picture_of(photo_rgba(query.image, LONGEST_SHOWN_PX)) if query.model else None
        seen = self._inspector.inspect(query, database)
        labels = label_picture(seen.labels_hw, {c.value: c.rgb for c in table})
        return ImagePicture(query.image, photo, labels, seen, {c.value: c.color for c in table})


def label_picture(labels_hw: np.ndarray, colors: Mapping[int, tuple[int, int, int]]) -> QImage:
    """Return labels in the colors of their classes; unlabeled pixels are transparent.

    Args:
        labels_hw: (H, W) uint8.
        colors: (r, g, b) by value.
    """
    step = -(-max(labels_hw.shape) // LONGEST_SHOWN_PX)
    shown = np.ascontiguousarray(labels_hw[::step, ::step])
    palette = np.zeros((256, 4), np.uint8)
    for value, color in colors.items():
        palette[value] = (*color, 255)
    palette[0] = 0
    return picture_of(palette[shown])


def picture_of(pixels_rgba: np.ndarray) -> QImage:
    """Return an image of (H, W, 4) uint8 pixels, each opaque or 0, in the format that Qt paints.

    Qt would convert other formats in its thread pool while the main thread waits and holds Python's lock. Python tasks
    that fill the pool wait for that lock, which is a deadlock.
    """
    pixels = np.ascontiguousarray(pixels_rgba[..., [2, 1, 0, 3]])
    height, width = pixels.shape[:2]
    # The copy owns its bytes; an image made from a buffer does not.
    return QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_ARGB32_Premultiplied).copy()
