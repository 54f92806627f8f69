"""Simulated images for an assessment: what a camera would show of a database's own landmarks, spoilt, and its fix.

A database has no label map, so its landmarks are seen as objects: those that lie whole in the image, missed, invented,
misnamed and moved as the noise says, then localized by the localizer itself. Map correlation, where it is wanted, is
tried on an image cut from the overview.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Optional, Tuple

import numpy as np

from ..constellation.hypotheses import Prior
from ..constellation.solver import localize as solve
from ..correlation.solver import NOMINAL_RANGE
from ..database.model import ReferenceDatabase
from ..errors import DatabaseError, ParameterError
from ..labels.sources import ArrayLabels
from ..landmarks.landmarks import Landmarks
from ..localization import FIX, Localization, from_constellation
from ..localizer.localizer import SCALES, SMALLEST_OBJECT_PX, Localizer
from ..simulation.views import (
    LabelNoise,
    ObjectNoise,
    View,
    cut_view,
    spoil_label_objects,
    spoil_labels,
    spoil_objects,
)

LARGEST_IMAGE_PX = 2000
"""Edge of a simulated image; a larger footprint is shown with larger pixels."""

RIGHT_SHARE = 0.02
"""A fix is right within this share of the footprint, as in evaluations."""

RAGGED_LENGTH_PX = 8.0
"""Over what length edges move alike, as in ``trials.LabelNoise``."""

CENTER_SHARE, CENTER_LENGTHS = 0.66, 7.5
"""Edges moved by σ move the center of an object of size s = √area by CENTER_SHARE · σ / √(1 + s / (CENTER_LENGTHS ·
RAGGED_LENGTH_PX)) along each axis. Measured on Liechtenstein 2021 with σ of 1, 2 and 3 px, s of 10 to 150 px."""

AREA_SHARE = 1.8
"""The same edges change ln area with a standard deviation of AREA_SHARE · σ / s; measured on the same images."""

SAMPLING_AREA = 0.05
"""Standard deviation of ln area that turning and sampling an image brings by itself; measured on the same images."""

SMALL_SHARE = 0.35
"""Objects too small for the catalogue that an image shows besides, as a share of its landmarks: a database doesn't know
them, and they are in the way. Liechtenstein 2021 has so many of 16 to 100 m²."""

OTHER_SHAPE = 0.8
"""An object whose bounding box is not known is taken for a square of this share of its half edge more: √area / 2 / 0.8,
as landmarks are hardly ever squares."""


@dataclass(frozen=True)
class AssessmentNoise:
    """How poor labels are taken to be. missed, invented, misnamed: shares of the landmarks; ragged: standard deviation
    of how far edges are moved, map units. Raises ParameterError for values that can't be."""

    missed: float = 0.2
    invented: float = 0.2
    misnamed: float = 0.05
    ragged: float = 1.0

    def __post_init__(self) -> None:
        for name in ("missed", "invented", "misnamed"):
            if not 0 <= getattr(self, name) <= 1:
                raise ParameterError(f"{name.upper()} is {100 * getattr(self, name):g} %; give 0 to 100.")
        if not 0 <= self.ragged < math.inf:
            raise ParameterError(f"RAGGED is {self.ragged:g}; give 0 or more map units.")


@dataclass(frozen=True)
class SimulatedFix:
    """What came of a simulated image. objects: whole landmarks of the map in view, before any noise; error: map units,
    None without a fix; right: a fix within RIGHT_SHARE of the footprint; method: which found it."""

    status: str
    objects: int
    right: bool = False
    error: Optional[float] = None
    method: str = ""

    @property
    def is_fix(self) -> bool:
        return self.status == FIX


