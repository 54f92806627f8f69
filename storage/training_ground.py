"""The ground a network is trained on: an image as networks see the world, in meters, and labels on its pixels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from osgeo import gdal

from ..core.errors import LabelMapError
from ..core.geometry.frame import MapFrame
from .gdal_errors import gdal_failure
from .label_maps import RasterFile
from .rasters import open_raster

Bounds = tuple[float, float, float, float]
"""Left, bottom, right, top, in map units."""

IMAGE = "image.vrt"
"""What describes the image as it is seen, where it is not seen as it lies."""

_SQUARE_WITHIN = 1e-6
"""Relative difference of a pixel's edges up to which it counts as square."""


@dataclass(frozen=True)
class WantedGround:
    """How the image is to be seen.

    Attributes:
        crs_wkt: Of the CRS in meters that it is brought to; "" to leave it as it is.
        pixel_size: Edge of a pixel in that CRS; None for the image's own.
        bounds: What is wanted of it, in that CRS; None for all.
    """

    crs_wkt: str = ""
    pixel_size: float | None = None
    bounds: Bounds | None = None


def is_upright(transform: Sequence[float]) -> bool:
    """Whether a geotransform has north up and square pixels."""
    _, across, turn_x, _, turn_y, down = transform
    return not (turn_x or turn_y) and across > 0 > down and abs(across + down) <= _SQUARE_WITHIN * across


def seen_ground(image: RasterFile, wanted: WantedGround, folder: Path) -> RasterFile:
    """The image as it is wanted: itself where that is how it lies, else a VRT in ``folder``.

    Args:
        image: What is photographed; one without a georeference is left as it is.
        wanted: CRS, pixel size and bounds.
        folder: Takes the VRT.

    Raises:
        LabelMapError: It can't be read, or has no pixel within the bounds.
    """
    source = open_raster(image.path)
    transform = source.GetGeoTransform(can_return_null=True)
    if transform is None:
        return image
    target = str(folder / IMAGE)
    if wanted.crs_wkt or wanted.pixel_size or not is_upright(transform):
        options = {"srcSRS": image.crs_wkt or None, "dstSRS": wanted.crs_wkt or image.crs_wkt or None}
        size = {"xRes": wanted.pixel_size, "yRes": wanted.pixel_size} if wanted.pixel_size else {}
        method = "average" if _is_coarser(wanted, transform) else "bilinear"
        made = _made(
            gdal.Warp,
            target,
            source,
            format="VRT",
            outputBounds=wanted.bounds,
            resampleAlg=method,
            dstAlpha=True,
            **options,
            **size,
        )
    elif wanted.bounds is not None:
        left, bottom, right, top = wanted.bounds
        made = _made(gdal.Translate, target, source, format="VRT", projWin=(left, top, right, bottom))
    else:
        return image
    if made is None:
        raise LabelMapError("{path} can't be read: {reason}.", path=image.path, reason=gdal_failure())
    made.FlushCache()
    return RasterFile(target, wanted.crs_wkt or image.crs_wkt, image.is_metric or bool(wanted.crs_wkt), ())


def is_placed(image: RasterFile) -> bool:
    """Whether an image has a georeference."""
    return open_raster(image.path).GetGeoTransform(can_return_null=True) is not None


def shape_of(image: RasterFile) -> tuple[int, int]:
    """(height, width) in pixels."""
    dataset = open_raster(image.path)
    return dataset.RasterYSize, dataset.RasterXSize


def frame_of(image: RasterFile) -> MapFrame:
    """Where the pixels of a seen ground lie. Raises LabelMapError for an image without georeference."""
    dataset = open_raster(image.path)
    transform = dataset.GetGeoTransform(can_return_null=True)
    if transform is None:
        raise LabelMapError(
            "{path} has no georeference, so polygons can't be laid on it; give a label map of its size, or an image "
            "with its place on the ground.",
            path=image.path,
        )
    return MapFrame(image.crs_wkt, tuple(transform), (dataset.RasterYSize, dataset.RasterXSize))


def _is_coarser(wanted: WantedGround, transform: Sequence[float]) -> bool:
    return wanted.pixel_size is not None and not wanted.crs_wkt and wanted.pixel_size > abs(transform[1])


def _made(function: object, *arguments: object, **options: object) -> gdal.Dataset | None:
    """What GDAL makes; it may raise or return None, as the user set it."""
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        gdal.ErrorReset()
        return function(*arguments, **options)  # type: ignore[operator]
    except RuntimeError as error:
        raise LabelMapError("{path} can't be read: {reason}.", path=arguments[0], reason=gdal_failure(error)) from None
    finally:
        gdal.PopErrorHandler()
