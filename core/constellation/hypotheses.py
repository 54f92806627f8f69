"""Where an image may be: triangles looked up, turned into poses, gathered into clusters.

Told in docs/method.md#constellation.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..localization import Prior
from .index import ConstellationIndex, expand_ranges, key_ranges, like_triangles
from .settings import ConstellationSettings
from .triangles import ORDERS, canonical_order, describe_triangles, neighbor_pairs, triples

PORTION = 400_000
"""Triangles of the index looked at together; bounds the memory of a search of many."""

_SORTED_AT_ONCE = 20_000
"""So many poses are sorted sooner than counted."""

_GROUP_BITS = 24
"""Of the number of a group, at most: counting them takes 128 MB."""

_SPREADING = np.uint64(0x9E3779B97F4A7C15)
"""Keys that are next to each other fall into groups far apart (Fibonacci hashing)."""


@dataclass(frozen=True)
class SeenLandmarks:
    """Landmarks as an image shows them, n of them.

    Attributes:
        points: (n,) complex, pixels from the image's center, y up.
        ranks: (n,) int64, place of each class in the catalogue's, −1 of a class that it doesn't have.
        log_areas: (n,) ln of areas in px².
        whole: (n,) bool, not cut by the image's border.
        diagonal: Of the image in pixels.
    """

    points: np.ndarray
    ranks: np.ndarray
    log_areas: np.ndarray
    whole: np.ndarray
    diagonal: float

    @property
    def usable_count(self) -> int:
        """Whole landmarks of known class."""
        return int((self.whole & (self.ranks >= 0)).sum())

    def select(self, chosen: np.ndarray) -> SeenLandmarks:
        """The chosen objects of the image, in that order."""
        return SeenLandmarks(
            self.points[chosen], self.ranks[chosen], self.log_areas[chosen], self.whole[chosen], self.diagonal
        )

    def mirrored(self) -> SeenLandmarks:
        """The landmarks of the mirrored image: same density, same regularity, and no camera can see it."""
        return SeenLandmarks(-self.points.conj(), self.ranks, self.log_areas, self.whole, self.diagonal)


@dataclass(frozen=True)
class QueryTriangles:
    """Labeled triangles of an image, Q of them.

    Attributes:
        members: (Q, 3) int64, objects A, B, C of the image.
        numbers: (Q, 5) float64, what they are described by (``describe_triangles``).
        tolerances: (Q,) float64, of the place of C in the frame of AB.
    """

    members: np.ndarray
    numbers: np.ndarray
    tolerances: np.ndarray

    def __len__(self) -> int:
        """How many triangles there are."""
        return len(self.members)

    def every(self, step: int) -> QueryTriangles:
        """The first triangle and every ``step``-th after it."""
        return QueryTriangles(self.members[::step], self.numbers[::step], self.tolerances[::step])

    def mirrored(self) -> QueryTriangles:
        """The triangles as the mirrored image has them."""
        return QueryTriangles(self.members, self.numbers * np.array([1, -1, 1, 1, 1]), self.tolerances)


@dataclass(frozen=True)
class Seeds:
    """Clusters of poses, S of them, most votes first.

    Attributes:
        centers: (S,) complex, map units from the index's origin.
        turns: (S,) complex, heading and pixel size.
        focuses: (S,) complex, where in the image the triangles are on average.
        votes: (S,) int64, triangles that agree.
        capped: Hits were left out.
    """

    centers: np.ndarray
    turns: np.ndarray
    focuses: np.ndarray
    votes: np.ndarray
    capped: bool


def query_triangles(query: SeenLandmarks, settings: ConstellationSettings) -> QueryTriangles:
    """Triangles of an image's whole objects of known class.

    One whose sides are so alike that noise could change their order is given in each order.
    """
    usable = np.flatnonzero(query.whole & (query.ranks >= 0))
    areas = np.exp(query.log_areas[usable])
    neighbors, exists = triples(query.points[usable], areas, settings.query_neighbors, settings)
    exists[np.argsort(-areas, kind="stable")[settings.anchors :]] = False
    rows, pair = np.nonzero(exists)
    chosen = np.take_along_axis(neighbors[rows], neighbor_pairs(settings.query_neighbors)[pair], axis=1)
    triple = usable[np.column_stack([rows, chosen])].reshape(-1, 3)
    order, sides = canonical_order(query.points[triple])
    sizes = np.exp(query.log_areas[triple] / 2).mean(axis=1)
    noise = np.hypot(settings.center_noise_px, settings.center_noise_in_sizes * sizes)
    tolerance = settings.place_tolerance_in_noise * noise / np.maximum(sides[:, 2], 1e-9)
    large = sides[:, 2] >= settings.minimum_side_in_sizes * np.exp(query.log_areas[triple[:, 0]] / 2)
    good = large & (tolerance <= settings.place_tolerance_maximum) & (sides[:, 0] > 0)
    triple = np.take_along_axis(triple[good], ORDERS[order[good]], axis=1)
    tolerance, sides = np.maximum(tolerance[good], settings.place_tolerance_minimum), sides[good]
    alike = tolerance * sides[:, 2]
    middle = sides[:, 2] - sides[:, 1] < alike
    short = sides[:, 1] - sides[:, 0] < alike
    triple = np.concatenate([triple, triple[middle][:, (2, 1, 0)], triple[short][:, (1, 0, 2)]])
    tolerance = np.concatenate([tolerance, tolerance[middle], tolerance[short]])
    return QueryTriangles(triple, describe_triangles(query.points[triple], query.log_areas[triple]), tolerance)


def find_seeds(  # noqa: PLR0913 - the map, the image, what is known, and how far to look
    index: ConstellationIndex,
    query: SeenLandmarks,
    triangles: QueryTriangles,
    prior: Prior | None,
    cap: int,
    count: int | None = None,
) -> Seeds:
    """The most voted poses of an image.

    Args:
        index: The map's catalogue.
        query: The image's objects.
        triangles: All or some of its triangles.
        prior: What is known beforehand.
        cap: Triangles of the index looked at, at most, those of the rarest first, a portion at a time; where they are
            more, only those where the prior has the image are counted.
        count: Poses of each of two lattices of cells; as many as the index's settings say without it.
    """
    triple, numbers, place = triangles.members, triangles.numbers, triangles.tolerances
    settings = index.settings
    reach = np.column_stack([place, place, *[np.full(len(place), settings.area_tolerance)] * 3])
    which, first, last = key_ranges(index, numbers, query.ranks[triple], reach)
    near = _triangles_near(index, query, prior) if (last - first).sum() > cap else None
    if near is not None:
        # From here on stretches of ``near`` instead of stretches of the index.
        first, last = np.searchsorted(near, first), np.searchsorted(near, last)
    which, first, last, capped = _rarest(which, first, last, len(triple), cap)
    found = []
    for portion in _portions(last - first, PORTION):
        stretch, hits = expand_ranges(first[portion], last[portion])
        source, hits = which[portion][stretch], hits if near is None else near[hits]
        agree = like_triangles(index, hits, source, numbers, reach)
        found.append(_poses(index, query, triple, source[agree], hits[agree]))
    centers, turns, focuses = (np.concatenate(parts) for parts in zip(*found)) if found else [np.empty(0, complex)] * 3
    kept = allowed_poses(index, centers, turns, prior)
    poses = centers[kept], turns[kept], focuses[kept]
    return _clusters(poses, query.diagonal, settings, capped, count or settings.seeds)


def _portions(spans: np.ndarray, most: int) -> Iterator[slice]:
    """Stretches in portions of about ``most`` triangles, so that memory is bounded."""
    ends = np.cumsum(spans)
    first = 0
    while first < len(spans):
        looked = ends[first - 1] if first else 0
        last = max(int(np.searchsorted(ends, looked + most, side="right")), first + 1)
        yield slice(first, last)
        first = last


def _poses(
    index: ConstellationIndex, query: SeenLandmarks, triple: np.ndarray, source: np.ndarray, hits: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Centers, turns and the triangles' middles in the image of like triangles whose classes agree.

    Args:
        index: The map's catalogue.
        query: The image's objects.
        triple: (Q, 3) corners of the image's triangles.
        source: (H,) the triangle of the image of each hit.
        hits: (H,) the triangles of the index that are like them.
    """
    members = index.members(hits)
    if not index.keys_tell_classes:
        alike = [index.ranks[of] == query.ranks[triple[source, k]] for k, of in enumerate(members)]
        same = np.logical_and.reduce(alike)
        members, source = [of[same] for of in members], source[same]
    # Least squares of three points each, the same as ``fit_similarity``: what only the image tells once a triangle.
    corners = query.points[triple]
    middles = corners.mean(axis=1)
    away = corners - middles[:, None]
    away = away.conj() / np.maximum((away.real**2 + away.imag**2).sum(axis=1), 1e-300)[:, None]
    a, b, c = (index.points.take(of) for of in members)
    middles, turns = middles[source], away[source, 1] * (b - a) + away[source, 2] * (c - a)
    return (a + b + c) / 3 - turns * middles, turns, middles


