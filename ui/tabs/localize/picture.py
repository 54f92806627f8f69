"""What SemRef sees in one image: pixels, labels, landmarks, its vector's star, and which landmarks are the map's."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Optional

import numpy as np
from qgis.core import QgsProcessingFeedback
from qgis.PyQt.QtGui import QImage

from ....core.database.model import ReferenceDatabase
from ....core.windows.topology_vector import vector_objects
from ...findings import RUNNERS_UP, Hit, Matches, RunnersUp
from ...running.background import DatabaseShelf

LONGEST_SHOWN_PX = 1600
"""Larger images are shown reduced: a dock is a few hundred pixels wide."""

_PICTURES_KEPT = 4
"""So that going back and forth between images is at once; a picture takes up to 20 MB."""


@dataclass(frozen=True)
class ImagePicture:
    """One image, to be shown; positions in its own pixel coordinates (column, row).

    width, height: of the image; photo: its pixels, None for a label image;
    labels: its label map in the classes' colors, perhaps reduced;
    objects: Landmarks of the whole image; star: (K, 2) centers of the landmarks of its topology vector, in the
    vector's order; colors: '#rrggbb' by class value; vector: (3·X,) float32 or None; square: (column, row, edge) of the
    part that the vector describes; matches: None without a fix that has a heading; runners_up: None but for the
    published method.
    """

    path: str
    width: int
    height: int
    photo: object
    labels: QImage
    objects: object
    star: np.ndarray
    colors: dict
    vector: object
    square: tuple
    matches: Optional[Matches] = None
    runners_up: Optional[RunnersUp] = None


class PictureShelf:
    """Reads pictures, and keeps the network and the last few; for one background thread at a time."""

    def __init__(self, databases: DatabaseShelf) -> None:
        self._databases = databases
        self._labels = (None, None)
        self._pictures: dict = {}

    def read(self, hit: Hit, database: str, model: str) -> ImagePicture:
        """Raises SemRefError."""
        key = (*(_version(path) for path in (hit.image, database, model)), hit)
        if key not in self._pictures:
            read = self._databases.read(database)
            picture = read_picture(hit, read, self._photo_labels(model, read, key[1:3]) if model else None)
            if len(self._pictures) == _PICTURES_KEPT:
                del self._pictures[next(iter(self._pictures))]
            self._pictures[key] = picture
        return self._pictures[key]

    def _photo_labels(self, model: str, database: ReferenceDatabase, key: tuple):
        from ....processing.framework.photo_labels import PhotoLabels

        if self._labels[0] != key:
            self._labels = key, PhotoLabels(model, database.class_table, QgsProcessingFeedback(False))
        return self._labels[1]


def _version(path: str) -> tuple:
    """Another one when the file has changed."""
    return (path, os.path.getmtime(path) if os.path.exists(path) else None)


def read_picture(hit: Hit, database: ReferenceDatabase, photo_labels=None) -> ImagePicture:
    """Reads and describes an image as ``database`` describes its windows.

    ``photo_labels``: function path → labels for photos; None for label images. Raises SemRefError.
    """
    # Not at the top: the dock has to open, and say so, where OpenCV is missing.
    from ....core.landmarks.landmarks import extract_landmarks
    from ....core.localizer.localizer import describe_image
    from ....storage.rasters import read_label_image

    table, parameters, path = database.class_table, database.parameters, hit.image
    photo = photo_picture(path) if photo_labels else None
    labels = photo_labels(path) if photo_labels else read_label_image(path, table)
    fraction = parameters.minimum_area / parameters.window_size**2
    described = describe_image(labels, table.reference_values, fraction, parameters.references_per_vector)
    inside, half = described.objects, described.size / 2
    kept = vector_objects(
        inside.centers_xy, inside.classes, (half, half), table.reference_values, parameters.references_per_vector
    )
    height, width = labels.shape
    objects = extract_landmarks(labels, table.reference_values, _smallest(hit, database, described.size))
    return ImagePicture(
        path,
        width,
        height,
        photo,
        label_picture(labels, {c.value: c.rgb for c in table}),
        objects,
        inside.centers_xy[kept] + described.first_xy,
        {c.value: c.color for c in table},
        described.vector,
        (*described.first_xy, described.size),
        None if hit.footprint is None else find_matches(hit, objects, labels.shape, database),
        find_runners_up(labels, database) if hit.by_vector else None,
    )


def _smallest(hit: Hit, database: ReferenceDatabase, size: int) -> float:
    """Smallest area of a landmark, px²: the database's on the ground if the image's pixel size is known, else the same
    share of the image as of a window."""
    from ....core.localizer.localizer import SMALLEST_OBJECT_PX

    parameters = database.parameters
    if hit.footprint is None:
        return parameters.minimum_area / parameters.window_size**2 * size**2
    return max(parameters.minimum_area / hit.pixel_size_m**2, SMALLEST_OBJECT_PX)


def find_matches(hit: Hit, objects, shape_hw: tuple, database: ReferenceDatabase) -> Matches:
    from ....core.constellation.matched_objects import matched_objects
    from ....core.geometry.footprint import on_ground

    references, footprint = database.references, np.array(hit.footprint)
    pose = footprint, hit.heading_deg, hit.pixel_size_m
    pairs = matched_objects(objects, shape_hw, *pose, references, database.parameters.pixel_size)
    seen = on_ground(objects.centers_xy[pairs[:, 0]], footprint, shape_hw)
    return Matches(pairs[:, 0], seen, references.positions[pairs[:, 1]])


def find_runners_up(labels_hw: np.ndarray, database: ReferenceDatabase) -> RunnersUp:
    from ....core.localizer.localizer import Localizer

    windows = database.windows
    found = Localizer(database).nearest_windows(labels_hw, RUNNERS_UP + 1)[1:]
    index = np.array([number for number, _ in found], np.int64)
    distances = np.array([distance for _, distance in found])
    return RunnersUp(windows.names[index], distances, windows.centers[index], windows.sizes[index])


def label_picture(labels_hw: np.ndarray, colors: dict) -> QImage:
    """A label map in its classes' colors ((r, g, b) by value); unlabeled pixels are transparent."""
    step = -(-max(labels_hw.shape) // LONGEST_SHOWN_PX)
    shown = np.ascontiguousarray(labels_hw[::step, ::step])
    palette = np.zeros((256, 4), np.uint8)
    for value, color in colors.items():
        palette[value] = (*color, 255)
    palette[0] = 0
    return _picture_of(palette[shown])


def photo_picture(path: str) -> QImage:
    """The photo as the network sees its colors."""
    from ....storage.images import GdalImage

    photo = GdalImage(path)
    height, width = photo.shape_hw
    step = -(-max(height, width) // LONGEST_SHOWN_PX)
    if step > 1:
        photo = GdalImage(path, (width // step, height // step))
        height, width = photo.shape_hw
    rgb, known = photo.read(0, 0, width, height)
    alpha = np.full((height, width), 255, np.uint8) if known is None else np.where(known, 255, 0).astype(np.uint8)
    return _picture_of(np.dstack([rgb, alpha]))


def _picture_of(pixels_rgba: np.ndarray) -> QImage:
    """An image of (H, W, 4) uint8 pixels, opaque or 0 throughout, in the format that Qt paints.

    Any other format is converted when it is to be shown, by Qt's own thread pool: the main thread would wait with
    Python's lock in hand, while tasks of Python that fill the pool wait for that lock – for ever.
    """
    pixels = np.ascontiguousarray(pixels_rgba[..., [2, 1, 0, 3]])
    height, width = pixels.shape[:2]
    # The copy owns its bytes; an image made from a buffer does not.
    return QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_ARGB32_Premultiplied).copy()
