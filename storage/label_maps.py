"""Label maps on disk: their values, their class tables, and the grid that they must have."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Callable

import numpy as np
from osgeo import gdal

from ..core.errors import LabelMapError
from ..core.labels.class_colors import chosen_colors
from ..core.labels.class_table import ClassTable, LandCoverClass, class_table_from_csv, class_table_from_values
from ..core.labels.sources import ArrayLabels, LabelSource, count_labels
from ..core.steps import Steps
from .gdal_errors import read_by_gdal
from .label_map_file import CLASS_TABLE_ITEM
from .rasters import open_raster

HELD_PIXELS = 400_000_000
"""Largest label map that is kept in memory while a database is built; larger maps are read piece by piece."""

_COUNTED_AT_ONCE = 8_000_000

_INTEGER_NAMES = ("Byte", "Int8", "UInt16", "Int16", "UInt32", "Int32", "UInt64", "Int64")
_INTEGER_TYPES = {getattr(gdal, f"GDT_{name}") for name in _INTEGER_NAMES if hasattr(gdal, f"GDT_{name}")}
"""Integer types of this GDAL; 64-bit types exist from 3.5 on, Int8 from 3.7 on."""


class GdalLabels:
    """A LabelSource in a file: one band of integers 0–255."""

    def __init__(self, path: str, keeps_blocks: bool = False) -> None:
        """Open the map.

        Args:
            keeps_blocks: Whether GDAL's cache keeps the blocks of parts, for work that reads the same places again.
                Blocks of whole rows are always dropped, since rows are read once and in order.

        Raises:
            ImageError: The file can't be read.
            LabelMapError: The file is not a label map.
        """
        self._path = path
        self._keeps_blocks = keeps_blocks
        self.dataset = open_raster(path)
        self._band = self.dataset.GetRasterBand(1)
        if self.dataset.RasterCount != 1:
            raise LabelMapError(
                "{path} has {bands} bands; a label map has one: decode a color image with “Decode color labels” first.",
                path=path,
                bands=self.dataset.RasterCount,
            )
        if self._band.DataType not in _INTEGER_TYPES:
            kind = gdal.GetDataTypeName(self._band.DataType)
            raise LabelMapError(
                "{path} holds {kind} values; a label map holds whole numbers from 0 to 255.", path=path, kind=kind
            )
        self._nodata = self._band.GetNoDataValue()

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self.dataset.RasterYSize, self.dataset.RasterXSize

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """Return (height, width) uint8 labels, 0 for no data.

        Raises:
            ImageError: The file is damaged.
            LabelMapError: A value is not in 0…255.
        """
        block = read_by_gdal(self._path, self._band.ReadAsArray, column, row, width, height)
        # Blocks that are not read again would only fill GDAL's cache.
        if not self._keeps_blocks or width == self.dataset.RasterXSize:
            self.dataset.FlushCache()
        if self._nodata is not None and self._nodata != 0:
            block[block == self._nodata] = 0
        return np.ascontiguousarray(block) if block.dtype == np.uint8 else as_labels(block, self._path)


def as_labels(values: np.ndarray, path: str) -> np.ndarray:
    """Return integers as uint8 labels. Raises LabelMapError for a value of the file that is not in 0…255."""
    if values.size and (values.min() < 0 or values.max() > 255):
        found = int(values.max() if values.max() > 255 else values.min())
        raise LabelMapError(
            "{path} has the value {found}; a label map holds class values from 0 to 255.", path=path, found=found
        )
    return values.astype(np.uint8)


def hold_labels(labels: GdalLabels) -> Steps[LabelSource]:
    """Read a label map into memory, so that it is decoded once; return a map of more than HELD_PIXELS itself."""
    height, width = labels.shape_hw
    if height * width > HELD_PIXELS:
        return labels
    held = np.empty((height, width), np.uint8)
    rows = max(1, _COUNTED_AT_ONCE // width)
    for first in range(0, height, rows):
        last = min(first + rows, height)
        held[first:last] = labels.read(0, first, width, last - first)
        yield "Reading the label map", last / height
    return ArrayLabels(held)


@dataclass(frozen=True)
class RasterFile:
    """A raster file with the properties of its QGIS layer that GDAL does not have.

    Attributes:
        path: Source for GDAL.
        crs_wkt: WKT of the layer's CRS; empty without one.
        is_metric: Whether that CRS is projected with meters as unit.
        styled_classes: Classes of the layer's style, if any.
    """

    path: str
    crs_wkt: str = ""
    is_metric: bool = False
    styled_classes: tuple[LandCoverClass, ...] = ()


def stored_class_table(dataset: gdal.Dataset, path: str) -> ClassTable | None:
    """Return the class table inside a label map that SemRef made; None without one."""
    text = dataset.GetMetadataItem(CLASS_TABLE_ITEM)
    return class_table_from_csv(text, f"the class table inside {path}") if text else None


def named_classes(dataset: gdal.Dataset) -> tuple[LandCoverClass, ...]:
    """Return classes from GDAL's category names and color table; empty if names repeat."""
    band = dataset.GetRasterBand(1)
    colors = band.GetRasterColorTable()
    named = [(v, name) for v, name in enumerate(band.GetRasterCategoryNames() or []) if 0 < v <= 255 and name]
    found = []
    for (value, name), chosen in zip(named, chosen_colors(named)):
        entry = colors.GetColorEntry(value) if colors is not None and value < colors.GetCount() else None
        color = "#{:02x}{:02x}{:02x}".format(*entry[:3]) if entry else chosen
        found.append(LandCoverClass(value, name, color))
    names = [c.name for c in found]
    return tuple(found) if len(set(names)) == len(names) else ()


