"""Burning polygons with GDAL into a label map, strip by strip."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from osgeo import gdal, ogr, osr

from ..core.annotation.job import BurnJob
from ..core.geometry.frame import MapFrame
from ..core.labels.class_table import ClassTable
from ..core.labels.counts import count_labels
from .label_map_file import TILE_ROWS, LabelMapFile

STRIP_PIXELS = 16_000_000
"""Pixels burnt and written at a time."""


@dataclass(frozen=True)
class BurnPolygon:
    """One polygon to burn.

    Attributes:
        wkb: Its outline in the target CRS.
        value: Of its class.
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
    ) -> None:
        self._path = path
        self._frame = frame
        self._table = table
        self._layer = BurnLayer(polygons, frame.crs)
        self.counts = np.zeros(256, np.int64)

    def steps(self) -> Iterator[tuple[str, float]]:
        """Yields (what is being done, share of the map written 0…1)."""
        height, width = self._frame.shape_hw
        file = LabelMapFile(self._path, width, height, self._frame.geotransform, self._frame.crs, self._table)
        # One thread compresses a strip while this one burns the next.
        with file as label_map, ThreadPoolExecutor(1) as writer:
            yield "Burning polygons", 0.0
            writing: Future[None] | None = None
            for first, strip in strips_of(self._frame):
                labels = self._layer.burnt(strip, gdal.GDT_Byte)
                self.counts += count_labels(labels)
                if writing is not None:
                    writing.result()
                writing = writer.submit(label_map.write_rows, first, labels)
                yield "Burning polygons", (first + len(labels)) / height
            if writing is not None:
                writing.result()


def strips_of(frame: MapFrame) -> Iterator[tuple[int, MapFrame]]:
    """(first row, frame) of what is burnt and written at a time, from top to bottom.

    Args:
        frame: Of the whole map.
    """
    height, width = frame.shape_hw
    rows = max(TILE_ROWS, STRIP_PIXELS // width // TILE_ROWS * TILE_ROWS)
    for first in range(0, height, rows):
        yield first, frame.part(0, first, (min(rows, height - first), width))


def burn_job(frame: MapFrame, table: ClassTable, polygons: list[BurnPolygon]) -> BurnJob:
    """What ``LabelMapBurning`` would burn, to be burnt elsewhere.

    Args:
        frame: Of the label map.
        table: Of its classes.
        polygons: In any order of priorities.
    """
    sorted_ = bottom_first(polygons)
    return BurnJob(
        frame,
        table,
        np.array([polygon.value for polygon in sorted_], np.uint8),
        np.array([polygon.bounds for polygon in sorted_], np.float64).reshape(-1, 4),
        np.cumsum([len(polygon.wkb) for polygon in sorted_], dtype=np.int64),
        np.frombuffer(b"".join(polygon.wkb for polygon in sorted_), np.uint8),
    )


def burnt_strip(strip: MapFrame, values: np.ndarray, ends: np.ndarray, outlines: np.ndarray) -> np.ndarray:
    """(H, W) uint8 labels of a strip, of what ``BurnJob.within`` gave for it."""
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
