"""The layers of localized images and flights: positions, tracks, footprints, possible places and matches."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import datetime, timezone
from math import isnan
from typing import TYPE_CHECKING, Any

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransformContext, QgsGeometry, QgsPointXY
from qgis.PyQt.QtCore import QDateTime, Qt

from ..compat import LINE, POINT, POLYGON
from .localized_image import (
    ALTERNATIVE_FIELDS,
    FIELDS,
    FOOTPRINT_FIELDS,
    MATCH_FIELDS,
    LocalizedImage,
    alternatives,
    error_probability,
    footprint_rows,
    match_rows,
    row,
)
from .outputs import Outputs

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase
    from ...core.flight.model import FlightPose
    from ..reports.flight_report import FlightPoint


POSITION_FIELDS = (*FIELDS, ("time", "datetime"))
FLIGHT_FIELDS = (
    *FIELDS,
    ("source", "text"),
    ("track", "integer"),
    ("outvoted", "boolean"),
    ("number", "integer"),
    ("time", "datetime"),
)
TRACK_FIELDS = (
    ("track", "integer"),
    ("images", "integer"),
    ("own", "integer"),
    ("first", "text"),
    ("last", "text"),
    ("length", "real"),
    ("largest_error_95", "real"),
    ("start", "datetime"),
    ("end", "datetime"),
)


def moment(time_s: float | None) -> QDateTime | None:
    """Return a time in UTC for layers. Seconds that are not a date count from 1970, so that they can be played."""
    if time_s is None:
        return None
    try:
        text = datetime.fromtimestamp(time_s, timezone.utc).strftime("%Y-%m-%dT%H:%M:%S.%f")[:-3]
    except (OverflowError, OSError, ValueError):
        # Years outside the calendar.
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
    """Write one row for each image; rows without a position have no geometry.

    ``times_s``: when each image was taken, in seconds since 1970 or any moment; None if unknown.
    """
    is_timed = any(time_s is not None for time_s in times_s)
    with outputs.layer(key, POSITION_FIELDS, POINT, crs, "positions", is_timed=is_timed) as sink:
        for (geometry, cells), time_s in zip(position_rows(localized, crs, context), times_s):
            sink.add(geometry, {**cells, "time": moment(time_s)})


def position_rows(
    localized: Sequence[LocalizedImage], crs: QgsCoordinateReferenceSystem, context: QgsCoordinateTransformContext
) -> Iterator[tuple[QgsGeometry | None, dict[str, Any]]]:
    """Yield (point, values of FIELDS) of each image; None without a position."""
    from ..layers.reference_systems import longitudes_latitudes

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
    """Write the footprints and, with a second key, the possible places."""
    kinds = (FOOTPRINT_FIELDS, footprint_rows, "footprints"), (ALTERNATIVE_FIELDS, alternatives, "places")
    for key, (fields, rows_of, style) in zip(keys, kinds):
        with outputs.layer(key, fields, POLYGON, crs, style) as sink:
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
    """Write the matching landmarks."""
    with outputs.layer(key, MATCH_FIELDS, POINT, crs, "matches") as sink:
        for item in localized:
            for position, cells in match_rows(item, database):
                sink.add(QgsGeometry.fromPointXY(QgsPointXY(*position)), cells)


@dataclass(frozen=True)
class FlownImage:
    """An image of a flight with its result.

    Attributes:
        localized: Result of the flight, in the form of a single image.
        pose: Result of the flight; None for an image that cannot be read.
        time_s: When it was taken, in seconds since 1970 (UTC) or since any moment; None if unknown.
    """

    localized: LocalizedImage
    pose: FlightPose | None = None
    time_s: float | None = None

    @property
    def is_placed(self) -> bool:
        """Whether the flight places it."""
        return self.pose is not None and self.pose.is_fix

    @property
    def source(self) -> str | None:
        """Key of the source of its position; None without a position."""
        return str(self.pose.source) if self.is_placed else None


def write_flight_positions(
    outputs: Outputs,
    key: str,
    flown: Sequence[FlownImage],
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
) -> None:
    """Write one row for each image, in flight order, with style and time."""
    is_timed = any(one.time_s is not None for one in flown)
    with outputs.layer(key, FLIGHT_FIELDS, POINT, crs, "poses", is_timed=is_timed) as sink:
        rows = position_rows([one.localized for one in flown], crs, context)
        for number, (one, (geometry, cells)) in enumerate(zip(flown, rows), start=1):
            sink.add(geometry, {**cells, **_flight_cells(one), "number": number, "time": moment(one.time_s)})


def _flight_cells(one: FlownImage) -> dict[str, Any]:
    if one.pose is None:
        return {}
    outvoted = one.pose.is_outvoted
    return {"source": one.source, "track": one.pose.track or None, "outvoted": outvoted}


def tracks_of(flown: Sequence[FlownImage]) -> list[list[FlownImage]]:
    """Return the placed images of each track, in order."""
    numbers = sorted({one.pose.track for one in flown if one.pose is not None and one.is_placed})
    return [[one for one in flown if one.is_placed and one.pose.track == number] for number in numbers]


def write_tracks(outputs: Outputs, key: str, flown: Sequence[FlownImage], crs: QgsCoordinateReferenceSystem) -> None:
    """Write one line for each track of two or more images."""
    with outputs.layer(key, TRACK_FIELDS, LINE, crs, "track") as sink:
        for members in tracks_of(flown):
            if len(members) < 2:
                continue
            points = [QgsPointXY(*one.localized.result.position) for one in members]
            line = QgsGeometry.fromPolylineXY(points)
            errors = [e for e in (one.localized.result.error_95_m for one in members) if e is not None]
            times = [one.time_s for one in members if one.time_s is not None]
            cells = {
                "track": members[0].pose.track,
                "images": len(members),
                "own": sum(one.source == "own" for one in members),
                "first": members[0].localized.path,
                "last": members[-1].localized.path,
                "length": line.length(),
                "largest_error_95": max(errors, default=None),
                "start": moment(min(times, default=None)),
                "end": moment(max(times, default=None)),
            }
            sink.add(line, cells)


def report_points(flown: Sequence[FlownImage]) -> list[FlightPoint]:
    """Return the images for the report."""
    return [_report_point(number, one) for number, one in enumerate(flown, start=1)]


def _report_point(number: int, one: FlownImage) -> FlightPoint:
    from ..reports.flight_report import FlightPoint

    cells, item, time = row(one.localized), one.localized, moment(one.time_s)
    shown = FlightPoint(
        number,
        os.path.basename(item.path),
        reason=cells.get("reason") or "",
        time="" if time is None else time.toString("yyyy-MM-dd hh:mm:ss"),
    )
    if one.pose is None or not one.is_placed or item.result is None:
        return shown
    known = item.result.covariance
    ellipse = known and known.ellipse_95
    return replace(
        shown,
        source=one.source,
        outvoted=one.pose.is_outvoted,
        track=one.pose.track,
        position=item.result.position,
        heading_deg=item.result.heading_deg,
        ellipse=ellipse and (ellipse.semi_major, ellipse.semi_minor, ellipse.orientation_deg),
        radius_95=item.result.error_95_m,
        error_probability=error_probability(item.result.confidence) if item.result.confidence else "",
    )
