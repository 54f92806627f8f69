"""Compare two label maps on one grid, and make polygons of their disagreements."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator

import numpy as np
from osgeo import gdal

from ..core.annotation.outlines import areas_and_wkb, outline_regions, to_map
from ..core.errors import LabelMapError, UnwritableError
from ..core.steps import Steps, part
from .gdal_errors import gdal_failure, require_written
from .label_maps import GdalLabels
from .polygonize import rows_of
from .rasters import WITHOUT_GEOREFERENCE, pixel_area

_PIXELS_AT_ONCE = 8_000_000


class LabelMapPair:
    """An annotated and a predicted label map, read on the grid of the annotated map where both overlap.

    Each pixel gets the predicted label at its center.

    Attributes:
        geotransform: GDAL's six numbers of the overlap.
    """

    def __init__(self, reference: str, predicted: str) -> None:
        """Open the two files, which must have the same CRS.

        Args:
            reference: The annotated label map.

        Raises:
            LabelMapError: The maps don't overlap or can't be compared.
        """
        self.reference, self.predicted = GdalLabels(reference), GdalLabels(predicted)
        grids = [labels.dataset.GetGeoTransform(can_return_null=True) for labels in (self.reference, self.predicted)]
        (height, width), (other_height, other_width) = self.reference.shape_hw, self.predicted.shape_hw
        if None in grids and (grids[0] != grids[1] or (height, width) != (other_height, other_width)):
            raise LabelMapError(
                "The reference has {width} × {height} pixels and the prediction {other_width} × {other_height}, and "
                "not both have a georeference; compare images of one size or two georeferenced maps.",
                width=width,
                height=height,
                other_width=other_width,
                other_height=other_height,
            )
        grid, other = (transform or WITHOUT_GEOREFERENCE for transform in grids)
        if grid != other and any(transform[2] or transform[4] for transform in (grid, other)):
            raise LabelMapError("One of the maps is rotated against the other; warp both to a north-up grid first.")
        # For each pixel of REFERENCE along an axis: the pixel of PREDICTED at its center.
        columns = _pixels_at(grid[0], grid[1], width, other[0], other[1])
        rows = _pixels_at(grid[3], grid[5], height, other[3], other[5])
        self._first_column, self._columns = _inside(columns, other_width)
        self._first_row, self._rows = _inside(rows, other_height)
        if not len(self._columns) or not len(self._rows):
            raise LabelMapError("The reference and the prediction don't overlap; choose maps of the same ground.")
        x0, dx, x_turn, y0, y_turn, dy = grid
        x = x0 + self._first_column * dx + self._first_row * x_turn
        self.geotransform = (x, dx, x_turn, y0 + self._first_column * y_turn + self._first_row * dy, y_turn, dy)

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) of the overlap in pixels."""
        return len(self._rows), len(self._columns)

    @property
    def pixel_size(self) -> float:
        """Edge of a pixel, map units (pixels without a georeference)."""
        return float(pixel_area(self.geotransform) ** 0.5)

    def blocks(self) -> Iterator[tuple[int, np.ndarray, np.ndarray]]:
        """Yield (first row, annotated labels, predicted labels) from top to bottom, (rows, W) uint8 each."""
        height, width = self.shape_hw
        at_once = max(1, _PIXELS_AT_ONCE // width)
        for first in range(0, height, at_once):
            rows = self._rows[first : first + at_once]
            yield first, *self._read(0, first, width, len(rows))

    def pieces(self, edge: int) -> Iterator[tuple[float, complex, np.ndarray, np.ndarray]]:
        """Yield (share done, upper left corner, annotated labels, predicted labels) of squares, cut at the edges.

        The corner is right and down in pixels; the labels are (h, w) uint8.
        """
        height, width = self.shape_hw
        for first in range(0, height, edge):
            for left in range(0, width, edge):
                size = min(edge, width - left), min(edge, height - first)
                yield first / height, complex(left, first), *self._read(left, first, *size)

    def _read(self, left: int, first: int, width: int, height: int) -> tuple[np.ndarray, np.ndarray]:
        columns, rows = self._columns[left : left + width], self._rows[first : first + height]
        x, y = int(columns.min()), int(rows.min())
        annotated = self.reference.read(self._first_column + left, self._first_row + first, width, height)
        predicted = self.predicted.read(x, y, int(columns.max()) - x + 1, int(rows.max()) - y + 1)
        return annotated, predicted[rows - y][:, columns - x]


def _pixels_at(origin: float, step: float, count: int, other_origin: float, other_step: float) -> np.ndarray:
    centers = origin + (np.arange(count) + 0.5) * step
    # Rounding must not decide for a center on the border of two pixels.
    return np.floor((centers - other_origin) / other_step + 1e-6).astype(np.int64)


def _inside(pixels: np.ndarray, size: int) -> tuple[int, np.ndarray]:
    """Return (index of the first pixel, pixels) inside a map of ``size`` pixels."""
    found = np.flatnonzero((pixels >= 0) & (pixels < size))
    return (int(found[0]), pixels[found]) if len(found) else (0, pixels[:0])


class DisagreementMap:
    """A raster of codes to polygonize. A context manager: its files are in a temporary folder, deleted at the end."""

    def __init__(self, pair: LabelMapPair) -> None:
        self._pair, self._folder = pair, tempfile.TemporaryDirectory(prefix="semref-compare-")
        height, width = pair.shape_hw
        self._path = os.path.join(self._folder.name, "codes.tif")
        options = ["TILED=YES", "COMPRESS=DEFLATE", "ZLEVEL=1", "BIGTIFF=IF_SAFER"]
        self._raster = gdal.GetDriverByName("GTiff").Create(self._path, width, height, 1, gdal.GDT_UInt16, options)
        if self._raster is None:
            raise UnwritableError("{path} can't be written: {reason}.", path=self._path, reason=gdal_failure())

    def __enter__(self) -> DisagreementMap:
        return self

    def __exit__(self, *error: object) -> None:
        # Close the file before its folder is removed.
        self._raster = None
        self._folder.cleanup()

    def write_rows(self, first_row: int, codes_hw: np.ndarray) -> None:
        """Write (rows, W) uint16 codes, 0 for no disagreement. Raises UnwritableError when the disk is full."""
        with require_written(self._path):
            self._raster.GetRasterBand(1).WriteArray(codes_hw, 0, first_row)

    def polygons(self, minimum_area: float) -> Steps[list[tuple[int, float, bytes]]]:
        """Return (code, area in square map units, WKB) of the polygons, largest first, equal areas from the top down.

        Raises:
            LabelMapError: The codes can't be read.
            UnwritableError: The disk is full.
        """
        with require_written(self._path):
            self._raster.FlushCache()
        yield "Making polygons of the disagreements", 0.0
        outlining = outline_regions(rows_of(self._raster.GetRasterBand(1)), self._pair.shape_hw)
        codes, outlines = yield from part("Making polygons of the disagreements", outlining, 0.0, 1.0)
        transform = self._pair.geotransform
        areas, wkb = areas_and_wkb(to_map(outlines, transform))
        # In pixels, areas have no rounding errors.
        pixels, _ = areas_and_wkb(outlines)
        kept = [n for n in np.argsort(-pixels, kind="stable") if pixels[n] * pixel_area(transform) >= minimum_area]
        return [(int(codes[n]), float(areas[n]), wkb[n]) for n in kept]
