"""Merge gaps and slivers with neighboring polygons."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely

from .findings import GAP, NOTHING, SLIVER, Finding
from .partition import PlanarPartition, Regions, find_regions
from .polygons import AnnotatedPolygons, to_wkb

THIN_M = 0.25
"""Gaps and pieces between neighbors with a smaller mean width (m) are drawing errors."""


@dataclass(frozen=True)
class Merge:
    """Faces that get the class of a neighbor.

    Attributes:
        faces: (n,) int64 indices of the faces.
        from_class: Their class; NOTHING for a gap.
        to_class: The neighbor's class.
    """

    faces: np.ndarray
    from_class: int
    to_class: int


def merge_gaps_and_slivers(
    partition: PlanarPartition, face_classes: np.ndarray, maximum_gap: float, minimum_area: float = 0.0
) -> tuple[np.ndarray, list[Merge]]:
    """Give every gap and sliver to the neighbor with the longest shared border.

    Neighbors that are not slivers themselves are preferred. Thin gaps and pieces are always merged.

    Args:
        partition: F faces.
        face_classes: (F,) visible class values.
        maximum_gap: m²; enclosed gaps up to this area are filled.
        minimum_area: m²; smaller pieces are merged.

    Returns:
        (F,) class values afterwards, and the merges in their order.
    """
    classes = face_classes.copy()
    merges: list[Merge] = []
    while True:
        regions = find_regions(partition, classes)
        unwanted = _unwanted(regions, maximum_gap, minimum_area)
        target = _longest_neighbors(regions, unwanted, taking=~unwanted)
        if (target < 0).all():
            # The remaining ones have only each other as neighbors: start with the smallest.
            target = _smallest_only(regions, _longest_neighbors(regions, unwanted, taking=np.ones_like(unwanted)))
        moved = np.flatnonzero(target >= 0)
        if not len(moved):
            return classes, merges
        order = np.argsort(regions.of_face, kind="stable")
        bounds = np.searchsorted(regions.of_face[order], np.arange(len(regions.classes) + 1))
        for region in moved.tolist():
            faces = order[bounds[region] : bounds[region + 1]]
            merges.append(Merge(faces, int(regions.classes[region]), int(regions.classes[target[region]])))
            classes[faces] = merges[-1].to_class


def merge_finding(
    merge: Merge, severity: str, polygons: AnnotatedPolygons, partition: PlanarPartition, top: np.ndarray
) -> Finding:
    """Return a gap or sliver as a finding, with the feature that is visible on most of it.

    Args:
        partition: Their F faces.
        top: (F,) int64 visible polygon on each face, or −1.
    """
    owner = top[merge.faces[np.argmax(partition.areas[merge.faces])]]
    return Finding(
        GAP if merge.from_class == NOTHING else SLIVER,
        severity,
        to_wkb(shapely.union_all(partition.faces[merge.faces])),
        int(polygons.feature_ids[owner]) if owner >= 0 else None,
        class_value=merge.from_class,
        other_class=merge.to_class,
        area=float(partition.areas[merge.faces].sum()),
    )


def _unwanted(regions: Regions, maximum_gap: float, minimum_area: float) -> np.ndarray:
    """Return (R,) bool: which regions are gaps or slivers."""
    # A gap with exactly the limit's area is filled; such a piece remains.
    too_small = np.where(regions.classes == NOTHING, regions.areas <= maximum_gap, regions.areas < minimum_area)
    return too_small | (regions.mean_widths < THIN_M)


def _longest_neighbors(regions: Regions, unwanted: np.ndarray, taking: np.ndarray) -> np.ndarray:
    """Return (R,) int64: the neighbor among ``taking`` for each unwanted region, or −1."""
    target = np.full(len(regions.classes), -1, np.int64)
    one, other = regions.neighbors.T
    possible = unwanted[one] & taking[other] & (regions.classes[other] != NOTHING)
    one, other, lengths = one[possible], other[possible], regions.border_lengths[possible]
    order = np.lexsort((-other, lengths))
    # Of several values for one index numpy stores the last: the longest.
    target[one[order]] = other[order]
    return target


def _smallest_only(regions: Regions, target: np.ndarray) -> np.ndarray:
    """Return (R,) int64: the target of the smallest region with one; −1 for all others."""
    merging = np.flatnonzero(target >= 0)
    only = np.full_like(target, -1)
    if len(merging):
        smallest = merging[np.argmin(regions.areas[merging])]
        only[smallest] = target[smallest]
    return only
