"""Positions as text to copy, in several formats."""

from __future__ import annotations

from qgis.core import QgsCoordinateFormatter, QgsCoordinateTransform, QgsProject

from ....processing.layers.reference_systems import transformed_point
from ....processing.translation import tr
from ...findings import Finding

FORMATS = "degrees", "latitude_first", "minutes", "project", "database", "wkt"
DEGREES, DEGREES_LATITUDE_FIRST, DEGREES_MINUTES, PROJECT, DATABASE, WELL_KNOWN_TEXT = FORMATS


def format_title(name: str, project: QgsProject) -> str:
    return {
        DEGREES: tr("Longitude, latitude (WGS 84)"),
        DEGREES_LATITUDE_FIRST: tr("Latitude, longitude (WGS 84)"),
        DEGREES_MINUTES: tr("Degrees, minutes, seconds (WGS 84)"),
        PROJECT: tr("x, y in the project’s CRS ({crs})").format(crs=project.crs().authid() or "–"),
        DATABASE: tr("x, y in the database’s CRS"),
        WELL_KNOWN_TEXT: tr("Well-known text in the project’s CRS"),
    }[name]


def position_text(finding: Finding, name: str, project: QgsProject) -> str:
    """Return a position in a format; empty if that is not possible. Seven decimals of a degree are about 1 cm."""
    if name == DATABASE:
        return f"{finding.x:.2f}, {finding.y:.2f}"
    if name in (PROJECT, WELL_KNOWN_TEXT):
        way = QgsCoordinateTransform(finding.crs, project.crs(), project)
        place = transformed_point(way, finding.center) if project.crs().isValid() else None
        if place is None:
            return ""
        decimals = 7 if project.crs().isGeographic() else 2
        x, y = f"{place.x():.{decimals}f}", f"{place.y():.{decimals}f}"
        return f"POINT ({x} {y})" if name == WELL_KNOWN_TEXT else f"{x}, {y}"
    if finding.longitude is None or finding.latitude is None:
        return ""
    if name == DEGREES:
        return f"{finding.longitude:.7f}, {finding.latitude:.7f}"
    if name == DEGREES_LATITUDE_FIRST:
        return f"{finding.latitude:.7f}, {finding.longitude:.7f}"
    kind = QgsCoordinateFormatter.FormatDegreesMinutesSeconds
    latitude = QgsCoordinateFormatter.formatY(finding.latitude, kind, 3)
    return f"{latitude}, {QgsCoordinateFormatter.formatX(finding.longitude, kind, 3)}"


def possible_formats(finding: Finding, project: QgsProject) -> list[str]:
    return [name for name in FORMATS if position_text(finding, name, project)]
