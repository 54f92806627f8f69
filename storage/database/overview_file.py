"""The overview of a map that is too large for memory, in a file of its own until it is written."""

from __future__ import annotations

import numpy as np
from osgeo import gdal

from ..written_raster import WrittenRaster

_OPTIONS = ("TILED=YES", "SPARSE_OK=TRUE", "BIGTIFF=YES")
"""Not compressed: pieces come in any order and end within tiles, which would be compressed again and again."""


class OverviewFile(WrittenRaster):
    """Takes pieces in any order within a ``with``; ``dataset`` is the whole afterwards."""

    def __init__(self, path: str, shape_hw: tuple[int, int]) -> None:
        """Creates the file.

        Args:
            path: Of the new file.
            shape_hw: (height, width) in pixels.

        Raises:
            LabelMapError: GDAL can't write there.
        """
        self._shape_hw = shape_hw
        super().__init__(path, shape_hw, 1, None, "", _OPTIONS)

    def put(self, column: int, row: int, piece_hw: np.ndarray) -> None:
        """Writes a piece (h, w) uint8 whose first pixel lies there."""
        self._write(1, column, row, piece_hw)

    def dataset(self) -> gdal.Dataset:
        """The pixels alone, as a dataset that takes a georeference and colors and has none of the file's own words."""
        height, width = self._shape_hw
        made = gdal.GetDriverByName("VRT").Create("", width, height, 1, gdal.GDT_Byte)
        source = (
            f'<SimpleSource><SourceFilename relativeToVRT="0">{self._path}</SourceFilename><SourceBand>1</SourceBand>'
            f'<SourceProperties RasterXSize="{width}" RasterYSize="{height}" DataType="Byte"/></SimpleSource>'
        )
        made.GetRasterBand(1).SetMetadataItem("source_0", source, "new_vrt_sources")
        return made
