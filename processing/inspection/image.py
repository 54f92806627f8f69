"""One image for the dock: its labels, its landmarks, and its topology vector."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from qgis.core import QgsProcessingFeedback

from ..jobs.photo_labels import PhotoLabelReader

if TYPE_CHECKING:
    import numpy as np

    from ...core.database.model import ReferenceDatabase
    from ...core.landmarks.landmarks import Landmarks


@dataclass(frozen=True)
class ImageQuery:
    """An image, and what is known from its localization.

    Attributes:
        labels: Path of the label image of a photo; empty without one.
        model: Path of the network for photos; empty if ``image`` is a label image.
        pixel_size_m: Ground sampling distance; None if unknown.
    """

    image: str
    labels: str = ""
    model: str = ""
    pixel_size_m: float | None = None


@dataclass(frozen=True)
class InspectedImage:
    """What an image shows; positions in its pixel coordinates (column, row).

    Attributes:
        labels_hw: (H, W) uint8 class values.
        vector: (3·X,) float32, topology vector; None with fewer than three landmarks.
    """

    labels_hw: np.ndarray
    landmarks: Landmarks
    vector: np.ndarray | None


class ImageInspector:
    """Describes images like the windows of a database; for one thread at a time.

    A network is loaded only for photos without label images, as in saved results, and stays loaded.
    """

    def __init__(self) -> None:
        self._network: tuple[tuple, PhotoLabelReader | None] = ((), None)

    def inspect(self, query: ImageQuery, database: ReferenceDatabase) -> InspectedImage:
        """Read an image and describe it. Raises SemRefError: the image or the model cannot be used."""
        from ...core.landmarks.landmarks import extract_landmarks
        from ...core.localizer.localizer import describe_image

        table, parameters = database.class_table, database.parameters
        labels_hw = self._labels(query, database)
        fraction = parameters.minimum_area / parameters.window_size**2
        described = describe_image(labels_hw, table.reference_values, fraction, parameters.references_per_vector)
        smallest_px2 = _smallest_px2(query, database, described.size)
        landmarks = extract_landmarks(labels_hw, table.reference_values, smallest_px2)
        return InspectedImage(labels_hw, landmarks, described.vector)

    def _labels(self, query: ImageQuery, database: ReferenceDatabase) -> np.ndarray:
        from ...storage.label_images import read_label_image

        if query.labels or not query.model:
            return read_label_image(query.labels or query.image, database.class_table)
        key = query.model, database.class_table
        if self._network[0] != key:
            self._network = key, PhotoLabelReader(query.model, database.class_table, QgsProcessingFeedback(False))
        return self._network[1](query.image).labels_hw


def _smallest_px2(query: ImageQuery, database: ReferenceDatabase, size: int) -> float:
    """Return the smallest area of a landmark.

    It is the database's on the ground if the pixel size is known, otherwise the same share of the image as of a window.
    """
    from ...core.constellation.hypotheses import SMALLEST_OBJECT_PX

    parameters = database.parameters
    if query.pixel_size_m is None:
        return parameters.minimum_area / parameters.window_size**2 * size**2
    return max(parameters.minimum_area / query.pixel_size_m**2, SMALLEST_OBJECT_PX)


def photo_rgba(path: str, longest_px: int) -> np.ndarray:
    """Return the colors of a photo as a network gets them.

    Args:
        longest_px: Photos with a longer side are reduced.

    Returns:
        (H, W, 4) uint8 red, green, blue and opacity (0 or 255).

    Raises:
        ImageError: The photo cannot be read.
    """
    import numpy as np

    from ...storage.images import GdalImage

    photo = GdalImage(path)
    height, width = photo.shape_hw
    step = -(-max(height, width) // longest_px)
    if step > 1:
        photo = GdalImage(path, (max(1, width // step), max(1, height // step)))
        height, width = photo.shape_hw
    rgb, known = photo.read(0, 0, width, height)
    opacity = np.full((height, width), 255, np.uint8) if known is None else np.where(known, 255, 0).astype(np.uint8)
    return np.dstack([rgb, opacity])
