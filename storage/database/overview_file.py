"""Collect the overview of a map before it is written: in memory, or in a temporary file for a large map."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from html import escape

import numpy as np
from osgeo import gdal

from ...core.geometry.frame import MapFrame
from ...core.labels.overview import HeldOverview
from ..pictures import WrittenRaster

HELD_PIXELS = 256 << 20
"""Largest overview in memory, in pixels."""

CACHE_BYTES = 64 << 20
"""GDAL's cache while a map with a larger overview is processed."""

_OPTIONS = ("TILED=YES", "SPARSE_OK=TRUE", "BIGTIFF=YES")
"""Not compressed: parts arrive in any order and end inside tiles, which would be compressed repeatedly."""


class OverviewFile(WrittenRaster):
    """Collector of parts in any order inside a ``with`` block; ``dataset()`` is the whole overview afterwards."""

    def __init__(self, path: str, shape_hw: tuple[int, int]) -> None:
        """Create the file.

        Args:
            shape_hw: (height, width) in pixels.

        Raises:
            UnwritableError: GDAL can't write the file.
        """
        self._shape_hw = shape_hw
        super().__init__(path, MapFrame("", (), shape_hw), 1, _OPTIONS)

    def put(self, column: int, row: int, piece_hw: np.ndarray) -> None:
        """Write a part (h, w) uint8 from ``column``, ``row`` on."""
        self._write(1, column, row, piece_hw)

    def dataset(self) -> gdal.Dataset:
        """Return the pixels as a dataset without metadata, to which georeference and colors can be added."""
        height, width = self._shape_hw
        made = gdal.GetDriverByName("VRT").Create("", width, height, 1, gdal.GDT_Byte)
        source = (
            f'<SimpleSource><SourceFilename relativeToVRT="0">{escape(self._path, quote=False)}</SourceFilename>'
            f"<SourceBand>1</SourceBand>"
            f'<SourceProperties RasterXSize="{width}" RasterYSize="{height}" DataType="Byte"/></SimpleSource>'
        )
        made.GetRasterBand(1).SetMetadataItem("source_0", source, "new_vrt_sources")
        return made


@contextlib.contextmanager
def overview_beside(path: str, shape_hw: tuple[int, int]) -> Iterator[HeldOverview | OverviewFile]:
    """Yield a collector of an overview, to be used as a context manager; its file is deleted at the end.

    Args:
        shape_hw: (height, width) in pixels.

    Raises:
        UnwritableError: GDAL can't write the file.
    """
    if shape_hw[0] * shape_hw[1] <= HELD_PIXELS:
        yield HeldOverview(shape_hw)
        return
    file, cache = f"{path}.overview.tif", gdal.GetCacheMax()
    # The default is a share of the memory, which a large map would fill with blocks that are read once.
    gdal.SetCacheMax(min(cache, CACHE_BYTES))
    try:
        yield OverviewFile(file, shape_hw)
    finally:
        gdal.SetCacheMax(cache)
        with contextlib.suppress(OSError):
            os.unlink(file)
