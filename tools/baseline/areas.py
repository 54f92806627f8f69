"""The areas that everything is recorded on: the sample area, a piece of Liechtenstein, a piece of Christchurch."""

from __future__ import annotations

import csv
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from osgeo import gdal, ogr, osr

from . import dumps
from .recorder import Recorder

ROOT = Path(__file__).resolve().parents[2]
LIECHTENSTEIN = "osm_liechtenstein_2021/li_landcover_2021.shp"
CHRISTCHURCH = "lcdb5_christchurch/lcdb5_christchurch.gpkg"
PATCHES = (
    "Urban Parkland/Open Space", "Surface Mine or Dump", "Lake or Pond", "Orchard, Vineyard or Other Perennial Crop",
    "Gorse and/or Broom", "Broadleaved Indigenous Hardwoods", "Deciduous Hardwoods", "Exotic Forest",
)  # fmt: skip
"""Christchurch's reference classes: those with separate patches."""

NOT_LAND = 255
"""Christchurch's code of it is 0, which means unlabelled in a label map."""


@dataclass(frozen=True)
class Area:
    """An area's files and sizes; window and stride are those of its database, in map units."""

    name: str
    labels: str
    database: str
    table: str
    window: float
    stride: float

    def pixels(self) -> np.ndarray:
        """(H, W) the label map."""
        return gdal.Open(self.labels).ReadAsArray()

    def geotransform(self) -> tuple:
        """Of the label map."""
        return gdal.Open(self.labels).GetGeoTransform()

    def epsg(self) -> int:
        """Code of the label map's CRS."""
        return int(osr.SpatialReference(gdal.Open(self.labels).GetProjection()).GetAuthorityCode(None))

    def colors(self) -> np.ndarray:
        """(256, 3) red, green, blue of each class value."""
        dataset = gdal.Open(self.labels)  # the band dies with it
        colors = dataset.GetRasterBand(1).GetRasterColorTable()
        return np.array([colors.GetColorEntry(n)[:3] for n in range(256)], np.uint8)

    def reference_values(self) -> list:
        """Class values of landmarks."""
        found = dumps.geopackage_tables(self.database)["classes"]
        return sorted(row["value"] for row in found if row["role"] == "reference")


def make(recorder: Recorder) -> dict[str, Any]:
    """Makes and records the areas; gives them by name, with the file of another place, of Liechtenstein's south."""
    places: dict[str, Any] = {"sample": _sample(recorder)}
    for name in (LIECHTENSTEIN, CHRISTCHURCH):
        if not (recorder.data / name).exists():
            print(f"Not here and not recorded: {recorder.data / name}")
    if (recorder.data / LIECHTENSTEIN).exists():
        table = recorder.path("liechtenstein/classes.csv")
        values = "building", "bare_land", "water"
        write_class_table(recorder.data / LIECHTENSTEIN, table, [("class_id", "class")], values)
        places["liechtenstein"] = _liechtenstein(recorder, table)
        places["elsewhere"] = _rasterized(recorder, "elsewhere", table, "539000,541000,5217000,5219000")
        _update(recorder, places["liechtenstein"])
    if (recorder.data / CHRISTCHURCH).exists() and not recorder.quick:
        places["christchurch"] = _christchurch(recorder)
    return places


