"""Arrays to picture files: PNG, JPEG, GeoTIFF."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from osgeo import gdal

from ..core.errors import LabelMapError
from ..core.geometry.frame import MapFrame
from .gdal_errors import close, gdal_failures
from .rasters import open_raster

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
    options = ["TILED=YES", "COMPRESS=DEFLATE", "BIGTIFF=IF_SAFER"]
    with gdal_failures() as failures:
        close(gdal.Translate(target, open_raster(source), format="GTiff", srcWin=list(window), creationOptions=options))
    if failures:
        raise LabelMapError("storage.unwritable", path=target, reason=failures[0])


class ColorPicture:
    """A georeferenced GeoTIFF with red, green, blue and opacity, written tile by tile.

    A context manager: leaving it closes the file, and raises LabelMapError when GDAL could not write (disk full).
    """

    def __init__(self, path: str, frame: MapFrame) -> None:
        """Creates the file where ``frame`` lies, all of it transparent. Raises LabelMapError."""
        self._path = path
        height, width = frame.shape_hw
        options = ["TILED=YES", "COMPRESS=DEFLATE", "PHOTOMETRIC=RGB", "ALPHA=YES", "BIGTIFF=IF_SAFER"]
        with gdal_failures() as failures:
            self._dataset = gdal.GetDriverByName("GTiff").Create(path, width, height, 4, gdal.GDT_Byte, options)
            if self._dataset is not None:
                self._dataset.SetGeoTransform(frame.geotransform)
                self._dataset.SetProjection(frame.crs)
        self._raise(failures)

    def __enter__(self) -> ColorPicture:
        return self

    def __exit__(self, kind: object, error: object, traceback: object) -> None:
        dataset, self._dataset = self._dataset, None
        with gdal_failures() as failures:
            close(dataset)
            del dataset
        if error is None:
            self._raise(failures)

    def write(self, column: int, row: int, pixels_hw4: np.ndarray) -> None:
        """Writes (height, width, 4) uint8, red first, whose first pixel comes to ``column``, ``row``."""
        with gdal_failures() as failures:
            for number in range(4):
                self._dataset.GetRasterBand(number + 1).WriteArray(pixels_hw4[:, :, number], column, row)
        self._raise(failures)

    def _raise(self, failures: list[str]) -> None:
        if failures:
            raise LabelMapError("storage.unwritable", path=self._path, reason=failures[0])


def _write(path: Path, bands: np.ndarray, kind: int, driver: str, options: list[str]) -> None:
    memory = gdal.GetDriverByName("MEM").Create("", bands.shape[2], bands.shape[1], len(bands), kind)
    for number, band in enumerate(bands, start=1):
        memory.GetRasterBand(number).WriteArray(band)
    with gdal_failures() as failures:
        # It may still write when it is closed.
        close(gdal.GetDriverByName(driver).CreateCopy(str(path), memory, options=options))
    if failures:
        raise LabelMapError("storage.unwritable", path=path, reason=failures[0])
