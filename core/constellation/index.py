"""Index of the labeled triangles of a map, which finds those similar to a triangle of an image.

See docs/explanation/method.md#constellation.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ..database.model import MapLandmarks
from .neighbors import ClassMatcher, local_density
from .settings import CONSTELLATION, ConstellationSettings
from .triangles import ORDERS, canonical_order, describe_triangles, neighbor_pairs, triples

LOWEST = np.array([-0.1, -1.0, -10.0, -10.0, -10.0])
CELL = np.array([0.05, 0.05, 0.5, 0.5, 0.5])
CELLS = np.array([14, 40, 20, 20, 20], np.int64)
"""Quantization of a triangle's five numbers; values outside belong to the outermost cells."""

LABEL_BUCKETS = 900
"""Number of buckets for label triples, so that a key fits into 32 bits; up to 9 classes have one bucket a triple."""

FINE_STEPS = 255
"""The five numbers are also stored in 8 bits each over the whole range, to check a hit without computing it again."""

BUILD_CHUNK = 100_000
"""Landmarks processed at a time, which limits the memory of a build."""

AREA_BIN = 0.25
AREA_BINS = np.arange(-5.0, 25.0, AREA_BIN)
"""Bins of ln area for the size distribution of each class."""

FINE_UNIT = CELL * CELLS / FINE_STEPS

IndexParts = dict[str, np.ndarray]
"""Arrays of an index by name."""


@dataclass(frozen=True)
class ConstellationIndex:
    """A map prepared for localization: N landmarks, T triangles, K neighbors, C classes.

    Attributes:
        origin: Map coordinates x + iy of the zero of ``points``.
        points: (N,) complex128, x + iy in map units.
        class_values: (C,) uint8, ascending.
        ranks: (N,) int64, index of each landmark's class in ``class_values``.
        log_areas: (N,) ln m².
        densities: (N,) landmarks of the same class per square map unit nearby.
        whole: (N,) bool, not cut by the map's edge.
        neighbors: (N, K) int32, nearest larger landmarks, −1 for missing ones.
        keys: (T,) uint32, ascending.
        triangles: (T,) int32, (anchor · P + pair) · 6 + order, P pairs of neighbors; int64 from 23 million landmarks.
        fine: (T, 5) uint8, the five numbers in steps of 1 / 255 of their range.
        area_densities: (C, B) density of ln area in AREA_BINS.
        by_easting: (N,) int64, landmarks from west to east.
        eastings: (N,) their eastings, ascending.
        settings: Settings of its build, used by every search in it.
    """

    origin: complex
    points: np.ndarray
    class_values: np.ndarray
    ranks: np.ndarray
    log_areas: np.ndarray
    densities: np.ndarray
    whole: np.ndarray
    minimum_area_m2: float
    neighbors: np.ndarray
    keys: np.ndarray
    triangles: np.ndarray
    fine: np.ndarray
    matcher: ClassMatcher
    area_densities: np.ndarray
    by_easting: np.ndarray
    eastings: np.ndarray
    settings: ConstellationSettings = CONSTELLATION

    def __len__(self) -> int:
        return len(self.points)

    def members(self, triangles: np.ndarray) -> list[np.ndarray]:
        """Return (H,) landmarks A, B and C of triangles (H,), given by their index in ``triangles``."""
        count, places = self.neighbors.shape[1], _corner_places(self.neighbors.shape[1])
        codes, near = self.triangles.take(triangles), self.neighbors.ravel()
        anchors = codes // len(places)
        corner = codes - anchors * len(places)
        anchors = anchors.astype(np.int64)
        first = anchors * count
        corners = (places[:, k].take(corner) for k in range(3))
        # The neighbors of anchor n start at n K. −1 marks the anchor; the value that it finds is not used.
        return [np.where(of < 0, anchors, near.take(first + of)) for of in corners]

    @property
    def keys_tell_classes(self) -> bool:
        """Whether triangles of other classes have other keys, so that their classes need no check."""
        return len(self.class_values) ** 3 <= LABEL_BUCKETS

    def anchors(self) -> np.ndarray:
        """Return (T,) anchors: each triangle consists of its anchor and two neighbors."""
        return self.triangles // (len(neighbor_pairs(self.neighbors.shape[1])) * len(ORDERS))

    def within(self, low: complex, high: complex) -> np.ndarray:
        """Return (M,) landmarks in the box between two corners."""
        first, last = self.eastings.searchsorted((low.real, high.real))
        found = self.by_easting[first:last]
        northings = self.points.imag.take(found)
        return found[(northings >= low.imag) & (northings <= high.imag)]

    def rank_of(self, classes: np.ndarray) -> np.ndarray:
        """Return (n,) indices of class values in ``class_values``, −1 for classes that the map lacks."""
        place = np.searchsorted(self.class_values, classes)
        place = np.minimum(place, max(len(self.class_values) - 1, 0))
        known = self.class_values[place] == classes if len(self.class_values) else np.zeros(len(classes), bool)
        return np.where(known, place, -1).astype(np.int64)


