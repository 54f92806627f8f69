"""What SemRef sees in one image: its pixels, its labels, its landmarks and the star of its topology vector."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from qgis.core import QgsProcessingFeedback
from qgis.PyQt.QtGui import QImage

from ..core.database import ReferenceDatabase
from ..core.topology_vector import vector_objects

LONGEST_SHOWN_PX = 1600
"""Larger images are shown reduced: a dock is a few hundred pixels wide."""


@dataclass(frozen=True)
class ImagePicture:
    """One image, to be shown; positions in its own pixel coordinates (column, row).

    width, height: of the image; photo: its pixels, None for a label image;
    labels: its label map in the classes' colours, perhaps reduced;
    objects: ReferenceObjects of the whole image; star: (K, 2) centres of the landmarks of its topology vector, in the
    vector's order; colors: '#rrggbb' by class value; vector: (3·X,) float32 or None; square: (column, row, edge) of the
    part that the vector describes.
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


def read_picture(path: str, database: ReferenceDatabase, model: str = "") -> ImagePicture:
    """Reads and describes an image as ``database`` describes its windows; with a model, a photo. Raises SemRefError."""
    # Not at the top: the dock has to open, and say so, where OpenCV is missing.
    from ..core.localizer import describe_image
    from ..core.reference_objects import extract_reference_objects
    from ..processing.exchange.rasters import read_label_image

    table, parameters = database.class_table, database.parameters
    photo = photo_picture(path) if model else None
    labels = _photo_labels(path, table, model) if model else read_label_image(path, table)
    fraction = parameters.minimum_area / parameters.window_size**2
    described = describe_image(labels, table.reference_values, fraction, parameters.references_per_vector)
    inside, half = described.objects, described.size / 2
    kept = vector_objects(
        inside.centers_xy, inside.classes, (half, half), table.reference_values, parameters.references_per_vector
    )
    height, width = labels.shape
    return ImagePicture(
        path,
        width,
        height,
        photo,
        label_picture(labels, {c.value: c.rgb for c in table}),
        extract_reference_objects(labels, table.reference_values, fraction * described.size**2),
        inside.centers_xy[kept] + described.first_xy,
        {c.value: c.color for c in table},
        described.vector,
        (*described.first_xy, described.size),
    )


def label_picture(labels_hw: np.ndarray, colors: dict) -> QImage:
    """A label map in its classes' colours ((r, g, b) by value); unlabelled pixels are transparent."""
    step = -(-max(labels_hw.shape) // LONGEST_SHOWN_PX)
    shown = np.ascontiguousarray(labels_hw[::step, ::step])
    palette = np.zeros((256, 4), np.uint8)
    for value, color in colors.items():
        palette[value] = (*color, 255)
    palette[0] = 0
    return _picture_of(palette[shown])


def photo_picture(path: str) -> QImage:
    """The photo as the network sees its colours."""
    from ..processing.exchange.images import GdalImage

    photo = GdalImage(path)
    height, width = photo.shape_hw
    step = -(-max(height, width) // LONGEST_SHOWN_PX)
    if step > 1:
        photo = GdalImage(path, (width // step, height // step))
        height, width = photo.shape_hw
    rgb, known = photo.read(0, 0, width, height)
    alpha = np.full((height, width), 255, np.uint8) if known is None else np.where(known, 255, 0).astype(np.uint8)
    return _picture_of(np.dstack([rgb, alpha]))


def _photo_labels(path: str, table, model: str) -> np.ndarray:
    from ..processing.photo_labels import PhotoLabels

    return PhotoLabels(model, table, QgsProcessingFeedback(False))(path)


def _picture_of(pixels_rgba: np.ndarray) -> QImage:
    pixels = np.ascontiguousarray(pixels_rgba)
    height, width = pixels.shape[:2]
    # The copy owns its bytes; an image made from a buffer does not.
    return QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_RGBA8888).copy()
