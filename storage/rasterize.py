"""Rasterize polygons with GDAL into a label map, strip by strip."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from osgeo import gdal, ogr, osr

from ..core.annotation.raster_losses import RegionRuns, join_runs, runs_of_strip
from ..core.geometry.frame import MapFrame
from ..core.labels.class_table import ClassTable
from ..core.labels.sources import count_labels
from ..core.steps import Steps
from .label_map_file import TILE_ROWS, LabelMapFile
from .rasters import WITHOUT_GEOREFERENCE

if TYPE_CHECKING:
    from ..core.annotation.check import DrawnRegion

STRIP_PIXELS = 16_000_000
"""Pixels per strip."""


@dataclass(frozen=True)
class BurnPolygon:
    """A polygon to rasterize.

    Attributes:
        wkb: Outline in the target CRS.
        priority: Polygons of higher priority cover others.
        bounds: (x_min, y_min, x_max, y_max) in the target CRS.
    """

    wkb: bytes
    value: int
    priority: float
    bounds: tuple[float, float, float, float]


def burn_label_map(
    path: str,
    frame: MapFrame,
    table: ClassTable,
    polygons: list[BurnPolygon],
    burn: Callable[[Iterable[tuple]], Iterator[np.ndarray]] | None = None,
) -> Steps[np.ndarray]:
    """Write a label map of polygons; return (256,) pixels per value.

    Args:
        burn: Function from the results of ``strip_polygons`` to the (H, W) labels of each strip, which workers
            execute; None to rasterize in this process.
    """
    counts = np.zeros(256, np.int64)
    file = LabelMapFile(path, frame, table)
    # One thread compresses a strip while this one rasterizes the next.
    with file, ThreadPoolExecutor(1) as writer:
        yield "Rasterizing polygons", 0.0
        writing: Future[None] | None = None
        if burn is None:
            layer = BurnLayer(polygons, frame.crs)
            found = (layer.rasterize(strip, gdal.GDT_Byte) for _, strip in strips_of(frame, STRIP_PIXELS))
        else:
            found = burn(strip_polygons(frame, polygons))
        for (first, _), labels in zip(strips_of(frame, STRIP_PIXELS), found):
            counts += count_labels(labels)
            if writing is not None:
                writing.result()
            writing = writer.submit(file.write_rows, first, labels)
            yield "Rasterizing polygons", (first + len(labels)) / frame.shape_hw[0]
        if writing is not None:
            writing.result()
    return counts


def strips_of(frame: MapFrame, pixels: int) -> Iterator[tuple[int, MapFrame]]:
    """Yield (first row, frame) of strips with about ``pixels`` pixels, from top to bottom."""
    height, width = frame.shape_hw
    rows = max(TILE_ROWS, pixels // width // TILE_ROWS * TILE_ROWS)
    for first in range(0, height, rows):
        yield first, frame.part(0, first, (min(rows, height - first), width))


def strip_polygons(frame: MapFrame, polygons: list[BurnPolygon]) -> Iterator[tuple]:
    """Yield each strip with the polygons that may overlap it, as ``rasterize_strip`` takes them.

    Yields:
        Geotransform, shape (H, W), (N,) values, (N,) end offsets, and the bytes of N concatenated WKB outlines.
    """
    ordered = bottom_first(polygons)
    bounds = np.array([polygon.bounds for polygon in ordered], np.float64).reshape(-1, 4)
    for _, strip in strips_of(frame, STRIP_PIXELS):
        left, bottom, right, top = strip.extent
        x_min, y_min, x_max, y_max = bounds.T
        chosen = np.flatnonzero((x_min <= right) & (x_max >= left) & (y_min <= top) & (y_max >= bottom))
        some = [ordered[number] for number in chosen]
        values = np.array([polygon.value for polygon in some], np.uint8)
        ends = np.cumsum([len(polygon.wkb) for polygon in some], dtype=np.int64)
        outlines = np.frombuffer(b"".join(polygon.wkb for polygon in some), np.uint8)
        yield strip.geotransform, strip.shape_hw, values, ends, outlines


def rasterize_strip(strip: MapFrame, values: np.ndarray, ends: np.ndarray, outlines: np.ndarray) -> np.ndarray:
    """Return (H, W) uint8 labels of a strip from the arrays of ``strip_polygons``."""
    whole, begins = outlines.tobytes(), [0, *ends.tolist()[:-1]]
    polygons = [
        BurnPolygon(whole[begin:end], value, 0.0, strip.extent)
        for begin, end, value in zip(begins, ends.tolist(), values.tolist())
    ]
    return BurnLayer(polygons, strip.crs).rasterize(strip, gdal.GDT_Byte)


def bottom_first(polygons: list[BurnPolygon]) -> list[BurnPolygon]:
    """Sort polygons by priority, which is the order of rasterizing; equal priorities keep their order."""
    return sorted(polygons, key=lambda polygon: polygon.priority)


class BurnLayer:
    """Polygons in a GDAL layer in memory, lowest priority first."""

    def __init__(self, polygons: list[BurnPolygon], crs_wkt: str) -> None:
        driver = gdal.GetDriverByName("Memory") or gdal.GetDriverByName("MEM")
        self._dataset = driver.Create("", 0, 0, 0, gdal.GDT_Unknown)
        self._layer = self._dataset.CreateLayer("polygons", osr.SpatialReference(crs_wkt), ogr.wkbPolygon)
        self._layer.CreateField(ogr.FieldDefn("value", ogr.OFTInteger))
        definition = self._layer.GetLayerDefn()
        for polygon in bottom_first(polygons):
            feature = ogr.Feature(definition)
            feature.SetField(0, polygon.value)
            feature.SetGeometryDirectly(ogr.CreateGeometryFromWkb(polygon.wkb))
            self._layer.CreateFeature(feature)

    def rasterize(self, frame: MapFrame, kind: int) -> np.ndarray:
        """Return (H, W) polygon values, 0 outside all polygons; ``kind``: GDAL's data type of the values."""
        height, width = frame.shape_hw
        strip = gdal.GetDriverByName("MEM").Create("", width, height, 1, kind)
        strip.SetGeoTransform(frame.geotransform)
        strip.SetProjection(frame.crs)
        self._layer.SetSpatialFilterRect(*frame.extent)
        gdal.RasterizeLayer(strip, [1], self._layer, options=["ATTRIBUTE=value"])
        return strip.ReadAsArray()


