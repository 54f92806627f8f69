"""Where a label map lies, by GDAL and PROJ alone: its frame, and the longitude and latitude of its places."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from osgeo import gdal, osr

from ..core.errors import LabelMapError
from ..core.geometry.frame import MapFrame
from .rasters import GdalLabels

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
    return MapFrame(srs.ExportToWkt(["FORMAT=WKT2_2019"]), tuple(transform), labels.shape_hw)


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