def _triangles_near(index: ConstellationIndex, query: SeenLandmarks, prior: Prior | None) -> np.ndarray | None:
    """Ascending triangles of the index that an image may show at a prior's position; None without one."""
    if prior is None or prior.position is None or prior.radius is None or prior.pixel_size_range is None:
        return None
    # Objects lie within half a diagonal of the center; the rest is for triangles that fit only nearly.
    reach = prior.radius + query.diagonal * prior.pixel_size_range[1]
    center, corner = complex(*prior.position) - index.origin, complex(reach, reach)
    inside = np.zeros(len(index), bool)
    inside[index.within(center - corner, center + corner)] = True
    return np.flatnonzero(inside[index.anchors()])


def _rarest(
    which: np.ndarray, first: np.ndarray, last: np.ndarray, count: int, cap: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray, bool]:
    """Only the stretches of the triangles with the fewest hits, as many as the cap allows; whether any is left out."""
    hits = np.bincount(which, weights=last - first, minlength=count)
    order = np.argsort(hits, kind="stable")
    allowed = np.zeros(count, bool)
    allowed[order[np.cumsum(hits[order]) <= cap]] = True
    kept = allowed[which]
    return which[kept], first[kept], last[kept], not bool(allowed.all())


def allowed_poses(index: ConstellationIndex, centers: np.ndarray, turns: np.ndarray, prior: Prior | None) -> np.ndarray:
    """(H,) bool: poses that the prior does not exclude."""
    size = np.abs(turns)
    kept = size > 0
    if prior is None:
        return kept
    if prior.pixel_size_range is not None:
        kept &= (size >= prior.pixel_size_range[0]) & (size <= prior.pixel_size_range[1])
    if prior.position is not None and prior.radius is not None:
        kept &= np.abs(centers + index.origin - complex(*prior.position)) <= prior.radius
    if prior.heading_deg is not None:
        away = (-np.degrees(np.angle(turns)) - prior.heading_deg + 180) % 360 - 180
        kept &= np.abs(away) <= prior.heading_range_deg
    return kept


