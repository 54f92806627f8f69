"""Arrays to picture files: PNG, JPEG, GeoTIFF."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from osgeo import gdal

from ..core.errors import LabelMapError
from ..core.geometry.frame import MapFrame
from .gdal_errors import close, gdal_failures
from .rasters import open_raster
from .written_raster import TILED, WrittenRaster

JPEG_QUALITY = 85


def write_png(path: Path, bands: np.ndarray) -> None:
    """(1 or 3, H, W) uint8 as a grey or RGB PNG, without a palette and without files beside it."""
    _write(path, bands, gdal.GDT_Byte, "PNG", [])


def write_tiff(path: Path, bands: np.ndarray, kind: int) -> None:
    """(bands, H, W) as a GeoTIFF with interleaved bands."""
    _write(path, bands, kind, "GTiff", ["COMPRESS=DEFLATE", "INTERLEAVE=PIXEL", "PHOTOMETRIC=MINISBLACK"])


def write_jpeg(path: Path, bands: np.ndarray) -> None:
    """(1 or 3, H, W) uint8 as a grey or RGB JPEG."""
    _write(path, bands, gdal.GDT_Byte, "JPEG", [f"QUALITY={JPEG_QUALITY}"])


def copy_part(source: str, target: str, window: tuple[int, int, int, int]) -> None:
    """Copies a piece of a raster, (first column, first row, width, height), to a GeoTIFF. Raises LabelMapError."""
    options = {"format": "GTiff", "srcWin": list(window), "creationOptions": list(TILED)}
    with gdal_failures() as failures:
        close(gdal.Translate(target, open_raster(source), **options))
    if failures:
        raise LabelMapError("storage.unwritable", path=target, reason=failures[0])


class ColorPicture(WrittenRaster):
    """A georeferenced GeoTIFF with red, green, blue and opacity, being written tile by tile."""

    def __init__(self, path: str, frame: MapFrame) -> None:
        """Creates the file where ``frame`` lies, all of it transparent. Raises LabelMapError."""
        options = (*TILED, "PHOTOMETRIC=RGB", "ALPHA=YES")
        super().__init__(path, frame.shape_hw, 4, frame.geotransform, frame.crs, options)

    def write(self, column: int, row: int, pixels_hw4: np.ndarray) -> None:
        """Writes (height, width, 4) uint8, red first, whose first pixel comes to ``column``, ``row``."""
        with gdal_failures() as failures:
            for band in range(4):
                self._write(band + 1, column, row, pixels_hw4[:, :, band])
        self._raise(failures)


def _write(path: Path, bands: np.ndarray, kind: int, driver: str, options: list[str]) -> None:
    memory = gdal.GetDriverByName("MEM").Create("", bands.shape[2], bands.shape[1], len(bands), kind)
    for number, band in enumerate(bands, start=1):
        memory.GetRasterBand(number).WriteArray(band)
    with gdal_failures() as failures:
        # It may still write when it is closed.
        close(gdal.GetDriverByName(driver).CreateCopy(str(path), memory, options=options))
    if failures:
        raise LabelMapError("storage.unwritable", path=path, reason=failures[0])
