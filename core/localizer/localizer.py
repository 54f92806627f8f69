"""THE localizer: a label image and a reference database in, one result out."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import List, Optional, Tuple

import numpy as np

from ..constellation.hypotheses import Prior
from ..constellation.index import ConstellationIndex, build_index
from ..constellation.matched_objects import matched_objects
from ..constellation.solver import localize as solve
from ..correlation.class_pyramid import MapPyramid
from ..correlation.places import Prior as CorrelationPrior
from ..correlation.solver import MAP_CORRELATION, NOMINAL_RANGE, agreement_at
from ..correlation.solver import localize as correlate
from ..database.model import ReferenceDatabase
from ..errors import DatabaseError, LabelMapError
from ..geometry.footprint import image_corners, on_ground
from ..landmarks.landmarks import Landmarks, extract_landmarks
from ..localization import (
    AMBIGUOUS,
    AUTOMATIC,
    CONSTELLATION,
    FIX,
    METHODS,
    NO_MATCH,
    TOO_FEW_REFERENCES,
    TOPOLOGY_VECTOR,
    Localization,
    Matches,
    PossiblePlace,
    from_constellation,
    from_correlation,
)
from ..windows.grid import centered_square
from ..windows.matching import DISTANCE_THRESHOLD, vector_confidence, vector_distances
from ..windows.topology_vector import MINIMUM_REFERENCES, topology_vector
from .combined import checked_by_areas, confirmed, near, neither

__all__ = [
    "AMBIGUOUS",
    "FIX",
    "NO_MATCH",
    "TOO_FEW_REFERENCES",
    "AUTOMATIC",
    "CONSTELLATION",
    "MAP_CORRELATION",
    "METHODS",
    "TOPOLOGY_VECTOR",
    "Localization",
    "Localizer",
    "PossiblePlace",
    "Prior",
]

SCALES = (0.4, 2.5)
"""Ground searched that an image may show without a prior, as multiples of a window's edge; the goal is 0.5 to 2."""

SMALLEST_OBJECT_PX = 9.0
"""Objects of an image below this contour area have neither a shape nor a center to speak of."""


def default_scales(method: str) -> Tuple[float, float]:
    """Ground searched without a prior, as multiples of a window's edge: what the method was calibrated for.

    Automatic leaves each of its two methods its own.
    """
    return NOMINAL_RANGE if method == MAP_CORRELATION else SCALES


@dataclass(frozen=True)
class DescribedImage:
    """The largest centered square of an image, described.

    first_xy: its first pixel (column, row); size: its edge in pixels; objects: in the square's own pixels.
    """

    first_xy: Tuple[int, int]
    size: int
    objects: Landmarks
    vector: Optional[np.ndarray]


def describe_image(
    labels_hw: np.ndarray, reference_values: Tuple[int, ...], area_fraction: float, references_per_vector: int
) -> DescribedImage:
    """Describes an image as a window is described: in its largest centered square, objects and topology vector.

    ``labels_hw``: (H, W) uint8; ``area_fraction``: smallest area of an object as a fraction of the square's.
    Raises LabelMapError for an image without pixels.
    """
    column, row, size = centered_square(labels_hw.shape)
    if size < 1:
        raise LabelMapError("labels.no_pixels")
    square = np.ascontiguousarray(labels_hw[row : row + size, column : column + size])
    objects = extract_landmarks(square, reference_values, area_fraction * size * size)
    vector = topology_vector(
        objects.centers_xy, objects.classes, (size / 2, size / 2), reference_values, references_per_vector
    )
    return DescribedImage((column, row), size, objects, vector)


