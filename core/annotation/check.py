"""Check a land-cover layer for everything that is wrong or noteworthy before it becomes a label map."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from ..landmarks.landmarks import minimum_area_px
from ..steps import Steps
from .findings import INFORMATION, LOST, MERGED, NOTHING, SMALL, SPLIT, WARNING, Finding
from .merging import merge_finding, merge_gaps_and_slivers
from .overlaps import NARROWEST_M, classes_of_faces, find_same_class_neighbors
from .partition import PlanarPartition, dissolve, find_regions, region_owners
from .polygons import AnnotatedFeature, AnnotatedPolygons, to_wkb
from .raster_losses import RegionRuns, count_pieces, lost_regions, merged_regions
from .surface import Surface, overlay_polygons


@dataclass(frozen=True)
class DrawnRegion:
    """A landmark as drawn.

    Attributes:
        wkb: WKB of its polygon, coordinates in meters.
        bounds: (left, bottom, right, top), meters.
        feature_id: Id of the feature that covers most of it.
    """

    wkb: bytes
    bounds: tuple[float, float, float, float]
    class_value: int
    feature_id: int
    area: float


def check_features(
    features: Sequence[AnnotatedFeature], minimum_area: float, maximum_gap: float, landmark_classes: Sequence[int]
) -> Steps[tuple[list[Finding], list[DrawnRegion]]]:
    """Check features for everything except the effects of pixels on landmarks (``find_raster_losses``).

    Args:
        minimum_area: m²; smaller regions are not landmarks.
        maximum_gap: m²; enclosed gaps up to this area are reported.

    Returns:
        The findings, and the drawn regions of the landmark classes with at least the minimum area.
    """
    findings, surface = yield from overlay_polygons(features, AnnotatedPolygons.drawn_ranks)
    if surface is None:
        return findings, []
    polygons, partition = surface.polygons, surface.partition
    yield "Looking for gaps and slivers", 0.8
    findings += find_gaps_and_slivers(polygons, partition, maximum_gap)
    yield "Checking neighbors of the same class", 0.85
    findings += find_same_class_neighbors(polygons, partition, surface.ranks, landmark_classes)
    yield "Checking landmarks", 0.9
    small, landmarks = _find_landmarks(surface, minimum_area, landmark_classes)
    yield "Checking landmarks", 1.0
    return findings + small, landmarks


def _find_landmarks(
    surface: Surface, minimum_area: float, landmark_classes: Sequence[int]
) -> tuple[list[Finding], list[DrawnRegion]]:
    """Return findings for the regions of the landmark classes that are too small, and the other regions."""
    polygons, partition = surface.polygons, surface.partition
    wanted = np.isin(surface.classes, [int(value) for value in landmark_classes])
    regions = find_regions(partition, surface.classes)
    owners = region_owners(regions, surface.top, partition.areas)
    numbers, groups = np.unique(regions.of_face[wanted], return_inverse=True)
    small, landmarks = [], []
    for region, geometry in zip(numbers.tolist(), dissolve(partition.faces[wanted], groups.reshape(-1))):
        value, area = int(regions.classes[region]), float(regions.areas[region])
        feature_id = int(polygons.feature_ids[owners[region]])
        if area < minimum_area:
            small.append(Finding(SMALL, INFORMATION, to_wkb(geometry), feature_id, None, value, area=area))
        else:
            left, bottom, right, top = shapely.bounds(geometry).tolist()
            landmarks.append(DrawnRegion(to_wkb(geometry), (left, bottom, right, top), value, feature_id, area))
    return small, landmarks


def find_gaps_and_slivers(polygons: AnnotatedPolygons, partition: PlanarPartition, maximum_gap: float) -> list[Finding]:
    """Find gaps between polygons and thin visible pieces between them, which a repair would give to a neighbor.

    Overlaps without priority count as repaired.

    Args:
        maximum_gap: m²; larger gaps count as intended.
    """
    top = partition.top_polygons(polygons.repair_ranks())
    _, merges = merge_gaps_and_slivers(partition, classes_of_faces(polygons, top), maximum_gap)
    found = []
    for merge in merges:
        area, perimeter = partition.areas[merge.faces].sum(), partition.perimeters[merge.faces].sum()
        if 2 * area < NARROWEST_M * perimeter:
            continue
        found.append(merge_finding(merge, WARNING, polygons, partition, top))
    return found


def find_raster_losses(
    landmarks: Sequence[DrawnRegion], runs: RegionRuns, minimum_area: float, pixel_size: float
) -> list[Finding]:
    """Find landmarks that rasterizing changes.

    A landmark is lost if no piece of it has the minimum contour area, merged if its pixels touch those of another of
    its class, and split if its pixels form several pieces.

    Args:
        runs: Their pixels; landmark n is region n + 1.
        minimum_area: m², of a landmark.
        pixel_size: Edge of a pixel, m.

    Returns:
        Warnings: lost ones, then merged, then split.
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


def _landmark(kind: str, landmark: DrawnRegion, other: DrawnRegion | None = None, number: float = 0.0) -> Finding:
    return Finding(
        kind,
        WARNING,
        landmark.wkb,
        landmark.feature_id,
        other.feature_id if other else None,
        landmark.class_value,
        landmark.class_value if other else NOTHING,
        landmark.area,
        number=number,
    )