def _sample(recorder: Recorder) -> Area:
    folder = recorder.path("sample")
    subprocess.run([sys.executable, "-m", "tools.sample", folder], cwd=ROOT, check=True)
    recorder.put("sample/files", dumps.folder_files(folder))
    recorder.put_layer("sample/landcover", f"{folder}/landcover.shp")
    for name in ("classes.csv", "photos.csv"):
        recorder.put(f"sample/{name}", Path(folder, name).read_text(encoding="utf-8").splitlines())
    labels = recorder.path("sample_map/labels.tif")
    parameters = {"INPUT": f"{folder}/landcover.shp", "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
    parameters.update(CLASS_TABLE=f"{folder}/classes.csv", PIXEL_SIZE=1.0, OUTPUT=labels)
    recorder.run("sample/rasterized", "rasterizeannotation", parameters)
    area = Area("sample", labels, recorder.path("sample_map/area.gpkg"), f"{folder}/classes.csv", 640.0, 160.0)
    return _built(recorder, area, MINIMUM_AREA=50)


def _rasterized(recorder: Recorder, name: str, table: str, extent: str) -> str:
    """Label map of a piece of Liechtenstein."""
    parameters = {"INPUT": str(recorder.data / LIECHTENSTEIN), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
    labels = recorder.path(f"{name}/labels.tif")
    parameters.update(CLASS_TABLE=table, PIXEL_SIZE=1.0, EXTENT=f"{extent} [EPSG:32632]", OUTPUT=labels)
    recorder.run(f"{name}/rasterized", "rasterizeannotation", parameters)
    return labels


def _liechtenstein(recorder: Recorder, table: str) -> Area:
    labels = _rasterized(recorder, "liechtenstein", table, "538000,542000,5228000,5232000")
    area = Area("liechtenstein", labels, recorder.path("liechtenstein/area.gpkg"), table, 800.0, 200.0)
    return _built(recorder, area, LEVELS="1;1.5", MINIMUM_AREA=80, REFERENCES_PER_VECTOR=12)


def _christchurch(recorder: Recorder) -> Area:
    table = recorder.path("christchurch/classes.csv")
    source = recorder.data / CHRISTCHURCH
    write_class_table(source, table, [(f"Class_{year}", f"Name_{year}") for year in (1996, 2018)], PATCHES)
    for year in (2018, 1996):
        labels = recorder.path(f"christchurch/labels_{year}.tif")
        parameters = {"INPUT": str(source), "CLASS_FIELD": f"Name_{year}", "CLASS_TABLE": table, "PIXEL_SIZE": 12.0}
        parameters.update(EXTENT="1560000,1578000,5170000,5188000 [EPSG:2193]", OUTPUT=labels)
        recorder.run(f"christchurch/rasterized {year}", "rasterizeannotation", parameters)
    recorder.put_raster("christchurch/label map 2018", recorder.path("christchurch/labels_2018.tif"))
    area = Area("christchurch", labels, recorder.path("christchurch/area.gpkg"), table, 6000.0, 1500.0)
    return _built(recorder, area, MINIMUM_AREA=5000)


def _built(recorder: Recorder, area: Area, **settings: Any) -> Area:
    """The area with its database, both recorded."""
    recorder.put_raster(f"{area.name}/label map", area.labels)
    parameters = {"LABELS": area.labels, "WINDOW_SIZE": area.window, "STRIDE": area.stride, "DATABASE": area.database}
    recorder.run(f"{area.name}/built", "builddatabase", {**parameters, **settings})
    recorder.put_database(f"{area.name}/database", area.database)
    return area


def _update(recorder: Recorder, area: Area) -> None:
    """Records what an edited label map makes of a database, compared whole and in the edited places only."""
    edited = recorder.path("liechtenstein/edited.tif")
    shutil.copyfile(area.labels, edited)
    dataset = gdal.Open(edited, gdal.GA_Update)
    band = dataset.GetRasterBand(1)
    for column, row, size, value in ((900, 1100, 60, 4), (1500, 1490, 25, 1), (3050, 2200, 40, 3), (3990, 3990, 10, 1)):
        band.WriteArray(np.full((size, size), value, np.uint8), column, row)
    dataset = band = None
    changed = recorder.path("liechtenstein/changed.geojson")
    _write_square(changed, area.geotransform(), 1480, 1470, 80)
    for name, more in (("whole", {}), ("changed", {"CHANGED": changed})):
        output = recorder.path(f"liechtenstein/updated_{name}.gpkg")
        parameters = {"DATABASE": area.database, "LABELS": edited, "OUTPUT": output, **more}
        recorder.run(f"updated/{name}", "updatedatabase", parameters)
        recorder.put_database(f"updated/{name}/database", output)


def _write_square(path: str, geotransform: tuple, column: int, row: int, size: int) -> None:
    """A GeoJSON layer with one square of the map's pixels."""
    x, y = geotransform[0] + column * geotransform[1], geotransform[3] + row * geotransform[5]
    wkt = f"POLYGON(({x} {y},{x + size} {y},{x + size} {y - size},{x} {y - size},{x} {y}))"
    write_geojson(path, wkt, 32632)


def write_geojson(path: str, wkt: str, epsg: int) -> None:
    """A GeoJSON layer with one feature."""
    text = ogr.CreateGeometryFromWkt(wkt).ExportToJson()
    crs = f'"crs":{{"type":"name","properties":{{"name":"urn:ogc:def:crs:EPSG::{epsg}"}}}}'
    feature = f'{{"type":"Feature","properties":{{"id":1}},"geometry":{text}}}'
    Path(path).write_text(f'{{"type":"FeatureCollection",{crs},"features":[{feature}]}}', encoding="utf-8")


def write_class_table(source: Path, table: str, fields: list, references: tuple) -> None:
    """Class table from pairs of fields, of value and name."""
    dataset = ogr.Open(str(source))
    found = {(int(f.GetField(value)), f.GetField(name)) for f in dataset.GetLayer(0) for value, name in fields}
    with open(table, "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["value", "name", "role"])
        for value, name in sorted(found):
            rows.writerow([value or NOT_LAND, name, "reference" if name in references else "background"])
