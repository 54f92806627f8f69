"""Read planned routes from waypoint files: GPX, KML, .plan, .waypoints."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from osgeo import gdal, ogr

from ..core import limits
from ..core.errors import ParameterError
from ..core.sentences import Sentence
from ..core.values import read_json
from .gdal_errors import gdal_failures

WAYPOINT_FILES = (".gpx", ".kml", ".kmz", ".plan", ".waypoints", ".mission")
"""Suffixes of files that are read here. As layers, QGIS would read only their first part, or nothing."""

_DRIVERS = {".gpx": ("GPX",), ".kml": ("LIBKML", "KML"), ".kmz": ("LIBKML",)}
"""GDAL's drivers by suffix. Other drivers could read descriptions of other files."""

_POSITION_COMMANDS = (16, 17, 18, 19, 21, 22, 31, 82, 84, 85)
"""MAVLink commands with a position: waypoint, loiter (4), land, take-off, spline, VTOL take-off and landing."""


def is_waypoint_file(value: object) -> bool:
    """Whether a parameter's value is the path of a waypoint file."""
    return isinstance(value, str) and Path(value).suffix.lower() in WAYPOINT_FILES


def read_waypoint_file(path: str) -> list[np.ndarray]:
    """Return lines, each (n, 2) longitude, latitude in degrees. Raises ParameterError: the file can't be read."""
    if not os.path.isfile(path):
        raise ParameterError("There is no file {path}; choose another route.", path=path)
    if os.path.getsize(path) > limits.ROUTE_BYTES:
        raise ParameterError(
            "{path} is larger than {most_mb} MB, which is too large for a route. Choose another file.",
            path=path,
            most_mb=limits.ROUTE_BYTES >> 20,
        )
    suffix = Path(path).suffix.lower()
    if suffix == ".plan":
        return [plan_positions(_text(path), path)]
    if suffix in (".waypoints", ".mission"):
        return [waypoint_positions(_text(path), path)]
    return [_lon_lat([(y, x) for x, y in line.tolist()], path) for line in _ogr_lines(path)]


def plan_positions(text: str, path: str) -> np.ndarray:
    """Return (n, 2) longitude, latitude of a QGroundControl plan: positions of the items, transects of surveys.

    Args:
        path: Name of the file for messages.

    Raises:
        ParameterError: The file is not such a plan.
    """
    try:
        plan = read_json(text)
    except (ValueError, RecursionError):
        raise ParameterError(
            "{path} is not JSON, so it is not a plan of QGroundControl. Save the plan again.", path=path
        ) from None
    mission = plan.get("mission") if isinstance(plan, dict) else None
    if not isinstance(mission, dict) or not isinstance(mission.get("items"), list):
        raise ParameterError("{path} has no mission; save it with QGroundControl as a plan.", path=path)
    found: list[tuple[float, float]] = []
    for item in mission["items"]:
        if isinstance(item, dict):
            found += _item_positions(item)
    return _lon_lat(found, path)


def waypoint_positions(text: str, path: str) -> np.ndarray:
    """Return (n, 2) longitude, latitude of a waypoint list in the format “QGC WPL 110” of MAVLink tools.

    Args:
        path: Name of the file for messages.

    Raises:
        ParameterError: The file is not such a list.
    """
    lines = text.splitlines()
    if not lines or not lines[0].startswith("QGC WPL"):
        raise ParameterError("{path} is not a waypoint list: its first line is not “QGC WPL 110”.", path=path)
    found = []
    # The first waypoint is the home position.
    for line in lines[2:]:
        cells = line.split()
        if len(cells) >= 11:
            try:
                command, latitude, longitude = int(cells[3]), float(cells[8]), float(cells[9])
            except ValueError:
                raise ParameterError(
                    "{path} has a line that is not a waypoint: {line}", path=path, line=line[:60]
                ) from None
            if command in _POSITION_COMMANDS and (latitude or longitude):
                found.append((latitude, longitude))
    return _lon_lat(found, path)