def _clusters(
    poses: tuple[np.ndarray, np.ndarray, np.ndarray],
    diagonal: float,
    settings: ConstellationSettings,
    capped: bool,
    count: int,
) -> Seeds:
    """Means of the poses in the fullest cells; two lattices of cells, so that no cluster is cut by both.

    Args:
        poses: (H,) complex centers, turns and focuses.
        diagonal: Of the image, pixels.
        settings: Of the constellation.
        capped: Goes into the seeds.
        count: Cells of each lattice.
    """
    centers, turns, _ = poses
    log_size = np.log(np.abs(turns))
    angle = np.angle(turns)
    # Cells of position grow with the pixel size in whole steps, so that equal poses share a lattice.
    turn_cell = settings.cell_of_turn
    cell = settings.cell_of_image * diagonal * np.exp(np.round(log_size / turn_cell) * turn_cell)
    around = int(np.ceil(2 * np.pi / turn_cell))
    across, along, turned = centers.real / cell, centers.imag / cell, (angle + np.pi) / (2 * np.pi) * around
    sizes = np.floor(log_size / turn_cell + 0.5)
    found = []
    for shift in (0.0, 0.5):
        cells = np.floor(across + shift), np.floor(along + shift), sizes, np.floor(turned + shift) % around
        found.append(_cell_means(cells, poses, count))
    centers, turns, focuses, votes = (np.concatenate(parts) for parts in zip(*found))
    order = np.argsort(-votes, kind="stable")
    # A cluster that neither lattice cuts is found twice.
    once = list({pose: number for number, pose in reversed([*enumerate(zip(centers[order], turns[order]))])}.values())
    order = order[np.sort(np.array(once, np.int64))]
    return Seeds(centers[order], turns[order], focuses[order], votes[order], capped)


