"""From a new orthophoto to an updated database with the plugin's models, as in docs/how-to/build_and_update.md."""

import sqlite3
from pathlib import Path

import pytest
from made_inputs import read_pixels
from osgeo import gdal, ogr
from qgis.core import QgsProcessingException

from sample import files as sample_files
from sample import landscape as landscape_module
from sample import photo as sample_photo
from sample.classes import CLASSES

pytestmark = pytest.mark.slow

FIND, APPLY = "semref:orthophototodisagreements", "semref:correctiontodatabase"
BUILDING = next(entry for entry in CLASSES if entry.name == "building")
SIZE_XY = (620.0, 520.0)
"""Size of a quick sample area in m."""


@pytest.fixture(scope="module")
def folder(run_algorithm, tmp_path_factory):
    """Return the true annotation, one without a building, and the orthophoto; label map and database lack it too."""
    folder = tmp_path_factory.mktemp("round_trip")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(landscape_module, "SIZE_XY", SIZE_XY)
        patch.setattr(landscape_module, "FILL_WINDOW_M", min(SIZE_XY))
        landscape = landscape_module.make_landscape(3)
    photo_hw3 = sample_photo.render(landscape)
    sample_files.write_shapefile(landscape, folder)
    sample_files.write_classes(folder / "classes.csv")
    sample_files.write_orthophoto(landscape, photo_hw3, folder / "orthophoto.tif")
    west, _, _, north, _, _ = gdal.Open(str(folder / "orthophoto.tif")).GetGeoTransform()
    extent = f"{west},{west + SIZE_XY[0]},{north - SIZE_XY[1]},{north}"
    forget_building(folder, extent)
    rasterize(run_algorithm, folder, "wrong.gpkg", extent, "old.tif")
    build(run_algorithm, folder, "old")
    rasterize(run_algorithm, folder, "landcover.shp", extent, "true.tif")
    build(run_algorithm, folder, "true")
    return folder


def forget_building(folder, extent):
    """Write wrong.gpkg: the annotation without its largest building well inside the extent."""
    gdal.VectorTranslate(str(folder / "wrong.gpkg"), str(folder / "landcover.shp"), geometryType="MULTIPOLYGON")
    source = ogr.Open(str(folder / "wrong.gpkg"), update=1)
    layer = source.GetLayer(0)
    left, right, bottom, top = (float(side) for side in extent.split(","))
    layer.SetAttributeFilter(f"class = '{BUILDING.name}'")
    found = []
    for feature in layer:
        shape = feature.GetGeometryRef()
        west, east, south, north = shape.GetEnvelope()
        if west > left + 40 and east < right - 40 and south > bottom + 40 and north < top - 40:
            found.append((shape.Area(), feature.GetFID(), (west, east, south, north)))
    area, fid, box = max(found)
    assert area > 150
    layer.SetAttributeFilter(None)
    layer.DeleteFeature(fid)
    (folder / "building.txt").write_text(",".join(map(str, box)))


def rasterize(run_algorithm, folder, layer, extent, output):
    asked = {"INPUT": str(folder / layer), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder", "PIXEL_SIZE": 1.0}
    asked |= {"CLASS_TABLE": str(folder / "classes.csv"), "EXTENT": extent, "OUTPUT": str(folder / output)}
    run_algorithm("semref:rasterizeannotation", asked)


def build(run_algorithm, folder, name):
    asked = {"LABELS": str(folder / f"{name}.tif"), "WINDOW_SIZE": 120, "STRIDE": 50, "MINIMUM_AREA": 40}
    run_algorithm("semref:builddatabase", {**asked, "DATABASE": str(folder / f"{name}.gpkg")})


def apply(run_algorithm, folder, output, layer="landcover.shp", **parameters):
    defaults = {
        "INPUT": str(folder / layer),
        "CLASS_FIELD": "class",
        "PRIORITY_FIELD": "zorder",
        "CLASS_TABLE": str(folder / "classes.csv"),
        "LABELS": str(folder / "old.tif"),
        "DATABASE": str(folder / "old.gpkg"),
        "rasterize:Corrected label map": str(output / "corrected.tif"),
        "update:Updated database": str(output / "updated.gpkg"),
    }
    return run_algorithm(APPLY, {**defaults, **parameters})


def windows(path):
    with sqlite3.connect(path) as connection:
        return connection.execute("SELECT * FROM windows ORDER BY fid").fetchall()


def test_what_the_annotation_lacks_is_found_and_corrected_in_the_database(run_algorithm, repository, folder, tmp_path):
    asked = {"IMAGE": str(folder / "orthophoto.tif"), "MODEL": str(repository / "models" / "sample_area.onnx")}
    outputs = {"segment:Predicted label map": "predicted.tif", "compare:Disagreements": "disagreements.gpkg"}
    outputs["compare:Report"] = "report.html"
    outputs = {key: str(tmp_path / name) for key, name in outputs.items()}
    results = run_algorithm(FIND, {**asked, "LABELS": str(folder / "old.tif"), "MINIMUM_AREA": 30, **outputs})
    assert Path(results["segment:Predicted label map"]).exists() and Path(results["compare:Report"]).exists()
    west, east, south, north = map(float, (folder / "building.txt").read_text().split(","))
    source = ogr.Open(results["compare:Disagreements"])
    layer = source.GetLayer(0)
    layer.SetSpatialFilterRect(west, south, east, north)
    layer.SetAttributeFilter(f"predicted_class = '{BUILDING.name}'")
    found = sorted(layer, key=lambda feature: -feature["area"])
    assert found[0]["area"] > 0.3 * (east - west) * (north - south)
    assert found[0]["annotated_class"] != BUILDING.name
    # The user draws the building and marks the place as done.
    done = str(tmp_path / "done.gpkg")
    # By name, because style and metadata are in tables beside it.
    chosen = {"layers": [layer.GetName()], "where": f"fid = {found[0].GetFID()}"}
    gdal.VectorTranslate(done, results["compare:Disagreements"], **chosen)
    results = apply(run_algorithm, folder, tmp_path, CHANGED=done)
    assert (read_pixels(results["rasterize:Corrected label map"]) == read_pixels(folder / "true.tif")).all()
    assert windows(results["update:Updated database"]) == windows(folder / "true.gpkg") != windows(folder / "old.gpkg")


def test_without_changed_areas_the_corrections_are_found(run_algorithm, folder, tmp_path):
    results = apply(run_algorithm, folder, tmp_path)
    assert windows(results["update:Updated database"]) == windows(folder / "true.gpkg")


def test_another_class_table_is_refused(run_algorithm, folder, tmp_path):
    table = tmp_path / "other.csv"
    table.write_text((folder / "classes.csv").read_text().replace("building", "house"))
    with pytest.raises(QgsProcessingException):
        apply(run_algorithm, folder, tmp_path, CLASS_TABLE=str(table))
    assert not (tmp_path / "updated.gpkg").exists()
