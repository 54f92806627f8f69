"""Repair a land-cover layer: valid polygons without overlaps, gaps and slivers, one per landmark."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from ..steps import Steps
from .findings import DISSOLVED, INFORMATION, NOTHING, Finding
from .merging import merge_finding, merge_gaps_and_slivers
from .partition import Regions, dissolve, find_regions, region_owners
from .polygons import AnnotatedFeature, AnnotatedPolygons, to_wkb
from .surface import Surface, overlay_polygons


@dataclass(frozen=True)
class RepairedPolygon:
    """A polygon of a repaired layer.

    Attributes:
        wkb: WKB of a valid polygon, coordinates in meters.
        feature: Index of the feature with its attributes.
    """

    wkb: bytes
    feature: int


def repair_features(
    features: Sequence[AnnotatedFeature], maximum_gap: float, minimum_area: float
) -> Steps[tuple[list[RepairedPolygon], list[Finding]]]:
    """Repair features; return the polygons and the changes.

    On overlaps, the polygon of higher priority remains, then the smaller one, then that of the lower class value. A
    second repair changes nothing, because the polygons of a repaired layer are its faces.

    Args:
        maximum_gap: m²; enclosed gaps up to this area are filled.
        minimum_area: m²; smaller pieces are merged.
    """
    changes, surface = yield from overlay_polygons(features, AnnotatedPolygons.repair_ranks)
    if surface is None:
        return [], changes
    yield "Filling gaps and merging slivers", 0.8
    classes, merges = merge_gaps_and_slivers(surface.partition, surface.classes, maximum_gap, minimum_area)
    changes += [merge_finding(merge, INFORMATION, surface.polygons, surface.partition, surface.top) for merge in merges]
    yield "Dissolving neighbors", 0.9
    polygons, dissolved = _dissolve(surface, classes)
    yield "Dissolving neighbors", 1.0
    return polygons, changes + dissolved


def _dissolve(surface: Surface, classes: np.ndarray) -> tuple[list[RepairedPolygon], list[Finding]]:
    """Return the regions of (F,) class values as polygons, and the findings of ``_dissolved``."""
    polygons, partition = surface.polygons, surface.partition
    regions = find_regions(partition, classes)
    # A face that got a neighbor's class does not count for the attributes of its region.
    own = np.where(surface.classes == classes, surface.top, -1)
    owners = region_owners(regions, own, partition.areas)
    covered = classes != NOTHING
    numbers, groups = np.unique(regions.of_face[covered], return_inverse=True)
    geometries = dissolve(partition.faces[covered], groups.reshape(-1))
    features = polygons.features[owners[numbers]]
    order = np.lexsort((*shapely.bounds(geometries).T, features))
    repaired = map(RepairedPolygon, to_wkb(geometries[order]).tolist(), features[order].tolist())
    return list(repaired), _dissolved(polygons, regions, own, dict(zip(numbers.tolist(), geometries)), owners)


def _dissolved(
    polygons: AnnotatedPolygons, regions: Regions, own: np.ndarray, geometries: dict[int, object], owners: np.ndarray
) -> list[Finding]:
    """Return one finding for each region that joins several features, with their number."""
    members: dict[int, set[int]] = {}
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
