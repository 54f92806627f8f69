"""Write arrays as PNG, JPEG or GeoTIFF, and GeoTIFFs of bytes piece by piece."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TypeVar

import numpy as np
from osgeo import gdal

from ..core.errors import UnwritableError
from ..core.geometry.frame import MapFrame
from ..core.labels.image_source import PixelMask
from ..core.segmentation.certainty import NO_DATA
from .gdal_errors import close, require_written
from .rasters import open_raster

_ROWS_AT_ONCE = 256


def write_png(path: Path, bands: np.ndarray) -> None:
    """Write (1 or 3, H, W) uint8 as a gray or RGB PNG, without palette or side-car files."""
    _write(path, bands, gdal.GDT_Byte, "PNG", [])


def write_tiff(path: Path, bands: np.ndarray, kind: int) -> None:
    """Write (bands, H, W) as a GeoTIFF with interleaved bands; ``kind``: GDAL's data type."""
    _write(path, bands, kind, "GTiff", ["COMPRESS=DEFLATE", "INTERLEAVE=PIXEL", "PHOTOMETRIC=MINISBLACK"])


def copy_part(source: str, target: str, window: tuple[int, int, int, int]) -> None:
    """Copy a part of a raster to a GeoTIFF; ``window``: (first column, first row, width, height) in pixels.

    Raises:
        UnwritableError: The GeoTIFF can't be written.
    """
    options = {"format": "GTiff", "srcWin": list(window), "creationOptions": list(TILED)}
    with require_written(target):
        close(gdal.Translate(target, open_raster(source), **options))


def keep_only(path: str, wanted: PixelMask) -> None:
    """Mark pixels of a GeoTIFF outside ``wanted`` as no data, in an internal mask; earlier no data remains no data.

    Raises:
        UnwritableError: The GeoTIFF can't be written.
    """
    with require_written(path):
        gdal.SetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES")
        try:
            _write_mask(gdal.OpenEx(path, gdal.OF_RASTER | gdal.OF_UPDATE), wanted)
        finally:
            gdal.SetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", None)


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


TILED = ("TILED=YES", "COMPRESS=DEFLATE", "BIGTIFF=IF_SAFER")

_Own = TypeVar("_Own", bound="WrittenRaster")


class WrittenRaster:
    """A context manager that closes the file at the end, and raises UnwritableError if the disk is full."""

    def __init__(self, path: str, frame: MapFrame, bands: int, options: Sequence[str] = TILED) -> None:
        """Create the file.

        Raises:
            UnwritableError: GDAL can't write the file.
        """
        self._path = path
        height, width = frame.shape_hw
        with require_written(path):
            driver = gdal.GetDriverByName("GTiff")
            self._dataset = driver.Create(path, width, height, bands, gdal.GDT_Byte, list(options))
            if self._dataset is not None and frame.geotransform:
                self._dataset.SetGeoTransform(frame.geotransform)
            if self._dataset is not None and frame.crs:
                self._dataset.SetProjection(frame.crs)

    def __enter__(self: _Own) -> _Own:
        return self

    def __exit__(self, kind: object, error: object, traceback: object) -> None:
        dataset, self._dataset = self._dataset, None
        try:
            with require_written(self._path):
                close(dataset)
                del dataset
        except UnwritableError:
            if error is None:
                raise

    def _write(self, band: int, column: int, row: int, values_hw: np.ndarray) -> None:
        self._dataset.GetRasterBand(band).WriteArray(values_hw, column, row)


class ColorPicture(WrittenRaster):
    """Writer of a georeferenced GeoTIFF with red, green, blue and opacity."""

    def __init__(self, path: str, frame: MapFrame) -> None:
        """Create a transparent picture of the extent of ``frame``. Raises UnwritableError."""
        options = (*TILED, "PHOTOMETRIC=RGB", "ALPHA=YES")
        super().__init__(path, frame, 4, options)

    def write(self, column: int, row: int, pixels_hw4: np.ndarray) -> None:
        """Write (height, width, 4) uint8 pixels, red first, from ``column``, ``row`` on."""
        with require_written(self._path):
            for band in range(4):
                self._write(band + 1, column, row, pixels_hw4[:, :, band])


class PercentRaster(WrittenRaster):
    """Writer of a GeoTIFF of probabilities, one band for each name: 0…100 %, 255 is no data."""

    def __init__(self, path: str, frame: MapFrame, names: Sequence[str]) -> None:
        """Create the file. Raises UnwritableError."""
        # Gray: otherwise programs would show three bands as red, green and blue.
        options = (*TILED, "INTERLEAVE=BAND", "PHOTOMETRIC=MINISBLACK")
        super().__init__(path, frame, len(names), options)
        for number, name in enumerate(names, start=1):
            band = self._dataset.GetRasterBand(number)
            band.SetDescription(name)
            band.SetUnitType("%")
            band.SetNoDataValue(NO_DATA)

    def write_rows(self, first_row: int, percents_chw: np.ndarray) -> None:
        """Write whole rows of all bands, (bands, rows, W) uint8, and flush them."""
        with require_written(self._path):
            for number, percent_hw in enumerate(percents_chw, start=1):
                self._write(number, 0, first_row, percent_hw)
            self._dataset.FlushCache()


def _write(path: Path, bands: np.ndarray, kind: int, driver: str, options: list[str]) -> None:
    memory = gdal.GetDriverByName("MEM").Create("", bands.shape[2], bands.shape[1], len(bands), kind)
    for number, band in enumerate(bands, start=1):
        memory.GetRasterBand(number).WriteArray(band)
    with require_written(path):
        close(gdal.GetDriverByName(driver).CreateCopy(str(path), memory, options=options))
