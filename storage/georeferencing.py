"""Georeference images by their positions: as a VRT or GeoTIFF, or by a world file or control points beside a copy."""

from __future__ import annotations

import csv
import io
import os
import shutil
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from html import escape

import numpy as np
from osgeo import gdal

from ..core.errors import ImageError, UnwritableError
from ..core.geometry.footprint import is_parallelogram, on_ground
from .gdal_errors import close, gdal_failure, require_written
from .pictures import TILED
from .rasters import open_raster

GRID = 16
"""Control points per side of a tilted image; GDAL interpolates between them by a thin plate spline.

The points are closer together at the edges. For a camera tilted by 30° and 4,000 × 3,000 pixels, the largest error is
1 pixel and the median 0.01 pixels. GDAL supports homographies only from 3.11.
"""


def write_draped(image: str, target: str, crs_wkt: str, corners_xy: np.ndarray) -> None:
    """Write a georeferenced VRT of an image, transparent outside the image.

    Args:
        target: The VRT; a second one is written beside it.
        corners_xy: (4, 2) map coordinates of the image's upper left, upper right, lower right and lower left corner.

    Raises:
        ImageError: The image can't be read.
        UnwritableError: The VRT can't be written.
    """
    source = open_raster(image)
    placed_path = f"{target}.placed.vrt"
    # The warper reads the file, which must be complete.
    _place(source, placed_path, crs_wkt, corners_xy).FlushCache()
    _turn(target, placed_path, source, corners_xy, format="VRT")


def write_geotiff(
    image: str, target: str, crs_wkt: str, corners_xy: np.ndarray, going_on: Callable[[], bool] = lambda: True
) -> None:
    """Write a georeferenced GeoTIFF of an image, north up, transparent outside the image.

    Photos are resampled bilinearly. An image with one band is a label image: it is resampled by nearest neighbor, keeps
    its colors, and is 0 outside.

    Args:
        corners_xy: As in ``write_draped``.
        going_on: Called repeatedly; False ends the work with an UnwritableError.

    Raises:
        ImageError: The image can't be read.
        UnwritableError: The GeoTIFF can't be written.
    """
    source = open_raster(image)
    placed = _place(source, "", crs_wkt, corners_xy)
    with require_written(target):
        _turn(
            target,
            placed,
            source,
            corners_xy,
            format="GTiff",
            resampleAlg="near" if source.RasterCount == 1 else "bilinear",
            creationOptions=list(TILED),
            callback=lambda *_: int(going_on()),
        )


def write_mosaic(
    images: Sequence[tuple[str, np.ndarray]],
    target: str,
    crs_wkt: str,
    pixel_m: float,
    going_on: Callable[[float], bool],
) -> None:
    """Write one georeferenced GeoTIFF of images, north up, transparent where there is none.

    Args:
        images: Path and corners, as in ``write_draped``, of images with the same number of bands; later images cover
            earlier ones.
        pixel_m: Edge of a pixel, map units.
        going_on: Called repeatedly with the share that is done; False ends the work with an UnwritableError.

    Raises:
        ImageError: An image can't be read.
        UnwritableError: The GeoTIFF can't be written.
    """
    first, corners = open_raster(images[0][0]), np.vstack([corners_xy for _, corners_xy in images])
    labels = first.RasterCount == 1
    left, top = corners[:, 0].min(), corners[:, 1].max()
    width, height = np.ceil((corners.max(axis=0) - corners.min(axis=0)) / pixel_m).astype(int).tolist()
    has_alpha = first.GetRasterBand(first.RasterCount).GetColorInterpretation() == gdal.GCI_AlphaBand
    count, kind = first.RasterCount + (not labels and not has_alpha), first.GetRasterBand(1).DataType
    with require_written(target):
        made = gdal.GetDriverByName("GTiff").Create(target, width, height, count, kind, list(TILED))
        if made is None:
            raise UnwritableError("{path} can't be written: {reason}.", path=target, reason=gdal_failure())
        made.SetGeoTransform((left, pixel_m, 0.0, top, 0.0, -pixel_m))
        made.SetProjection(crs_wkt)
        if not labels:
            made.GetRasterBand(count).SetColorInterpretation(gdal.GCI_AlphaBand)
        elif first.GetRasterBand(1).GetColorTable() is not None:
            made.GetRasterBand(1).SetColorTable(first.GetRasterBand(1).GetColorTable())
        # One after the other, because each one is an open file.
        for number, (path, corners_xy) in enumerate(images):
            source = open_raster(path)
            tilted = not is_parallelogram(np.asarray(corners_xy, np.float64))
            options = {"dstNodata": 0} if labels else {"dstAlpha": True, "resampleAlg": "bilinear"}
            level = gdal.Warp("", _place(source, "", crs_wkt, corners_xy), format="VRT", tps=tilted, **options)
            how = {"srcNodata": 0} if labels else {"srcAlpha": True, "dstAlpha": True, "resampleAlg": "average"}

            def called(share: float, *_: object, done: int = number) -> int:
                return int(going_on((done + share) / len(images)))

            if not gdal.Warp(made, level, callback=called, **how):
                raise UnwritableError("{path} can't be written: {reason}.", path=target, reason=gdal_failure())
        made.FlushCache()
        close(made)