def full_area(contour_areas: np.ndarray | float, pixel: float) -> np.ndarray:
    """Return full areas from contour areas; contours connect pixel centers and so omit half a pixel all around.

    Exact for squares. Makes areas of images of different scale comparable.

    Args:
        contour_areas: (n,), or one, in the unit of ``pixel`` squared.
    """
    return (np.sqrt(contour_areas) + pixel) ** 2


def build_index(
    references: MapLandmarks, pixel_size_m: float, settings: ConstellationSettings = CONSTELLATION
) -> ConstellationIndex:
    """Index all landmarks of a map; takes seconds for 10⁵ landmarks.

    Landmarks cut by the map's edge are not in triangles, because their true centers are unknown.
    """
    return index_of_parts(references, pixel_size_m, settings, index_parts(references, pixel_size_m, settings))


def index_parts(references: MapLandmarks, pixel_size_m: float, settings: ConstellationSettings) -> IndexParts:
    """Return the parts of an index that take time to compute, by name."""
    bare = _Bare(references, pixel_size_m)
    neighbors, keys, triangles, fine = _all_triangles(bare.points, bare.ranks, bare.log_areas, bare.whole, settings)
    order = np.argsort(keys, kind="stable")
    return {
        "neighbors": neighbors,
        "keys": keys[order],
        "triangles": triangles[order],
        "fine": fine[order],
        "densities": local_density(bare.positions, bare.ranks),
        "by_easting": np.argsort(bare.points.real, kind="stable").astype(np.int64, copy=False),
    }


def _kind_of_codes(count: int, settings: ConstellationSettings) -> str:
    codes = count * len(neighbor_pairs(settings.limits.neighbors)) * len(ORDERS)
    return "<i4" if codes <= np.iinfo(np.int32).max else "<i8"


def index_of_parts(
    references: MapLandmarks, pixel_size_m: float, settings: ConstellationSettings, parts: IndexParts
) -> ConstellationIndex:
    """Return the index of landmarks from its computed or cached parts."""
    bare = _Bare(references, pixel_size_m)
    return ConstellationIndex(
        bare.origin,
        bare.points,
        bare.class_values,
        bare.ranks,
        bare.log_areas,
        parts["densities"],
        bare.whole,
        bare.minimum_area_m2,
        parts["neighbors"],
        parts["keys"],
        parts["triangles"],
        parts["fine"],
        ClassMatcher(bare.points, bare.ranks),
        area_densities(bare.ranks, bare.log_areas),
        parts["by_easting"],
        bare.points.real[parts["by_easting"]],
        settings,
    )


class _Bare:
    """Landmarks in the form of an index, without the parts that take time."""

    def __init__(self, references: MapLandmarks, pixel_size_m: float) -> None:
        self.positions = np.asarray(references.positions, np.float64).reshape(-1, 2)
        middle = self.positions.mean(axis=0) if len(self.positions) else np.zeros(2)
        self.origin = complex(*middle)
        self.points = (self.positions[:, 0] - middle[0]) + 1j * (self.positions[:, 1] - middle[1])
        self.class_values = np.unique(references.classes)
        self.ranks = np.searchsorted(self.class_values, references.classes).astype(np.int64, copy=False)
        areas = full_area(np.asarray(references.areas_m2, np.float64), pixel_size_m)
        self.log_areas = np.log(np.maximum(areas, 1e-12))
        self.minimum_area_m2 = float(areas.min()) if len(areas) else 0.0
        self.whole = ~np.asarray(references.touches_edge, bool)


