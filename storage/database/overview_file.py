"""The overview of a map until it is written: in memory or, of a large map, in a file of its own."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator

import numpy as np
from osgeo import gdal

from ...core.labels.overview import HeldOverview
from ..raster_writer import WrittenRaster

HELD_PIXELS = 256 << 20
"""Of an overview that is held in memory while it is made."""

CACHE_BYTES = 64 << 20
"""Of GDAL, while a map of a larger overview is read and written."""

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


@contextlib.contextmanager
def overview_beside(path: str, shape_hw: tuple[int, int]) -> Iterator[HeldOverview | OverviewFile]:
    """Gives what takes the pieces of an overview, within a ``with`` of its own; if it has a file, that goes at the end.

    Args:
        path: Of the database that it is for.
        shape_hw: (height, width) in pixels.

    Raises:
        LabelMapError: GDAL can't write there.
    """
    if shape_hw[0] * shape_hw[1] <= HELD_PIXELS:
        yield HeldOverview(shape_hw)
        return
    file, cache = f"{path}.overview.tif", gdal.GetCacheMax()
    # By default a share of the machine's memory, which a map this large fills with what goes through once.
    gdal.SetCacheMax(min(cache, CACHE_BYTES))
    try:
        yield OverviewFile(file, shape_hw)
    finally:
        gdal.SetCacheMax(cache)
        with contextlib.suppress(OSError):
            os.unlink(file)
