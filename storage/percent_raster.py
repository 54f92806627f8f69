"""How sure a network is of what it sees, as a GeoTIFF of percent."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..core.segmentation.certainty import NO_DATA
from .gdal_errors import gdal_failures
from .raster_writer import TILED, WrittenRaster


class PercentRaster(WrittenRaster):
    """A GeoTIFF being written, a band for each name: 0…100 percent, 255 is no data."""

    def __init__(
        self,
        path: str,
        shape_hw: tuple[int, int],
        geotransform: Sequence[float] | None,
        crs_wkt: str,
        names: Sequence[str],
    ) -> None:
        """Creates the file.

        Args:
            path: Of the new file.
            shape_hw: (height, width) in pixels.
            geotransform: GDAL's six numbers; None without a georeference.
            crs_wkt: WKT of the CRS; empty for none.
            names: Of the bands.

        Raises:
            LabelMapError: GDAL can't write there.
        """
        # Band by band as it is written; gray, so that three bands are not taken for red, green and blue.
        options = (*TILED, "INTERLEAVE=BAND", "PHOTOMETRIC=MINISBLACK")
        super().__init__(path, shape_hw, len(names), geotransform, crs_wkt, options)
        for number, name in enumerate(names, start=1):
            band = self._dataset.GetRasterBand(number)
            band.SetDescription(name)
            band.SetUnitType("%")
            band.SetNoDataValue(NO_DATA)

    def write_rows(self, first_row: int, percents_chw: np.ndarray) -> None:
        """Writes whole rows of all bands, (bands, rows, W) uint8, through to the file."""
        with gdal_failures() as failures:
            for number, percent_hw in enumerate(percents_chw, start=1):
                self._write(number, 0, first_row, percent_hw)
            self._dataset.FlushCache()
        self._raise(failures)
