"""THE localiser: a label image and a reference database in, one result out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Tuple

import numpy as np

from .database import ReferenceDatabase
from .errors import DatabaseError, LabelMapError
from .matching import DISTANCE_THRESHOLD, vector_confidence, vector_distances
from .reference_objects import ReferenceObjects, extract_reference_objects
from .topology_vector import MINIMUM_REFERENCES, topology_vector
from .window_grid import centered_square

FIX = "fix"
NO_MATCH = "no_match"
TOO_FEW_REFERENCES = "too_few_references"

TOPOLOGY_VECTOR = "topology vector"


@dataclass(frozen=True)
class Localization:
    """What is known of an image's position; None where a method doesn't tell.

    status: ``fix``, ``no_match`` or ``too_few_references``; reason: one sentence without a fix, else empty.
    position: map coordinates (x, y) of the image's centre; heading_deg: of the image's top, clockwise from grid north;
    pixel_size_m: ground sampling distance; error_95_m: radius; distance: of topology vectors;
    references: reference objects described; inliers: those that agree with the map.
    """

    status: str
    method: str
    references: int
    reason: str = ""
    position: Optional[Tuple[float, float]] = None
    heading_deg: Optional[float] = None
    pixel_size_m: Optional[float] = None
    confidence: float = 0.0
    distance: Optional[float] = None
    inliers: Optional[int] = None
    log_odds: Optional[float] = None
    error_95_m: Optional[float] = None
    window: Optional[str] = None
    window_index: Optional[int] = None


@dataclass(frozen=True)
class DescribedImage:
    """The largest centred square of an image, described.

    first_xy: its first pixel (column, row); size: its edge in pixels; objects: in the square's own pixels.
    """

    first_xy: Tuple[int, int]
    size: int
    objects: ReferenceObjects
    vector: Optional[np.ndarray]


def describe_image(
    labels_hw: np.ndarray, reference_values: Tuple[int, ...], area_fraction: float, references_per_vector: int
) -> DescribedImage:
    """Describes an image as a window is described: in its largest centred square, objects and topology vector.

    ``labels_hw``: (H, W) uint8; ``area_fraction``: smallest area of an object as a fraction of the square's.
    Raises LabelMapError for an image without pixels.
    """
    column, row, size = centered_square(labels_hw.shape)
    if size < 1:
        raise LabelMapError("The image has no pixels.")
    square = np.ascontiguousarray(labels_hw[row:row + size, column:column + size])
    objects = extract_reference_objects(square, reference_values, area_fraction * size * size)
    vector = topology_vector(
        objects.centers_xy, objects.classes, (size / 2, size / 2), reference_values, references_per_vector
    )
    return DescribedImage((column, row), size, objects, vector)


class Localizer:
    """Localises label images in one database. Raises DatabaseError when no window can be matched."""

    def __init__(self, database: ReferenceDatabase) -> None:
        self._database = database
        windows = database.windows
        if not windows.described.any():
            raise DatabaseError(
                f"No window of the database has the {MINIMUM_REFERENCES} reference objects a topology vector needs; "
                "build it with larger windows, a smaller minimum area or more reference classes."
            )
        self._levels = []
        for size in np.unique(windows.sizes[windows.described]):
            index = np.flatnonzero(windows.described & (windows.sizes == size))
            self._levels.append((float(size), index, windows.vectors[index]))

    def localize_by_topology_vector(self, labels_hw: np.ndarray) -> Localization:
        """The published method, exactly: nearest topology vector, accepted up to distance T (DESIGN §2).

        ``labels_hw``: (H, W) uint8 labels of the database's class table. The position is the matched window's centre;
        heading and pixel size are not part of the method. With several levels the image is described once for
        each window size, because the smallest object is the same fraction of the window's area.
        """
        count, best = 0, None
        for size, index, vectors in self._levels:
            described = self.describe(labels_hw, size)
            count = max(count, len(described.objects))
            if described.vector is None:
                continue
            distances = vector_distances(described.vector, vectors)
            nearest = int(distances.argmin())
            if best is None or distances[nearest] < best[0]:
                best = float(distances[nearest]), int(index[nearest]), len(described.objects)
        if best is None:
            missing = MINIMUM_REFERENCES - count
            reason = (
                f"The image shows {count} landmark{'' if count == 1 else 's'}; "
                f"at least {missing} more {'is' if missing == 1 else 'are'} needed."
            )
            return Localization(TOO_FEW_REFERENCES, TOPOLOGY_VECTOR, count, reason)
        distance, index, count = best
        if distance > DISTANCE_THRESHOLD:
            reason = f"The nearest window has distance {distance:.3f}, more than {DISTANCE_THRESHOLD:g}."
            return Localization(NO_MATCH, TOPOLOGY_VECTOR, count, reason, distance=distance)
        windows = self._database.windows
        return Localization(
            FIX,
            TOPOLOGY_VECTOR,
            count,
            position=(float(windows.centers[index, 0]), float(windows.centers[index, 1])),
            confidence=vector_confidence(distance),
            distance=distance,
            window=str(windows.names[index]),
            window_index=index,
        )

    def describe(self, labels_hw: np.ndarray, window_size: float) -> DescribedImage:
        """The image as windows of ``window_size`` (map units) of this database are described."""
        parameters = self._database.parameters
        return describe_image(
            labels_hw,
            self._database.class_table.reference_values,
            parameters.minimum_area / window_size**2,
            parameters.references_per_vector,
        )
