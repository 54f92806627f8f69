"""Write a GeoTIFF of bytes piece by piece."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import numpy as np
from osgeo import gdal

from ..core.errors import UnwritableError
from .gdal_errors import close, require_written

TILED = ("TILED=YES", "COMPRESS=DEFLATE", "BIGTIFF=IF_SAFER")

_Own = TypeVar("_Own", bound="WrittenRaster")


class WrittenRaster:
    """A context manager that closes the file at the end, and raises UnwritableError if the disk is full."""

    def __init__(  # noqa: PLR0913 - what a GeoTIFF is made of; not every one has a MapFrame
        self,
        path: str,
        shape_hw: tuple[int, int],
        bands: int,
        geotransform: Sequence[float] | None,
        crs_wkt: str,
        options: Sequence[str] = TILED,
    ) -> None:
        """Create the file.

        Args:
            path: The new file.
            shape_hw: (height, width) in pixels.
            bands: Number of bands.
            geotransform: GDAL's six numbers; None without a georeference.
            crs_wkt: WKT of the CRS; empty without one.
            options: GDAL's creation options.

        Raises:
            UnwritableError: GDAL can't write the file.
        """
        self._path = path
        height, width = shape_hw
        with require_written(path):
            driver = gdal.GetDriverByName("GTiff")
            self._dataset = driver.Create(path, width, height, bands, gdal.GDT_Byte, list(options))
            if self._dataset is not None and geotransform is not None:
                self._dataset.SetGeoTransform(geotransform)
            if self._dataset is not None and crs_wkt:
                self._dataset.SetProjection(crs_wkt)

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
