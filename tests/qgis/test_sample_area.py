"""The sample area as it ships: all that a first try needs, and photos that the model that ships can read."""

from __future__ import annotations

import csv
from datetime import datetime
from math import hypot
from pathlib import Path

import pytest
from qgis.core import QgsVectorLayer

PHOTO_COUNT = 12


def truth_of(sample: Path) -> dict:
    """(x, y) of each photo by its name."""
    with (sample / "photos.csv").open(newline="", encoding="utf-8") as file:
        return {row["image"]: (float(row["x"]), float(row["y"])) for row in csv.DictReader(file)}


def test_it_has_annotation_class_table_orthophoto_and_photos(sample):
    from osgeo import gdal

    layer = QgsVectorLayer(str(sample / "landcover.shp"), "annotation", "ogr")
    orthophoto = gdal.Open(str(sample / "orthophoto.tif"))
    photos = [gdal.Open(str(path)) for path in sorted((sample / "photos").iterdir())]
    assert layer.featureCount() > 500
    assert layer.crs().authid() == "EPSG:25832"
    assert layer.fields().names() == ["class", "class_id", "zorder"]
    assert {"building", "water"} < layer.uniqueValues(0)
    assert (orthophoto.RasterXSize, orthophoto.RasterYSize, orthophoto.RasterCount) == (4000, 3000, 3)
    assert {(photo.RasterXSize, photo.RasterYSize, photo.RasterCount) for photo in photos} == {(640, 640, 3)}
    assert sorted(truth_of(sample)) == sorted(path.name for path in (sample / "photos").iterdir())
    assert len(photos) == PHOTO_COUNT


@pytest.mark.slow
def test_the_photos_are_found_with_the_model_that_ships(sample, repository, run_algorithm, tmp_path):
    pytest.importorskip("onnxruntime")
    labels, database, positions = (str(tmp_path / name) for name in ("labels.tif", "area.gpkg", "positions.gpkg"))
    annotation = {"INPUT": str(sample / "landcover.shp"), "CLASS_FIELD": "class", "PRIORITY_FIELD": "zorder"}
    burning = {"CLASS_TABLE": str(sample / "classes.csv"), "PIXEL_SIZE": 1, "OUTPUT": labels}
    run_algorithm("semref:rasterizeannotation", {**annotation, **burning})
    windows = {"WINDOW_SIZE": 640, "STRIDE": 160, "MINIMUM_AREA": 50}
    run_algorithm("semref:builddatabase", {"LABELS": labels, **windows, "DATABASE": database})
    model = str(repository / "models" / "sample_area.onnx")
    photos = [str(path) for path in sorted((sample / "photos").iterdir())[:4]]
    job = {"DATABASE": database, "IMAGES": photos, "MODEL": model, "OUTPUT": positions}
    assert run_algorithm("semref:localizeimages", job)["FIX_COUNT"] == len(photos)
    truth = truth_of(sample)
    for row in QgsVectorLayer(positions, "positions", "ogr").getFeatures():
        x, y = truth[Path(row["image"]).name]
        assert hypot(row["x"] - x, row["y"] - y) < 10


def test_it_holds_a_flight_with_the_times_of_its_photos(sample):
    with (sample / "flight.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["image"] for row in rows] == sorted(path.name for path in (sample / "flight").iterdir())
    times = [datetime.fromisoformat(row["time"]) for row in rows]
    assert {(b - a).total_seconds() for a, b in zip(times, times[1:])} == {12}
    assert len(rows) == 16
