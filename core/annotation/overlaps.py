"""Polygons that cover each other: overlaps, duplicates, hidden polygons."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from itertools import combinations
from typing import Any

import numpy as np
import shapely

from .findings import DUPLICATE, ERROR, HIDDEN, INFORMATION, NOTHING, OVERLAP, SAME_CLASS_NEIGHBORS, WARNING, Finding
from .partition import PlanarPartition, corner_neighbors
from .polygons import AnnotatedPolygons, to_wkb

NARROWEST_M = 0.001
"""Overlaps with a smaller mean width (m) are rounding errors; they are repaired, but not reported."""


def find_duplicates(polygons: AnnotatedPolygons, partition: PlanarPartition) -> tuple[list[Finding], np.ndarray]:
    """Find polygons that cover exactly what an earlier one covers.

    With different classes it is an error, unless a priority decides which is on top.

    Returns:
        A finding for each such polygon, and (N,) bool which these are.
    """
    first_of: dict[bytes, int] = {}
    repeated, found = np.zeros(len(polygons), bool), []
    order = np.argsort(partition.cover_polygons, kind="stable")
    bounds = np.searchsorted(partition.cover_polygons[order], np.arange(len(polygons) + 1))
    faces = partition.cover_faces[order]
    for n, (start, end) in enumerate(zip(bounds[:-1].tolist(), bounds[1:].tolist())):
        first = first_of.setdefault(faces[start:end].tobytes(), n) if start < end else n
        if first == n:
            continue
        repeated[n] = True
        decided = bool(polygons.priorities[first] != polygons.priorities[n])
        differs = polygons.classes[first] != polygons.classes[n]
        severity = ERROR if differs and not decided else WARNING
        found.append(_pair(DUPLICATE, severity, polygons, (n, first), decided=decided))
    return found, repeated


def find_overlaps(
    polygons: AnnotatedPolygons, partition: PlanarPartition, ranks: np.ndarray, ignored: np.ndarray
) -> list[Finding]:
    """Find pairs of polygons of different features and classes that share an area.

    If a priority decides which is on top, the finding is information, otherwise an error.

    Args:
        ranks: (N,) int64, higher ones are on top.
        ignored: (N,) bool, polygons to skip.

    Returns:
        A finding for each pair, the upper polygon first.
    """
    faces_of: dict[tuple[int, int], list[int]] = defaultdict(list)
    starts = np.flatnonzero(np.diff(partition.cover_faces, prepend=-1))
    for start, end in zip(starts, [*starts[1:], len(partition.cover_faces)]):
        if end - start < 2:
            continue
        covering = partition.cover_polygons[start:end]
        covering = covering[~ignored[covering]].tolist()
        for first, second in combinations(covering, 2):
            if polygons.classes[first] != polygons.classes[second]:
                faces_of[first, second].append(partition.cover_faces[start])
    return [
        _overlap(polygons, ranks, pair, shapely.union_all(partition.faces[faces]))
        for pair, faces in faces_of.items()
        if 2 * partition.areas[faces].sum() >= NARROWEST_M * partition.perimeters[faces].sum()
    ]


def find_hidden(
    polygons: AnnotatedPolygons, partition: PlanarPartition, ranks: np.ndarray, duplicates: list[Finding]
) -> list[Finding]:
    """Find polygons that are completely hidden.

    Args:
        ranks: (N,) int64, higher ones are on top.
        duplicates: Findings of hidden duplicates, which are not repeated.

    Returns:
        A finding for each other hidden polygon, with the polygon that covers most of it.
    """
    top = partition.top_polygons(ranks)
    seen = np.zeros(len(polygons), bool)
    seen[top[top >= 0]] = True
    covered: dict[int, dict[int, float]] = defaultdict(lambda: defaultdict(float))
    hidden = ~seen[partition.cover_polygons]
    for polygon, face in zip(partition.cover_polygons[hidden].tolist(), partition.cover_faces[hidden].tolist()):
        covered[polygon][int(top[face])] += partition.areas[face]
    found = [
        _pair(HIDDEN, WARNING, polygons, (n, max(over, key=over.__getitem__))) for n, over in sorted(covered.items())
    ]
    known = {frozenset((duplicate.feature_id, duplicate.other_id)) for duplicate in duplicates}
    return [hidden for hidden in found if frozenset((hidden.feature_id, hidden.other_id)) not in known]


def find_same_class_neighbors(
    polygons: AnnotatedPolygons, partition: PlanarPartition, ranks: np.ndarray, landmark_classes: Sequence[int]
) -> list[Finding]:
    """Find pairs of features of one class that visibly touch.

    Landmarks are also reported if they touch in one point, because pixels that touch by a corner form one region.

    Args:
        ranks: (N,) int64, higher ones are on top.

    Returns:
        A finding for each pair, the smaller polygon first; its number is the shared border in meters, 0 for a point.
    """
    top = partition.top_polygons(ranks)
    lengths: dict[tuple[int, int], float] = defaultdict(float)
    pairs, same = _of_one_class(polygons, top, partition.neighbors)
    for pair, length in zip(pairs, partition.border_lengths[same].tolist()):
        lengths[pair] += length
    known = {_features(polygons, pair) for pair in lengths}
    for pair in _of_one_class(polygons, top, corner_neighbors(partition, classes_of_faces(polygons, top)))[0]:
        if polygons.classes[pair[0]] in landmark_classes and _features(polygons, pair) not in known:
            known.add(_features(polygons, pair))
            lengths[pair] = 0.0
    areas = shapely.area(polygons.geometries)
    found = []
    for pair, length in lengths.items():
        smaller, larger = sorted(pair, key=lambda n: (areas[n], n))
        more = {"number": length, "is_landmark": bool(polygons.classes[smaller] in landmark_classes)}
        found.append(_pair(SAME_CLASS_NEIGHBORS, INFORMATION, polygons, (smaller, larger), **more))
    return found


def classes_of_faces(polygons: AnnotatedPolygons, top: np.ndarray) -> np.ndarray:
    """Return (F,) class values of the visible polygons, NOTHING where ``top`` is −1."""
    return np.where(top >= 0, np.append(polygons.classes, NOTHING)[top], NOTHING)


def _of_one_class(
    polygons: AnnotatedPolygons, top: np.ndarray, neighbors: np.ndarray
) -> tuple[list[tuple[int, int]], np.ndarray]:
    """Return pairs of polygons of one class and different features, and (E,) bool: which ``neighbors`` they are."""
    pairs = top[neighbors]
    both = (pairs >= 0).all(axis=1)
    same = np.zeros(len(pairs), bool)
    same[both] = polygons.classes[pairs[both, 0]] == polygons.classes[pairs[both, 1]]
    same[both] &= polygons.features[pairs[both, 0]] != polygons.features[pairs[both, 1]]
    return [tuple(pair) for pair in np.sort(pairs[same], axis=1).tolist()], same


def _features(polygons: AnnotatedPolygons, pair: tuple[int, int]) -> frozenset[int]:
    return frozenset(polygons.features[list(pair)].tolist())


def _overlap(
    polygons: AnnotatedPolygons, ranks: np.ndarray, pair: tuple[int, int], shared: shapely.Geometry
) -> Finding:
    upper, lower = sorted(pair, key=lambda n: -ranks[n])
    decided = bool(polygons.priorities[upper] != polygons.priorities[lower])
    severity = INFORMATION if decided else ERROR
    return _pair(OVERLAP, severity, polygons, (upper, lower), shared, decided=decided)


def _pair(
    kind: str,
    severity: str,
    polygons: AnnotatedPolygons,
    pair: tuple[int, int],
    geometry: shapely.Geometry | None = None,
    **more: Any,  # noqa: ANN401 - further attributes of Finding
) -> Finding:
    """Return a finding about two polygons, by index; it shows ``geometry``, or the first polygon."""
    one, other = pair
    shown = polygons.geometries[one] if geometry is None else geometry
    return Finding(
        kind,
        severity,
        to_wkb(shown),
        int(polygons.feature_ids[one]),
        int(polygons.feature_ids[other]),
        int(polygons.classes[one]),
        int(polygons.classes[other]),
        float(shapely.area(shown)),
        **more,
    )
