"""Polygons that lie on each other: overlaps, duplicates, polygons that nothing is seen of."""

from __future__ import annotations

from collections import defaultdict
from itertools import combinations
from typing import Dict, List, Tuple

import numpy as np
import shapely

from .annotation_findings import (
    DUPLICATE,
    ERROR,
    HIDDEN,
    INFORMATION,
    OVERLAP,
    SAME_CLASS_NEIGHBORS,
    WARNING,
    Finding,
)
from .annotation_polygons import AnnotatedPolygons
from .geometry_bytes import to_wkb
from .planar_partition import PlanarPartition

NARROWEST_M = 0.001
"""Overlaps with a smaller mean width (m) are rounding; they are mended, but not worth telling."""


def find_duplicates(polygons: AnnotatedPolygons) -> Tuple[List[Finding], np.ndarray]:
    """A finding for each polygon equal to an earlier one, and (N,) bool which these are.

    With different classes it is an error, unless a priority says which lies on top.
    """
    first_of: Dict[bytes, int] = {}
    repeated, found = np.zeros(len(polygons), bool), []
    for n, wkb in enumerate(to_wkb(shapely.normalize(polygons.geometries))):
        first = first_of.setdefault(wkb, n)
        if first == n:
            continue
        repeated[n] = True
        decided = bool(polygons.priorities[first] != polygons.priorities[n])
        differs = polygons.classes[first] != polygons.classes[n]
        found.append(_pair(DUPLICATE, ERROR if differs and not decided else WARNING, polygons, n, first, decided))
    return found, repeated


def find_overlaps(
    polygons: AnnotatedPolygons, partition: PlanarPartition, ranks: np.ndarray, ignored: np.ndarray
) -> List[Finding]:
    """A finding for each two polygons of different features and classes that share an area, the upper one first.

    Where priorities differ they say what lies on top: information. Else it is an error. ``ranks``: (N,) higher on
    top; ``ignored``: (N,) bool polygons left out.
    """
    faces_of: Dict[Tuple[int, int], List[int]] = defaultdict(list)
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
    polygons: AnnotatedPolygons, partition: PlanarPartition, ranks: np.ndarray, duplicates: List[Finding]
) -> List[Finding]:
    """A finding for each polygon of which nothing is seen from above, with the polygon that covers most of it.

    Those that their own duplicate hides are left out: that is told already.
    """
    top = partition.top_polygons(ranks)
    seen = np.zeros(len(polygons), bool)
    seen[top[top >= 0]] = True
    covered: Dict[int, Dict[int, float]] = defaultdict(lambda: defaultdict(float))
    hidden = ~seen[partition.cover_polygons]
    for polygon, face in zip(partition.cover_polygons[hidden].tolist(), partition.cover_faces[hidden].tolist()):
        covered[polygon][int(top[face])] += partition.areas[face]
    found = [_pair(HIDDEN, WARNING, polygons, n, max(over, key=over.get)) for n, over in sorted(covered.items())]
    told = {frozenset((duplicate.feature_id, duplicate.other_id)) for duplicate in duplicates}
    return [hidden for hidden in found if frozenset((hidden.feature_id, hidden.other_id)) not in told]


def find_same_class_neighbors(
    polygons: AnnotatedPolygons, partition: PlanarPartition, ranks: np.ndarray
) -> List[Finding]:
    """A finding for each two features of one class that share a border as seen from above; ``number``: m of border."""
    top = partition.top_polygons(ranks)
    pairs = top[partition.neighbors]
    both = (pairs >= 0).all(axis=1)
    same = np.zeros(len(pairs), bool)
    same[both] = polygons.classes[pairs[both, 0]] == polygons.classes[pairs[both, 1]]
    same[both] &= polygons.features[pairs[both, 0]] != polygons.features[pairs[both, 1]]
    lengths: Dict[Tuple[int, int], float] = defaultdict(float)
    for pair, length in zip(np.sort(pairs[same], axis=1).tolist(), partition.border_lengths[same].tolist()):
        lengths[tuple(pair)] += length
    areas = shapely.area(polygons.geometries)
    found = []
    for pair, length in lengths.items():
        smaller, larger = sorted(pair, key=lambda n: (areas[n], n))
        found.append(_pair(SAME_CLASS_NEIGHBORS, INFORMATION, polygons, smaller, larger, number=length))
    return found


def _overlap(polygons: AnnotatedPolygons, ranks: np.ndarray, pair: Tuple[int, int], shared) -> Finding:
    upper, lower = sorted(pair, key=lambda n: -ranks[n])
    decided = bool(polygons.priorities[upper] != polygons.priorities[lower])
    return _pair(OVERLAP, INFORMATION if decided else ERROR, polygons, upper, lower, decided, geometry=shared)


def _pair(
    kind: str,
    severity: str,
    polygons: AnnotatedPolygons,
    one: int,
    other: int,
    decided: bool = False,
    number: float = 0.0,
    geometry=None,
) -> Finding:
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
        number=number,
        decided=decided,
    )
