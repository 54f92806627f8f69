"""The layers of localized images: positions, footprints, possible places and matches."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import datetime, timezone
from math import isnan
from typing import TYPE_CHECKING, Any

from qgis.core import QgsGeometry, QgsPointXY
from qgis.PyQt.QtCore import QDateTime, Qt

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

POSITION_FIELDS = (*FIELDS, ("time", "datetime"))

if TYPE_CHECKING:
    from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransformContext

    from ...core.database.model import ReferenceDatabase
    from .outputs import Outputs


def moment(time_s: float | None) -> QDateTime | None:
    """A time as layers have it: UTC. Seconds that are no date count from 1970, so that they can be played."""
    if time_s is None:
        return None
    try:
        text = datetime.fromtimestamp(time_s, timezone.utc).strftime("%Y-%m-%dT%H:%M:%S.%f")[:-3]
    except (OverflowError, OSError, ValueError):
        # Years that no calendar has.
        return None
    found = QDateTime.fromString(text, Qt.DateFormat.ISODateWithMs)
    found.setTimeSpec(Qt.TimeSpec.UTC)
    return found


def write_positions(
    outputs: Outputs,
    key: str,
    localized: Sequence[LocalizedImage],
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
    times_s: Sequence[float | None],
) -> None:
    """Writes one row an image; without a fix it has no geometry.

    ``times_s``: when each image was taken, seconds since 1970 or any moment; None where unknown.
    """
    from ..exchange.position_looks import positions_look

    look = positions_look(any(time_s is not None for time_s in times_s))
    with outputs.layer(key, POSITION_FIELDS, POINT, crs, look) as sink:
        for (geometry, cells), time_s in zip(position_rows(localized, crs, context), times_s):
            sink.add(geometry, {**cells, "time": moment(time_s)})


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
    from ..exchange.position_looks import footprints_look, places_look

    kinds = (FOOTPRINT_FIELDS, footprint_rows, footprints_look), (ALTERNATIVE_FIELDS, alternatives, places_look)
    for key, (fields, rows_of, look_of) in zip(keys, kinds):
        with outputs.layer(key, fields, POLYGON, crs, look_of()) as sink:
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
    from ..exchange.position_looks import matches_look

    with outputs.layer(key, MATCH_FIELDS, POINT, crs, matches_look()) as sink:
        for item in localized:
            for position, cells in match_rows(item, database):
                sink.add(QgsGeometry.fromPointXY(QgsPointXY(*position)), cells)
