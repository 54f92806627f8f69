"""Neighbors among points: nearest larger landmarks, and the local density of a landmark's class."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

CANDIDATES_PER_NEIGHBOR = 5
"""Neighbors examined for each larger one wanted: half of them are larger by construction, locally more or fewer."""

DENSITY_NEIGHBORS = 6
"""The local density follows from the distance to this neighbor of the same class."""

KD_TREE_SINGLE = 4
"""OpenCV's name for its exact, deterministic k-d tree (FLANN_INDEX_KDTREE_SINGLE)."""

LEAF_POINTS = 12
"""Points in a leaf of that tree; affects only the speed."""

ROUNDING = 1e-6
"""Largest error of distances of points in 32 bits, as a share of their coordinates; several times the worst case."""


class ClassMatcher:
    """Finds the nearest landmark of the same class, many at a time."""

    def __init__(self, points: np.ndarray, ranks: np.ndarray) -> None:
        """Store the landmarks; the tree of a class is built at its first use.

        Args:
            points: (N,) complex, near zero.
            ranks: (N,) int, place of each object's class, from 0.
        """
        self._points, self._ranks = points, ranks
        self._made: dict[int, tuple[np.ndarray, Any]] = {}

    def match(
        self, places: np.ndarray, ranks: np.ndarray, wanted: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the nearest landmark of the same class for each point.

        Args:
            places: (S, n) complex.
            ranks: (n,) int, −1 for unknown classes.
            wanted: (S, n) bool, the points to match; None for all.

        Returns:
            (S, n) float32 distances and (S, n) int64 landmarks; inf and −1 where the class has no landmark, and for
            points that are not wanted.
        """
        distances = np.full(places.shape, np.inf, np.float32)
        objects = np.full(places.shape, -1, np.int64)
        chosen = np.arange(places.size) if wanted is None else np.flatnonzero(wanted)
        of_points, queries = ranks.take(chosen % len(ranks)), as_float32(places.take(chosen))
        for rank in np.flatnonzero(np.bincount(of_points + 1)[1:]).tolist():
            members, tree = self._tree(rank)
            if not len(members):
                continue
            some = np.flatnonzero(of_points == rank)
            found, squared = tree.knnSearch(queries[some], 1, params={"checks": -1})
            distances.put(chosen[some], np.sqrt(squared))
            objects.put(chosen[some], members[found])
        return distances, objects

    def _tree(self, rank: int) -> tuple[np.ndarray, Any]:
        """Return the landmarks of a class and their tree."""
        if rank not in self._made:
            members = np.flatnonzero(self._ranks == rank)
            self._made[rank] = members, make_tree(as_float32(self._points[members])) if len(members) else None
        return self._made[rank]


class SteppedMatcher:
    """Matches points that move step by step: a point that is still too far from everything is not matched again."""

    def __init__(self, matcher: ClassMatcher, ranks: np.ndarray, count: int) -> None:
        """Match nothing yet.

        Args:
            ranks: (n,) int, −1 for unknown classes.
        """
        self._matcher, self._ranks = matcher, ranks
        self._places = np.zeros((count, len(ranks)), complex)
        self._least = np.full((count, len(ranks)), -np.inf)

    def match(
        self, places: np.ndarray, reach: np.ndarray, which: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the nearest landmark of the same class for each point, exact where it is within a distance.

        Args:
            places: (S, n) complex, the same points as before after a step.
            reach: Largest distance of interest, broadcastable to (S, n).
            which: (S,) numbers of these sets of points; None for all.

        Returns:
            (S, n) float32 distances and (S, n) int64 landmarks. Of points without a landmark within ``reach`` some have
            inf and −1, the others their nearest one.
        """
        # No landmark is nearer than before by more than the step; rounding to 32 bits adds a little.
        rows = slice(None) if which is None else which
        least = self._least[rows] - np.abs(places - self._places[rows])
        wanted = least <= reach + ROUNDING * np.abs(places).max(initial=0)
        distances, objects = self._matcher.match(places, self._ranks, wanted)
        self._places[rows], self._least[rows] = places, np.where(wanted, distances, least)
        return distances, objects


def as_float32(points: np.ndarray) -> np.ndarray:
    """Return (n,) complex points as (n, 2) float32."""
    pairs = np.empty((len(points), 2), np.float32)
    pairs[:, 0], pairs[:, 1] = points.real, points.imag
    return pairs


def make_tree(points_xy: np.ndarray) -> Any:  # noqa: ANN401 -- OpenCV has no type for it
    """Return OpenCV's exact k-d tree of points (N, 2) float32."""
    return cv2.flann_Index(  # type: ignore[attr-defined] # OpenCV has it
        points_xy, {"algorithm": KD_TREE_SINGLE, "leaf_max_size": LEAF_POINTS}
    )


def nearest(points_xy: np.ndarray, queries_xy: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the nearest points of each query, nearest first; exact.

    Args:
        points_xy: (N, 2) float32.
        queries_xy: (Q, 2) float32.
        count: Points for each query, at most N.

    Returns:
        (Q, count) int32 indices and (Q, count) float32 squared distances.
    """
    return make_tree(points_xy).knnSearch(queries_xy, count, params={"checks": -1})


def nearest_larger(points_xy: np.ndarray, areas: np.ndarray, count: int) -> np.ndarray:
    """Return the nearest landmarks of larger area for each landmark.

    The result is independent of the scale of an image, which is why dense towns are thinned in this way. Landmarks are
    halved by area; in each half all but the largest are searched for the others' neighbors, so the work is about 2 N
    nearest-neighbor searches.

    Args:
        points_xy: (N, 2) float.
        areas: (N,) in the square of any unit.
        count: Neighbors for each landmark.

    Returns:
        (N, count) int32, nearest first, −1 for missing ones.
        (N, count) int32, nearest first, −1 where there are no more.
    """
    found = np.full((len(areas), count), -1, np.int32)
    points = centered_float32(points_xy)
    # Position breaks ties of area, so that the result is independent of the order of the landmarks.
    order = np.lexsort((points[:, 1], points[:, 0], areas))
    first, candidates = 0, CANDIDATES_PER_NEIGHBOR * count
    while first < len(order):
        members = order[first:]
        anchors = members[: max(len(members) // 2, 1)] if len(members) > candidates else members
        found[anchors] = _larger_among(points, members, len(anchors), count, candidates)
        first += len(anchors)
    return found


def local_density(points_xy: np.ndarray, classes: np.ndarray) -> np.ndarray:
    """Return (N,) landmarks of the same class per unit of area around each landmark.

    The density is k / (π d²) with the distance d of the k-th neighbor of its class; for a class with few landmarks it
    is that of the whole extent.

    Args:
        points_xy: (N, 2) float.
        classes: (N,) class of each landmark, or its rank.
    """
    points, count = centered_float32(points_xy), DENSITY_NEIGHBORS
    density = np.empty(len(classes))
    extent = float(np.prod(np.maximum(np.ptp(points, axis=0), 1e-6))) if len(points) else 1.0
    for value in np.unique(classes):
        members = np.flatnonzero(classes == value)
        density[members] = len(members) / extent
        if len(members) > count:
            ordered = members[spatial_order(points[members])]
            squared = nearest(points[ordered], points[ordered], count + 1)[1][:, -1]
            near = count / (np.pi * np.maximum(squared, 1e-6))
            density[ordered] = np.maximum(near, len(members) / extent)
    return density


def centered_float32(points_xy: np.ndarray) -> np.ndarray:
    """Return (N, 2) float32 relative to the mean: map coordinates in millions of meters would lose digits."""
    points = np.asarray(points_xy, np.float64).reshape(-1, 2)
    return np.ascontiguousarray(points - (points.mean(axis=0) if len(points) else 0), np.float32)


def spatial_order(points_xy: np.ndarray) -> np.ndarray:
    """Return (N,) an order with near points next to each other (strips), so that searches find data in the cache."""
    strips = max(int(np.sqrt(len(points_xy) / 20)), 1)
    low = points_xy[:, 0].min()
    strip = ((points_xy[:, 0] - low) / (np.ptp(points_xy[:, 0]) + 1e-6) * strips).astype(np.int64)
    return np.lexsort((points_xy[:, 1], strip))


def _larger_among(
    points: np.ndarray, members: np.ndarray, anchor_count: int, count: int, candidates: int
) -> np.ndarray:
    """Return (anchor_count, count) nearest larger landmarks, among ``candidates`` nearest ones, of the first members.

    members are in ascending order of area.
    """
    found = np.full((anchor_count, count), -1, np.int32)
    size = min(candidates + 1, len(members))
    order = spatial_order(points[members])
    anchors = order[order < anchor_count]
    near = nearest(points[members[order]], points[members[anchors]], size)[0]
    ranks = order[near]
    larger = ranks > anchors[:, None]
    place = np.cumsum(larger, axis=1) - 1
    rows, columns = np.nonzero(larger & (place < count))
    found[anchors[rows], place[rows, columns]] = members[ranks[rows, columns]]
    return found