def area_densities(ranks: np.ndarray, log_areas: np.ndarray) -> np.ndarray:
    """Return (C, B) probability density of ln area of each class, smoothed, never 0."""
    rows = []
    for rank in range(int(ranks.max()) + 1 if len(ranks) else 0):
        counts = np.histogram(log_areas[ranks == rank], np.append(AREA_BINS, np.inf))[0].astype(float)
        share = np.convolve(counts, (0.25, 0.5, 0.25), "same") / max(counts.sum(), 1)
        rows.append(0.8 * share / AREA_BIN + 0.2 / 10)
    return np.array(rows).reshape(-1, len(AREA_BINS))


def cell_keys(ranks: np.ndarray, class_count: int, cells: np.ndarray) -> np.ndarray:
    """Return (T,) uint32 keys of triangles; the last number varies fastest.

    Args:
        ranks: (T, 3) label ranks of A, B, C.
        cells: (T, 5) int64, quantized numbers.
    """
    key = ((ranks[:, 0] * class_count + ranks[:, 1]) * class_count + ranks[:, 2]) % LABEL_BUCKETS
    for column, count in enumerate(CELLS):
        key = key * count + cells[:, column]
    return key.astype(np.uint32)


def quantize(numbers: np.ndarray) -> np.ndarray:
    """Return (T, 5) int64 cells of descriptors (T, 5)."""
    return np.clip(np.floor((numbers - LOWEST) / CELL), 0, CELLS - 1).astype(np.int64)


def fine_values(numbers: np.ndarray) -> np.ndarray:
    """Return (T, 5) float64 descriptors in steps of 1 / 255 of their range, not rounded."""
    return np.clip((numbers - LOWEST) / FINE_UNIT, 0, FINE_STEPS)


