"""What is measured: the annotation of an area, its label map and databases, made once and kept in the work folder."""

from __future__ import annotations

import csv
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

TOOLS = Path(__file__).resolve().parents[1]

REFERENCE_CLASSES = ("building", "bare_land", "water")
PIXEL_SIZE = 1.0
MINIMUM_AREA = 100.0

TILES = "dubai_aerial"
TILE_CLASSES = (
    "value,name,color,role\n1,building,#3c1098,reference\n2,land_unpaved,#8429f6,reference\n3,road,#6ec1e4,reference\n"
    "4,vegetation,#fedd3a,reference\n5,water,#e2a929,reference\n"
)
"""Annotated aerial photos, and the class table of their labels."""

_TILE_ROWS = 256


@dataclass(frozen=True)
class Area:
    """An annotated area: shapefile with the fields class, class_id and zorder; window and stride in meters."""

    name: str
    sentence: str
    annotation: Path
    class_table: Path
    window_size: float
    stride: float
    dense_stride: float


@dataclass(frozen=True)
class Run:
    """What a benchmark gets.

    Attributes:
        area: what is measured
        data: folder of the real data
        work: folder of intermediate files
        repetitions: turns of what is timed
        quick: smaller cases, to try the benchmark itself
        count: images or trials a case; None for as many as the benchmark wants
        only: parts of names of the cases wanted; all if empty
        half: of Liechtenstein that images are cut from; constants were fitted on the northern one
        model: segmentation model, for photos
        tile: of dubai_aerial that the model was not trained on
        python: runs ``python -m core``; one without QGIS makes the proof
        pictures: folder for pictures of the documentation; None for none
        is_kept: nothing is measured, what is kept in the work folder is told
    """

    area: Area
    data: Path
    work: Path
    repetitions: int
    quick: bool
    count: int | None = None
    only: tuple[str, ...] = ()
    half: str = "south"
    model: Path | None = None
    tile: int = 6
    python: str = sys.executable
    pictures: Path | None = None
    is_kept: bool = False

    def wants(self, case: str) -> bool:
        """Whether a case is among those to be measured; a part that begins with “-” names those that are not."""
        name, left_out = case.casefold(), [part[1:].casefold() for part in self.only if part.startswith("-")]
        wanted = [part.casefold() for part in self.only if not part.startswith("-")]
        return not any(part in name for part in left_out) and (not wanted or any(part in name for part in wanted))

    def how_many(self, full: int, quick: int) -> int:
        """Trials a case: what --count says, else as many as the benchmark wants."""
        return self.count or (quick if self.quick else full)

    def rasterize_parameters(self, output: Path) -> dict:
        return {
            "INPUT": str(self.area.annotation),
            "CLASS_FIELD": "class",
            "PRIORITY_FIELD": "zorder",
            "CLASS_TABLE": str(self.area.class_table),
            "PIXEL_SIZE": PIXEL_SIZE,
            "OUTPUT": str(output),
        }

    def build_parameters(self, labels: Path, stride: float, output: Path) -> dict:
        return {
            "LABELS": str(labels),
            "REFERENCE_CLASSES": ";".join(REFERENCE_CLASSES),
            "WINDOW_SIZE": self.area.window_size,
            "STRIDE": stride,
            "MINIMUM_AREA": MINIMUM_AREA,
            "DATABASE": str(output),
        }

    def label_map(self) -> Path:
        """The area's label map, made by the algorithm unless an earlier run left it."""
        from bench import plugin

        path = self.work / f"{self.area.name}.tif"
        if not path.exists():
            plugin.run_algorithm("rasterizeannotation", self.rasterize_parameters(path))
        return path

    def database(self, stride: float) -> Path:
        """The area's database at a stride, made by the algorithm unless an earlier run left it."""
        from bench import plugin

        path = self.work / f"{self.area.name}_{stride:g}.gpkg"
        if not path.exists():
            plugin.run_algorithm("builddatabase", self.build_parameters(self.label_map(), stride, path))
        return path


def main_area(data: Path, work: Path, sample: bool = False) -> Area:
    """Liechtenstein if its data is there, else the sample area; the area's sentence says which."""
    annotation = data / "osm_liechtenstein_2021" / "li_landcover_2021.shp"
    if sample or not annotation.exists():
        reason = "" if sample else " (the real data is not here)"
        return sample_area(work, f"Measured on the sample area of tools/sample{reason}.")
    table = work / "liechtenstein_classes.csv"
    write_class_table(annotation, table)
    sentence = "Liechtenstein 2021, 18,493 polygons, at 1 m."
    return Area("liechtenstein", sentence, annotation, table, 1280.0, 350.0, 50.0)


def sample_area(work: Path, sentence: str = "") -> Area:
    """The sample area with its own windows of 640 m."""
    folder = work / "sample"
    if not (folder / "landcover.shp").exists():
        command = [sys.executable, "-m", "tools.sample", str(folder.absolute()), "--label-images"]
        subprocess.run(command, cwd=TOOLS.parent, check=True, stdout=subprocess.DEVNULL)
    return Area("sample", sentence, folder / "landcover.shp", folder / "classes.csv", 640.0, 160.0, 40.0)


def write_class_table(annotation: Path, table: Path) -> None:
    """Class table of a layer from its fields class and class_id."""
    from osgeo import ogr

    dataset = ogr.Open(str(annotation))
    found = {(f.GetField("class_id"), f.GetField("class")) for f in dataset.GetLayer(0)}
    with table.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["value", "name", "role"])
        for value, name in sorted(found):
            rows.writerow([value, name, "reference" if name in REFERENCE_CLASSES else "background"])


def read_labels(path: Path) -> np.ndarray:
    """A whole label map, (H, W) uint8, with GDAL alone."""
    from osgeo import gdal

    return gdal.Open(str(path)).ReadAsArray()


def write_labels(
    path: Path, template: Path, width: int, height: int, rows_of: Callable[[np.ndarray], np.ndarray]
) -> None:
    """A label map of another size with the place, CRS and classes of `template`.

    `rows_of`: row numbers (n,) → labels (n, width) uint8; asked for a few at a time.
    """
    from osgeo import gdal

    from semref.storage.label_map_file import CLASS_TABLE_ITEM

    source = gdal.Open(str(template))
    options = ["TILED=YES", "COMPRESS=DEFLATE", "ZLEVEL=1", "BIGTIFF=IF_SAFER"]
    target = gdal.GetDriverByName("GTiff").Create(str(path), width, height, 1, gdal.GDT_Byte, options)
    target.SetGeoTransform(source.GetGeoTransform())
    target.SetProjection(source.GetProjection())
    target.SetMetadataItem(CLASS_TABLE_ITEM, source.GetMetadataItem(CLASS_TABLE_ITEM))
    for first in range(0, height, _TILE_ROWS):
        rows = np.arange(first, min(first + _TILE_ROWS, height))
        target.GetRasterBand(1).WriteArray(np.ascontiguousarray(rows_of(rows)), 0, first)
    target.FlushCache()
