import json

import numpy as np
import pytest
from built_database import (
    BUILD,
    HEIGHT,
    LONGITUDE,
    MINIMUM_AREA,
    SIZE,
    STRIDE,
    WIDTH,
    content,
    map_labels,
    most_frequent,
)
from made_inputs import CLASSES_CSV, METRIC_CRS, NAMES, NORTH, WEST, read_rows, spatial_reference, write_raster
from osgeo import gdal, osr
from qgis.core import QgsPalettedRasterRenderer, QgsRasterLayer
from qgis.PyQt.QtGui import QColor

from semref.core.landmarks.landmarks import extract_landmarks
from semref.storage.database import overview_file


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


@pytest.mark.parametrize("table", [CLASSES_CSV, CLASSES_CSV.replace("reference", "background")])
def test_roles_of_the_stored_class_table_or_usual_landmarks_are_the_default(build, tmp_path, table):
    path = write_raster(tmp_path / "labels.tif", map_labels())
    labels = gdal.Open(str(path), gdal.GA_Update)
    labels.SetMetadataItem("SEMREF_CLASS_TABLE", table)
    del labels
    made = content(build(path, REFERENCE_CLASSES="")["DATABASE"])
    assert [row[2] for row in made["classes"] if row[4] == "reference"] == ["building", "water", "bare_land"]


def test_windows_without_vector_and_a_web_map_are_noted_in_the_log(run_algorithm, label_map, feedback, tmp_path, query):
    sizes = {"WINDOW_SIZE": SIZE, "STRIDE": STRIDE, "MINIMUM_AREA": MINIMUM_AREA}
    asked = {"LABELS": str(label_map), "REFERENCE_CLASSES": "1;2;3", "DATABASE": str(tmp_path / "area.gpkg")}
    run_algorithm(BUILD, {**asked, **sizes}, feedback)
    lacking = query("SELECT count(*) FROM windows WHERE vector IS NULL")[0][0]
    assert f"{lacking} windows" in feedback.textLog() and "on the ground" not in feedback.textLog()
    asked["LABELS"] = str(write_raster(tmp_path / "a.tif", map_labels(), crs=3857, transform=(0, 1, 0, 8399738, 0, -1)))
    run_algorithm(BUILD, {**asked, **sizes}, feedback)
    assert "EPSG:3857 WGS 84 / Pseudo-Mercator, 1 m on the map is 0.50 m on the ground" in feedback.textLog()


def test_a_local_crs_that_leads_to_no_longitude_gives_null(build, tmp_path):
    local = 'ENGCRS["site",EDATUM["site"],CS[Cartesian,2],AXIS["x",east],AXIS["y",north],LENGTHUNIT["metre",1]]'
    labels = write_raster(tmp_path / "labels.tif", map_labels(), crs=local, names=NAMES)
    made = content(build(labels)["DATABASE"])
    assert {row[LONGITUDE : LONGITUDE + 2] for row in made["windows"]} == {(None, None)}


def test_references_and_overview_are_those_of_the_whole_map(built, database):
    objects = extract_landmarks(map_labels(), (1, 2, 3), MINIMUM_AREA)
    rows = read_rows(database, "references")
    assert len(rows) == len(objects) == built["REFERENCE_COUNT"]
    for n, row in enumerate(rows):
        x, y = objects.centers_xy[n]
        assert row["geometry"].GetPoint_2D() == pytest.approx((WEST + x, NORTH - y), abs=1e-6)
        found = row["class"], row["class_name"], row["area"], bool(row["touches_edge"])
        value = objects.classes[n]
        assert found == (value, NAMES[value], objects.areas_px[n], objects.touches_edge[n])
    overview = gdal.Open(f"GPKG:{database}:overview")
    assert overview.RasterCount == 1
    np.testing.assert_array_equal(overview.ReadAsArray(), most_frequent(map_labels(), 4))
    assert overview.GetGeoTransform() == (WEST, 4, 0, NORTH, 0, -4)


def test_classes_and_parameters_are_those_of_the_map_and_those_asked_for(query):
    found = query("SELECT value, name, role FROM classes ORDER BY value")
    assert found == [(n, NAMES[n], "background" if n == 4 else "reference") for n in range(1, 5)]
    stored = {key: json.loads(value) for key, value in query("SELECT key, value FROM parameters")}
    expected = {"format_version": 1, "window_size": SIZE, "stride": STRIDE, "minimum_area": MINIMUM_AREA}
    expected |= {"levels": [1.0], "pixel_size": 1.0, "map_width_px": WIDTH, "map_height_px": HEIGHT}
    assert stored.items() >= expected.items() and stored["plugin_version"]
    assert osr.SpatialReference(stored["crs"]).IsSame(spatial_reference(METRIC_CRS))
    assert len(stored["map_hash"]) == len(stored["class_table_hash"]) == 64


def test_an_overview_too_large_for_memory_uses_a_temporary_file(build, label_map, tmp_path, monkeypatch):
    monkeypatch.setattr(overview_file, "HELD_PIXELS", 0)
    caches, before = [], gdal.GetCacheMax()
    put = overview_file.OverviewFile.put
    monkeypatch.setattr(overview_file.OverviewFile, "put", lambda *a: caches.append(gdal.GetCacheMax()) or put(*a))
    folder = tmp_path / "R&D"
    folder.mkdir()
    built = build(label_map, DATABASE=str(folder / "filed.gpkg"))
    overview = gdal.Open(f"GPKG:{built['DATABASE']}:overview")
    np.testing.assert_array_equal(overview.ReadAsArray(), most_frequent(map_labels(), 4))
    assert set(caches) == {overview_file.CACHE_BYTES} and gdal.GetCacheMax() == before
    assert [path.name for path in folder.iterdir() if path.suffix != ".qml"] == ["filed.gpkg"]


def test_every_window_is_its_square_on_the_ground(database):
    for row in read_rows(database, "windows"):
        column, line = map(int, row["name"].split("_"))
        left, top = WEST + column, NORTH - line
        assert row["geometry"].GetEnvelope() == (left, left + SIZE, top - SIZE, top)
        assert row["geometry"].GetArea() == SIZE**2


def test_windows_have_longitude_and_latitude_of_their_center_and_a_vector_with_three_references(query):
    degrees = osr.CoordinateTransformation(spatial_reference(METRIC_CRS), spatial_reference(4326))
    for x, y, longitude, latitude in query("SELECT center_x, center_y, longitude, latitude FROM windows"):
        expected = degrees.TransformPoint(x, y)
        assert (longitude, latitude) == pytest.approx(expected[:2], abs=1e-9)
        assert 9 < longitude < 10 and 47 < latitude < 48
    rows = query("SELECT reference_count, vector FROM windows")
    assert {count >= 3 for count, _ in rows} == {True, False}
    for count, blob in rows:
        assert (blob is None) == (count < 3)
        assert blob is None or len(blob) == 4 * 3 * 10
