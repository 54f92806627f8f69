"""The localizer: a label image and a reference database in, one result out."""

from __future__ import annotations

import copy
from dataclasses import dataclass, field, replace
from threading import Lock

import numpy as np

from ..constellation.cached import cached_index
from ..constellation.hypotheses import SMALLEST_OBJECT_PX
from ..constellation.index import ConstellationIndex, build_index
from ..constellation.settings import CONSTELLATION
from ..constellation.solver import localize as solve
from ..constellation.solver import matches_at
from ..correlation.cached import cached_pyramid
from ..correlation.class_pyramid import MapPyramid
from ..correlation.settings import CORRELATION
from ..correlation.solver import agreement_at, part_against
from ..correlation.solver import localize as correlate
from ..database.model import ReferenceDatabase
from ..errors import DatabaseError, LabelMapError, ParameterError
from ..geometry.error_settings import UNBIASED, KnownBiases, SharedErrors
from ..geometry.footprint import image_corners
from ..labels.class_shares import ClassShares
from ..landmarks.landmarks import Landmarks, extract_landmarks
from ..localization import Localization, Matches, Method, Place, Prior, Status, too_few_landmarks
from ..sentences import Sentence
from ..windows.grid import centered_square
from ..windows.topology_vector import (
    DISTANCE_THRESHOLD,
    MINIMUM_REFERENCES,
    topology_vector,
    vector_confidence,
    vector_distances,
)
from .combined import (
    check_by_areas,
    combine_agreeing,
    combine_without_fix,
    confirm,
    confirm_by_earlier,
    doubt_outside,
    prior_near,
    share_on_map,
    show_likely,
    with_search_range,
)
from .settings import LOCALIZER, LocalizerSettings


def default_scales(method: Method) -> tuple[float, float]:
    """Return the default range of ground sizes, as multiples of a window's edge, that the method was calibrated for.

    *Automatic* uses the default of each of its two methods.
    """
    by_areas, by_landmarks = LOCALIZER.correlation.scales, LOCALIZER.constellation.limits.scales
    return by_areas if method == Method.MAP_CORRELATION else by_landmarks


@dataclass(frozen=True)
class DescribedImage:
    """Description of the largest centered square of an image.

    Attributes:
        first_xy: First pixel of the square (column, row).
        size: Edge of the square, pixels.
        objects: Landmarks, in pixels of the square.
        vector: Topology vector; None with too few landmarks.
    """

    first_xy: tuple[int, int]
    size: int
    objects: Landmarks
    vector: np.ndarray | None


def describe_image(
    labels_hw: np.ndarray, reference_values: tuple[int, ...], area_fraction: float, references_per_vector: int
) -> DescribedImage:
    """Describe the largest centered square of an image like a window: landmarks and topology vector.

    Args:
        labels_hw: (H, W) uint8 labels.
        reference_values: Values of the reference classes, ascending.
        area_fraction: Smallest area of a landmark as a fraction of the square's.

    Raises:
        LabelMapError: The image has no pixels.
    """
    column, row, size = centered_square(_shape(labels_hw))
    square = np.ascontiguousarray(labels_hw[row : row + size, column : column + size])
    objects = extract_landmarks(square, reference_values, area_fraction * size * size)
    vector = topology_vector(
        objects.centers_xy, objects.classes, (size / 2, size / 2), reference_values, references_per_vector
    )
    return DescribedImage((column, row), size, objects, vector)


@dataclass
class _Indexes:
    """Indexes of a database, once they are needed; copies of a localizer share them.

    Attributes:
        turn: Held while an image is localized. Python lets only one thread compute, so two at once would be slower than
            one after the other.
    """

    constellation: ConstellationIndex | None = None
    pyramid: MapPyramid | None = None
    turn: Lock = field(default_factory=Lock)


