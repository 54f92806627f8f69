"""Burning polygons with GDAL into a label map, strip by strip."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from osgeo import gdal, ogr, osr

from ..core.geometry.frame import MapFrame
from ..core.labels.class_table import ClassTable
from ..core.labels.sources import count_labels
from .label_map_file import TILE_ROWS, LabelMapFile

STRIP_PIXELS = 16_000_000
"""Pixels burnt and written at a time."""


@dataclass(frozen=True)
class BurnPolygon:
    """One polygon to burn.

    Attributes:
        wkb: Its outline in the target CRS.
        priority: Higher ones lie on top.
        bounds: (x_min, y_min, x_max, y_max).
    """

    wkb: bytes
    value: int
    priority: float
    bounds: tuple[float, float, float, float]


class LabelMapBurning:
    """Writes a label map; iterate ``steps()`` to the end, then ``counts`` has the (256,) pixels of each value."""

    def __init__(
        self,
        path: str,
        frame: MapFrame,
        table: ClassTable,
        polygons: list[BurnPolygon],
        burn: Callable[[Iterable[tuple]], Iterator[np.ndarray]] | None = None,
    ) -> None:
        """Nothing is burnt yet.

        Args:
            path: Of the new file.
            frame: Its pixels.
            polygons: In any order of priorities.
            burn: Takes what ``strip_polygons`` gives and gives the (H, W) labels of each strip, from elsewhere; None to
                burn them here.
        """
        self._path = path
        self._frame = frame
        self._table = table
        self._polygons = polygons
        self._burn = burn or self._burnt
        self.counts = np.zeros(256, np.int64)

    def steps(self) -> Iterator[tuple[str, float]]:
        """Yields (what is being done, share of the map written 0…1)."""
        height, width = self._frame.shape_hw
        file = LabelMapFile(self._path, width, height, self._frame.geotransform, self._frame.crs, self._table)
        # One thread compresses a strip while this one burns the next.
        with file as label_map, ThreadPoolExecutor(1) as writer:
            yield "Burning polygons", 0.0
            writing: Future[None] | None = None
            found = self._burn(strip_polygons(self._frame, self._polygons))
            for (first, _), labels in zip(strips_of(self._frame), found):
                self.counts += count_labels(labels)
                if writing is not None:
                    writing.result()
                writing = writer.submit(label_map.write_rows, first, labels)
                yield "Burning polygons", (first + len(labels)) / height
            if writing is not None:
                writing.result()

    def _burnt(self, _: Iterable[tuple]) -> Iterator[np.ndarray]:
        layer = BurnLayer(self._polygons, self._frame.crs)
        return (layer.burnt(strip, gdal.GDT_Byte) for _, strip in strips_of(self._frame))


def strips_of(frame: MapFrame) -> Iterator[tuple[int, MapFrame]]:
    """(first row, frame) of what is burnt and written at a time, from top to bottom."""
    height, width = frame.shape_hw
    rows = max(TILE_ROWS, STRIP_PIXELS // width // TILE_ROWS * TILE_ROWS)
    for first in range(0, height, rows):
        yield first, frame.part(0, first, (min(rows, height - first), width))


def strip_polygons(frame: MapFrame, polygons: list[BurnPolygon]) -> Iterator[tuple]:
    """Yields of each strip geotransform, shape, and (N,) values, (N,) ends and WKB outlines of what may reach into it.

    Args:
        polygons: In any order of priorities.
    """
    ordered = bottom_first(polygons)
    bounds = np.array([polygon.bounds for polygon in ordered], np.float64).reshape(-1, 4)
    for _, strip in strips_of(frame):
        left, bottom, right, top = strip.extent
        x_min, y_min, x_max, y_max = bounds.T
        chosen = np.flatnonzero((x_min <= right) & (x_max >= left) & (y_min <= top) & (y_max >= bottom))
        some = [ordered[number] for number in chosen]
        values = np.array([polygon.value for polygon in some], np.uint8)
        ends = np.cumsum([len(polygon.wkb) for polygon in some], dtype=np.int64)
        outlines = np.frombuffer(b"".join(polygon.wkb for polygon in some), np.uint8)
        yield strip.geotransform, strip.shape_hw, values, ends, outlines


def burnt_strip(strip: MapFrame, values: np.ndarray, ends: np.ndarray, outlines: np.ndarray) -> np.ndarray:
    """(H, W) uint8 labels of a strip, of what ``strip_polygons`` gave for it."""
    whole, begins = outlines.tobytes(), [0, *ends.tolist()[:-1]]
    polygons = [
        BurnPolygon(whole[begin:end], value, 0.0, strip.extent)
        for begin, end, value in zip(begins, ends.tolist(), values.tolist())
    ]
    return BurnLayer(polygons, strip.crs).burnt(strip, gdal.GDT_Byte)


def bottom_first(polygons: list[BurnPolygon]) -> list[BurnPolygon]:
    """As they are burnt; of one priority in their order."""
    return sorted(polygons, key=lambda polygon: polygon.priority)


class BurnLayer:
    """Polygons in memory, bottom first, to be burnt strip by strip with GDAL."""

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

    def burnt(self, frame: MapFrame, kind: int) -> np.ndarray:
        """(H, W) values burnt into pixels, 0 where no polygon lies.

        Args:
            frame: Where the pixels lie.
            kind: GDAL's data type of the values.
        """
        height, width = frame.shape_hw
        strip = gdal.GetDriverByName("MEM").Create("", width, height, 1, kind)
        strip.SetGeoTransform(frame.geotransform)
        strip.SetProjection(frame.crs)
        self._layer.SetSpatialFilterRect(*frame.extent)
        gdal.RasterizeLayer(strip, [1], self._layer, options=["ATTRIBUTE=value"])
        return strip.ReadAsArray()


_PIXELS = MapFrame("", (0.0, 1.0, 0.0, 0.0, 0.0, -1.0))
"""An image's pixels as a map: x is the column, y the row, negative."""


class AreaMask:
    """The pixels of an image whose centers lie in polygons: a PixelMask."""

    def __init__(self, polygons: Sequence[bytes]) -> None:
        """Takes WKB of polygons, x the column and y the negative row of the image."""
        self._layer = BurnLayer([BurnPolygon(wkb, 1, 0.0, (0.0, 0.0, 0.0, 0.0)) for wkb in polygons], "")

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """(height, width) bool: which pixels of a piece of the image lie in the polygons."""
        return self._layer.burnt(_PIXELS.part(column, row, (height, width)), gdal.GDT_Byte) > 0
