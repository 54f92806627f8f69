"""Images that are localized: label images with how they are shifted, and photos that are not too large."""

from __future__ import annotations

import numpy as np

from ..core.errors import ImageError
from ..core.geometry.camera import Camera
from ..core.labels.class_shares import SeenLabels
from ..core.labels.class_table import ClassTable
from ..core.labels.image_files import MAXIMUM_IMAGE_PIXELS
from ..core.segmentation.class_bias import KEY, KnownBiases, known_biases, read_class_bias
from .images import GdalImage
from .rasters import read_label_image, stated_biases


class LabelImageReader:
    """Reads label images: ``label_images(path)`` gives (H, W) uint8 labels in the classes of a table."""

    stated_biases = ""
    pace = None

    def __init__(self, table: ClassTable) -> None:
        """Keeps the table.

        Args:
            table: Of the database.
        """
        self._table = table

    def __call__(self, path: str) -> np.ndarray:
        """Labels of an image. Raises SemRefError."""
        return read_label_image(path, self._table)

    def seen(self, path: str, camera: Camera | None = None) -> SeenLabels:
        """Labels of an image, which tell no scores. Raises SemRefError."""
        return SeenLabels(self(path))

    def seen_with_pixels(self, path: str, camera: Camera | None = None) -> tuple[SeenLabels, None]:
        """The same; there are no other pixels."""
        return self.seen(path), None

    def biases(self, path: str) -> KnownBiases:
        """How the labels of an image are shifted: as the network says that made it, if one did."""
        stated = stated_biases(path)
        if stated is None:
            return KnownBiases()
        return known_biases(read_class_bias({KEY: stated}, None, path), self._table)


def opened_photo(path: str) -> GdalImage:
    """A photo; raises ImageError for one that is too large."""
    photo = GdalImage(path)
    height, width = photo.shape_hw
    if height * width > MAXIMUM_IMAGE_PIXELS:
        raise ImageError(
            "labels.image_too_large",
            path=path,
            width=width,
            height=height,
            most_million=MAXIMUM_IMAGE_PIXELS // 1_000_000,
        )
    return photo
