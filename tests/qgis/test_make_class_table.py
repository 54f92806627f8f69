from pathlib import Path

import pytest
from made_inputs import read_pixels, read_rows, square, write_layer
from osgeo import gdal, ogr
from qgis.core import QgsProcessingException, QgsVectorLayer
from rasterized import styled_layer

from semref.core.labels.class_table import class_table_from_csv
from semref.processing.jobs.annotation import PRESETS
from semref.storage.label_maps import stored_class_table
from semref.storage.rasters import open_raster
from semref.storage.text_tables import read_class_table

CLASS_TABLE, RASTERIZE = "semref:classtable", "semref:rasterizeannotation"


@pytest.fixture
def made(run_algorithm, tmp_path):
    def run(layer, **parameters):
        output = str(tmp_path / "classes.csv")
        given = {"INPUT": layer, "CLASS_FIELD": "class", "OUTPUT": output, **parameters}
        results = run_algorithm(CLASS_TABLE, given)
        return class_table_from_csv(Path(output).read_text(encoding="utf-8")), results

    return run


def layer_of(tmp_path, *values, kind="text") -> str:
    features = [(square(10 + 40 * n, 10, 30), value) for n, value in enumerate(values)]
    return str(write_layer(tmp_path / "annotation.gpkg", features, [("class", kind)]))


def test_a_layers_classes_get_values_colors_and_roles_and_keep_the_colors_of_its_style(made, tmp_path):
    layer = layer_of(tmp_path, "water", "forest", "building", "water", None)
    table, results = made(layer)
    assert results["CLASS_COUNT"] == 3
    assert [(c.value, c.name) for c in table] == [(1, "building"), (2, "forest"), (3, "water")]
    assert [c.name for c in table.references] == ["building", "water"]
    assert table.find("water").color == "#3a87c8"
    assert [c.name for c in made(layer, REFERENCE_CLASSES="forest")[0].references] == ["forest"]
    path = Path(layer_of(tmp_path, 4, 9, kind="integer"))
    table, _ = made(styled_layer(path, [(4, "Lake", "#112233"), (9, "House", "#445566")]))
    assert [(c.value, c.name, c.color) for c in table] == [(4, "Lake", "#112233"), (9, "House", "#445566")]


def test_the_table_is_good_for_the_layer_it_was_made_of(made, run_algorithm, tmp_path):
    layer = layer_of(tmp_path, "311", "112", "something else")
    table, _ = made(layer, PRESET=3)
    assert [c.value for c in table] == [2, 23, 24]
    output = str(tmp_path / "labels.tif")
    given = {"INPUT": layer, "CLASS_FIELD": "class", "CLASS_TABLE": str(tmp_path / "classes.csv"), "OUTPUT": output}
    assert run_algorithm(RASTERIZE, given)["CLASS_COUNT"] == 3


@pytest.mark.parametrize("preset", PRESETS)
def test_presets_are_class_tables_whose_colors_differ_and_that_have_landmarks(preset):
    table = read_class_table(PRESETS[preset])
    assert len({c.color for c in table}) >= 0.95 * len(table)
    assert 3 <= len(table.references) < len(table)


def test_a_layer_without_classes_or_an_unknown_reference_class_is_refused(made, tmp_path):
    with pytest.raises(QgsProcessingException, match="Reference classes"):
        made(layer_of(tmp_path, "water"), REFERENCE_CLASSES="lava")
    with pytest.raises(QgsProcessingException, match="No feature of “annotation” has a class"):
        made(layer_of(tmp_path, None))
    with pytest.raises(QgsProcessingException, match="“annotation” has no features to use"):
        made(QgsVectorLayer("Polygon?crs=EPSG:32632&field=class:string", "annotation", "memory"))
    assert not list(tmp_path.glob("classes*"))


def test_a_label_map_has_its_classes_as_gdals_attribute_table_also_in_an_old_ones_place(run_algorithm, tmp_path):
    output = str(tmp_path / "labels.tif")
    for names in (["building", "forest", "water"], ["grass", "road"]):
        (tmp_path / names[0]).mkdir()
        layer = layer_of(tmp_path / names[0], *names)
        run_algorithm(RASTERIZE, {"INPUT": layer, "CLASS_FIELD": "class", "OUTPUT": output})
        raster = gdal.Open(output)
        band = raster.GetRasterBand(1)
        rows, usages = band.GetDefaultRAT(), (gdal.GFU_MinMax, gdal.GFU_Name, gdal.GFU_Red)
        columns = [rows.GetColOfUsage(usage) for usage in usages]
        found = [[rows.GetValueAsString(row, column) for column in columns] for row in range(rows.GetRowCount())]
        colors = band.GetRasterColorTable()
        reds = [colors.GetColorEntry(n)[0] for n in range(1, len(names) + 1)]
        assert found == [[str(n), name, str(red)] for n, (name, red) in enumerate(zip(names, reds), 1)]
        assert band.GetRasterCategoryNames() == ["unlabeled", *names]


@pytest.mark.real_data
def test_the_classes_of_lcdb_are_called_as_its_data_call_them(real_data):
    """Includes every class of the layer at any of its dates, by number and name."""
    source = ogr.Open(str(real_data("lcdb5_christchurch/lcdb5_christchurch.gpkg")))
    name = source.GetLayer(0).GetName()
    table = {c.value: c.name for c in read_class_table(PRESETS["LCDB v5 (New Zealand)"])}
    for year in (1996, 2001, 2008, 2012, 2018):
        found = source.ExecuteSQL(f'SELECT DISTINCT "Class_{year}", "Name_{year}" FROM "{name}"')
        rows = {int(row.GetField(0)): row.GetField(1) for row in found}
        assert rows == {value: table[value] for value in rows}
        source.ReleaseResultSet(found)


def test_ground_without_data_gets_a_class_of_its_own_and_no_other_s(made, tmp_path):
    """Urban Atlas has polygons of no data, which are no land cover; the shipped table leaves them out."""
    table, _ = made(layer_of(tmp_path, "50000", "91000"), PRESET=4)
    assert [(c.value, c.name) for c in table] == [(27, "50000 Water"), (28, "91000")]


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
