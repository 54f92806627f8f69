"""What checking and repairing begin with: features as valid polygons, laid on each other, and how they lie."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import dataclass
from typing import Callable

import numpy as np

from .findings import Finding
from .overlaps import classes_of_faces, find_duplicates, find_hidden, find_overlaps
from .partition import PlanarPartition, partition_polygons
from .polygons import AnnotatedFeature, AnnotatedPolygons, feature_geometries, split_parts, valid_polygons
from .validity import find_invalid, find_unusable


@dataclass(frozen=True)
class Surface:
    """Polygons as seen from above.

    Attributes:
        polygons: N valid polygons
        partition: their F faces
        ranks: (N,) int64, higher lie on top
        top: (F,) int64 polygon seen on each face, −1 for none
    """

    polygons: AnnotatedPolygons
    partition: PlanarPartition
    ranks: np.ndarray
    top: np.ndarray

    @property
    def classes(self) -> np.ndarray:
        """(F,) class values seen, NOTHING where no polygon lies."""
        return classes_of_faces(self.polygons, self.top)


def laid_polygons(
    features: Sequence[AnnotatedFeature],
    ranks_of: Callable[[AnnotatedPolygons], np.ndarray],
    findings: list[Finding],
) -> Generator[tuple[str, float], None, Surface | None]:
    """Lays features on each other, step by step; a generator calls it with ``yield from``.

    Args:
        features: As they were drawn.
        ranks_of: What lies on top: a method of AnnotatedPolygons.
        findings: Gets what is wrong with the geometries, and every duplicate, overlap and hidden polygon.

    Yields:
        What is being done, and the share of all checking or repairing that is done, 0…1.

    Returns:
        The surface; None when no feature has an area.
    """
    yield "Looking at geometries", 0.0
    geometries = feature_geometries(features)
    parts = split_parts(geometries)
    findings += find_invalid(features, geometries, parts)
    polygons = valid_polygons(features, parts)
    findings += find_unusable(features, geometries, polygons)
    if not len(polygons):
        return None
    yield "Laying polygons on each other", 0.1
    partition = partition_polygons(polygons.geometries)
    yield "Looking for overlaps", 0.6
    ranks = ranks_of(polygons)
    duplicates, repeated = find_duplicates(polygons, partition)
    findings += duplicates
    findings += find_overlaps(polygons, partition, ranks, repeated)
    findings += find_hidden(polygons, partition, ranks, duplicates)
    return Surface(polygons, partition, ranks, partition.top_polygons(ranks))