def key_ranges(
    index: ConstellationIndex, numbers: np.ndarray, ranks: np.ndarray, tolerances: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return ranges of the index that may contain triangles similar to the given ones.

    Args:
        numbers: (Q, 5) descriptors.
        ranks: (Q, 3) label ranks of A, B, C, all known.
        tolerances: (Q, 5) of the descriptors.

    Returns:
        (R,) given triangle, (R,) first and (R,) last + 1 triangle of the index; no range is empty.
    """
    low, high = quantize(numbers - tolerances), quantize(numbers + tolerances)
    spans = (high - low + 1).astype(np.int32)
    # Cells of the last number are adjacent in the index; all combinations of the others are counted up like digits.
    each = spans[:, :-1].prod(axis=1)
    which = np.repeat(np.arange(len(numbers)), each)
    counted = (np.arange(len(which)) - np.repeat(np.cumsum(each) - each, each)).astype(np.int32)
    first_key = cell_keys(ranks, len(index.class_values), low)[which]
    for column in reversed(range(len(CELLS) - 1)):
        counted, step = np.divmod(counted, spans[which, column])
        first_key += step.view(np.uint32) * np.uint32(CELLS[column + 1 :].prod())
    last_key = first_key + (spans[which, -1] - 1).astype(np.uint32)
    # Ascending keys are found several times faster, because successive searches use the same cached memory.
    order = ascending_order(first_key)
    first = np.searchsorted(index.keys, first_key[order], side="left")
    last = np.searchsorted(index.keys, last_key[order], side="right")
    some = last > first
    return which[order][some], first[some], last[some]


def ascending_order(keys: np.ndarray) -> np.ndarray:
    """Return (H,) the stable order of integers (H,), none negative. NumPy sorts 16 bits at a time much faster."""
    order = np.argsort(keys.astype(np.uint16), kind="stable")
    for shift in range(16, int(keys.max(initial=0)).bit_length(), 16):
        digits = (keys >> keys.dtype.type(shift)).astype(np.uint16)
        order = order[np.argsort(digits[order], kind="stable")]
    return order


def expand_ranges(first: np.ndarray, last: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return every number in ranges first … last − 1.

    Args:
        first: (R,) int.
        last: (R,) int, exclusive.

    Returns:
        (H,) index of the range and (H,) the number.
    """
    spans = last - first
    return np.repeat(np.arange(len(first)), spans), numbers_in(first, spans)


def numbers_in(first: np.ndarray, spans: np.ndarray) -> np.ndarray:
    """Return (H,) every number in ranges (R,) that start at ``first`` and are ``spans`` long."""
    ends = np.cumsum(spans)
    numbers = np.repeat(first - (ends - spans), spans)
    numbers += np.arange(len(numbers))
    return numbers


def similar_triangles(
    index: ConstellationIndex, hits: np.ndarray, source: np.ndarray, numbers: np.ndarray, tolerances: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the hits with five numbers within the tolerances of their given triangle's, and these triangles.

    Args:
        hits: (H,) triangles of the index.
        source: (H,) given triangle of each hit.
        numbers: (Q, 5) descriptors of the given triangles.
        tolerances: (Q, 5) of the descriptors.
    """
    wanted = fine_values(numbers)
    reach = tolerances / FINE_UNIT + 0.5
    low = np.clip(np.ceil(wanted - reach), 0, FINE_STEPS).astype(np.uint8)
    high = np.clip(np.floor(wanted + reach), 0, FINE_STEPS).astype(np.uint8)
    values, first = index.fine.ravel(), hits * len(CELLS)
    for column in range(len(CELLS)):
        # Values below the lowest wrap around and exceed any span.
        above = values[column:].take(first) - low[:, column].copy().take(source)
        agree = np.flatnonzero(above <= (high - low)[:, column].copy().take(source))
        first, source = first.take(agree), source.take(agree)
    return first // len(CELLS), source


def _all_triangles(
    points: np.ndarray, ranks: np.ndarray, log_areas: np.ndarray, whole: np.ndarray, settings: ConstellationSettings
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return neighbors (N, K), and keys, codes and fine numbers of all triangles of the map."""
    neighbor_count = settings.limits.neighbors
    usable = np.flatnonzero(whole)
    neighbors = np.full((len(points), neighbor_count), -1, np.int32)
    near, exists = triples(points[usable], np.exp(log_areas[usable]), neighbor_count)
    neighbors[usable] = np.where(near >= 0, usable[near].astype(np.int32) if len(usable) else near, -1)
    pairs = neighbor_pairs(neighbor_count)
    count = int(ranks.max()) + 1 if len(ranks) else 0
    kind = _kind_of_codes(len(points), settings)
    parts = [(np.empty(0, np.uint32), np.empty(0, kind), np.empty((0, len(CELLS)), np.uint8))]
    for chunk, mask in _chunks(usable, exists):
        rows, pair = np.nonzero(mask)
        anchors = chunk[rows]
        triple = np.column_stack([anchors, np.take_along_axis(neighbors[anchors], pairs[pair], axis=1)])
        order, sides = canonical_order(points[triple])
        large = sides[:, 2] >= settings.limits.minimum_side_in_sizes * np.exp(log_areas[anchors] / 2)
        large &= sides[:, 0] > 0
        triple = np.take_along_axis(triple[large], ORDERS[order[large]], axis=1)
        numbers = describe_triangles(points[triple], log_areas[triple])
        keys = cell_keys(ranks[triple], count, quantize(numbers))
        codes = (anchors[large] * len(pairs) + pair[large]) * len(ORDERS) + order[large]
        parts.append((keys, codes.astype(kind), np.rint(fine_values(numbers)).astype(np.uint8)))
    keys, codes, fine = (np.concatenate([part[i] for part in parts]) for i in range(3))
    return neighbors, keys, codes, fine


@lru_cache
def _corner_places(neighbor_count: int) -> np.ndarray:
    """Return (P · 6, 3) positions of A, B, C among the anchor's neighbors, −1 for the anchor, by code modulo P · 6."""
    pairs = neighbor_pairs(neighbor_count)
    triples_of = np.column_stack([np.full(len(pairs), -1), pairs])
    return triples_of[:, ORDERS].reshape(-1, 3)


def _chunks(usable: np.ndarray, exists: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    for first in range(0, len(usable), BUILD_CHUNK):
        yield usable[first : first + BUILD_CHUNK], exists[first : first + BUILD_CHUNK]
