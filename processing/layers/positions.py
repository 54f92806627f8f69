"""Read the positions, footprints and matches that “Localize images” wrote."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from qgis.core import (
    QgsFeature,
    QgsPointXY,
    QgsProcessingFeatureSource,
    QgsProcessingUtils,
    QgsProviderRegistry,
    QgsVectorLayer,
)

from ...core.errors import ParameterError
from ...core.geometry.footprint import image_corners
from ...core.localization import Method
from ...core.named_files import named_file
from ...storage.georeferencing import ControlPoint
from ..compat import is_null

NEEDED = ("image", "status", "heading", "pixel_size")
"""Columns of positions that georeferencing needs."""


@dataclass(frozen=True)
class PositionRow:
    """A row of the positions.

    Attributes:
        position: Map (x, y) of the image's center; None without a position.
        heading_deg: Direction of the image's top, clockwise from grid north; None if unknown.
        pixel_size: In m; None if unknown.
        was_leveled: Whether the camera was tilted, so that the footprint needs more than position, heading and size.
        ground: (4, 2) corners of the footprint, upper left first, clockwise; None without footprint.
        is_by_areas: Whether the position is from map correlation, which is more accurate than the matched landmarks.
    """

    path: str
    status: str
    position: tuple[float, float] | None
    heading_deg: float | None
    pixel_size: float | None
    was_leveled: bool
    ground: np.ndarray | None
    is_by_areas: bool = False

    @property
    def has_place(self) -> bool:
        return None not in (self.position, self.heading_deg, self.pixel_size)

    def corners(self, shape_hw: tuple[int, int]) -> np.ndarray:
        """Return the (4, 2) corners of an image with (height, width) pixels, in the order of ``ground``."""
        if self.ground is not None:
            return self.ground
        height, width = shape_hw
        return image_corners(self.position, self.heading_deg, self.pixel_size, width, height)

    def in_pixels(self, east: float, north: float) -> tuple[float, float]:
        """Convert an offset on the ground in m to (right, down) pixels of a level image."""
        heading = np.radians(self.heading_deg)
        right = east * np.cos(heading) - north * np.sin(heading)
        up = east * np.sin(heading) + north * np.cos(heading)
        return float(right / self.pixel_size), float(-up / self.pixel_size)


def folder_of(layer: QgsVectorLayer) -> str | None:
    """Return the folder of a layer's file, where image names are looked up; None for a temporary layer."""
    path = QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source()).get("path") or ""
    is_temporary = layer.providerType() == "memory" or named_file(path, [QgsProcessingUtils.tempFolder()])
    return None if is_temporary else os.path.dirname(path)


def read_positions(
    source: QgsProcessingFeatureSource, footprints: QgsProcessingFeatureSource | None
) -> list[PositionRow]:
    """Return the rows of the positions in their order.

    Args:
        footprints: The footprints of the same run, or None.

    Raises:
        ParameterError: A layer lacks a column, the positions are in degrees, or the footprints in another CRS.
    """
    _require(source, NEEDED)
    if source.sourceCrs().isGeographic() or not source.sourceCrs().isValid():
        name = source.sourceCrs().authid() or source.sourceCrs().description()
        raise ParameterError(
            "“{source}” is in {crs}, which is not in meters. Choose the positions layer of “Localize images” in the "
            "database’s CRS.",
            source=source.sourceName(),
            crs=name,
        )
    grounds = {}
    if footprints is not None:
        _require(footprints, ("image",))
        _require_same_crs(footprints, source)
        for feature in footprints.getFeatures():
            corners = _corners(feature)
            if corners is not None:
                grounds[feature["image"]] = corners
    return [_row(feature, grounds) for feature in source.getFeatures()]


def read_matches(
    source: QgsProcessingFeatureSource | None, positions: QgsProcessingFeatureSource, images: Sequence[PositionRow]
) -> dict[str, list[ControlPoint]]:
    """Return the matched landmarks of each image by the image's path.

    Args:
        source: The matches of the same run, or None.
        images: Rows with position, heading and pixel size.

    Raises:
        ParameterError: The layer lacks a column, or is in another CRS.
    """
    points: dict[str, list[ControlPoint]] = {}
    if source is None:
        return points
    _require(source, ("image", "image_column", "image_row", "seen_x", "seen_y"))
    _require_same_crs(source, positions)
    by_path = {image.path: image for image in images}
    for feature in source.getFeatures():
        image = by_path.get(feature["image"])
        names = "image_column", "image_row", "seen_x", "seen_y"
        column, row, seen_x, seen_y = (_number(feature, name) for name in names)
        place = _point(feature)
        if image is None or place is None or None in (column, row, seen_x, seen_y):
            continue
        off_px = image.in_pixels(seen_x - place.x(), seen_y - place.y())
        points.setdefault(image.path, []).append(ControlPoint(column, row, place.x(), place.y(), off_px))
    return points


def _require(source: QgsProcessingFeatureSource, names: tuple[str, ...]) -> None:
    lacking = [name for name in names if source.fields().lookupField(name) < 0]
    if lacking:
        missing = ", ".join(lacking)
        raise ParameterError(
            "“{source}” lacks the columns {missing}. Choose a layer of “Localize images” with all its columns.",
            source=source.sourceName(),
            missing=missing,
        )


def _require_same_crs(source: QgsProcessingFeatureSource, other: QgsProcessingFeatureSource) -> None:
    if source.sourceCrs() != other.sourceCrs():
        one, two = source.sourceCrs().authid(), other.sourceCrs().authid()
        raise ParameterError(
            "“{source}” is in {crs}, but the positions are in {positions_crs}. Choose the layers of one run of "
            "“Localize images”.",
            source=source.sourceName(),
            crs=one,
            positions_crs=two,
        )


def _row(feature: QgsFeature, grounds: dict[str, np.ndarray]) -> PositionRow:
    point = _point(feature)
    path = _text(feature, "image")
    return PositionRow(
        path,
        _text(feature, "status"),
        None if point is None else (point.x(), point.y()),
        _number(feature, "heading"),
        _number(feature, "pixel_size"),
        feature.fieldNameIndex("camera_x") >= 0 and _number(feature, "camera_x") is not None,
        grounds.get(path),
        feature.fieldNameIndex("method") >= 0 and _text(feature, "method") == Method.MAP_CORRELATION,
    )


def _point(feature: QgsFeature) -> QgsPointXY | None:
    """Return a point, also of a multipoint; None without geometry."""
    if not feature.hasGeometry() or feature.geometry().isEmpty():
        return None
    return feature.geometry().boundingBox().center()


def _text(feature: QgsFeature, name: str) -> str:
    return "" if is_null(feature[name]) else str(feature[name])


def _number(feature: QgsFeature, name: str) -> float | None:
    """Return a number of a column; None for NULL and other values."""
    value: Any = feature[name]
    try:
        number = float(value)
    except (TypeError, ValueError):
        return None
    return number if np.isfinite(number) else None


def _corners(feature: QgsFeature) -> np.ndarray | None:
    """Return the (4, 2) corners in the written order; None for another shape."""
    geometry = feature.geometry()
    rings = geometry.asMultiPolygon()[0] if geometry.isMultipart() else geometry.asPolygon()
    ring = rings[0] if rings else []
    return np.array([[point.x(), point.y()] for point in ring[:4]]) if len(ring) == 5 else None
