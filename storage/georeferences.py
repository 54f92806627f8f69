"""Write a world file or the Georeferencer's control points beside a copy of an image."""

from __future__ import annotations

import csv
import io
import os
import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import numpy as np

from ..core.errors import LabelMapError
from ..core.geometry.footprint import is_parallelogram, on_ground
from .georeferenced_vrt import geotransform
from .rasters import open_raster


def write_world_file(image: str, target: str, crs_wkt: str, corners_xy: np.ndarray) -> None:
    """Copy an image, write its world file beside it, and write the CRS to ``.aux.xml``.

    Args:
        target: The copy.
        crs_wkt: WKT of the map's CRS.
        corners_xy: (4, 2) map coordinates of the image's upper left, upper right, lower right and lower left corner.

    Raises:
        LabelMapError: The image can't be read, or was tilted: a world file can only describe a parallelogram.
    """
    source = open_raster(image)
    if not is_parallelogram(np.asarray(corners_xy, np.float64)):
        raise LabelMapError(
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
        column: Pixel coordinate.
        row: Pixel coordinate, downwards.
        x: Map coordinate.
        y: Map coordinate.
        off_px: (right, down) residual of the position, pixels.
    """

    column: float
    row: float
    x: float
    y: float
    off_px: tuple[float, float] = (0.0, 0.0)


def corner_points(image: str, corners_xy: np.ndarray) -> list[ControlPoint]:
    """Return nine points: the corners, the middles of the edges and the center. Raises LabelMapError."""
    source = open_raster(image)
    height, width = source.RasterYSize, source.RasterXSize
    columns, rows = np.meshgrid((0.0, width / 2, width), (0.0, height / 2, height))
    pixels = np.column_stack([columns.ravel(), rows.ravel()])
    ground = on_ground(pixels, np.asarray(corners_xy, np.float64), (height, width))
    return [ControlPoint(*pixel, *place) for pixel, place in zip(pixels.tolist(), ground.tolist())]


def write_points(image: str, target: str, crs_wkt: str, points: Sequence[ControlPoint]) -> None:
    """Copy an image and write its ``.points`` file, which QGIS's Georeferencer loads with the image.

    Args:
        target: The copy.
        crs_wkt: WKT of the map's CRS.
        points: At least four for a tilted image, three for a level one.

    Raises:
        LabelMapError: The image can't be read.
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
