"""First steps of checking and repairing: valid polygons of features, cut into faces, with their order of drawing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Callable

import numpy as np

from ..steps import Steps
from .findings import Finding
from .overlaps import classes_of_faces, find_duplicates, find_hidden, find_overlaps
from .partition import PlanarPartition, partition_polygons
from .polygons import AnnotatedFeature, AnnotatedPolygons, feature_geometries, split_parts, valid_polygons
from .validity import find_invalid, find_unusable


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
    parts = split_parts(geometries)
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