def class_table_of_map(labels: GdalLabels, file: RasterFile) -> ClassTable | None:
    """Return the class table inside the map, or one of its category names, or of its layer's style, or None."""
    stored = stored_class_table(labels.dataset, file.path)
    if stored is not None:
        return stored
    classes = named_classes(labels.dataset) or file.styled_classes
    return ClassTable(classes) if classes else None


def count_values(labels: GdalLabels, canceled: Callable[[], bool]) -> np.ndarray:
    """Return (256,) pixels per value of the whole map; zeros if canceled."""
    height, width = labels.shape_hw
    rows = max(1, _COUNTED_AT_ONCE // width)
    counts = np.zeros(256, np.int64)
    for first in range(0, height, rows):
        counts += count_labels(labels.read(0, first, width, min(rows, height - first)))
        if canceled():
            return np.zeros(256, np.int64)
    return counts


def class_table_of_values(counts: np.ndarray) -> ClassTable:
    """Return a class table of the values that occur; ``counts``: (256,) pixels per value."""
    return class_table_from_values(int(v) for v in np.flatnonzero(counts) if v)


def require_map_grid(transform: Sequence[float] | None, path: str) -> None:
    """Raise LabelMapError unless a georeference is a north-up grid of square pixels.

    Args:
        transform: GDAL's six numbers; None without a georeference.
        path: Name of the raster for the message.
    """
    if transform is None:
        raise LabelMapError("{path} has no georeference, so its windows would have no place on the map.", path=path)
    _, pixel_x, turn_x, _, turn_y, pixel_y = transform
    if turn_x or turn_y or pixel_y >= 0 or pixel_x <= 0:
        raise LabelMapError("{path} is rotated or mirrored; warp it to a north-up grid first.", path=path)
    if abs(pixel_x + pixel_y) > 1e-6 * pixel_x:
        raise LabelMapError(
            "{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.",
            path=path,
            pixel_x=pixel_x,
            pixel_y=-pixel_y,
        )


def require_classes_of(labels: GdalLabels, table: ClassTable, path: str) -> None:
    """Raise LabelMapError if a label map and a database have different names for a class value.

    Args:
        path: Name of the label map for the message.
    """
    for found in stored_class_table(labels.dataset, path) or named_classes(labels.dataset):
        known = table.by_value(found.value)
        if known is not None and known.name != found.name:
            raise LabelMapError(
                "{path} calls the class {value} “{name}” and the database “{known}”; rasterize the map with the "
                "database’s class table.",
                path=path,
                value=found.value,
                name=found.name,
                known=known.name,
            )
