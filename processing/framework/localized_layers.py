"""The layers of localized images: positions, footprints, possible places and matches."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isnan
from typing import TYPE_CHECKING, Any

from qgis.core import QgsGeometry, QgsPointXY

from ..compat import POINT, POLYGON
from .localized_image import (
    ALTERNATIVE_FIELDS,
    FIELDS,
    FOOTPRINT_FIELDS,
    MATCH_FIELDS,
    LocalizedImage,
    alternatives,
    footprint_rows,
    match_rows,
    row,
)

if TYPE_CHECKING:
    from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransformContext

    from ...core.database.model import ReferenceDatabase
    from .outputs import Outputs


def write_positions(
    outputs: Outputs,
    key: str,
    localized: Sequence[LocalizedImage],
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
) -> None:
    """Writes one row an image; without a fix it has no geometry."""
    with outputs.layer(key, FIELDS, POINT, crs) as sink:
        for geometry, cells in position_rows(localized, crs, context):
            sink.add(geometry, cells)


def position_rows(
    localized: Sequence[LocalizedImage], crs: QgsCoordinateReferenceSystem, context: QgsCoordinateTransformContext
) -> Iterator[tuple[QgsGeometry | None, dict[str, Any]]]:
    """(point, values of FIELDS) of each image; without a fix there is no point."""
    from ..exchange.reference_systems import longitudes_latitudes

    for item in localized:
        cells, geometry = row(item), None
        if item.result and item.result.position:
            geometry = QgsGeometry.fromPointXY(QgsPointXY(*item.result.position))
            degrees = longitudes_latitudes([item.result.position], crs, context)
            cells["longitude"], cells["latitude"] = (None if isnan(v[0]) else float(v[0]) for v in degrees)
        yield geometry, cells


def write_grounds(
    outputs: Outputs, keys: Sequence[str], localized: Sequence[LocalizedImage], crs: QgsCoordinateReferenceSystem
) -> None:
    """Writes the ground of fixes, and of possible places with a second key, where they are wanted."""
    kinds = (FOOTPRINT_FIELDS, footprint_rows), (ALTERNATIVE_FIELDS, alternatives)
    for key, (fields, rows_of) in zip(keys, kinds):
        with outputs.layer(key, fields, POLYGON, crs) as sink:
            for item in localized:
                for corners_xy, cells in rows_of(item):
                    sink.add(QgsGeometry.fromPolygonXY([[QgsPointXY(x, y) for x, y in corners_xy]]), cells)


def write_matches(
    outputs: Outputs,
    key: str,
    localized: Sequence[LocalizedImage],
    database: ReferenceDatabase,
    crs: QgsCoordinateReferenceSystem,
) -> None:
    """Writes the landmarks that agree where they are wanted."""
    with outputs.layer(key, MATCH_FIELDS, POINT, crs) as sink:
        for item in localized:
            for position, cells in match_rows(item, database):
                sink.add(QgsGeometry.fromPointXY(QgsPointXY(*position)), cells)