class Localizer:
    """Localizes label images in one database."""

    def __init__(self, database: ReferenceDatabase) -> None:
        self._database = database
        windows = database.windows
        self._index: Optional[ConstellationIndex] = None
        self._pyramid: Optional[MapPyramid] = None
        self._levels = []
        for size in np.unique(windows.sizes[windows.described]):
            index = np.flatnonzero(windows.described & (windows.sizes == size))
            self._levels.append((float(size), index, windows.vectors[index]))

    def localize_by_topology_vector(self, labels_hw: np.ndarray) -> Localization:
        """The published method, exactly: nearest topology vector, accepted up to distance T.

        Told in docs/method.md#topology-vector.

        ``labels_hw``: (H, W) uint8 labels of the database's class table. The position is the matched window's center;
        heading and pixel size are not part of the method. With several levels the image is described once for
        each window size, because the smallest object is the same fraction of the window's area.
        Raises DatabaseError when no window can be matched.
        """
        self.check(TOPOLOGY_VECTOR)
        count, nearest = self._nearest_windows(labels_hw, 1)
        if not nearest:
            missing = MINIMUM_REFERENCES - count
            reason = (
                f"The image shows {count} landmark{'' if count == 1 else 's'}; "
                f"at least {missing} more {'is' if missing == 1 else 'are'} needed."
            )
            return Localization(TOO_FEW_REFERENCES, TOPOLOGY_VECTOR, count, reason)
        distance, index, count = nearest[0]
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
            window=windows.name(index),
            window_index=index,
        )

    def nearest_windows(self, labels_hw: np.ndarray, count: int) -> List[Tuple[int, float]]:
        """(index, distance) of up to ``count`` windows with the vectors nearest to the image's, nearest first.

        ``labels_hw``: (H, W) uint8 labels of the database's class table. Empty where it shows too few landmarks.
        """
        return [(index, distance) for distance, index, _ in self._nearest_windows(labels_hw, count)[1]]

    def _nearest_windows(self, labels_hw: np.ndarray, count: int) -> Tuple[int, List[Tuple[float, int, int]]]:
        """The most landmarks the image has at any level; (distance, index, landmarks) of the nearest windows."""
        most, found = 0, []
        for size, index, vectors in self._levels:
            described = self.describe(labels_hw, size)
            most = max(most, len(described.objects))
            if described.vector is None:
                continue
            distances = vector_distances(described.vector, vectors)
            # Sorting takes a hundred times as long; both take the first of equal ones.
            nearest = [distances.argmin()] if count == 1 else np.argsort(distances, kind="stable")[:count]
            found += [(float(distances[n]), int(index[n]), len(described.objects)) for n in nearest]
        # By distance alone: of equal ones the first level's first window comes first.
        return most, sorted(found, key=lambda window: window[0])[:count]

    @property
    def index(self) -> ConstellationIndex:
        """The catalogue's triangles; built at the first use, seconds at 10⁵ objects."""
        if self._index is None:
            self._index = build_index(self._database.references, self._database.parameters.pixel_size)
        return self._index

    def localize_by_constellation(self, labels_hw: np.ndarray, prior: Optional[Prior] = None) -> Localization:
        """Landmarks as stars (docs/method.md#constellation); position, heading and pixel size of any image.

        ``labels_hw``: (H, W) uint8 labels of the database's class table. Without a prior on the pixel size,
        images are searched that show SCALES times a window's ground. Raises LabelMapError for an image without pixels.
        """
        height, width = _shape(labels_hw)
        prior = prior or Prior()
        if not prior.pixel_size_range:
            prior = replace(prior, pixel_size_range=self.pixel_sizes(labels_hw.shape, SCALES))
        objects, smallest = self._objects(labels_hw, prior.pixel_size_range[1])
        return from_constellation(solve(objects, width, height, self.index, prior, smallest))

    def _objects(self, labels_hw: np.ndarray, largest_pixel_size: float) -> Tuple[Landmarks, float]:
        """The image's landmarks, and the smallest contour area, px², that the map's may have in it."""
        parameters = self._database.parameters
        smallest = max(parameters.minimum_area / largest_pixel_size**2, SMALLEST_OBJECT_PX)
        return extract_landmarks(labels_hw, self._database.class_table.reference_values, smallest), smallest

    @property
    def pyramid(self) -> MapPyramid:
        """The overview as map correlation searches it; made at the first use. Raises DatabaseError without overview."""
        if self._pyramid is None:
            database = self._database
            if database.overview is None:
                raise DatabaseError("The database was read without its overview, which map correlation searches.")
            frame = database.parameters.overview_frame
            self._pyramid = MapPyramid(database.overview, (*frame.origin, frame.pixel_size))
        return self._pyramid

    def localize_by_map_correlation(self, labels_hw: np.ndarray, prior: Optional[Prior] = None) -> Localization:
        """By the overlap of class areas, for labels too poor for centers of gravity (docs/method.md#map-correlation).

        ``labels_hw``: (H, W) uint8 labels of the database's class table. Without a prior on the pixel size the image is
        taken to show 0.7 to 1.4 times a window's ground. Takes seconds without a prior on the position.
        """
        _shape(labels_hw)
        prior = prior or Prior()
        sizes = prior.pixel_size_range or self.pixel_sizes(labels_hw.shape, NOMINAL_RANGE)
        headings = None
        if prior.heading_deg is not None and prior.heading_range_deg < 180:
            headings = prior.heading_deg - prior.heading_range_deg, prior.heading_deg + prior.heading_range_deg
        place = (
            CorrelationPrior(prior.position, prior.radius, headings)
            if prior.position
            else CorrelationPrior(headings_deg=headings)
        )
        return from_correlation(correlate(labels_hw, self.pyramid, sizes, place))

    @property
    def has_overview(self) -> bool:
        """Whether map correlation can be used."""
        return self._database.overview is not None

    def localize_automatically(self, labels_hw: np.ndarray, prior: Optional[Prior] = None) -> Localization:
        """The constellation, checked by class areas; where that has no fix, map correlation, made finer by the first.

        ``labels_hw``: (H, W) uint8 labels of the database's class table. Without a prior on the pixel size each
        searches its own range. A database without overview leaves the constellation alone. Takes as long as map
        correlation for images without a fix by the constellation. ``method`` of a fix: whose pose it is.
        """
        objects = self.localize_by_constellation(labels_hw, prior)
        if not self.has_overview:
            return objects
        if objects.status == FIX:
            pose = objects.position, objects.heading_deg, objects.pixel_size_m
            return checked_by_areas(objects, agreement_at(labels_hw, self.pyramid, *pose))
        areas = self.localize_by_map_correlation(labels_hw, prior)
        if areas.status != FIX:
            return neither(objects, areas, min(labels_hw.shape))
        areas = replace(areas, references=objects.references)
        closer = near(areas, prior or Prior(), min(labels_hw.shape))
        found = confirmed(areas, self.localize_by_constellation(labels_hw, closer), closer.radius)
        return found or areas

    def pixel_sizes(self, shape_hw: Tuple[int, int], scales: Tuple[float, float]) -> Tuple[float, float]:
        """Smallest and largest pixel size of images whose shorter edge shows ``scales`` times a window's edge."""
        parameters = self._database.parameters
        edges = [parameters.window_size * level for level in parameters.levels]
        shorter = max(min(shape_hw), 1)
        return scales[0] * min(edges) / shorter, scales[1] * max(edges) / shorter

    def check(self, method: str) -> None:
        """Raises DatabaseError when the database can't serve ``method`` for any image."""
        if method == TOPOLOGY_VECTOR and not self._database.windows.described.any():
            raise DatabaseError(
                f"No window of the database has the {MINIMUM_REFERENCES} landmarks a topology vector needs; "
                "build it with larger windows, a smaller minimum area or more reference classes."
            )

    def localize(self, labels_hw: np.ndarray, method: str, prior: Optional[Prior] = None) -> Localization:
        """By one of METHODS."""
        if method == TOPOLOGY_VECTOR:
            return self.localize_by_topology_vector(labels_hw)
        if method == MAP_CORRELATION:
            return self.localize_by_map_correlation(labels_hw, prior)
        if method == AUTOMATIC:
            return self.localize_automatically(labels_hw, prior)
        return self.localize_by_constellation(labels_hw, prior)

    def matches(
        self, labels_hw: np.ndarray, found: Localization, footprint: Optional[np.ndarray] = None
    ) -> Optional[Matches]:
        """Which of the image's landmarks are which of the map's, as the constellation verifies a fix.

        Args:
            labels_hw: (H, W) uint8 labels of the image.
            found: what was found for it.
            footprint: (4, 2) map coordinates of the ground at its corners, upper left first, of a leveled image.

        Returns:
            None without a fix that has a heading.
        """
        if found.status != FIX or found.heading_deg is None:
            return None
        height, width = labels_hw.shape
        if footprint is None:
            footprint = image_corners(found.position, found.heading_deg, found.pixel_size_m, width, height)
        objects, _ = self._objects(labels_hw, found.pixel_size_m)
        references, pose = self._database.references, (footprint, found.heading_deg, found.pixel_size_m)
        pairs = matched_objects(objects, labels_hw.shape, *pose, references, self._database.parameters.pixel_size)
        pixels, on_map = objects.centers_xy[pairs[:, 0]], pairs[:, 1]
        seen = on_ground(pixels, footprint, labels_hw.shape)
        return Matches(on_map, pixels, seen, np.hypot(*(seen - references.positions[on_map]).T))

    def describe(self, labels_hw: np.ndarray, window_size: float) -> DescribedImage:
        """The image as windows of ``window_size`` (map units) of this database are described."""
        parameters = self._database.parameters
        return describe_image(
            labels_hw,
            self._database.class_table.reference_values,
            parameters.minimum_area / window_size**2,
            parameters.references_per_vector,
        )


def _shape(labels_hw: np.ndarray) -> Tuple[int, int]:
    """(height, width). Raises LabelMapError for an image without pixels."""
    if not labels_hw.size:
        raise LabelMapError("labels.no_pixels")
    return labels_hw.shape[0], labels_hw.shape[1]
