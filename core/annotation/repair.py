"""Repairing an annotation: valid polygons that don't overlap, without gaps and slivers, one a landmark."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, Iterator, List, Sequence, Set, Tuple

import numpy as np
import shapely

from ..geometry.well_known_binary import to_wkb
from .check import region_owners
from .findings import DISSOLVED, GAP, INFORMATION, NOTHING, SLIVER, Finding
from .merging import Merge, MergeSettings, merge_gaps_and_slivers
from .overlaps import classes_of_faces, find_duplicates, find_hidden, find_overlaps
from .partition import PlanarPartition, Regions, dissolve, find_regions, partition_polygons
from .polygons import AnnotatedFeature, AnnotatedPolygons, feature_geometries, split_parts, valid_polygons
from .validity import find_invalid, find_unusable


@dataclass(frozen=True)
class RepairedPolygon:
    """WKB of a valid polygon in meters; its attributes are those of feature number ``feature`` of the list."""

    wkb: bytes
    feature: int


class AnnotationRepair:
    """Iterate ``steps()`` to the end, then ``polygons`` and ``changes`` are there.

    What lies on top where polygons overlap: the higher priority, else the smaller, else the lower class value. On its
    own output nothing changes: the polygons of a repaired annotation are the faces they are cut into.
    """

    def __init__(self, features: Sequence[AnnotatedFeature], settings: MergeSettings) -> None:
        self._features = features
        self._settings = settings
        self.polygons: List[RepairedPolygon] = []
        self.changes: List[Finding] = []

    def steps(self) -> Iterator[Tuple[str, float]]:
        """Yields (what is being done, share done 0…1)."""
        yield "Looking at geometries", 0.0
        geometries = feature_geometries(self._features)
        parts = split_parts(geometries)
        self.changes += find_invalid(self._features, geometries, parts)
        polygons = valid_polygons(self._features, parts)
        self.changes += find_unusable(self._features, geometries, polygons)
        if not len(polygons):
            return
        yield "Laying polygons on each other", 0.1
        partition = partition_polygons(polygons.geometries)
        yield "Resolving overlaps", 0.6
        ranks = polygons.repair_ranks()
        duplicates, repeated = find_duplicates(polygons, partition)
        self.changes += duplicates
        self.changes += find_overlaps(polygons, partition, ranks, repeated)
        self.changes += find_hidden(polygons, partition, ranks, duplicates)
        top = partition.top_polygons(ranks)
        yield "Filling gaps and merging slivers", 0.8
        classes, merges = merge_gaps_and_slivers(partition, classes_of_faces(polygons, top), self._settings)
        self.changes += [_merged(merge, polygons, partition, top) for merge in merges]
        yield "Dissolving neighbors", 0.9
        self._dissolve(polygons, partition, top, classes)
        yield "Dissolving neighbors", 1.0

    def _dissolve(
        self, polygons: AnnotatedPolygons, partition: PlanarPartition, top: np.ndarray, classes: np.ndarray
    ) -> None:
        regions = find_regions(partition, classes)
        # A face that went to a neighbor's class says nothing about whose attributes its region has.
        own = np.where(classes_of_faces(polygons, top) == classes, top, -1)
        owners = region_owners(regions, own, partition.areas)
        covered = classes != NOTHING
        numbers, groups = np.unique(regions.of_face[covered], return_inverse=True)
        geometries = dissolve(partition.faces[covered], groups.reshape(-1))
        features = polygons.features[owners[numbers]]
        order = np.lexsort((*shapely.bounds(geometries).T, features))
        self.polygons = [
            RepairedPolygon(wkb, feature)
            for wkb, feature in zip(to_wkb(geometries[order]).tolist(), features[order].tolist())
        ]
        self.changes += _dissolved(polygons, regions, own, dict(zip(numbers.tolist(), geometries)), owners)


def _merged(merge: Merge, polygons: AnnotatedPolygons, partition: PlanarPartition, top: np.ndarray) -> Finding:
    owner = top[merge.faces[np.argmax(partition.areas[merge.faces])]]
    return Finding(
        GAP if merge.from_class == NOTHING else SLIVER,
        INFORMATION,
        to_wkb(shapely.union_all(partition.faces[merge.faces])),
        int(polygons.feature_ids[owner]) if owner >= 0 else None,
        class_value=merge.from_class,
        other_class=merge.to_class,
        area=float(partition.areas[merge.faces].sum()),
    )


def _dissolved(
    polygons: AnnotatedPolygons, regions: Regions, own: np.ndarray, geometries: Dict[int, object], owners: np.ndarray
) -> List[Finding]:
    """One finding for each region that several features became, with how many."""
    members: Dict[int, Set[int]] = {}
    for region, polygon in zip(regions.of_face[own >= 0].tolist(), own[own >= 0].tolist()):
        members.setdefault(region, set()).add(int(polygons.features[polygon]))
    return [
        Finding(
            DISSOLVED,
            INFORMATION,
            to_wkb(geometries[region]),
            int(polygons.feature_ids[owners[region]]),
            class_value=int(regions.classes[region]),
            area=float(regions.areas[region]),
            number=float(len(features)),
        )
        for region, features in sorted(members.items())
        if len(features) > 1
    ]
