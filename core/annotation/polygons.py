"""Convert features of a land-cover layer to valid single polygons."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely

from .findings import NOTHING

FARTHEST_M = 1e8
"""Larger coordinates are on no map (the Earth's circumference is 4·10⁷ m) and count as broken."""

_POLYGON = 3

_DIMENSION = 3
"""Explicit, because newer versions of shapely default to 4. In desktop QGIS on Linux shapely's calls use the GEOS of
QGIS, which before 3.12 refuses a 4."""


@dataclass(frozen=True)
class AnnotatedFeature:
    """A feature of a land-cover layer.

    Attributes:
        wkb: WKB of a (multi)polygon, coordinates in meters; None for a feature without one.
        class_value: NOTHING for a feature without a usable class.
        priority: Higher ones are on top.
    """

    feature_id: int
    wkb: bytes | None
    class_value: int
    priority: float = 0.0


@dataclass(frozen=True)
class AnnotatedPolygons:
    """N valid single polygons of features with a class, in the features' order.

    Attributes:
        geometries: (N,) shapely polygons, meters.
        features: (N,) int64 index of the feature.
        feature_ids: (N,) int64.
        classes: (N,) int64 class values.
        priorities: (N,) float64, higher ones are on top.
    """

    geometries: np.ndarray
    features: np.ndarray
    feature_ids: np.ndarray
    classes: np.ndarray
    priorities: np.ndarray

    def __len__(self) -> int:
        return len(self.geometries)

    def drawn_ranks(self) -> np.ndarray:
        """Return (N,) int64, higher ones are on top, as in rasterizing: by priority, then the later feature."""
        return _ranks(np.lexsort((np.arange(len(self)), self.priorities)))

    def repair_ranks(self) -> np.ndarray:
        """Return (N,) int64, higher ones are on top: by priority, then the smaller area, then the lower class value."""
        areas = shapely.area(self.geometries)
        return _ranks(np.lexsort((np.arange(len(self)), -self.classes, -areas, self.priorities)))


FeatureParts = tuple[np.ndarray, np.ndarray]
"""(P,) shapely geometries of the single parts of features as drawn, meters, and (P,) int64 index of their feature."""


def feature_geometries(features: Sequence[AnnotatedFeature]) -> np.ndarray:
    """Return (M,) shapely geometries, None for missing and unreadable ones."""
    wkbs = np.array([feature.wkb for feature in features] + [None], object)[:-1]
    with np.errstate(invalid="ignore"):
        geometries = shapely.force_2d(shapely.from_wkb(wkbs, on_invalid="ignore"))
    coordinates, place = shapely.get_coordinates(geometries, return_index=True)
    usable = (np.isfinite(coordinates) & (np.abs(coordinates) < FARTHEST_M)).all(axis=1)
    geometries[place[~usable]] = None
    return geometries


def valid_polygons(features: Sequence[AnnotatedFeature], parts: FeatureParts) -> AnnotatedPolygons:
    """Return the polygons with area of features with a class; invalid ones are made valid as in rasterizing."""
    geometries, place = _made_valid(parts)
    classes = np.array([feature.class_value for feature in features], np.int64)[place]
    keep = (shapely.get_type_id(geometries) == _POLYGON) & (shapely.area(geometries) > 0) & (classes != NOTHING)
    place = place[keep]
    return AnnotatedPolygons(
        geometries[keep],
        place,
        np.array([feature.feature_id for feature in features], np.int64)[place],
        classes[keep],
        np.array([feature.priority for feature in features], np.float64)[place],
    )


def _made_valid(parts: FeatureParts) -> tuple[np.ndarray, np.ndarray]:
    """Return single valid geometries and the index of their feature, in the features' order."""
    geometries, features = parts
    geometries = geometries.copy()
    broken = ~shapely.is_valid(geometries)
    geometries[broken] = shapely.make_valid(geometries[broken])
    place = np.arange(len(geometries))
    # A collection may contain multipolygons.
    for _ in range(2):
        geometries, index = shapely.get_parts(geometries, return_index=True)
        place = place[index]
    return geometries, features[place]


def _ranks(order: np.ndarray) -> np.ndarray:
    """Return (N,) int64 rank of each index in ``order``."""
    ranks = np.empty(len(order), np.int64)
    ranks[order] = np.arange(len(order))
    return ranks


def to_wkb(geometries: shapely.Geometry | np.ndarray) -> Any:  # noqa: ANN401 - bytes, or an array of them
    """Return the WKB of a geometry, or of an array of them, with Z and without M."""
    return shapely.to_wkb(geometries, output_dimension=_DIMENSION)