def _cell_means(
    cells: tuple[np.ndarray, ...], values: tuple[np.ndarray, ...], seed_count: int
) -> tuple[np.ndarray, ...]:
    """Means of each of the complex values (H,) in the fullest cells, and their counts.

    ``cells``: whole numbers (H,) a dimension.
    """
    if not len(cells[0]):
        return (*(np.empty(0, complex) for _ in values), np.empty(0, np.int64))
    key = np.zeros(len(cells[0]), np.int64)
    for column in cells:
        place = (column - column.min()).astype(np.int64)
        key = key * (int(place.max()) + 1) + place
    found = _in_full_cells(key, seed_count)
    order = found[np.argsort(key[found], kind="stable")]
    starts = np.flatnonzero(np.concatenate([[True], np.diff(key[order]) != 0]))
    votes = np.diff(np.append(starts, len(order)))
    best = _fullest(votes, seed_count)
    starts, votes = starts[best], votes[best]
    # In the order in which they came, so that equal cells have equal means.
    which, places = expand_ranges(starts, starts + votes)
    begins = np.cumsum(votes) - votes
    return (*(np.add.reduceat(value[order[places]], begins) / votes for value in values), votes)


def _in_full_cells(key: np.ndarray, count: int) -> np.ndarray:
    """Ascending places (H,) of keys among which those of the ``count`` fullest cells surely are, all of them.

    Nearly all of millions of poses lie alone in their cells. Cells are counted in groups, which takes no sorting: what
    is in a group of few poses is in a cell of few.
    """
    everything = np.arange(len(key))
    if len(key) < _SORTED_AT_ONCE:
        return everything
    bits = min(len(key).bit_length() + 2, _GROUP_BITS)
    group = (key.view(np.uint64) * _SPREADING >> np.uint64(64 - bits)).view(np.int64)
    sizes = np.bincount(group, minlength=1 << bits)
    groups_of = np.bincount(sizes)
    # Down from the largest groups, until so many cells are as full as the least of them.
    for least in range(len(groups_of) - 1, 1, -1):
        if groups_of[least:].sum() < count:
            continue
        found = np.flatnonzero(sizes[group] >= least)
        if (np.unique(key[found], return_counts=True)[1] >= least).sum() >= count:
            return found
    return everything


def _fullest(votes: np.ndarray, count: int) -> np.ndarray:
    """The ``count`` fullest cells, fullest first."""
    if len(votes) <= count:
        return np.argsort(-votes, kind="stable")
    least = np.partition(votes, len(votes) - count)[len(votes) - count]
    order = np.flatnonzero(votes >= least)
    return order[np.argsort(-votes[order], kind="stable")[:count]]