def _place(source: gdal.Dataset, path: str, crs_wkt: str, corners_xy: np.ndarray) -> gdal.Dataset:
    """Return a VRT of an image with its georeference; in memory if ``path`` is empty."""
    footprint = np.asarray(corners_xy, np.float64)
    placed = gdal.GetDriverByName("VRT").CreateCopy(path, source)
    if placed is None:
        raise UnwritableError("{path} can't be written: {reason}.", path=path, reason=gdal_failure())
    if is_parallelogram(footprint):
        placed.SetProjection(crs_wkt)
        placed.SetGeoTransform(geotransform(footprint, source))
    else:
        placed.SetGCPs(_control_points(footprint, source), crs_wkt)
    return placed


def _turn(
    target: str, placed: str | gdal.Dataset, source: gdal.Dataset, corners_xy: np.ndarray, **options: object
) -> None:
    """Warp the result of ``_place`` to a north-up raster. Raises UnwritableError."""
    tilted, is_labels = not is_parallelogram(np.asarray(corners_xy, np.float64)), source.RasterCount == 1
    options |= {"dstNodata": 0} if is_labels else {"dstAlpha": True}
    made = gdal.Warp(target, placed, tps=tilted, **options)
    if made is None:
        raise UnwritableError("{path} can't be written: {reason}.", path=target, reason=gdal_failure())
    made.FlushCache()
    close(made)


def geotransform(corners_xy: np.ndarray, source: gdal.Dataset) -> tuple:
    """Return GDAL's six numbers of a level image.

    Args:
        corners_xy: (4, 2) map coordinates of the corners, upper left first, clockwise.
    """
    (x0, y0), (x1, y1), _, (x3, y3) = np.asarray(corners_xy, np.float64).tolist()
    width, height = source.RasterXSize, source.RasterYSize
    return x0, (x1 - x0) / width, (x3 - x0) / height, y0, (y1 - y0) / width, (y3 - y0) / height


def _control_points(footprint: np.ndarray, source: gdal.Dataset) -> list:
    """Return a grid of control points of a tilted image. With four points, GDAL would fit an affine transform."""
    shares = (1 - np.cos(np.linspace(0, np.pi, GRID))) / 2
    return [gdal.GCP(p.x, p.y, 0.0, p.column, p.row) for p in _grid_points(source, footprint, shares)]