def burn_regions(regions: Sequence[DrawnRegion], frame: MapFrame) -> Steps[RegionRuns]:
    """Rasterize regions that don't overlap, as a label map is; region n of the list has the number n + 1."""
    polygons = [BurnPolygon(region.wkb, n, 0.0, region.bounds) for n, region in enumerate(regions, start=1)]
    layer, found = BurnLayer(polygons, frame.crs), []
    for first, strip in strips_of(frame, STRIP_PIXELS // 4):
        found.append(runs_of_strip(layer.rasterize(strip, gdal.GDT_Int32), first))
        yield "Rasterizing landmarks", (first + strip.shape_hw[0]) / frame.shape_hw[0]
    return join_runs(found)


_PIXELS = MapFrame("", WITHOUT_GEOREFERENCE)
"""Pixel coordinates of an image as a map: x is the column, y the negative row."""


class AreaMask:
    """A PixelMask: the pixels of an image with their center in a polygon."""

    def __init__(self, polygons: Sequence[bytes]) -> None:
        """Take WKB polygons; x is the column and y the negative row of the image."""
        self._layer = BurnLayer([BurnPolygon(wkb, 1, 0.0, (0.0, 0.0, 0.0, 0.0)) for wkb in polygons], "")

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """Return (height, width) bool of the pixels inside the polygons, for a part of the image."""
        return self._layer.rasterize(_PIXELS.part(column, row, (height, width)), gdal.GDT_Byte) > 0
