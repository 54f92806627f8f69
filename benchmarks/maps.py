"""Label maps and databases of the maps in maps.toml, created by the plugin's algorithms and kept in the work folder."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.ground import Ground
from benchmarks.toml import read_toml

MAPS = read_toml(Path(__file__).with_name("maps.toml"))
USUAL = {"pixel_size": 1.0, "window": 1280.0, "stride": 350.0, "minimum_area": 100.0}
LAND = ("building", "bare_land", "water")
MOVED_M = 500
UNLABELED_CODE = 255
"""Value for class code 0, because 0 means unlabeled in a label map."""


class NoDataError(Exception):
    """The data of a map is missing."""


@dataclass(frozen=True)
class World:
    """Folders and size of a benchmark run.

    Attributes:
        data: Folder of the real data.
        work: Folder of intermediate files, kept between runs.
        models: Folder of networks, for photos.
        count: Images per row; None for the number in the scenario.
    """

    data: Path
    work: Path
    models: Path | None = None
    count: int | None = None

    def ground(self, database: str, images: str = "", half: str = "") -> Ground:
        """Return the ground with images of one map and the database of the same or another map."""
        return _ground(self, database, images or database, half)

    def label_map(self, name: str) -> Path:
        """Return the label map (GeoTIFF) of a map.

        Raises:
            NoDataError: The data is missing.
        """
        path, one = self.work / f"{name}.tif", settings(name)
        if path.exists():
            return path
        if "seed" in one:
            write_sample(self.work / "sample")
            return run_rasterize(
                self.work / "sample" / "landcover.shp", path, self.work / "sample" / "classes.csv", one
            )
        source = self.data / one.get("annotation", one.get("extract", ""))
        if not source.exists():
            raise NoDataError(f"{source.name} is not here.")
        if "extract" in one:
            source = self._classified(name, source, one)
            table = self._rule_table()
        else:
            table = self._class_table(name, source, one)
        return run_rasterize(source, path, table, one)

    def database(self, name: str, stride: float | None = None) -> Path:
        """Return the database of a map, with the default or another stride."""
        one = settings(name)
        path = self.work / f"{name}_{stride or one['stride']:g}.gpkg"
        if not path.exists():
            run_algorithm("builddatabase", build_parameters(name, self.label_map(name), path, stride))
        return path

    def _classified(self, name: str, extract: Path, one: dict[str, Any]) -> Path:
        from osgeo import gdal

        from semref.processing.algorithms.set_up_area import rules_of

        gdal.UseExceptions()
        metric = {what: self.work / f"{name}_{what}.gpkg" for what in ("multipolygons", "lines")}
        for what in metric if one.get("lines") else ["multipolygons"]:
            kind = "MULTIPOLYGON" if what == "multipolygons" else "LINESTRING"
            srs = f"EPSG:{one['epsg']}"
            gdal.VectorTranslate(str(metric[what]), str(extract), layers=[what], dstSRS=srs, geometryType=kind)
        parameters = {"INPUT": str(metric["multipolygons"]), "OUTPUT": str(self.work / f"{name}_classes.gpkg")}
        if one.get("lines"):
            parameters["LINES"] = str(metric["lines"])
        if one.get("line_errors"):
            spoil_lines(metric["lines"], *one["line_errors"])
        if one.get("classes"):
            parameters["RULES"] = str(self.work / f"{name}_rules.csv")
            Path(parameters["RULES"]).write_text(rules_of(one["classes"]), encoding="utf-8")
        run_algorithm("classifyopenstreetmap", parameters)
        return Path(parameters["OUTPUT"])

    def _rule_table(self) -> Path:
        from semref.processing.algorithms.classify_openstreetmap import RULES_PATH
        from semref.storage.text_tables import read_rules

        names = read_rules(str(RULES_PATH)).classes
        return _write_table(self.work / "rules_classes.csv", list(enumerate(names, 1)), LAND)

    def _class_table(self, name: str, source: Path, one: dict[str, Any]) -> Path:
        """Return the classes of all dates of a source, so that maps of two dates have the same values."""
        from osgeo import ogr

        layer, found = ogr.Open(str(source)), set()
        others = [other for other in map(settings, MAPS) if other.get("annotation") == one["annotation"]]
        for feature in layer.GetLayer(0):
            for other in others:
                value = int(feature.GetField(other["value_field"]))
                found.add((value or UNLABELED_CODE, feature.GetField(other["class_field"])))
        return _write_table(self.work / f"{name}_classes.csv", sorted(found), one["references"])


@cache
def _ground(world: World, database: str, images: str, half: str) -> Ground:
    from semref.storage.database.reader import read_database

    one = settings(database)
    content = read_database(str(world.database(database)), with_overview=True)
    labels = aligned(world, images, content.parameters.frame) if images != database else read(world.label_map(images))
    return Ground(labels, content, half, round(one["window"] / one["pixel_size"]))


def aligned(world: World, images: str, frame: Any) -> np.ndarray:
    """Return labels of another date on the pixels of a database's map; 0 for missing labels."""
    from osgeo import gdal

    gdal.UseExceptions()
    left, bottom, right, top = frame.extent
    options = {"format": "MEM", "outputBounds": (left, bottom, right, top), "xRes": frame.pixel_size}
    return gdal.Warp("", str(world.label_map(images)), yRes=frame.pixel_size, **options).ReadAsArray()


