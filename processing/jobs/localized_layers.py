"""The layers of localized images and flights: positions, tracks, footprints, possible places and matches."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isnan
from typing import Any

import numpy as np
from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransformContext, QgsGeometry, QgsPointXY

from ...core.database.model import ReferenceDatabase
from ...core.geometry.footprint import image_corners
from ...core.localizer.record import record
from ...core.values import schema
from ..base.outputs import Outputs
from ..compat import LINE, POINT, POLYGON
from ..layers.localized_image import ERROR, LocalizedImage, moment
from ..layers.reference_systems import longitudes_latitudes
from ..messages.sentences import worded

FIELDS = schema(
    "image text, status text, x real, y real, longitude real, latitude real, heading real, pixel_size real, "
    "confidence real, distance real, inliers integer, references integer, log_odds real, error_95 real, "
    "window text, method text, reason text, camera_x real, camera_y real, jump boolean, error_95_minor real, "
    "error_95_direction real, heading_deviation real, pixel_size_deviation real, search_capped boolean, "
    "sigma_east real, sigma_north real, correlation real, sigma_heading real, sigma_scale real, camera text, "
    "gps_distance real"
)
FOOTPRINT_FIELDS = schema("image text, status text, confidence real, window text, method text")
ALTERNATIVE_FIELDS = schema("image text, rank integer, heading real, pixel_size real")
MATCH_FIELDS = schema(
    "image text, number integer, class integer, class_name text, image_column real, image_row real, seen_x real, "
    "seen_y real, residual real"
)
POSITION_FIELDS = (*FIELDS, ("time", "datetime"))
FLIGHT_FIELDS = (*FIELDS, *schema("source text, track integer, outvoted boolean, number integer, time datetime"))
TRACK_FIELDS = schema(
    "track integer, images integer, own integer, first text, last text, length real, largest_error_95 real, "
    "start datetime, end datetime"
)


def write_positions(
    outputs: Outputs,
    key: str,
    localized: Sequence[LocalizedImage],
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
    is_flight: bool = False,
) -> None:
    """Write one row for each image, of a flight in its order; rows without a position have no geometry."""
    fields, style = (FLIGHT_FIELDS, "poses") if is_flight else (POSITION_FIELDS, "positions")
    is_timed = any(item.time_s is not None for item in localized)
    with outputs.layer(key, fields, POINT, crs, style, is_timed=is_timed) as sink:
        for number, item in enumerate(localized, start=1):
            cells, geometry = {**_row(item), "time": moment(item.time_s)}, None
            if item.position is not None:
                geometry = QgsGeometry.fromPointXY(QgsPointXY(*item.position))
                degrees = longitudes_latitudes([item.position], crs, context)
                cells["longitude"], cells["latitude"] = (None if isnan(v[0]) else float(v[0]) for v in degrees)
            sink.add(geometry, {**cells, **_flight_cells(item), "number": number} if is_flight else cells)


def _row(item: LocalizedImage) -> dict[str, Any]:
    """Return the values of FIELDS by name, without longitude and latitude."""
    result = item.result
    if result is None:
        return {"image": item.path, "status": ERROR, "reason": item.error}
    return {
        "image": item.path,
        **record(result, worded),
        "reason": item.reason,
        "camera_x": result.nadir and result.nadir[0],
        "camera_y": result.nadir and result.nadir[1],
        "jump": item.jump,
        "search_capped": result.search_capped,
        "camera": item.camera or None,
        "gps_distance": item.gps_distance_m,
    }


def _flight_cells(item: LocalizedImage) -> dict[str, Any]:
    if item.pose is None:
        return {}
    return {"source": item.source, "track": item.pose.track or None, "outvoted": item.is_outvoted}


def write_footprints(
    outputs: Outputs, key: str, localized: Sequence[LocalizedImage], crs: QgsCoordinateReferenceSystem
) -> None:
    with outputs.layer(key, FOOTPRINT_FIELDS, POLYGON, crs, "footprints") as sink:
        for item in localized:
            if item.result is not None and item.result.footprint is not None:
                cells = _row(item)
                sink.add(_polygon(item.result.footprint), {name: cells[name] for name, _ in FOOTPRINT_FIELDS})


def write_places(
    outputs: Outputs, key: str, localized: Sequence[LocalizedImage], crs: QgsCoordinateReferenceSystem
) -> None:
    """Write the footprint of each possible place of an ambiguous image."""
    with outputs.layer(key, ALTERNATIVE_FIELDS, POLYGON, crs, "places") as sink:
        for item in localized:
            height, width = item.shape_hw
            for rank, place in enumerate(item.result.alternatives if item.result is not None else (), start=1):
                heading, size = place.heading_deg, place.pixel_size_m
                corners = image_corners(place.position, heading, size, width, height)
                cells = {"image": item.path, "rank": rank, "heading": heading, "pixel_size": size}
                sink.add(_polygon(corners), cells)


def _polygon(corners_xy: np.ndarray) -> QgsGeometry:
    return QgsGeometry.fromPolygonXY([[QgsPointXY(x, y) for x, y in corners_xy]])


def write_matches(
    outputs: Outputs,
    key: str,
    localized: Sequence[LocalizedImage],
    database: ReferenceDatabase,
    crs: QgsCoordinateReferenceSystem,
) -> None:
    with outputs.layer(key, MATCH_FIELDS, POINT, crs, "matches") as sink:
        for item in localized:
            for position, cells in _match_rows(item, database):
                sink.add_row(QgsGeometry.fromPointXY(QgsPointXY(*position)), cells)


def _match_rows(item: LocalizedImage, database: ReferenceDatabase) -> Iterator[tuple[list[float], tuple]]:
    """Yield (map position, values of MATCH_FIELDS) of each landmark of the map that matches one of the image."""
    if item.result is None or item.result.place is None or item.result.matches is None:
        return
    found = item.result.matches
    names = {c.value: c.name for c in database.class_table}
    positions = database.references.positions[found.on_map].tolist()
    classes = database.references.classes[found.on_map].tolist()
    columns = found.pixels_xy.tolist(), found.seen_xy.tolist(), found.residuals.tolist()
    for n, (position, value, pixel, seen, residual) in enumerate(zip(positions, classes, *columns), start=1):
        yield position, (item.path, n, value, names.get(value), *pixel, *seen, residual)


def tracks_of(flown: Sequence[LocalizedImage]) -> list[list[LocalizedImage]]:
    """Return the placed images of each track, in order."""
    numbers = sorted({item.pose.track for item in flown if item.is_placed})
    return [[item for item in flown if item.is_placed and item.pose.track == number] for number in numbers]


def write_tracks(
    outputs: Outputs, key: str, flown: Sequence[LocalizedImage], crs: QgsCoordinateReferenceSystem
) -> None:
    """Write one line for each track of two or more images."""
    with outputs.layer(key, TRACK_FIELDS, LINE, crs, "track") as sink:
        for members in tracks_of(flown):
            if len(members) < 2:
                continue
            line = QgsGeometry.fromPolylineXY([QgsPointXY(*item.position) for item in members])
            errors = [item.result.error_95_m for item in members if item.result.error_95_m is not None]
            times = [item.time_s for item in members if item.time_s is not None]
            cells = {
                "track": members[0].pose.track,
                "images": len(members),
                "own": sum(item.source == "own" for item in members),
                "first": members[0].path,
                "last": members[-1].path,
                "length": line.length(),
                "largest_error_95": max(errors, default=None),
                "start": moment(min(times, default=None)),
                "end": moment(max(times, default=None)),
            }
            sink.add(line, cells)