def _item_positions(item: dict) -> list[tuple[Any, Any]]:
    """Return (latitude, longitude) of the positions of a mission item."""
    if item.get("type") == "SimpleItem":
        place = item.get("params")
        if item.get("command") not in _POSITION_COMMANDS or not isinstance(place, list) or len(place) < 6:
            return []
        # A take-off from the current position has no coordinates, or 0, 0.
        return [(place[4], place[5])] if place[4] and place[5] else []
    transects = item.get("TransectStyleComplexItem")
    if isinstance(transects, dict):
        return _pairs(transects.get("VisualTransectPoints"))
    keys = "landingApproachCoordinate", "loiterCoordinate", "landCoordinate"
    return [pair for key in keys for pair in _pairs([item.get(key)])]


def _pairs(places: object) -> list[tuple[Any, Any]]:
    """Return (latitude, longitude) of the entries that have both."""
    if not isinstance(places, list):
        return []
    return [(place[0], place[1]) for place in places if isinstance(place, list) and len(place) >= 2]


def _lon_lat(positions: Sequence[tuple[Any, Any]], path: str) -> np.ndarray:
    for latitude, longitude in positions:
        numbers = all(isinstance(value, (int, float)) and math.isfinite(value) for value in (latitude, longitude))
        if not numbers or abs(latitude) > 90 or abs(longitude) > 180:
            raise ParameterError(
                "{path} has a waypoint at {latitude}, {longitude}, which is not a valid latitude and longitude.",
                path=path,
                latitude=latitude,
                longitude=longitude,
            )
    return np.array([(longitude, latitude) for latitude, longitude in positions], np.float64).reshape(-1, 2)


def _text(path: str) -> str:
    try:
        return Path(path).read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise ParameterError(
            "{path} is not a text file, so it is not a route. Choose another file.", path=path
        ) from None


def _ogr_lines(path: str) -> list[np.ndarray]:
    """Return the lines (n, 2) of a KML file, or of the first of a GPX file's routes, tracks and waypoints."""
    dataset = None
    with gdal_failures() as failures:
        dataset = gdal.OpenEx(path, gdal.OF_VECTOR, list(_DRIVERS[Path(path).suffix.lower()]))
    if dataset is None:
        raise ParameterError(
            "{path} can't be read as a route ({reason}).",
            path=path,
            reason=failures[0] if failures else Sentence("unknown format"),
        )
    names = [dataset.GetLayer(n).GetName() for n in range(dataset.GetLayerCount())]
    if Path(path).suffix.lower() == ".gpx":
        # The other layers repeat these points.
        for wanted in ("routes", "tracks", "waypoints"):
            found = _geometries(dataset, [name for name in names if name == wanted])
            if found:
                return found
        return []
    return _geometries(dataset, names)


def _geometries(dataset: gdal.Dataset, names: Sequence[str]) -> list[np.ndarray]:
    lines, points = [], []
    for name in names:
        for feature in dataset.GetLayerByName(name):
            for part in _parts(feature.GetGeometryRef()):
                kind = ogr.GT_Flatten(part.GetGeometryType())
                if kind == ogr.wkbLineString and part.GetPointCount() > 1:
                    lines.append(np.array([point[:2] for point in part.GetPoints()]))
                elif kind == ogr.wkbPoint:
                    points.append((part.GetX(), part.GetY()))
    return lines or ([np.array(points)] if len(points) > 1 else [])


def _parts(geometry: ogr.Geometry | None) -> list[ogr.Geometry]:
    if geometry is None or geometry.IsEmpty():
        return []
    if ogr.GT_IsSubClassOf(ogr.GT_Flatten(geometry.GetGeometryType()), ogr.wkbGeometryCollection):
        return [part for n in range(geometry.GetGeometryCount()) for part in _parts(geometry.GetGeometryRef(n))]
    return [geometry]
