"""One class for all polygons, named by a parameter instead of a field."""

from pathlib import Path

import pytest
from made_inputs import read_pixels, read_rows, square, write_layer
from qgis.core import QgsProcessingException, QgsVectorLayer

from semref.core.labels.class_table import class_table_from_csv
from semref.storage.label_maps import stored_class_table
from semref.storage.rasters import open_raster

RASTERIZE = "semref:rasterizeannotation"


@pytest.fixture
def houses(tmp_path):
    """Return a layer of 25 squares; its only field numbers them."""
    features = [(square(70 * (n % 5), 70 * (n // 5) + 3 * n % 17, 12), n) for n in range(25)]
    return str(write_layer(tmp_path / "houses.gpkg", features, [("osm_id", "integer")]))


def test_a_database_of_buildings_needs_a_layer_and_a_name(run_algorithm, houses, tmp_path):
    given = {"INPUT": houses, "CLASS": "building", "WINDOW_SIZE": 200, "STRIDE": 50}
    labels, area = str(tmp_path / "labels.tif"), str(tmp_path / "area.gpkg")
    outputs = {"rasterize:Label map": labels, "build:Reference database": area}
    run_algorithm("semref:annotationtodatabase", {**given, **outputs})
    assert [row["class"] for row in read_rows(area, "references")] == [1] * 25
    # The only class of a layer is that of the landmarks.
    assert [one.name for one in stored_class_table(open_raster(labels), labels).references] == ["building"]


def test_the_name_is_found_in_a_class_table_and_counts_more_than_a_field(run_algorithm, houses, tmp_path):
    (tmp_path / "classes.csv").write_text("value,name,color,role\n7,building,#ff0000,reference\n")
    given = {"INPUT": houses, "CLASS_FIELD": "osm_id", "CLASS": " building ", "OUTPUT": str(tmp_path / "labels.tif")}
    table = {"CLASS_TABLE": str(tmp_path / "classes.csv")}
    run_algorithm(RASTERIZE, {**given, **table})
    assert 7 in read_pixels(Path(given["OUTPUT"]))
    with pytest.raises(QgsProcessingException, match="barn"):
        run_algorithm(RASTERIZE, {**given, **table, "CLASS": "barn"})


def test_check_repair_and_class_table_take_it_as_well(run_algorithm, houses, tmp_path):
    given = {"INPUT": houses, "CLASS": "building"}
    assert run_algorithm("semref:checkannotation", {**given, "ISSUES": str(tmp_path / "i.gpkg")})["ERROR_COUNT"] == 0
    repaired = run_algorithm("semref:repairannotation", {**given, "OUTPUT": str(tmp_path / "r.gpkg")})["OUTPUT"]
    layer = QgsVectorLayer(repaired, "repaired", "ogr")
    assert layer.featureCount() == 25
    assert [category.value() for category in layer.renderer().categories()] == ["building"]
    assert layer.renderer().classAttribute() == "'building'"
    table = run_algorithm("semref:classtable", {**given, "OUTPUT": str(tmp_path / "classes.csv")})["OUTPUT"]
    (one,) = class_table_from_csv(Path(table).read_text(encoding="utf-8"))
    assert (one.name, one.is_reference) == ("building", True)


def test_without_a_field_and_a_name_nothing_runs(run_algorithm, houses, tmp_path):
    with pytest.raises(QgsProcessingException, match="class field"):
        run_algorithm(RASTERIZE, {"INPUT": houses, "OUTPUT": str(tmp_path / "labels.tif")})
