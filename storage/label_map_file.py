"""Write label maps as GeoTIFF with class table, colors and names inside."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
from osgeo import gdal

from ..core.geometry.frame import MapFrame
from ..core.labels.class_table import ClassTable
from .gdal_errors import close, require_written
from .pictures import WrittenRaster

CLASS_TABLE_ITEM = "SEMREF_CLASS_TABLE"
"""Metadata item of a label map with its class table as CSV."""

CLASS_BIAS_ITEM = "SEMREF_CLASS_BIAS"
"""Metadata item of a label map that a network made: class_bias of its metadata, “{}” if it has no class offsets."""

_PASTED_ROWS = 1024

TILE_ROWS = 256
"""Rows of a GeoTIFF tile. Writing whole tiles compresses each tile once."""


class LabelMapFile(WrittenRaster):
    """Writer of a label map: GeoTIFF, uint8, tiled, DEFLATE, with classes and colors inside."""

    def __init__(self, path: str, frame: MapFrame, table: ClassTable, class_bias: str = "") -> None:
        """Create the file.

        Args:
            class_bias: Text of the network's class offsets; empty if no network made the labels.

        Raises:
            UnwritableError: GDAL can't write the file.
        """
        super().__init__(path, frame, 1)
        self._dataset.SetMetadataItem(CLASS_TABLE_ITEM, table.to_csv())
        if class_bias:
            self._dataset.SetMetadataItem(CLASS_BIAS_ITEM, class_bias)
        # TIFF palettes have no transparency: without a no-data value unlabeled pixels would be black.
        self._dataset.GetRasterBand(1).SetNoDataValue(0)
        set_class_colors(self._dataset.GetRasterBand(1), table)
        set_attribute_table(self._dataset.GetRasterBand(1), table)

    def write_rows(self, first_row: int, labels_hw: np.ndarray) -> None:
        """Write (rows, W) uint8 labels and flush them; may run in another thread, one call at a time."""
        with require_written(self._path):
            self._write(1, 0, first_row, labels_hw)
            self._dataset.FlushCache()


def paste_labels(path: str, part: str) -> None:
    """Overwrite the extent of ``part`` in a label map.

    Args:
        part: A label map on the same pixel grid, inside the extent of the first.

    Raises:
        UnwritableError: GDAL can't read the part or write the label map.
    """
    with require_written(path):
        whole, piece = gdal.OpenEx(path, gdal.OF_RASTER | gdal.OF_UPDATE), gdal.OpenEx(part, gdal.OF_RASTER)
        if whole is not None and piece is not None:
            (left, size, _, top, *_), (part_left, _, _, part_top, *_) = whole.GetGeoTransform(), piece.GetGeoTransform()
            column, row = round((part_left - left) / size), round((top - part_top) / size)
            for first in range(0, piece.RasterYSize, _PASTED_ROWS):
                rows = min(_PASTED_ROWS, piece.RasterYSize - first)
                labels = piece.GetRasterBand(1).ReadAsArray(0, first, piece.RasterXSize, rows)
                whole.GetRasterBand(1).WriteArray(labels, column, row + first)
        close(whole)
        del whole


def whole_tile_rows(pieces: Iterable[tuple[int, np.ndarray]]) -> Iterator[tuple[int, np.ndarray]]:
    """Yield (first row, (…, rows, W) values) in pieces that end at a row of GeoTIFF tiles, except the last piece."""
    held = []
    first = 0
    for start, values in pieces:
        end = start + values.shape[-2]
        ready = end // TILE_ROWS * TILE_ROWS
        if ready <= first:
            held.append(values)
            continue
        held.append(values[..., : ready - start, :])
        yield first, np.concatenate(held, axis=-2)
        first, held = ready, [values[..., ready - start :, :]]
    if held and sum(values.shape[-2] for values in held):
        yield first, np.concatenate(held, axis=-2)


def set_class_colors(band: gdal.Band, table: ClassTable) -> None:
    """Set the color table (0 is transparent) and the category names; for a GeoTIFF GDAL writes names to .aux.xml."""
    colors = gdal.ColorTable()
    last = max([c.value for c in table], default=0)
    names = [""] * (last + 1)
    colors.SetColorEntry(0, (0, 0, 0, 0))
    for value in range(1, last + 1):
        colors.SetColorEntry(value, (0, 0, 0, 255))
    for c in table:
        if c.value:
            colors.SetColorEntry(c.value, (*c.rgb, 255))
        names[c.value] = c.name
    names[0] = names[0] or "unlabeled"
    band.SetRasterColorTable(colors)
    band.SetRasterCategoryNames(names)


def set_attribute_table(band: gdal.Band, table: ClassTable) -> None:
    """Set GDAL's raster attribute table: value, name, color and role of each class; for a GeoTIFF in .aux.xml."""
    attributes = gdal.RasterAttributeTable()
    columns = (
        ("Value", gdal.GFT_Integer, gdal.GFU_MinMax),
        ("Class", gdal.GFT_String, gdal.GFU_Name),
        ("Red", gdal.GFT_Integer, gdal.GFU_Red),
        ("Green", gdal.GFT_Integer, gdal.GFU_Green),
        ("Blue", gdal.GFT_Integer, gdal.GFU_Blue),
        ("Role", gdal.GFT_String, gdal.GFU_Generic),
    )
    for name, kind, usage in columns:
        attributes.CreateColumn(name, kind, usage)
    rows = [(c.value, c.name, *c.rgb, c.role) for c in table if c.value]
    attributes.SetRowCount(len(rows))
    for row, cells in enumerate(rows):
        for column, cell in enumerate(cells):
            (attributes.SetValueAsString if isinstance(cell, str) else attributes.SetValueAsInt)(row, column, cell)
    attributes.SetTableType(gdal.GRTT_THEMATIC)
    band.SetDefaultRAT(attributes)
