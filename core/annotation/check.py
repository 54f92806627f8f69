"""Checking an annotation: everything that is wrong or worth knowing before it becomes a label map."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterator, List, Optional, Sequence, Tuple

import numpy as np
import shapely

from ..geometry.well_known_binary import to_wkb
from ..landmarks.landmarks import minimum_area_px
from .findings import GAP, INFORMATION, LOST, MERGED, NOTHING, SLIVER, SMALL, SPLIT, WARNING, Finding
from .merging import MergeSettings, merge_gaps_and_slivers
from .overlaps import (
    NARROWEST_M,
    classes_of_faces,
    find_duplicates,
    find_hidden,
    find_overlaps,
    find_same_class_neighbors,
)
from .partition import PlanarPartition, Regions, dissolve, find_regions, partition_polygons
from .polygons import AnnotatedFeature, AnnotatedPolygons, feature_geometries, split_parts, valid_polygons
from .raster_losses import RegionRuns, count_pieces, lost_regions, merged_regions
from .validity import find_invalid, find_unusable


@dataclass(frozen=True)
class CheckSettings:
    """minimum_area: smaller landmarks (m²) are none; maximum_gap: enclosed gaps up to this area (m²) are reported;
    landmark_classes: class values that become landmarks."""

    minimum_area: float
    maximum_gap: float
    landmark_classes: Sequence[int]


@dataclass(frozen=True)
class DrawnRegion:
    """A landmark as drawn: WKB of a polygon in meters, its bounds (left, bottom, right, top), its class value, the id
    of the feature that covers most of it, m²."""

    wkb: bytes
    bounds: Tuple[float, float, float, float]
    class_value: int
    feature_id: int
    area: float


class AnnotationCheck:
    """Iterate ``steps()`` to the end, then ``findings`` has all but what pixels do; ``landmarks`` are for those.

    landmarks: drawn regions of the landmark classes with at least the minimum area
    """

    def __init__(self, features: Sequence[AnnotatedFeature], settings: CheckSettings) -> None:
        self._features = features
        self._settings = settings
        self.findings: List[Finding] = []
        self.landmarks: List[DrawnRegion] = []

    def steps(self) -> Iterator[Tuple[str, float]]:
        """Yields (what is being done, share done 0…1)."""
        yield "Looking at geometries", 0.0
        geometries = feature_geometries(self._features)
        parts = split_parts(geometries)
        self.findings += find_invalid(self._features, geometries, parts)
        polygons = valid_polygons(self._features, parts)
        self.findings += find_unusable(self._features, geometries, polygons)
        yield "Laying polygons on each other", 0.1
        if not len(polygons):
            return
        partition = partition_polygons(polygons.geometries)
        yield "Looking for overlaps", 0.6
        ranks = polygons.drawn_ranks()
        duplicates, repeated = find_duplicates(polygons, partition)
        self.findings += duplicates
        self.findings += find_overlaps(polygons, partition, ranks, repeated)
        self.findings += find_hidden(polygons, partition, ranks, duplicates)
        yield "Looking for gaps and slivers", 0.8
        self.findings += find_gaps_and_slivers(polygons, partition, self._settings.maximum_gap)
        yield "Looking at neighbors of one class", 0.85
        self.findings += find_same_class_neighbors(polygons, partition, ranks, self._settings.landmark_classes)
        yield "Looking at landmarks", 0.9
        self._find_landmarks(polygons, partition, ranks)
        yield "Looking at landmarks", 1.0

    def _find_landmarks(self, polygons: AnnotatedPolygons, partition: PlanarPartition, ranks: np.ndarray) -> None:
        top = partition.top_polygons(ranks)
        face_classes = classes_of_faces(polygons, top)
        wanted = np.isin(face_classes, [int(value) for value in self._settings.landmark_classes])
        regions = find_regions(partition, face_classes)
        owners = region_owners(regions, top, partition.areas)
        numbers, groups = np.unique(regions.of_face[wanted], return_inverse=True)
        for region, geometry in zip(numbers.tolist(), dissolve(partition.faces[wanted], groups.reshape(-1))):
            value, area = int(regions.classes[region]), float(regions.areas[region])
            feature_id = int(polygons.feature_ids[owners[region]])
            if area < self._settings.minimum_area:
                wkb = to_wkb(geometry)
                self.findings.append(Finding(SMALL, INFORMATION, wkb, feature_id, None, value, area=area))
            else:
                bounds = tuple(shapely.bounds(geometry).tolist())
                self.landmarks.append(DrawnRegion(to_wkb(geometry), bounds, value, feature_id, area))


def region_owners(regions: Regions, top: np.ndarray, face_areas: np.ndarray) -> np.ndarray:
    """(R,) int64 polygon that covers most of each region as seen from above, the first of equals; −1 for none.

    ``top``: (F,) polygon seen on each face, −1 where the region's class is not this polygon's.
    """
    owners = np.full(len(regions.classes), -1, np.int64)
    owned = top >= 0
    count = int(top.max(initial=0)) + 1
    keys, place = np.unique(regions.of_face[owned] * count + top[owned], return_inverse=True)
    areas = np.bincount(place.reshape(-1), face_areas[owned], len(keys))
    order = np.lexsort((-keys, areas))
    owners[keys[order] // count] = keys[order] % count
    return owners


def find_gaps_and_slivers(polygons: AnnotatedPolygons, partition: PlanarPartition, maximum_gap: float) -> List[Finding]:
    """What repairing would give to a neighbor: gaps between polygons, and thin pieces that are seen between them.

    Overlaps without priority are taken as repaired.
    """
    top = partition.top_polygons(polygons.repair_ranks())
    _, merges = merge_gaps_and_slivers(partition, classes_of_faces(polygons, top), MergeSettings(maximum_gap))
    found = []
    for merge in merges:
        area, perimeter = partition.areas[merge.faces].sum(), partition.perimeters[merge.faces].sum()
        if 2 * area < NARROWEST_M * perimeter:
            continue
        owner = top[merge.faces[np.argmax(partition.areas[merge.faces])]]
        found.append(
            Finding(
                GAP if merge.from_class == NOTHING else SLIVER,
                WARNING,
                to_wkb(shapely.union_all(partition.faces[merge.faces])),
                int(polygons.feature_ids[owner]) if owner >= 0 else None,
                class_value=merge.from_class,
                other_class=merge.to_class,
                area=float(area),
            )
        )
    return found


def find_raster_losses(
    landmarks: Sequence[DrawnRegion], runs: RegionRuns, minimum_area: float, pixel_size: float
) -> List[Finding]:
    """What pixels of ``pixel_size`` m make of landmarks; ``runs`` has landmark n as region n + 1.

    Lost: no piece has a contour area of ``minimum_area`` m²; merged: pixels of two touch, so that they are one object;
    split: the pixels fall into pieces.
    """
    count = len(landmarks) + 1
    classes = np.array([NOTHING, *(landmark.class_value for landmark in landmarks)])
    merged = merged_regions(runs, classes)
    lost = lost_regions(runs, count, minimum_area_px(minimum_area, pixel_size))
    lost[merged] = False
    lost[0] = False
    pieces = count_pieces(runs, count)
    found = [_landmark(LOST, landmarks[n - 1]) for n in np.flatnonzero(lost)]
    for one, other in merged.tolist():
        smaller, larger = sorted((landmarks[one - 1], landmarks[other - 1]), key=lambda landmark: landmark.area)
        found.append(_landmark(MERGED, smaller, larger))
    return found + [_landmark(SPLIT, landmarks[n - 1], number=float(pieces[n])) for n in np.flatnonzero(pieces > 1)]


def _landmark(kind: str, landmark: DrawnRegion, other: Optional[DrawnRegion] = None, number: float = 0.0) -> Finding:
    return Finding(
        kind,
        WARNING,
        landmark.wkb,
        landmark.feature_id,
        other and other.feature_id,
        landmark.class_value,
        landmark.class_value if other else NOTHING,
        landmark.area,
        number=number,
    )
