"""An image with the georeference of its fix, to lie on the map as it was taken."""

from __future__ import annotations

from osgeo import gdal

from ...core.errors import LabelMapError
from .gdal_errors import gdal_failure
from .rasters import open_raster


def write_draped(image: str, target: str, crs_wkt: str, corners_xy) -> None:
    """Writes a VRT of ``image`` at ``target``, transparent outside the image; ``corners_xy``: (4, 2) map coordinates
    of its upper left, upper right, lower right and lower left corner. Raises LabelMapError."""
    source = open_raster(image, "Image")
    (x0, y0), (x1, y1), _, (x3, y3) = (tuple(map(float, corner)) for corner in corners_xy)
    width, height = source.RasterXSize, source.RasterYSize
    placed_path = f"{target}.placed.vrt"
    placed = gdal.GetDriverByName("VRT").CreateCopy(placed_path, source)
    if placed is None:
        raise LabelMapError(f"{placed_path} can't be written: {gdal_failure()}.")
    placed.SetProjection(crs_wkt)
    placed.SetGeoTransform((x0, (x1 - x0) / width, (x3 - x0) / height, y0, (y1 - y0) / width, (y3 - y0) / height))
    # The warper reads the file, which must be complete.
    del placed
    labels = source.RasterCount == 1
    turned = gdal.Warp(target, placed_path, format="VRT", dstNodata=0 if labels else None, dstAlpha=not labels)
    if turned is None:
        raise LabelMapError(f"{target} can't be written: {gdal_failure()}.")
    turned.FlushCache()