def settings(name: str) -> dict[str, Any]:
    """Return the entry of a map in maps.toml."""
    one = MAPS[name]
    return {**(settings(one["like"]) if "like" in one else USUAL), **one}


def build_parameters(name: str, labels: Path, output: Path, stride: float | None = None) -> dict[str, Any]:
    """Return the parameters for semref:builddatabase."""
    one = settings(name)
    found = {"LABELS": str(labels), "WINDOW_SIZE": one["window"], "STRIDE": stride or one["stride"]}
    return {**found, "MINIMUM_AREA": one["minimum_area"], "DATABASE": str(output)}


def run_rasterize(annotation: Path, output: Path, table: Path, one: dict[str, Any]) -> Path:
    """Run semref:rasterizeannotation."""
    is_extract = "extract" in one
    parameters = {
        "INPUT": str(annotation),
        "CLASS_FIELD": one.get("class_field", "class"),
        "PRIORITY_FIELD": one.get("priority_field", "priority" if is_extract else "zorder" if "seed" in one else None),
        "CLASS_TABLE": str(table),
        "PIXEL_SIZE": one["pixel_size"],
        "OTHER_GROUND": "classes" in one,
        "OUTPUT": str(output),
    }
    run_algorithm("rasterizeannotation", parameters)
    return output


def run_algorithm(name: str, parameters: dict[str, Any]) -> list[str]:
    """Run ``semref:name`` like the toolbox and return the lines of its log."""
    import processing
    from qgis.core import QgsProcessingFeedback

    feedback = QgsProcessingFeedback(False)
    processing.run(f"semref:{name}", parameters, feedback=feedback)
    return [line for line in feedback.textLog().splitlines() if line.strip()]


def read(path: Path) -> np.ndarray:
    """Read all bands of a raster with GDAL."""
    from osgeo import gdal

    return gdal.Open(str(path)).ReadAsArray()


def read_photo(path: Path) -> np.ndarray:
    """Read a photo as (H, W, 3) uint8."""
    return np.ascontiguousarray(np.moveaxis(read(path)[:3], 0, 2))


def spoil_lines(path: Path, missing: float, spurious: float) -> None:
    """Remove a share of the lines of a file, and add turned copies of a share, moved by up to MOVED_M."""
    from osgeo import ogr
    from shapely.affinity import rotate, translate
    from shapely.geometry import LineString

    data = ogr.Open(str(path), 1)
    layer, rng = data.GetLayer(0), np.random.default_rng(MOVED_M)
    lines = {feature.GetFID(): feature.Clone() for feature in layer}
    layer.StartTransaction()
    for number, feature in lines.items():
        if rng.random() < spurious:
            line = np.array(feature.GetGeometryRef().GetPoints())[:, :2]
            angle, middle = rng.uniform(0, 360), tuple(line.mean(axis=0))
            turned = rotate(LineString(line), -angle, origin=middle)
            moved = translate(turned, *rng.uniform(-MOVED_M, MOVED_M, 2))
            copy = feature.Clone()
            copy.SetFID(-1)
            copy.SetGeometry(ogr.CreateGeometryFromWkb(moved.wkb))
            layer.CreateFeature(copy)
        if rng.random() < missing:
            layer.DeleteFeature(number)
    layer.CommitTransaction()


def write_sample(folder: Path, seed: int = 1671) -> None:
    """Create polygons and classes of the sample area if they are missing."""
    if not (folder / "landcover.shp").exists():
        from sample.files import write_classes, write_shapefile
        from sample.landscape import make_landscape

        folder.mkdir(parents=True, exist_ok=True)
        write_shapefile(make_landscape(seed), folder)
        write_classes(folder / "classes.csv")


def _write_table(path: Path, classes: list[tuple[int, str]], references: tuple[str, ...] | list[str]) -> Path:
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["value", "name", "role"])
        rows.writerows([value, name, "reference" if name in references else "background"] for value, name in classes)
    return path