def write_world_file(image: str, target: str, crs_wkt: str, corners_xy: np.ndarray) -> None:
    """Copy an image, write its world file beside it, and write the CRS to ``.aux.xml``.

    Args:
        corners_xy: (4, 2) map coordinates of the image's upper left, upper right, lower right and lower left corner.

    Raises:
        ImageError: The image can't be read, or was tilted: a world file can only describe a parallelogram.
    """
    source = open_raster(image)
    if not is_parallelogram(np.asarray(corners_xy, np.float64)):
        raise ImageError(
            "{image} was tilted, which a world file can’t describe; write GeoTIFFs or control points instead.",
            image=os.path.basename(image),
        )
    transform = geotransform(corners_xy, source)
    x0, across_x, down_x, y0, across_y, down_y = transform
    # A world file has the center of the first pixel.
    first = x0 + (across_x + down_x) / 2, y0 + (across_y + down_y) / 2
    lines = [f"{value:.12g}" if abs(value) < 1 else f"{value:.6f}" for value in (across_x, across_y, down_x, down_y)]
    lines += [f"{value:.6f}" for value in first]
    shutil.copyfile(image, target)
    _write_text(f"{os.path.splitext(target)[0]}{world_file_suffix(target)}", "\n".join(lines) + "\n")
    numbers = ", ".join(f"{value:.17g}" for value in transform)
    # For GDAL it has priority over a georeference inside a TIFF.
    inside = f"  <SRS>{escape(crs_wkt, quote=False)}</SRS>\n  <GeoTransform>{numbers}</GeoTransform>\n"
    _write_text(f"{target}.aux.xml", f"<PAMDataset>\n{inside}</PAMDataset>\n")


def world_file_suffix(image: str) -> str:
    """Return the suffix of an image's world file: ``.jgw`` for ``.jpg``, ``.tfw`` for ``.tif``."""
    suffix = os.path.splitext(image)[1]
    return f".{suffix[1]}{suffix[-1]}w" if len(suffix) > 2 else ".wld"


@dataclass(frozen=True)
class ControlPoint:
    """A pixel of an image and its map coordinates.

    Attributes:
        row: Pixel coordinate, downwards.
        off_px: (right, down) residual of the position, pixels.
    """

    column: float
    row: float
    x: float
    y: float
    off_px: tuple[float, float] = (0.0, 0.0)


def corner_points(image: str, corners_xy: np.ndarray) -> list[ControlPoint]:
    """Return nine points: the corners, the middles of the edges and the center. Raises ImageError."""
    return _grid_points(open_raster(image), np.asarray(corners_xy, np.float64), np.array([0.0, 0.5, 1.0]))


def _grid_points(source: gdal.Dataset, footprint: np.ndarray, shares: np.ndarray) -> list[ControlPoint]:
    """Return the points at these shares of the width and of the height of an image, row by row."""
    width, height = source.RasterXSize, source.RasterYSize
    columns, rows = np.meshgrid(width * shares, height * shares)
    pixels = np.column_stack([columns.ravel(), rows.ravel()])
    ground = on_ground(pixels, footprint, (height, width))
    return [ControlPoint(*pixel, *place) for pixel, place in zip(pixels.tolist(), ground.tolist())]


def write_points(image: str, target: str, crs_wkt: str, points: Sequence[ControlPoint]) -> None:
    """Copy an image and write its ``.points`` file, which QGIS's Georeferencer loads with the image.

    Args:
        points: At least four for a tilted image, three for a level one.

    Raises:
        ImageError: The image can't be read.
    """
    open_raster(image)
    text = io.StringIO()
    text.write(f"#CRS: {' '.join(crs_wkt.split())}\n")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(("mapX", "mapY", "sourceX", "sourceY", "enable", "dX", "dY", "residual"))
    for point in points:
        # Rows increase downward; the Georeferencer's y increases upward.
        right, down = point.off_px
        values = point.x, point.y, point.column, -point.row, 1, right, down, float(np.hypot(right, down))
        writer.writerow([f"{value:.12g}" for value in values])
    shutil.copyfile(image, target)
    _write_text(f"{target}.points", text.getvalue())


def _write_text(path: str, text: str) -> None:
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(text)
