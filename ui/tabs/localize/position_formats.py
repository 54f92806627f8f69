"""A fix's position as text to copy, in the ways that people and programs write it."""

from __future__ import annotations

from qgis.core import (
    QgsCoordinateFormatter,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsProject,
)

from ....processing.layers.reference_systems import transformed_point
from ....processing.translation import tr
from ...findings import Finding

DEGREES, DEGREES_LATITUDE_FIRST, DEGREES_MINUTES, PROJECT, DATABASE, WELL_KNOWN_TEXT = (
    "degrees",
    "latitude_first",
    "minutes",
    "project",
    "database",
    "wkt",
)
FORMATS = (DEGREES, DEGREES_LATITUDE_FIRST, DEGREES_MINUTES, PROJECT, DATABASE, WELL_KNOWN_TEXT)


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
    """Empty where the position can't be told in that way. Seven decimals of a degree are a centimeter."""
    if name == DATABASE:
        return f"{finding.x:.2f}, {finding.y:.2f}"
    if name in (PROJECT, WELL_KNOWN_TEXT):
        place = _in_project(finding, project)
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
    return ", ".join(_sexagesimal(finding))


def _sexagesimal(finding: Finding) -> tuple[str, str]:
    kind = QgsCoordinateFormatter.FormatDegreesMinutesSeconds
    return (
        QgsCoordinateFormatter.formatY(finding.latitude, kind, 3),
        QgsCoordinateFormatter.formatX(finding.longitude, kind, 3),
    )


def _in_project(finding: Finding, project: QgsProject):
    crs: QgsCoordinateReferenceSystem = project.crs()
    if not crs.isValid():
        return None
    return transformed_point(QgsCoordinateTransform(finding.crs, crs, project), finding.center)


def possible_formats(finding: Finding, project: QgsProject) -> list[str]:
    return [name for name in FORMATS if position_text(finding, name, project)]
