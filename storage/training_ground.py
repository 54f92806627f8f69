"""Prepare the image that a network is trained on: in meters, with the wanted pixel size and extent."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from osgeo import gdal

from ..core.errors import LabelMapError
from ..core.geometry.frame import MapFrame
from .gdal_errors import gdal_failure, gdal_failures
from .label_maps import RasterFile
from .pixel_grid import Bounds
from .rasters import open_raster
from .training_tiles import ImageBands

IMAGE = "image.vrt"
"""Name of the VRT that reprojects, resamples or cuts the image."""

_SQUARE_WITHIN = 1e-6
"""Largest relative difference between the edges of a square pixel."""


def is_upright(transform: Sequence[float]) -> bool:
    """Whether a geotransform has north up and square pixels."""
    _, across, turn_x, _, turn_y, down = transform
    return not (turn_x or turn_y) and across > 0 > down and abs(across + down) <= _SQUARE_WITHIN * across


def prepare_image(
    image: RasterFile, folder: Path, crs_wkt: str, pixel_size: float | None, bounds: Bounds | None
) -> RasterFile:
    """Return the image itself if it is as wanted, otherwise a VRT in ``folder``.

    Args:
        image: The image; without a georeference it is returned unchanged.
        crs_wkt: WKT of the target CRS in meters; "" to keep the CRS.
        pixel_size: Edge of a pixel in that CRS; None to keep the image's pixel size.
        bounds: Wanted extent in that CRS; None for all.

    Raises:
        ImageError: The image can't be read.
        LabelMapError: The image has another type than tiles, or has no pixel within the bounds.
    """
    # With the name of the user's file, not of the VRT.
    ImageBands(image.path)
    source = open_raster(image.path)
    transform = source.GetGeoTransform(can_return_null=True)
    if transform is None:
        return image
    target = str(folder / IMAGE)
    if crs_wkt or pixel_size or not is_upright(transform):
        options = {"srcSRS": image.crs_wkt or None, "dstSRS": crs_wkt or image.crs_wkt or None}
        size = {"xRes": pixel_size, "yRes": pixel_size} if pixel_size else {}
        is_coarser = pixel_size and not crs_wkt and pixel_size > abs(transform[1])
        method = "average" if is_coarser else "bilinear"
        options |= {"outputBounds": bounds, "resampleAlg": method, "dstAlpha": True, **size}
        convert = gdal.Warp
    elif bounds is not None:
        left, bottom, right, top = bounds
        options, convert = {"projWin": (left, top, right, bottom)}, gdal.Translate
    else:
        return image
    made = None
    with gdal_failures() as failures:
        made = convert(target, source, format="VRT", **options)
    if made is None:
        reason = gdal_failure(failures[0] if failures else None)
        raise LabelMapError("{path} can't be read: {reason}.", path=image.path, reason=reason)
    made.FlushCache()
    return RasterFile(target, crs_wkt or image.crs_wkt, image.is_metric or bool(crs_wkt), ())


def is_placed(image: RasterFile) -> bool:
    """Whether an image has a georeference."""
    return open_raster(image.path).GetGeoTransform(can_return_null=True) is not None


def frame_of(image: RasterFile) -> MapFrame:
    """Return the pixel grid of an image. Raises LabelMapError for an image without georeference."""
    dataset = open_raster(image.path)
    transform = dataset.GetGeoTransform(can_return_null=True)
    if transform is None:
        raise LabelMapError(
            "{path} has no georeference, so polygons can't be drawn on it. Choose a label map of its size, or a "
            "georeferenced image.",
            path=image.path,
        )
    return MapFrame(image.crs_wkt, tuple(transform), (dataset.RasterYSize, dataset.RasterXSize))
