"""A GeoTIFF of bytes while it is written, piece by piece."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import numpy as np
from osgeo import gdal

from ..core.errors import UnwritableError
from .gdal_errors import close, gdal_failure, gdal_failures

TILED = ("TILED=YES", "COMPRESS=DEFLATE", "BIGTIFF=IF_SAFER")

_Own = TypeVar("_Own", bound="WrittenRaster")


class WrittenRaster:
    """A context manager: leaving it closes the file, and raises LabelMapError when GDAL could not write (disk full)."""

    def __init__(  # noqa: PLR0913 - what a GeoTIFF is made of; not every one has a MapFrame
        self,
        path: str,
        shape_hw: tuple[int, int],
        bands: int,
        geotransform: Sequence[float] | None,
        crs_wkt: str,
        options: Sequence[str] = TILED,
    ) -> None:
        """Creates the file.

        Args:
            path: Of the new file.
            shape_hw: (height, width) in pixels.
            bands: How many.
            geotransform: GDAL's six numbers; None without a georeference.
            crs_wkt: WKT of the CRS; empty for none.
            options: GDAL's creation options.

        Raises:
            UnwritableError: GDAL can't write there.
        """
        self._path = path
        height, width = shape_hw
        with gdal_failures() as failures:
            driver = gdal.GetDriverByName("GTiff")
            self._dataset = driver.Create(path, width, height, bands, gdal.GDT_Byte, list(options))
            if self._dataset is not None and geotransform is not None:
                self._dataset.SetGeoTransform(geotransform)
            if self._dataset is not None and crs_wkt:
                self._dataset.SetProjection(crs_wkt)
        self._raise(failures)

    def __enter__(self: _Own) -> _Own:
        return self

    def __exit__(self, kind: object, error: object, traceback: object) -> None:
        # Closing may still write: before the file's folder is removed, and heeding errors.
        dataset, self._dataset = self._dataset, None
        with gdal_failures() as failures:
            close(dataset)
            del dataset
        if error is None:
            self._raise(failures)

    def _write(self, band: int, column: int, row: int, values_hw: np.ndarray) -> None:
        self._dataset.GetRasterBand(band).WriteArray(values_hw, column, row)

    def _raise(self, failures: Sequence[str]) -> None:
        if failures:
            raise UnwritableError(
                "{path} can't be written: {reason}.", path=self._path, reason=gdal_failure(failures[0])
            )