class Localizer:
    """Localizes label images in one database."""

    def __init__(
        self,
        database: ReferenceDatabase,
        settings: LocalizerSettings = LOCALIZER,
        sun_deg: float | None = None,
    ) -> None:
        """Make the localizer; it builds indexes when they are first needed.

        Args:
            database: With its overview for map correlation.
            settings: Of the methods; other values than the default are for calibration only.
            sun_deg: Azimuth of the sun when the images were taken, clockwise from grid north.
        """
        self.settings = settings
        known = database.parameters.map_accuracy, database.parameters.pixel_size
        self.errors = SharedErrors(*known, settings=settings.errors, sun_deg=sun_deg)
        self._database = database
        self._view: np.ndarray | None = None
        windows = database.windows
        self._indexes = _Indexes()
        self._levels = []
        for size in np.unique(windows.sizes[windows.described]):
            index = np.flatnonzero(windows.described & (windows.sizes == size))
            self._levels.append((float(size), index, windows.vectors[index]))

    def with_risk(self, allowed_risk: float) -> Localizer:
        """Return this localizer with another maximum error probability; the indexes are shared."""
        other = copy.copy(self)
        other.settings = replace(self.settings, allowed_risk=allowed_risk)
        return other

    def with_view(self, view: np.ndarray) -> Localizer:
        """Return this localizer for one leveled image; the indexes are shared.

        Args:
            view: (4,) complex corners of what the image shows, pixels from its center, clockwise.
        """
        other = copy.copy(self)
        other._view = view
        return other

    @property
    def landmark_classes(self) -> tuple[str, ...]:
        """Names of the landmark classes."""
        return tuple(one.name for one in self._database.class_table if one.is_reference)

    def localize_by_topology_vector(self, labels_hw: np.ndarray) -> Localization:
        """Localize by the published method, exactly: nearest topology vector, accepted up to distance T.

        See docs/explanation/method.md#topology-vector.

        The position is the matched window's center; the method finds no heading and pixel size. With several levels the
        image is described once for each window size, because the smallest landmark is the same fraction of the window's
        area.

        Args:
            labels_hw: (H, W) uint8 labels of the database's class table.

        Raises:
            DatabaseError: No window can be matched.
            LabelMapError: The image has no pixels.
        """
        self.check(Method.TOPOLOGY_VECTOR)
        count, nearest = self._nearest_window(labels_hw)
        if nearest is None:
            reason = too_few_landmarks(count, MINIMUM_REFERENCES - count)
            return Localization(Status.TOO_FEW_REFERENCES, Method.TOPOLOGY_VECTOR, count, reason)
        distance, index, count = nearest
        if distance > DISTANCE_THRESHOLD:
            reason = Sentence(
                "The most similar window has the distance {distance:.3f}; at most {threshold:g} is accepted.",
                distance=distance,
                threshold=DISTANCE_THRESHOLD,
            )
            return Localization(Status.NO_MATCH, Method.TOPOLOGY_VECTOR, count, reason, distance=distance)
        windows = self._database.windows
        center = float(windows.centers[index, 0]), float(windows.centers[index, 1])
        return Localization(
            Status.FIX,
            Method.TOPOLOGY_VECTOR,
            count,
            best=Place(center),
            confidence=vector_confidence(distance),
            distance=distance,
            window=windows.name(index),
            window_index=index,
            footprint=image_corners(center, 0.0, float(windows.sizes[index]), 1, 1),
        )

    def _nearest_window(self, labels_hw: np.ndarray) -> tuple[int, tuple[float, int, int] | None]:
        """Return the largest landmark count at any level, and (distance, index, landmarks) of the nearest window."""
        most, nearest = 0, None
        for size, index, vectors in self._levels:
            described = self.describe(labels_hw, size)
            most = max(most, len(described.objects))
            if described.vector is None:
                continue
            distances = vector_distances(described.vector, vectors)
            n = distances.argmin()
            # Of equal ones the first level's first window is the nearest.
            if nearest is None or distances[n] < nearest[0]:
                nearest = float(distances[n]), int(index[n]), len(described.objects)
        return most, nearest

    @property
    def index(self) -> ConstellationIndex:
        """The triangle index of the map, from the cache or built, which takes seconds for 10⁵ landmarks."""
        if self._indexes.constellation is None:
            settings, database = self.settings.constellation, self._database
            # An index for calibration is not reused.
            is_cached = database.source is not None and settings == CONSTELLATION
            of = cached_index if is_cached else build_index
            self._indexes.constellation = of(database.references, database.parameters.pixel_size, settings)
        return self._indexes.constellation

    def localize_by_constellation(
        self, labels_hw: np.ndarray, prior: Prior | None = None, biases: KnownBiases = UNBIASED
    ) -> Localization:
        """Localize an image by the constellation, which finds position, heading and pixel size.

        See docs/explanation/method.md#constellation.

        Args:
            labels_hw: (H, W) uint8 labels of the database's class table.
            prior: Without a range of pixel sizes, images may show 0.4 to 2.5 times a window's ground.

        Raises:
            LabelMapError: The image has no pixels.
        """
        height, width = _shape(labels_hw)
        prior = prior or Prior()
        sizes = prior.pixel_size_range or self.pixel_sizes((height, width), self.settings.constellation.limits.scales)
        prior = replace(prior, pixel_size_range=sizes)
        objects, smallest = self._objects(labels_hw, sizes[1])
        allowed_risk, errors = self.settings.allowed_risk, self.errors.with_biases(biases)
        return solve(objects, (width, height), self.index, prior, smallest, allowed_risk, errors, self._view)

    def _objects(self, labels_hw: np.ndarray, largest_pixel_size: float) -> tuple[Landmarks, float]:
        """Return the image's landmarks, and the smallest contour area, px², of the map's landmarks in it."""
        parameters = self._database.parameters
        smallest = max(parameters.minimum_area / largest_pixel_size**2, SMALLEST_OBJECT_PX)
        return extract_landmarks(labels_hw, self._database.class_table.reference_values, smallest), smallest

    @property
    def pyramid(self) -> MapPyramid:
        """The overview for map correlation, from the cache or built, which takes seconds for a large map.

        Raises:
            DatabaseError: The database was read without its overview.
        """
        if self._indexes.pyramid is None:
            database = self._database
            if database.overview is None:
                raise DatabaseError("The database was read without its overview, which map correlation searches.")
            settings, frame = self.settings.correlation, database.parameters.overview_frame
            is_cached = database.source is not None and settings == CORRELATION
            self._indexes.pyramid = (cached_pyramid if is_cached else MapPyramid)(database.overview, frame, settings)
        return self._indexes.pyramid

    def localize_by_map_correlation(
        self,
        labels_hw: np.ndarray,
        prior: Prior | None = None,
        shares: ClassShares | None = None,
        biases: KnownBiases = UNBIASED,
    ) -> Localization:
        """Localize by the overlap of class areas, for labels too poor for centers of gravity.

        See docs/explanation/method.md#map-correlation. Takes seconds without a prior position.

        Args:
            labels_hw: (H, W) uint8 labels of the database's class table.
            prior: Without a range of pixel sizes, images may show 0.4 to 2.5 times a window's ground.
            shares: Probable shares of classes, which replace the labels.

        Raises:
            LabelMapError: The image has no pixels.
            DatabaseError: The database was read without its overview.
        """
        prior = prior or Prior()
        sizes = prior.pixel_size_range or self.pixel_sizes(_shape(labels_hw), self.settings.correlation.scales)
        prior = replace(prior, pixel_size_range=sizes)
        errors = self.errors.with_biases(biases)
        return correlate(labels_hw, self.pyramid, prior, self.settings.allowed_risk, errors, shares)

    @property
    def has_overview(self) -> bool:
        """Whether map correlation is possible."""
        return self._database.overview is not None

    def localize_automatically(
        self,
        labels_hw: np.ndarray,
        prior: Prior | None = None,
        shares: ClassShares | None = None,
        biases: KnownBiases = UNBIASED,
    ) -> Localization:
        """Localize by the constellation, checked by class areas; without a fix, by map correlation.

        The constellation refines a position of map correlation. Without an overview only the constellation is used.
        Images without a fix by the constellation take as long as map correlation.

        Args:
            labels_hw: (H, W) uint8 labels of the database's class table.
            prior: Without a range of pixel sizes, each method searches its own range.
            shares: Probable shares of classes, which replace the labels in map correlation.

        Returns:
            The method of a fix is the one that found its pose.
        """
        objects = self.localize_by_constellation(labels_hw, prior, biases)
        if not self.has_overview:
            return objects
        if objects.best is not None:
            agreement = agreement_at(labels_hw, self.pyramid, objects.best)
            checked = check_by_areas(objects, agreement, self.settings)
            if checked.is_fix and checked.reason is None and agreement is not None:
                return replace(checked, reason=part_against(labels_hw, self.pyramid, objects.best))
            if objects.is_fix or checked.is_fix:
                return checked
        areas = self.localize_by_map_correlation(labels_hw, prior, shares, biases)
        both = combine_agreeing(objects, areas, min(labels_hw.shape), self.settings)
        if both is not None:
            return both
        if not areas.is_fix:
            return combine_without_fix(objects, areas, min(labels_hw.shape), self.settings)
        areas = replace(areas, references=objects.references)
        closer = prior_near(areas, prior or Prior(), min(labels_hw.shape), self.settings)
        return confirm(areas, self.localize_by_constellation(labels_hw, closer, biases), closer) or areas

    def pixel_sizes(self, shape_hw: tuple[int, int], scales: tuple[float, float]) -> tuple[float, float]:
        """Return the smallest and largest pixel size for images that show about a window's ground.

        Args:
            shape_hw: (height, width) of the image, pixels.
            scales: Smallest and largest ground along its shorter edge, in edges of a window.
        """
        parameters = self._database.parameters
        edges = [parameters.window_size * level for level in parameters.levels]
        shorter = max(min(shape_hw), 1)
        return scales[0] * min(edges) / shorter, scales[1] * max(edges) / shorter

    def check(self, method: Method, prior: Prior | None = None) -> None:
        """Refuse a method and a prior with which no image can get a position.

        Raises:
            DatabaseError: The database can't support the method.
            ParameterError: The search area is outside the map, for example because it is longitude and latitude.
        """
        extent = self._database.parameters.extent
        if share_on_map(prior or Prior(), extent) == 0:
            x_min, y_min, x_max, y_max = extent
            raise ParameterError(
                "The search area does not touch the map (x {x_min:.0f} to {x_max:.0f}, y {y_min:.0f} to {y_max:.0f}). "
                "Choose a position on the map.",
                x_min=x_min,
                x_max=x_max,
                y_min=y_min,
                y_max=y_max,
            )
        if method == Method.TOPOLOGY_VECTOR and not self._database.windows.described.any():
            raise DatabaseError(
                "No window of the database has the {least} landmarks a topology vector needs; build it with larger "
                "windows, a smaller minimum area or more reference classes.",
                least=MINIMUM_REFERENCES,
            )

    def localize(  # noqa: PLR0913 - the data of one image
        self,
        labels_hw: np.ndarray,
        method: Method,
        prior: Prior | None = None,
        with_matches: bool = False,
        shares: ClassShares | None = None,
        biases: KnownBiases = UNBIASED,
        earlier: Localization | None = None,
    ) -> Localization:
        """Localize an image; threads take turns.

        Args:
            labels_hw: (H, W) uint8 labels of the database's class table.
            with_matches: Also return matching landmarks for a fix of map correlation, which needs no matches. The
                constellation always returns them.
            shares: Probable shares of classes, for map correlation.
            biases: Class offsets of the labels; ignored by the topology vector.
            earlier: From other labels of the same photo, without a fix; ignored by the topology vector.

        Returns:
            A fix or likely position has its footprint.

        Raises:
            DatabaseError: The database can't support the method.
            LabelMapError: The image has no pixels.
        """
        with self._indexes.turn:
            return self._localize(labels_hw, method, prior or Prior(), with_matches, shares, biases, earlier)

    def _localize(  # noqa: PLR0913 - as ``localize``
        self,
        labels_hw: np.ndarray,
        method: Method,
        prior: Prior,
        with_matches: bool,
        shares: ClassShares | None,
        biases: KnownBiases,
        earlier: Localization | None,
    ) -> Localization:
        if method == Method.TOPOLOGY_VECTOR:
            return self.localize_by_topology_vector(labels_hw)
        if method == Method.MAP_CORRELATION:
            found = self.localize_by_map_correlation(labels_hw, prior, shares, biases)
        elif method == Method.AUTOMATIC:
            found = self.localize_automatically(labels_hw, prior, shares, biases)
        else:
            found = self.localize_by_constellation(labels_hw, prior, biases)
        if earlier is not None:
            found = confirm_by_earlier(found, earlier, min(_shape(labels_hw)), self.settings)
        on_map = share_on_map(prior, self._database.parameters.extent)
        found = show_likely(doubt_outside(found, on_map, self.settings), self.settings)
        place = found.place
        if place is None:
            return self._with_search_range(found, method, _shape(labels_hw), prior)
        height, width = labels_hw.shape
        heading_deg, pixel_size = place.oriented
        ground = image_corners(place.position, heading_deg, pixel_size, width, height)
        matches = self._matches_at(labels_hw, place) if with_matches and found.matches is None else found.matches
        return replace(found, footprint=ground, matches=matches)

    def _with_search_range(
        self, found: Localization, method: Method, shape_hw: tuple[int, int], prior: Prior
    ) -> Localization:
        if found.reason is None or found.status is Status.TOO_FEW_REFERENCES and found.peaks is None:
            return found
        smallest, largest = prior.pixel_size_range or self.pixel_sizes(shape_hw, default_scales(method))
        return with_search_range(found, found.reason, (smallest, largest), prior)

    def _matches_at(self, labels_hw: np.ndarray, place: Place) -> Matches | None:
        height, width = labels_hw.shape
        objects, _ = self._objects(labels_hw, place.oriented[1])
        return matches_at(objects, (width, height), self.index, place) if len(objects) else None

    def describe(self, labels_hw: np.ndarray, window_size: float) -> DescribedImage:
        """Describe the image in the same way as the database's windows of ``window_size`` (map units)."""
        parameters = self._database.parameters
        return describe_image(
            labels_hw,
            self._database.class_table.reference_values,
            parameters.minimum_area / window_size**2,
            parameters.references_per_vector,
        )


def _shape(labels_hw: np.ndarray) -> tuple[int, int]:
    """Return (height, width); raise LabelMapError for an image without pixels."""
    if not labels_hw.size:
        raise LabelMapError("The image has no pixels.")
    return labels_hw.shape[0], labels_hw.shape[1]
