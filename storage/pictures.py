"""Arrays to picture files: PNG, JPEG, GeoTIFF."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from osgeo import gdal

from ..core.errors import UnwritableError
from ..core.geometry.frame import MapFrame
from ..core.labels.image_source import PixelMask
from .gdal_errors import close, gdal_failures
from .raster_writer import TILED, WrittenRaster
from .rasters import open_raster

JPEG_QUALITY = 85
_ROWS_AT_ONCE = 256


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
    """Copies a piece of a raster, (first column, first row, width, height), to a GeoTIFF. Raises UnwritableError."""
    options = {"format": "GTiff", "srcWin": list(window), "creationOptions": list(TILED)}
    with gdal_failures() as failures:
        close(gdal.Translate(target, open_raster(source), **options))
    if failures:
        raise UnwritableError("{path} can't be written: {reason}.", path=target, reason=failures[0])


def keep_only(path: str, wanted: PixelMask) -> None:
    """Leaves a GeoTIFF no data outside a mask, as a mask of its own; what had none before still has none.

    Raises:
        UnwritableError: It can't be written.
    """
    with gdal_failures() as failures:
        gdal.SetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES")
        try:
            _write_mask(gdal.OpenEx(path, gdal.OF_RASTER | gdal.OF_UPDATE), wanted)
        finally:
            gdal.SetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", None)
    if failures:
        raise UnwritableError("{path} can't be written: {reason}.", path=path, reason=failures[0])


def _write_mask(dataset: gdal.Dataset | None, wanted: PixelMask) -> None:
    if dataset is None:
        return
    width, height = dataset.RasterXSize, dataset.RasterYSize
    band = dataset.GetRasterBand(1)
    had_data = None if band.GetMaskFlags() & gdal.GMF_ALL_VALID else band.GetMaskBand().ReadAsArray() > 0
    dataset.CreateMaskBand(gdal.GMF_PER_DATASET)
    mask = dataset.GetRasterBand(1).GetMaskBand()
    for row in range(0, height, _ROWS_AT_ONCE):
        rows = min(_ROWS_AT_ONCE, height - row)
        kept = wanted.read(0, row, width, rows)
        kept = kept if had_data is None else kept & had_data[row : row + rows]
        mask.WriteArray(kept.astype(np.uint8) * 255, 0, row)
    del band, mask
    close(dataset)


class ColorPicture(WrittenRaster):
    """A georeferenced GeoTIFF with red, green, blue and opacity, being written tile by tile."""

    def __init__(self, path: str, frame: MapFrame) -> None:
        """Creates the file where ``frame`` lies, all of it transparent. Raises UnwritableError."""
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
        raise UnwritableError("{path} can't be written: {reason}.", path=path, reason=failures[0])
