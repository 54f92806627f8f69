"""First steps of checking and repairing: find unusable geometries, and cut the valid polygons into faces."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np
import shapely

from ..steps import Steps
from .findings import ERROR, INVALID, NO_AREA, NO_GEOMETRY, NOTHING, WARNING, Finding
from .overlaps import classes_of_faces, find_duplicates, find_hidden, find_overlaps
from .partition import PlanarPartition, partition_polygons
from .polygons import (
    AnnotatedFeature,
    AnnotatedPolygons,
    FeatureParts,
    feature_geometries,
    to_wkb,
    valid_polygons,
)

UNREADABLE = "Coordinates or rings that can't be used"
"""Reason for geometries that GEOS can't read."""

_MARK_M = 1.0
"""Half the edge of the square that marks a finding."""

_REASON = re.compile(r"(?P<why>[^\[]*)\[(?P<x>\S+) (?P<y>[^\s\]]+)")
"""GEOS's own message: reason[x y]."""


def find_invalid(features: Sequence[AnnotatedFeature], geometries: np.ndarray, parts: FeatureParts) -> list[Finding]:
    """Return one finding per invalid part with position and reason; one per feature with valid, conflicting parts."""
    singles, owners = parts
    broken = np.flatnonzero(~shapely.is_valid(singles))
    found = [_invalid(features[owners[n]], singles[n]) for n in broken]
    whole = ~shapely.is_valid(geometries) & ~shapely.is_missing(geometries)
    whole[owners[broken]] = False
    return found + [_invalid(features[n], geometries[n]) for n in np.flatnonzero(whole)]


def find_unusable(
    features: Sequence[AnnotatedFeature], geometries: np.ndarray, polygons: AnnotatedPolygons
) -> list[Finding]:
    """Find features without geometry, with an unreadable one, and with one without area."""
    found = []
    with_area = set(polygons.features.tolist())
    areas = shapely.area(geometries)
    for n, (feature, geometry) in enumerate(zip(features, geometries)):
        if feature.wkb is None:
            found.append(_finding(NO_GEOMETRY, WARNING, feature))
        elif geometry is None:
            found.append(_finding(INVALID, ERROR, feature, reason=UNREADABLE))
        elif geometry.is_empty:
            found.append(_finding(NO_GEOMETRY, WARNING, feature))
        elif n not in with_area and (feature.class_value != NOTHING or areas[n] == 0):
            x, y = shapely.get_coordinates(geometry)[0]
            found.append(_finding(NO_AREA, WARNING, feature, wkb=_mark_at(x, y), area=0.0))
    return found


def _invalid(feature: AnnotatedFeature, geometry: shapely.Geometry) -> Finding:
    why, x, y = _reason(geometry)
    area, reason = float(shapely.area(geometry)), f"{why} ({x:.2f}, {y:.2f})"
    return _finding(INVALID, ERROR, feature, wkb=_mark_at(x, y), area=area, reason=reason)


def _finding(kind: str, severity: str, feature: AnnotatedFeature, **more: Any) -> Finding:  # noqa: ANN401 - of Finding
    return Finding(kind, severity, feature_id=feature.feature_id, class_value=feature.class_value, **more)


def _mark_at(x: float, y: float) -> bytes:
    """Return the WKB of a small square around a point."""
    return to_wkb(shapely.box(x - _MARK_M, y - _MARK_M, x + _MARK_M, y + _MARK_M))


def _reason(geometry: shapely.Geometry) -> tuple[str, float, float]:
    """Return why a geometry is invalid, and x and y of the fault; its first vertex if GEOS gives no position."""
    text = str(shapely.is_valid_reason(geometry))
    match = _REASON.match(text)
    if match:
        return match["why"].strip(), float(match["x"]), float(match["y"])
    return (text, *shapely.get_coordinates(geometry)[0].tolist())


@dataclass(frozen=True)
class Surface:
    """Polygons as seen from above.

    Attributes:
        polygons: N valid polygons.
        partition: Their F faces.
        ranks: (N,) int64, higher ones are on top.
        top: (F,) int64 visible polygon on each face, or −1.
    """

    polygons: AnnotatedPolygons
    partition: PlanarPartition
    ranks: np.ndarray
    top: np.ndarray

    @property
    def classes(self) -> np.ndarray:
        """(F,) visible class values, NOTHING where no polygon is."""
        return classes_of_faces(self.polygons, self.top)


def overlay_polygons(
    features: Sequence[AnnotatedFeature], ranks_of: Callable[[AnnotatedPolygons], np.ndarray]
) -> Steps[tuple[list[Finding], Surface | None]]:
    """Overlay features, as the first steps of a check or repair.

    Args:
        ranks_of: Returns the order of drawing: a method of AnnotatedPolygons.

    Returns:
        Invalid geometries with every duplicate, overlap and hidden polygon, and the surface; None if no feature has an
        area.
    """
    yield "Checking geometries", 0.0
    geometries = feature_geometries(features)
    parts = shapely.get_parts(geometries, return_index=True)
    findings = find_invalid(features, geometries, parts)
    polygons = valid_polygons(features, parts)
    findings += find_unusable(features, geometries, polygons)
    if not len(polygons):
        return findings, None
    yield "Overlaying polygons", 0.1
    partition = partition_polygons(polygons.geometries)
    yield "Looking for overlaps", 0.6
    ranks = ranks_of(polygons)
    duplicates, repeated = find_duplicates(polygons, partition)
    findings += duplicates
    findings += find_overlaps(polygons, partition, ranks, repeated)
    findings += find_hidden(polygons, partition, ranks, duplicates)
    return findings, Surface(polygons, partition, ranks, partition.top_polygons(ranks))
