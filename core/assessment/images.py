"""Simulate images for an assessment from a database's own landmarks, with errors, and localize them.

A database contains no label map, so its landmarks are points: those that are whole in the image, missed, spurious,
mislabeled and moved according to the noise, then localized by the localizer itself. Map correlation uses an image cut
from the overview.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import cast

import numpy as np

from .. import limits
from ..constellation.hypotheses import SMALLEST_OBJECT_PX
from ..constellation.solver import localize as solve
from ..database.model import ReferenceDatabase
from ..errors import DatabaseError, ParameterError
from ..evaluation.trial import RIGHT_SHARE, Query, Trial, judge
from ..geometry.error_settings import UNBIASED, KnownBiases
from ..labels.sources import ArrayLabels
from ..landmarks.landmarks import Landmarks
from ..localization import Localization, Method, Prior, Status
from ..localizer.localizer import Localizer
from ..simulation.label_errors import spoil_labels
from ..simulation.landmark_errors import concatenate, spoil_landmarks, with_moved_boundaries
from ..simulation.noise import JITTER_LENGTH_PX
from ..simulation.views import View, cut, image_coordinates

SMALL_SHARE = 0.35
"""Objects too small for the database that an image also shows, as a share of its landmarks: the database does not
contain them, and they disturb. Liechtenstein 2021 has this share of objects of 16 to 100 m²."""

REACH = 1.5
"""Landmarks are searched this many times farther out than a level camera sees: a tilted one sees farther on one
side."""

COARSE_EDGE_PX = 128
"""Smallest width of an image for map correlation. The overview has fewer pixels on the ground of a small image, but the
image shows the class areas in them."""

OTHER_SHAPE = 0.8
"""An object without a known bounding box counts as a square with a half edge of √area / 2 / 0.8, as landmarks are
hardly ever squares."""


class ImageSimulator:
    """Makes images of one footprint from a database and localizes them. The same generator gives the same image."""

    def __init__(
        self, localizer: Localizer, database: ReferenceDatabase, footprint: float, biases: KnownBiases = UNBIASED
    ) -> None:
        """Prepare the landmarks of a database for images of one size.

        Args:
            database: With an overview if map correlation is needed.
            footprint: Footprint width of an image, m.

        Raises:
            ParameterError: The footprint is invalid.
            DatabaseError: The database has no landmarks.
        """
        if not 0 < footprint <= limits.FOOTPRINT_M:
            raise ParameterError(
                "The footprint width is {footprint:g} m; it must be more than 0 m and at most {most:g} m.",
                footprint=footprint,
                most=limits.FOOTPRINT_M,
            )
        if not len(database.references):
            raise DatabaseError(
                "{source} has no landmark. Build it with other classes or a smaller minimum area.",
                source=database.source,
            )
        self._localizer, self._biases = localizer, biases
        self._database = database
        self.footprint = footprint
        # A position cannot be more accurate than the map.
        self._right_within = max(RIGHT_SHARE * footprint, 2 * database.parameters.map_accuracy)
        parameters, settings = database.parameters, localizer.settings.constellation
        self.size_px = min(max(round(footprint / parameters.pixel_size), 1), limits.SIMULATED_EDGE_PX)
        self.pixel = footprint / self.size_px
        self._pixel_sizes = localizer.pixel_sizes((self.size_px, self.size_px), settings.limits.scales)
        self._prior = Prior(pixel_size_range=self._pixel_sizes)
        smallest = parameters.minimum_area / self._pixel_sizes[1] ** 2
        self._smallest_px = max(smallest, SMALLEST_OBJECT_PX)
        references = database.references
        self._half = _half_boxes(database)
        self._order = np.argsort(references.positions[:, 0], kind="stable")
        self._eastings = references.positions[self._order, 0]
        self._reach = REACH * footprint * math.sqrt(0.5)

    def view(self, x: float, y: float, heading_deg: float) -> View:
        """Return an image of the footprint at a place."""
        return View(x, y, heading_deg, self.pixel, self.size_px, self.size_px)

    @property
    def is_searched(self) -> bool:
        """Whether the constellation searches images of this footprint without a prior scale."""
        low, high = self._pixel_sizes
        return low <= self.pixel <= high

    @property
    def is_correlated(self) -> bool:
        """Whether map correlation searches images of this footprint without a prior scale."""
        low, high = self._localizer.pixel_sizes(
            (self.size_px, self.size_px), self._localizer.settings.correlation.scales
        )
        return low <= self.pixel <= high

    def whole_landmarks(self, view: View) -> tuple[np.ndarray, np.ndarray]:
        """Return the database's landmarks in a view.

        Returns:
            (n,) numbers of those that are whole in the image, and (n, 2) their pixel coordinates.
        """
        first, last = np.searchsorted(self._eastings, (view.x - self._reach, view.x + self._reach))
        near = self._order[first:last]
        centers = image_coordinates(view, self._database.references.positions[near])
        # Along a turned axis, the widest point of an upright box is the corner in that direction.
        turn = math.radians(view.heading_deg)
        half_width, half_height = self._half[near].T / view.pixel_size
        cosine, sine = abs(math.cos(turn)), abs(math.sin(turn))
        across = _seen_half(half_width, half_height, cosine, sine)
        along = _seen_half(half_width, half_height, sine, cosine)
        edge = view.width_px / 2
        areas = self._database.references.areas_m2[near] / view.pixel_size**2
        off_x, off_y = np.abs(centers - edge).T
        whole = (off_x + across < edge) & (off_y + along < edge) & (areas >= self._smallest_px)
        return near[whole], centers[whole]

    def landmarks(self, query: Query, rng: np.random.Generator) -> tuple[Landmarks, int]:
        """Return the landmarks of the image with errors, and the number of the map's whole landmarks in it."""
        chosen, centers = self.whole_landmarks(query.view)
        seen = self._as_seen(chosen, centers)
        noise = query.noise.in_pixels(self.pixel)
        population = self._as_seen(rng.integers(0, len(self._database.references), max(len(chosen), 1)))
        spoiled = spoil_landmarks(seen, noise, rng, population, (self.size_px, self.size_px))
        moved = with_moved_boundaries(spoiled, noise, rng)
        moved = moved.select(moved.areas_px >= self._smallest_px)
        return self._with_small(moved, len(chosen), rng), len(chosen)

    def constellation(self, query: Query, rng: np.random.Generator) -> Trial:
        """Localize an image at a place by its landmarks."""
        landmarks, count = self.landmarks(query, rng)
        if not len(landmarks):
            found = Localization(Status.TOO_FEW_REFERENCES, Method.CONSTELLATION)
        else:
            size = self.size_px, self.size_px
            localizer = self._localizer
            errors = localizer.errors.with_biases(self._biases)
            found = solve(landmarks, size, localizer.index, self._prior, self._smallest_px, errors=errors)
        return judge(query, Method.CONSTELLATION, found, self._right_within, count)

    def correlation(self, query: Query, rng: np.random.Generator) -> Trial:
        """Localize an image at a place, cut from the overview with errors, by its class areas."""
        database = self._database
        # A database for map correlation has an overview.
        frame, source = database.parameters.overview_frame, ArrayLabels(cast(np.ndarray, database.overview))
        view = self._coarse_view(query.view, frame.pixel_size)
        labels, pixel = cut(source, frame, view), view.pixel_size
        # Spurious landmarks are those of another place.
        x, y = database.references.positions[rng.integers(0, len(database.references))]
        donor = cut(source, frame, self._coarse_view(self.view(x, y, float(rng.uniform(0, 360))), frame.pixel_size))
        # Boundaries move together over as many meters as pixels of a label map with pixels of 1 m.
        noise = replace(query.noise.in_pixels(pixel), jitter_length=max(JITTER_LENGTH_PX / pixel, 2.0))
        labels = spoil_labels(labels, noise, rng, database.class_table.reference_values, donor)
        found = self._localizer.localize_by_map_correlation(labels, biases=self._biases)
        count = len(self.whole_landmarks(query.view)[0])
        return judge(query, Method.MAP_CORRELATION, found, self._right_within, count)

    def _coarse_view(self, view: View, pixel: float) -> View:
        """Return the same ground in pixels about as coarse as the overview's, but in enough of them."""
        size = min(max(round(self.footprint / pixel), COARSE_EDGE_PX), limits.SIMULATED_EDGE_PX)
        return replace(view, pixel_size=self.footprint / size, width_px=size, height_px=size)

    def _as_seen(self, chosen: np.ndarray, centers: np.ndarray | None = None) -> Landmarks:
        references = self._database.references
        centers = np.zeros((len(chosen), 2)) if centers is None else centers
        areas = references.areas_m2[chosen] / self.pixel**2
        # Contours run through pixel centers, so the same ground has another contour area at other pixels.
        areas = np.maximum(np.sqrt(areas) + self._database.parameters.pixel_size / self.pixel - 1, 1.0) ** 2
        half = np.sqrt(areas)[:, None] / 2
        bounds = np.column_stack([np.floor(centers - half), np.ceil(centers + half)]).astype(np.int64)
        return Landmarks(centers, references.classes[chosen], areas, bounds, np.zeros(len(chosen), bool))

    def _with_small(self, landmarks: Landmarks, count: int, rng: np.random.Generator) -> Landmarks:
        """Return the landmarks and, anywhere in the image, some that are too small for the database."""
        largest = self._database.parameters.minimum_area / self.pixel**2
        count = rng.poisson(SMALL_SHARE * count) if largest > self._smallest_px else 0
        small = self._as_seen(rng.integers(0, len(self._database.references), count))
        areas = np.exp(rng.uniform(math.log(self._smallest_px), math.log(max(largest, self._smallest_px)), count))
        centers = rng.uniform(0, self.size_px, (count, 2))
        return concatenate(landmarks, Landmarks(centers, small.classes, areas, small.bounds, small.touches_edge))


def _half_boxes(database: ReferenceDatabase) -> np.ndarray:
    """Return (N, 2) half width and half height of each landmark's upright box, m."""
    references = database.references
    if references.bounds_px is not None:
        bounds = references.bounds_px.astype(np.float64)
        return (bounds[:, 2:] - bounds[:, :2]) * database.parameters.pixel_size / 2
    half = np.sqrt(references.areas_m2) / 2 / OTHER_SHAPE
    return np.column_stack([half, half])


def _seen_half(half_width: np.ndarray, half_height: np.ndarray, cosine: float, sine: float) -> np.ndarray:
    """Return (n,) half extents of upright boxes along an axis turned by that angle.

    They are those of the ellipse in the box, because turned buildings hardly ever fill its corners.
    """
    return np.hypot(half_width * cosine, half_height * sine)
