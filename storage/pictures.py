"""Arrays to picture files: PNG, JPEG, GeoTIFF."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from osgeo import gdal

from ..core.errors import LabelMapError
from .gdal_errors import gdal_failures

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


def _write(path: Path, bands: np.ndarray, kind: int, driver: str, options: list[str]) -> None:
    memory = gdal.GetDriverByName("MEM").Create("", bands.shape[2], bands.shape[1], len(bands), kind)
    for number, band in enumerate(bands, start=1):
        memory.GetRasterBand(number).WriteArray(band)
    with gdal_failures() as failures:
        # Dropping the last reference closes the file, which may still write.
        gdal.GetDriverByName(driver).CreateCopy(str(path), memory, options=options)
    if failures:
        raise LabelMapError("storage.unwritable", path=path, reason=failures[0])
