"""Where a label map lies, by GDAL and PROJ alone: its frame, and the longitude and latitude of its places."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from osgeo import gdal, osr

from ..core.errors import LabelMapError
from ..core.geometry.frame import MapFrame
from ..core.labels.class_table import ClassTable
from .crs_text import crs_wkt
from .rasters import GdalLabels, named_classes, stored_class_table

_WGS84 = 4326
_POINTS_AT_ONCE = 50_000


def require_map_grid(transform: Sequence[float] | None, path: str) -> None:
    """Raises LabelMapError for a georeference that is none, or of no north-up grid of square pixels.

    Args:
        transform: GDAL's six numbers.
        path: What the raster is called in what is said.
    """
    if transform is None:
        raise LabelMapError("storage.no_georeference", path=path)
    _, pixel_x, turn_x, _, turn_y, pixel_y = transform
    if turn_x or turn_y or pixel_y >= 0 or pixel_x <= 0:
        raise LabelMapError("storage.rotated", path=path)
    if abs(pixel_x + pixel_y) > 1e-6 * pixel_x:
        raise LabelMapError("storage.not_square", path=path, pixel_x=pixel_x, pixel_y=-pixel_y)


def label_map_frame(labels: GdalLabels, path: str) -> MapFrame:
    """CRS and geotransform of a label map, as the file tells them; raises LabelMapError unless metric and north up."""
    srs = labels.dataset.GetSpatialRef()
    if srs is None:
        raise LabelMapError("storage.no_crs", path=path)
    if not srs.IsProjected() or abs(srs.GetLinearUnits() - 1) > 1e-9:
        raise LabelMapError("storage.not_in_meters", path=path, crs=srs.GetName() or "")
    transform = labels.dataset.GetGeoTransform(can_return_null=True)
    require_map_grid(transform, path)
    return MapFrame(crs_wkt(srs), tuple(transform), labels.shape_hw)


def require_crs_of(frame: MapFrame, database_crs: str, path: str) -> None:
    """Raises LabelMapError for a label map in another CRS than the database's.

    Args:
        frame: Where the map lies.
        database_crs: WKT of the database's.
        path: What the map is called in what is said.
    """
    own, other = (osr.SpatialReference(wkt) for wkt in (frame.crs, database_crs))
    if not own.IsSame(other):
        names = own.GetName() or "", other.GetName() or ""
        raise LabelMapError("storage.map_in_other_crs", path=path, crs=names[0], database_crs=names[1])


def require_classes_of(labels: GdalLabels, table: ClassTable, path: str) -> None:
    """Raises LabelMapError for a label map that calls a class otherwise than the database does.

    Args:
        labels: The map.
        table: Of the database.
        path: What the map is called in what is said.
    """
    for found in stored_class_table(labels.dataset, path) or named_classes(labels.dataset):
        known = table.by_value(found.value)
        if known is not None and known.name != found.name:
            raise LabelMapError(
                "storage.class_called_otherwise", path=path, value=found.value, name=found.name, known=known.name
            )


def longitudes_latitudes(points_xy: np.ndarray, crs_wkt: str) -> tuple[np.ndarray, np.ndarray]:
    """(N, 2) map coordinates → longitudes (N,), latitudes (N,) in degrees, EPSG:4326; NaN where there are none."""
    source, target = osr.SpatialReference(), osr.SpatialReference()
    nowhere = np.full(len(points_xy), np.nan)
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        source.ImportFromWkt(crs_wkt)
        target.ImportFromEPSG(_WGS84)
        for srs in (source, target):
            srs.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
        transform = osr.CoordinateTransformation(source, target)
        # By parts: a point is some 200 B in Python's lists.
        parts = np.array_split(np.asarray(points_xy, np.float64), len(points_xy) // _POINTS_AT_ONCE + 1)
        found = np.concatenate([np.array(transform.TransformPoints(part.tolist())).reshape(-1, 3) for part in parts])
    except RuntimeError:
        return nowhere, nowhere.copy()
    finally:
        gdal.PopErrorHandler()
    found[~np.isfinite(found)] = np.nan
    return found[:, 0], found[:, 1]