class ImageSimulator:
    """Makes images of one footprint from a database alone and localizes them. Same generator, same image."""

    def __init__(self, localizer: Localizer, database: ReferenceDatabase, footprint: float, noise: AssessmentNoise):
        """``footprint``: edge of the ground that an image shows, map units. Raises ParameterError and DatabaseError."""
        if not 0 < footprint < math.inf:
            raise ParameterError(f"FOOTPRINT is {footprint:g}; give the edge of the ground that an image shows.")
        if not len(database.references):
            raise DatabaseError(f"{database.source} has no landmark; build it with other classes or a smaller area.")
        self._localizer = localizer
        self._database = database
        self._noise = noise
        self.footprint = footprint
        parameters = database.parameters
        self.size_px = min(max(round(footprint / parameters.pixel_size), 1), LARGEST_IMAGE_PX)
        self.pixel = footprint / self.size_px
        self._prior = Prior(pixel_size_range=localizer.pixel_sizes((self.size_px, self.size_px), SCALES))
        self._smallest_px = max(parameters.minimum_area / self._prior.pixel_size_range[1] ** 2, SMALLEST_OBJECT_PX)
        references = database.references
        self._half = _half_boxes(database)
        self._order = np.argsort(references.positions[:, 0], kind="stable")
        self._eastings = references.positions[self._order, 0]
        self._reach = footprint * math.sqrt(0.5)

    @property
    def is_searched(self) -> bool:
        """Whether images of this footprint are among those that the constellation looks for without being told."""
        low, high = self._prior.pixel_size_range
        return low <= self.pixel <= high

    @property
    def is_correlated(self) -> bool:
        """The same of map correlation."""
        low, high = self._localizer.pixel_sizes((self.size_px, self.size_px), NOMINAL_RANGE)
        return low <= self.pixel <= high

    def whole_objects(self, x: float, y: float, heading_deg: float) -> Tuple[np.ndarray, np.ndarray]:
        """(n,) landmarks whole in an image centered at map (x, y), and their (n, 2) pixel coordinates in it."""
        first, last = np.searchsorted(self._eastings, (x - self._reach, x + self._reach))
        near = self._order[first:last]
        east, north = (self._database.references.positions[near] - (x, y)).T
        turn = math.radians(heading_deg)
        right = (east * math.cos(turn) - north * math.sin(turn)) / self.pixel
        up = (east * math.sin(turn) + north * math.cos(turn)) / self.pixel
        # An upright box has its widest point, seen along a turned axis, at the corner that lies that way.
        half_width, half_height = self._half[near].T / self.pixel
        cosine, sine = abs(math.cos(turn)), abs(math.sin(turn))
        across = _seen_half(half_width, half_height, cosine, sine)
        along = _seen_half(half_width, half_height, sine, cosine)
        edge = self.size_px / 2
        areas = self._database.references.areas_m2[near] / self.pixel**2
        whole = (np.abs(right) + across < edge) & (np.abs(up) + along < edge) & (areas >= self._smallest_px)
        return near[whole], np.column_stack([edge + right[whole], edge - up[whole]])

    def objects(self, x: float, y: float, heading_deg: float, rng: np.random.Generator) -> Tuple[Landmarks, int]:
        """Objects of the spoilt image, and how many landmarks the map has whole in it."""
        chosen, centers = self.whole_objects(x, y, heading_deg)
        seen = self._as_objects(chosen, centers)
        noise = self._noise
        population = self._as_objects(rng.integers(0, len(self._database.references), max(len(chosen), 1)))
        size = (self.size_px, self.size_px)
        spoilt = spoil_objects(seen, ObjectNoise(noise.missed, noise.invented, noise.misnamed), rng, population, size)
        return self._with_small(self._moved(spoilt, rng), len(chosen), rng), len(chosen)

    def constellation(self, x: float, y: float, heading_deg: float, rng: np.random.Generator) -> SimulatedFix:
        """An image at a place, localized by its landmarks."""
        objects, count = self.objects(x, y, heading_deg, rng)
        if not len(objects):
            found = Localization("too_few_references", "constellation", 0)
        else:
            solved = solve(objects, self.size_px, self.size_px, self._localizer.index, self._prior, self._smallest_px)
            found = from_constellation(solved)
        return self._judged(found, (x, y), count)

    def correlation(self, x: float, y: float, heading_deg: float, rng: np.random.Generator) -> SimulatedFix:
        """An image at a place, cut from the overview and spoilt, localized by its class areas."""
        database, parameters = self._database, self._database.parameters
        pixel = parameters.overview_frame.pixel_size
        view = self._overview_view(x, y, heading_deg, pixel)
        source, values = ArrayLabels(database.overview), database.class_table.reference_values
        labels = cut_view(source, view)
        noise = ObjectNoise(self._noise.missed, self._noise.invented, self._noise.misnamed)
        # Invented objects look like those of some other place.
        other = database.references.positions[rng.integers(0, len(database.references))]
        donor = cut_view(source, self._overview_view(*other, float(rng.uniform(0, 360)), pixel))
        labels = spoil_label_objects(labels, noise, rng, values, donor)
        ragged = LabelNoise(ragged_px=self._noise.ragged / pixel, ragged_length_px=max(RAGGED_LENGTH_PX / pixel, 2.0))
        labels = spoil_labels(labels, ragged, rng, values)
        found = self._localizer.localize_by_map_correlation(labels)
        return self._judged(found, (x, y), len(self.whole_objects(x, y, heading_deg)[0]))

    def _overview_view(self, x: float, y: float, heading_deg: float, pixel: float) -> View:
        column, row = self._database.parameters.overview_frame.to_pixels((x, y)).tolist()
        size = max(round(self.footprint / pixel), 1)
        scale = self.footprint / pixel / size
        return View(column, row, heading_deg, scale, size, size)

    def _judged(self, found: Localization, position: Tuple[float, float], count: int) -> SimulatedFix:
        if found.status != FIX:
            return SimulatedFix(found.status, count)
        error = math.hypot(found.position[0] - position[0], found.position[1] - position[1])
        return SimulatedFix(FIX, count, error <= RIGHT_SHARE * self.footprint, error, found.method)

    def _as_objects(self, chosen: np.ndarray, centers: Optional[np.ndarray] = None) -> Landmarks:
        references = self._database.references
        centers = np.zeros((len(chosen), 2)) if centers is None else centers
        areas = references.areas_m2[chosen] / self.pixel**2
        # Contours run through pixel centers, so the same ground has another contour area at other pixels.
        areas = np.maximum(np.sqrt(areas) + self._database.parameters.pixel_size / self.pixel - 1, 1.0) ** 2
        half = np.sqrt(areas)[:, None] / 2
        bounds = np.column_stack([np.floor(centers - half), np.ceil(centers + half)]).astype(np.int64)
        return Landmarks(centers, references.classes[chosen], areas, bounds, np.zeros(len(chosen), bool))

    def _with_small(self, objects: Landmarks, landmarks: int, rng: np.random.Generator) -> Landmarks:
        """The objects and, anywhere in the image, some that are too small for the catalogue."""
        largest = self._database.parameters.minimum_area / self.pixel**2
        count = rng.poisson(SMALL_SHARE * landmarks) if largest > self._smallest_px else 0
        small = self._as_objects(rng.integers(0, len(self._database.references), count))
        areas = np.exp(rng.uniform(math.log(self._smallest_px), math.log(max(largest, self._smallest_px)), count))
        centers = rng.uniform(0, self.size_px, (count, 2))
        return _joined(objects, Landmarks(centers, small.classes, areas, small.bounds, small.touches_edge))

    def _moved(self, objects: Landmarks, rng: np.random.Generator) -> Landmarks:
        """The objects with the centers and areas that ragged edges would give them."""
        ragged = self._noise.ragged / self.pixel
        sizes = np.sqrt(objects.areas_px)
        deviation = CENTER_SHARE * ragged / np.sqrt(1 + sizes / (CENTER_LENGTHS * RAGGED_LENGTH_PX))
        centers = objects.centers_xy + rng.normal(0, 1, objects.centers_xy.shape) * deviation[:, None]
        spread = np.hypot(AREA_SHARE * ragged / sizes, SAMPLING_AREA)
        areas = objects.areas_px * np.exp(rng.normal(0, 1, len(objects)) * spread)
        kept = areas >= self._smallest_px
        return Landmarks(centers, objects.classes, areas, objects.bounds, objects.touches_edge).select(kept)


def _joined(one: Landmarks, other: Landmarks) -> Landmarks:
    names = ("centers_xy", "classes", "areas_px", "bounds", "touches_edge")
    return Landmarks(*(np.concatenate([getattr(one, name), getattr(other, name)]) for name in names))


def _half_boxes(database: ReferenceDatabase) -> np.ndarray:
    """(N, 2) half width and half height of each landmark's upright box, map units."""
    references = database.references
    if references.bounds_px is not None:
        bounds = references.bounds_px.astype(np.float64)
        return (bounds[:, 2:] - bounds[:, :2]) * database.parameters.pixel_size / 2
    half = np.sqrt(references.areas_m2) / 2 / OTHER_SHAPE
    return np.column_stack([half, half])


def _seen_half(half_width: np.ndarray, half_height: np.ndarray, cosine: float, sine: float) -> np.ndarray:
    """(n,) half extents of upright boxes along an axis turned by that angle; of the ellipse in the box, not its
    corners, which turned buildings hardly ever fill."""
    return np.hypot(half_width * cosine, half_height * sine)
