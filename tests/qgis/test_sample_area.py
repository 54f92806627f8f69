"""The shipped sample area has all that a first test needs, with photos for the shipped model."""

import csv
from datetime import datetime
from pathlib import Path

from osgeo import gdal
from qgis.core import QgsVectorLayer

PHOTO_COUNT = 12


def truth_of(sample: Path) -> dict:
    """Return the (x, y) of each photo by its name."""
    with (sample / "photos.csv").open(newline="", encoding="utf-8") as file:
        return {row["image"]: (float(row["x"]), float(row["y"])) for row in csv.DictReader(file)}


def test_it_has_annotation_class_table_orthophoto_and_photos(sample):
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


def test_it_has_a_flight_with_the_times_of_its_photos(sample):
    with (sample / "flight.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["image"] for row in rows] == sorted(path.name for path in (sample / "flight").iterdir())
    times = [datetime.fromisoformat(row["time"]) for row in rows]
    assert {(b - a).total_seconds() for a, b in zip(times, times[1:])} == {12}
    assert len(rows) == 16
