"""Label maps of other programs give the same database, and unusual ones get a note."""

import numpy as np
import pytest
from built_database import BUILD, LONGITUDE, MINIMUM_AREA, SIZE, STRIDE, content, map_labels, most_frequent
from made_inputs import CLASSES_CSV, NAMES, write_raster
from osgeo import gdal
from qgis.core import QgsPalettedRasterRenderer, QgsRasterLayer
from qgis.PyQt.QtGui import QColor


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["UInt16", "Int16", "UInt32", "Int32", "Int8", "UInt64", "Int64"])
def test_label_maps_of_other_integer_types_give_the_same_database(build, database, tmp_path, kind):
    code = gdal.GetDataTypeByName(kind)
    if code == gdal.GDT_Unknown:
        pytest.skip(f"GDAL {gdal.__version__} has no {kind}")
    labels = write_raster(tmp_path / "labels.tif", map_labels().astype(kind.lower()), kind=code, names=NAMES)
    made = content(build(labels)["DATABASE"])
    for name in ("windows", "references", "classes"):
        assert made[name] == content(database)[name]


def test_nodata_is_unlabeled(build, tmp_path):
    labels = map_labels()
    labels[labels == 2] = 255
    with_nodata = write_raster(tmp_path / "labels.tif", labels, nodata=255, names=NAMES)
    database = build(with_nodata, REFERENCE_CLASSES="building;bare_land")["DATABASE"]
    overview = gdal.Open(f"GPKG:{database}:overview").ReadAsArray()
    labels[labels == 255] = 0
    np.testing.assert_array_equal(overview, most_frequent(labels, 4))


def test_classes_of_a_map_without_names_are_named_by_their_values(build, tmp_path):
    labels = write_raster(tmp_path / "labels.tif", map_labels())
    made = content(build(labels, REFERENCE_CLASSES="1;3")["DATABASE"])
    found = {row[1]: (row[2], row[4]) for row in made["classes"]}
    assert found == {1: ("1", "reference"), 2: ("2", "background"), 3: ("3", "reference"), 4: ("4", "background")}


def test_classes_come_from_a_paletted_style(build, tmp_path):
    layer = QgsRasterLayer(str(write_raster(tmp_path / "labels.tif", map_labels())), "labels")
    classes = [
        QgsPalettedRasterRenderer.Class(value, QColor(color), label)
        for value, color, label in ((1, "#ff0000", "house"), (2, "#0000ff", "lake"), (4, "#00ff00", "meadow"))
    ]
    layer.setRenderer(QgsPalettedRasterRenderer(layer.dataProvider(), 1, classes))
    made = content(build(layer, REFERENCE_CLASSES="house;lake")["DATABASE"])
    assert [(row[1], row[2], row[3]) for row in made["classes"]] == [
        (1, "house", "#ff0000"),
        (2, "lake", "#0000ff"),
        (4, "meadow", "#00ff00"),
    ]


def test_a_color_table_without_names_makes_no_classes_that_the_map_lacks(build, tmp_path):
    path = write_raster(tmp_path / "labels.tif", map_labels())
    table = gdal.ColorTable()
    for value in range(256):
        table.SetColorEntry(value, (value, 0, 0, 255))
    labels = gdal.Open(str(path), gdal.GA_Update)
    labels.GetRasterBand(1).SetRasterColorTable(table)
    del labels
    layer = QgsRasterLayer(str(path), "labels")
    assert isinstance(layer.renderer(), QgsPalettedRasterRenderer) and len(layer.renderer().classes()) == 256
    made = content(build(layer, REFERENCE_CLASSES="1;3")["DATABASE"])
    assert [row[1] for row in made["classes"]] == [1, 2, 3, 4]


def test_roles_of_the_stored_class_table_are_the_default(build, tmp_path):
    path = write_raster(tmp_path / "labels.tif", map_labels())
    labels = gdal.Open(str(path), gdal.GA_Update)
    labels.SetMetadataItem("SEMREF_CLASS_TABLE", CLASSES_CSV)
    del labels
    made = content(build(path, REFERENCE_CLASSES="")["DATABASE"])
    assert [row[2] for row in made["classes"] if row[4] == "reference"] == ["building", "water", "bare_land"]


def test_windows_without_vector_are_counted_in_the_log(run_algorithm, label_map, feedback, tmp_path, query):
    sizes = {"WINDOW_SIZE": SIZE, "STRIDE": STRIDE, "MINIMUM_AREA": MINIMUM_AREA}
    asked = {"LABELS": str(label_map), "REFERENCE_CLASSES": "1;2;3", "DATABASE": str(tmp_path / "area.gpkg")}
    run_algorithm(BUILD, {**asked, **sizes}, feedback)
    lacking = query("SELECT count(*) FROM windows WHERE vector IS NULL")[0][0]
    assert f"{lacking} windows" in feedback.textLog()


def test_a_local_crs_that_leads_to_no_longitude_gives_null(build, tmp_path):
    local = 'ENGCRS["site",EDATUM["site"],CS[Cartesian,2],AXIS["x",east],AXIS["y",north],LENGTHUNIT["metre",1]]'
    labels = write_raster(tmp_path / "labels.tif", map_labels(), crs=local, names=NAMES)
    made = content(build(labels)["DATABASE"])
    assert {row[LONGITUDE : LONGITUDE + 2] for row in made["windows"]} == {(None, None)}
