"""Geometries that are invalid, empty or without area: which, where and why."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np
import shapely

from ..geometry.well_known_binary import to_wkb
from .findings import ERROR, INVALID, NO_AREA, NO_GEOMETRY, NOTHING, WARNING, Finding
from .polygons import AnnotatedFeature, AnnotatedPolygons, FeatureParts

UNREADABLE = "Coordinates or rings that can't be used"
"""Reason for geometries that GEOS does not even read."""

_MARK_M = 1.0
"""Half the edge of the square that shows where something is."""

_REASON = re.compile(r"(?P<why>[^\[]*)\[(?P<x>\S+) (?P<y>[^\s\]]+)")
"""GEOS's own sentence: why[x y]."""


def find_invalid(features: Sequence[AnnotatedFeature], geometries: np.ndarray, parts: FeatureParts) -> list[Finding]:
    """One finding for each invalid part, with place and reason; for features whose valid parts don't fit, one."""
    broken = np.flatnonzero(~shapely.is_valid(parts.geometries))
    found = [_invalid(features[parts.features[n]], parts.geometries[n]) for n in broken]
    whole = ~shapely.is_valid(geometries) & ~shapely.is_missing(geometries)
    whole[parts.features[broken]] = False
    return found + [_invalid(features[n], geometries[n]) for n in np.flatnonzero(whole)]


def find_unusable(
    features: Sequence[AnnotatedFeature], geometries: np.ndarray, polygons: AnnotatedPolygons
) -> list[Finding]:
    """Features without geometry, with one that can't be read, and with one that has no area."""
    found = []
    with_area = set(polygons.features.tolist())
    areas = shapely.area(geometries)
    for n, (feature, geometry) in enumerate(zip(features, geometries)):
        identity = {"feature_id": feature.feature_id, "class_value": feature.class_value}
        if feature.wkb is None:
            found.append(Finding(NO_GEOMETRY, WARNING, **identity))
        elif geometry is None:
            found.append(Finding(INVALID, ERROR, **identity, reason=UNREADABLE))
        elif geometry.is_empty:
            found.append(Finding(NO_GEOMETRY, WARNING, **identity))
        elif n not in with_area and (feature.class_value != NOTHING or areas[n] == 0):
            x, y = shapely.get_coordinates(geometry)[0]
            found.append(Finding(NO_AREA, WARNING, _mark_at(x, y), **identity, area=0.0))
    return found


def _invalid(feature: AnnotatedFeature, geometry) -> Finding:
    why, x, y = _reason(geometry)
    return Finding(
        INVALID,
        ERROR,
        _mark_at(x, y),
        feature_id=feature.feature_id,
        class_value=feature.class_value,
        area=float(shapely.area(geometry)),
        reason=f"{why} ({x:.2f}, {y:.2f})",
    )


def _mark_at(x: float, y: float) -> bytes:
    """WKB of a small square to look at, around a place without extent."""
    return to_wkb(shapely.box(x - _MARK_M, y - _MARK_M, x + _MARK_M, y + _MARK_M))


def _reason(geometry) -> tuple[str, float, float]:
    """Why it is invalid and where; its first vertex where GEOS names no place."""
    text = str(shapely.is_valid_reason(geometry))
    match = _REASON.match(text)
    if match:
        return match["why"].strip(), float(match["x"]), float(match["y"])
    return (text, *shapely.get_coordinates(geometry)[0].tolist())
