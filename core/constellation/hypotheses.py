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
"""Triangles of the index looked at together; bounds the memory of a search without a cap."""


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


def find_seeds(
    index: ConstellationIndex, query: SeenLandmarks, triangles: QueryTriangles, prior: Prior | None, cap: int | None
) -> Seeds:
    """The most voted poses of an image.

    Args:
        index: The map's catalogue.
        query: The image's objects.
        triangles: All or some of its triangles.
        prior: What is known beforehand.
        cap: Triangles of the index looked at, at most, those of the rarest first; where they are more, only those where
            the prior has the image are counted. Without a cap all are, a portion at a time, and in every region of the
            map as many poses are kept as else of the whole map.
    """
    triple, numbers, place = triangles.members, triangles.numbers, triangles.tolerances
    settings = index.settings
    reach = np.column_stack([place, place, *[np.full(len(place), settings.area_tolerance)] * 3])
    which, first, last = key_ranges(index, numbers, query.ranks[triple], reach)
    near, capped = None, False
    if cap is not None:
        if (last - first).sum() > cap:
            near = _triangles_near(index, query, prior)
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
    kept = _allowed(index, centers, turns, prior)
    poses = centers[kept], turns[kept], focuses[kept]
    return _clusters(poses, query.diagonal, settings, capped, None if cap is not None else region_edge(index))


def region_edge(index: ConstellationIndex) -> float | None:
    """Edge of a square that holds ``landmarks_of_a_region`` on average, map units; None where the map has no more."""
    most = index.settings.landmarks_of_a_region
    if len(index) <= most:
        return None
    return float(np.sqrt(np.ptp(index.points.real) * np.ptp(index.points.imag) * most / len(index)))


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
        same = (index.ranks[members] == query.ranks[triple[source]]).all(axis=1)
        members, source = members[same], source[same]
    # Least squares of three points each, the same as ``fit_similarity``: what only the image tells once a triangle.
    corners = query.points[triple]
    middles = corners.mean(axis=1)
    away = corners - middles[:, None]
    away = away.conj() / np.maximum((away.real**2 + away.imag**2).sum(axis=1), 1e-300)[:, None]
    a, b, c = (index.points[members[:, k]] for k in range(3))
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


def _allowed(index: ConstellationIndex, centers: np.ndarray, turns: np.ndarray, prior: Prior | None) -> np.ndarray:
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
    region: float | None,
) -> Seeds:
    """Means of the poses in the fullest cells; two lattices of cells, so that no cluster is cut by both.

    Args:
        poses: (H,) complex centers, turns and focuses.
        diagonal: Of the image, pixels.
        settings: Of the constellation.
        capped: Goes into the seeds.
        region: Edge of the squares of the map of which each has its own fullest cells; None for the map as one.
    """
    centers, turns, _ = poses
    log_size = np.log(np.abs(turns))
    angle = np.angle(turns)
    # Cells of position grow with the pixel size in whole steps, so that equal poses share a lattice.
    turn_cell = settings.cell_of_turn
    cell = settings.cell_of_image * diagonal * np.exp(np.round(log_size / turn_cell) * turn_cell)
    around = int(np.ceil(2 * np.pi / turn_cell))
    across, along, turned = centers.real / cell, centers.imag / cell, (angle + np.pi) / (2 * np.pi) * around
    sizes, regions = np.floor(log_size / turn_cell + 0.5), _regions(centers, region)
    found = []
    for shift in (0.0, 0.5):
        cells = np.floor(across + shift), np.floor(along + shift), sizes, np.floor(turned + shift) % around
        found.append(_cell_means(cells, poses, settings.seeds, regions))
    centers, turns, focuses, votes = (np.concatenate(parts) for parts in zip(*found))
    order = np.argsort(-votes, kind="stable")
    # A cluster that neither lattice cuts is found twice.
    once = list({pose: number for number, pose in reversed([*enumerate(zip(centers[order], turns[order]))])}.values())
    order = order[np.sort(np.array(once, np.int64))]
    return Seeds(centers[order], turns[order], focuses[order], votes[order], capped)


def _regions(centers: np.ndarray, edge: float | None) -> np.ndarray | None:
    """(H,) number of the square that each center lies in; None where all are in one."""
    if edge is None or not len(centers):
        return None
    column, row = np.floor(centers.real / edge).astype(np.int64), np.floor(centers.imag / edge).astype(np.int64)
    return (column - column.min()) * (np.ptp(row) + 1) + row - row.min()


def _cell_means(
    cells: tuple[np.ndarray, ...], values: tuple[np.ndarray, ...], seed_count: int, regions: np.ndarray | None
) -> tuple[np.ndarray, ...]:
    """Means of each of the complex values (H,) in the fullest cells of every region (H,), and their counts.

    ``cells``: whole numbers (H,) a dimension.
    """
    if not len(cells[0]):
        return (*(np.empty(0, complex) for _ in values), np.empty(0, np.int64))
    key = np.zeros(len(cells[0]), np.int64)
    for column in cells:
        place = (column - column.min()).astype(np.int64)
        key = key * (int(place.max()) + 1) + place
    order = np.argsort(key)
    starts = np.flatnonzero(np.concatenate([[True], np.diff(key[order]) != 0]))
    votes = np.diff(np.append(starts, len(order)))
    best = _fullest(votes, None if regions is None else regions[order[starts]], seed_count)
    starts, votes = starts[best], votes[best]
    which, places = expand_ranges(starts, starts + votes)
    members = order[places]
    # In the order in which they came, so that equal cells have equal means.
    members, begins = members[np.lexsort((members, which))], np.cumsum(votes) - votes
    return (*(np.add.reduceat(value[members], begins) / votes for value in values), votes)


def _fullest(votes: np.ndarray, regions: np.ndarray | None, count: int) -> np.ndarray:
    """The ``count`` fullest cells of each region, fullest first."""
    if regions is None and len(votes) > count:
        least = np.partition(votes, len(votes) - count)[len(votes) - count]
        order = np.flatnonzero(votes >= least)
        return order[np.argsort(-votes[order], kind="stable")[:count]]
    order = np.argsort(-votes, kind="stable")
    if regions is None:
        return order
    by_region = order[np.argsort(regions[order], kind="stable")]
    starts = np.flatnonzero(np.concatenate([[True], np.diff(regions[by_region]) != 0]))
    place = np.arange(len(by_region)) - np.repeat(starts, np.diff(np.append(starts, len(by_region))))
    kept = np.zeros(len(votes), bool)
    kept[by_region[place < count]] = True
    return order[kept[order]]
