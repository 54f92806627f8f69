"""semref:builddatabase: the file has exactly the layers, columns and values that the format promises."""

from __future__ import annotations

import contextlib
import json
import shutil
import sqlite3
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest
from made_inputs import CLASSES_CSV, METRIC_CRS, NORTH, WEST, scattered_objects, spatial_reference, write_raster
from osgeo import gdal, ogr, osr
from qgis.core import (
    QgsCategorizedSymbolRenderer,
    QgsPalettedRasterRenderer,
    QgsRasterLayer,
    QgsSingleSymbolRenderer,
    QgsVectorLayer,
)

BUILD = "semref:builddatabase"
HEIGHT, WIDTH, SIZE, STRIDE, MINIMUM_AREA = 300, 420, 120, 50, 40
NAMES = ["unlabeled", "building", "water", "bare_land", "field"]

LAYERS = {
    "windows": (
        ogr.wkbPolygon,
        "name String, level Integer, size Real, center_x Real, center_y Real, longitude Real, latitude Real, "
        "reference_count Integer, vector Binary, distinctiveness Real",
    ),
    "references": (ogr.wkbPoint, "class Integer, class_name String, area Real, touches_edge Integer(Boolean)"),
    "reference_bounds": (
        ogr.wkbNone,
        "first_column Integer, first_row Integer, end_column Integer, end_row Integer",
    ),
    "classes": (
        ogr.wkbNone,
        "value Integer, name String, color String, role String, draw_order Real, hsv_min String, hsv_max String",
    ),
    "parameters": (ogr.wkbNone, "key String, value String"),
}

NAME, LEVEL, SIZE_COLUMN, LONGITUDE, VECTOR = 2, 3, 4, 7, 10
"""Places in a row of the table windows, after fid and geom."""


def map_labels() -> np.ndarray:
    """(H, W) labels with objects everywhere but in the left third, so that some windows have too few."""
    labels = scattered_objects(HEIGHT, WIDTH, 150, seed=5)
    labels[:, :140] = 4
    labels[20:30, 20:30] = 1
    labels[150:162, 30:45] = 2
    labels[-20:, -30:] = 0
    return labels


@pytest.fixture(scope="module")
def build(run_algorithm, tmp_path_factory):
    """`build(labels_path, **parameters)` gives the results; DATABASE is a path."""

    def run(labels, **parameters):
        defaults = {
            "REFERENCE_CLASSES": "building;water;bare_land",
            "WINDOW_SIZE": SIZE,
            "STRIDE": STRIDE,
            "MINIMUM_AREA": MINIMUM_AREA,
            "DATABASE": str(tmp_path_factory.mktemp("built") / "area.gpkg"),
        }
        source = str(labels) if isinstance(labels, Path) else labels
        return run_algorithm(BUILD, {"LABELS": source, **defaults, **parameters})

    return run


@pytest.fixture(scope="module")
def label_map(tmp_path_factory):
    return write_raster(tmp_path_factory.mktemp("map") / "labels.tif", map_labels(), names=NAMES)


@pytest.fixture(scope="module")
def built(build, label_map):
    return build(label_map)


@pytest.fixture(scope="module")
def database(built):
    return built["DATABASE"]


@pytest.fixture
def query(database):
    """`query(sql)` gives rows as Python's own sqlite3 reads them."""
    with contextlib.closing(sqlite3.connect(f"file:{database}?mode=ro", uri=True)) as connection:
        yield lambda sql: connection.execute(sql).fetchall()


def columns_of(layer) -> str:
    definition, found = layer.GetLayerDefn(), []
    for index in range(definition.GetFieldCount()):
        field = definition.GetFieldDefn(index)
        kind = ogr.GetFieldTypeName(field.GetType())
        if field.GetSubType() != ogr.OFSTNone:
            kind += f"({ogr.GetFieldSubTypeName(field.GetSubType())})"
        found.append(f"{field.GetName()} {kind}")
    return ", ".join(found)


def content(database) -> dict:
    """All rows of the tables that the format defines; the time of building is none of them."""
    with contextlib.closing(sqlite3.connect(f"file:{database}?mode=ro", uri=True)) as connection:
        return {name: connection.execute(f'SELECT * FROM "{name}" ORDER BY fid').fetchall() for name in LAYERS}


# --- the file ---


@pytest.mark.parametrize("name", LAYERS)
def test_ogr_sees_the_layers_with_their_columns_in_order(database, name):
    source = ogr.Open(database)
    layer = source.GetLayerByName(name)
    assert (layer.GetGeomType(), columns_of(layer)) == LAYERS[name]


def test_the_layers_lie_in_the_crs_of_the_map(database):
    source = ogr.Open(database)
    for name in ("windows", "references"):
        assert source.GetLayerByName(name).GetSpatialRef().GetAuthorityCode(None) == str(METRIC_CRS)


@pytest.mark.parametrize(
    ("table", "types"),
    [
        ("windows", "TEXT MEDIUMINT REAL REAL REAL REAL REAL MEDIUMINT BLOB REAL"),
        ("references", "MEDIUMINT TEXT REAL BOOLEAN"),
        ("classes", "MEDIUMINT TEXT TEXT TEXT REAL TEXT TEXT"),
        ("parameters", "TEXT TEXT"),
    ],
)
def test_sqlite_sees_the_column_types(query, table, types):
    columns = [row[2] for row in query(f'PRAGMA table_info("{table}")') if row[1] not in ("fid", "geom")]
    assert " ".join(columns) == types


def test_no_file_of_sqlite_stays_beside_the_database(database):
    assert [path.name for path in Path(database).parent.iterdir()] == ["area.gpkg"]
    with contextlib.closing(sqlite3.connect(f"file:{database}?mode=ro", uri=True)) as connection:
        assert connection.execute("PRAGMA journal_mode").fetchone() == ("delete",)
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)


def test_the_plain_ogrinfo_program_reads_it(database):
    program = shutil.which("ogrinfo")
    if program is None:
        pytest.skip("ogrinfo is not installed")
    answer = subprocess.run([program, "-ro", "-al", "-so", database], capture_output=True, text=True, timeout=600)
    assert answer.returncode == 0
    assert "ERROR" not in answer.stderr and "Warning" not in answer.stderr
    for name in LAYERS:
        assert f"Layer name: {name}" in answer.stdout


def test_the_plain_sqlite3_program_reads_it(database):
    program = shutil.which("sqlite3")
    if program is None:
        pytest.skip("sqlite3 is not installed")
    question = "SELECT count(*), count(vector) FROM windows;"
    answer = subprocess.run([program, "-readonly", database, question], capture_output=True, text=True, timeout=600)
    assert answer.returncode == 0, answer.stderr
    windows, vectors = map(int, answer.stdout.split("|"))
    assert windows > vectors > 0


def test_an_open_older_database_with_changes_in_waiting_does_not_leak_into_the_new_one(build, label_map, tmp_path):
    target = tmp_path / "area.gpkg"
    build(label_map, DATABASE=str(target))
    with contextlib.closing(sqlite3.connect(target)) as older:
        older.execute("PRAGMA journal_mode=WAL")
        older.execute("CREATE TABLE edited (value)")
        older.commit()
        assert (tmp_path / "area.gpkg-wal").stat().st_size
        build(label_map, DATABASE=str(target))
        with contextlib.closing(sqlite3.connect(target)) as newer:
            assert newer.execute("PRAGMA integrity_check").fetchone() == ("ok",)
            assert newer.execute("SELECT name FROM sqlite_master WHERE name = 'edited'").fetchall() == []


# --- windows ---


def test_the_windows_are_the_grid_named_after_their_first_pixel(built, query):
    expected = []
    for row in range(0, HEIGHT - SIZE + 1, STRIDE):
        for column in range(0, WIDTH - SIZE + 1, STRIDE):
            center = WEST + column + SIZE / 2, NORTH - row - SIZE / 2
            expected.append((f"{column}_{row}", 1, float(SIZE), *center))
    assert query("SELECT name, level, size, center_x, center_y FROM windows ORDER BY fid") == expected
    assert built["WINDOW_COUNT"] == len(expected)


def test_every_window_is_its_square_on_the_ground(database):
    source = ogr.Open(database)
    for feature in source.GetLayerByName("windows"):
        column, row = map(int, feature["name"].split("_"))
        left, top = WEST + column, NORTH - row
        assert feature.GetGeometryRef().GetEnvelope() == (left, left + SIZE, top - SIZE, top)
        assert feature.GetGeometryRef().GetArea() == SIZE**2


def test_longitude_and_latitude_are_those_of_the_center(query):
    degrees = osr.CoordinateTransformation(spatial_reference(METRIC_CRS), spatial_reference(4326))
    for x, y, longitude, latitude in query("SELECT center_x, center_y, longitude, latitude FROM windows"):
        expected = degrees.TransformPoint(x, y)
        assert (longitude, latitude) == pytest.approx(expected[:2], abs=1e-9)
        assert 9 < longitude < 10 and 47 < latitude < 48


def test_the_vector_is_that_of_the_cut_out_window_to_the_last_bit(query):
    from semref.core.localizer.localizer import describe_image

    labels = map_labels()
    for name, count, blob in query("SELECT name, reference_count, vector FROM windows"):
        column, row = map(int, name.split("_"))
        window = labels[row : row + SIZE, column : column + SIZE]
        described = describe_image(window, (1, 2, 3), MINIMUM_AREA / SIZE**2, 10)
        assert count == len(described.objects)
        assert blob == (None if described.vector is None else described.vector.astype("<f4").tobytes())


def test_a_vector_has_three_rows_of_float32_and_is_null_with_fewer_than_three_references(query):
    rows = query("SELECT reference_count, vector FROM windows")
    assert {count >= 3 for count, _ in rows} == {True, False}
    for count, blob in rows:
        assert (blob is None) == (count < 3)
        assert blob is None or len(blob) == 4 * 3 * 10


def test_references_per_vector_sets_the_length(build, label_map):
    rows = content(build(label_map, REFERENCES_PER_VECTOR=4)["DATABASE"])["windows"]
    assert {len(row[VECTOR]) for row in rows if row[VECTOR]} == {4 * 3 * 4}


def test_distinctiveness_is_the_distance_to_the_nearest_window_that_does_not_overlap(query):
    rows = query("SELECT center_x, center_y, vector, distinctiveness FROM windows")
    described = [(x, y, np.frombuffer(blob, "<f4").astype(float)) for x, y, blob, _ in rows if blob]
    for x, y, blob, found in rows:
        if blob is None:
            assert found is None
            continue
        vector = np.frombuffer(blob, "<f4").astype(float)
        apart = [v for cx, cy, v in described if abs(cx - x) >= SIZE or abs(cy - y) >= SIZE]
        expected = min((np.linalg.norm(vector - v) for v in apart), default=None)
        assert found == (None if expected is None else pytest.approx(expected, abs=1e-5))


def test_levels_multiply_window_and_stride(build, label_map):
    rows = content(build(label_map, LEVELS="1; 2")["DATABASE"])["windows"]
    second = [row for row in rows if row[LEVEL] == 2]
    assert [(row[NAME], row[SIZE_COLUMN]) for row in second] == [("0_0", 2 * SIZE), ("100_0", 2 * SIZE)]
    assert [row[1:] for row in rows if row[LEVEL] == 1] != []


# --- references, overview, classes, parameters ---


def test_the_references_are_the_objects_of_the_whole_map(built, database):
    from semref.core.landmarks.landmarks import extract_landmarks

    objects = extract_landmarks(map_labels(), (1, 2, 3), MINIMUM_AREA)
    source = ogr.Open(database)
    layer = source.GetLayerByName("references")
    assert layer.GetFeatureCount() == len(objects) == built["REFERENCE_COUNT"]
    for n, feature in enumerate(layer):
        x, y = objects.centers_xy[n]
        assert feature.GetGeometryRef().GetPoint_2D() == pytest.approx((WEST + x, NORTH - y))
        assert feature["class"] == objects.classes[n]
        assert feature["class_name"] == NAMES[objects.classes[n]]
        assert feature["area"] == objects.areas_px[n]
        assert bool(feature["touches_edge"]) == objects.touches_edge[n]


def most_frequent(labels: np.ndarray, factor: int) -> np.ndarray:
    """Plainly: the most frequent value of each block, of equals the smallest."""
    height, width = (n // factor for n in labels.shape)
    blocks = labels[: height * factor, : width * factor].reshape(height, factor, width, factor).swapaxes(1, 2)
    return np.array([[np.bincount(block.ravel()).argmax() for block in row] for row in blocks])


def test_the_values_of_the_overview_come_back_exactly(database):
    overview = gdal.Open(f"GPKG:{database}:overview")
    assert overview.RasterCount == 1
    np.testing.assert_array_equal(overview.ReadAsArray(), most_frequent(map_labels(), 4))
    assert overview.GetGeoTransform() == (WEST, 4, 0, NORTH, 0, -4)


def test_the_classes_are_the_table_of_the_map_with_the_asked_roles(query):
    found = query("SELECT value, name, role FROM classes ORDER BY value")
    assert found == [(n, NAMES[n], "background" if n == 4 else "reference") for n in range(1, 5)]


def test_each_reference_lies_within_its_bounds(query):
    rows = query(
        'SELECT r.geom, r.touches_edge, b.* FROM "references" AS r JOIN reference_bounds AS b ON b.fid = r.fid'
    )
    assert len(rows) == query('SELECT count(*) FROM "references"')[0][0] > 50
    for geometry, touches_edge, _, left, top, right, bottom in rows:
        x, y = struct.unpack_from("<dd", geometry, 13)
        assert left < x - WEST < right and top < NORTH - y < bottom
        assert touches_edge == (left == 0 or top == 0 or right == WIDTH or bottom == HEIGHT)


def test_the_parameters_tell_how_it_was_built(query):
    stored = {key: json.loads(value) for key, value in query("SELECT key, value FROM parameters")}
    assert stored["format_version"] == 1
    assert stored["window_size"] == SIZE and stored["stride"] == STRIDE
    assert stored["minimum_area"] == MINIMUM_AREA and stored["levels"] == [1.0]
    assert stored["pixel_size"] == 1.0
    assert stored["map_width_px"] == WIDTH and stored["map_height_px"] == HEIGHT
    assert osr.SpatialReference(stored["crs"]).IsSame(spatial_reference(METRIC_CRS))
    assert len(stored["map_hash"]) == len(stored["class_table_hash"]) == 64
    assert stored["plugin_version"]


def test_the_same_map_gives_the_same_database(build, label_map, database):
    assert content(build(label_map)["DATABASE"]) == content(database)


# --- on a canvas ---


def test_the_windows_open_as_outlines(database):
    layer = QgsVectorLayer(f"{database}|layername=windows", "windows", "ogr")
    assert isinstance(layer.renderer(), QgsSingleSymbolRenderer)
    properties = layer.renderer().symbol().symbolLayer(0).properties()
    assert properties["style"] == "no"


def test_the_references_open_colored_with_a_legend_by_class_name(database):
    layer = QgsVectorLayer(f"{database}|layername=references", "references", "ogr")
    renderer = layer.renderer()
    assert isinstance(renderer, QgsCategorizedSymbolRenderer)
    assert renderer.classAttribute() == "class"
    assert [(int(c.value()), c.label()) for c in renderer.categories()] == [
        (1, "building"),
        (2, "water"),
        (3, "bare_land"),
    ]


def test_the_overview_opens_colored_by_class(database, query):
    layer = QgsRasterLayer(f"GPKG:{database}:overview", "overview")
    renderer = layer.renderer()
    assert isinstance(renderer, QgsPalettedRasterRenderer)
    shown = {int(entry.value): entry.color.name() for entry in renderer.classes()}
    for value, color in query("SELECT value, color FROM classes"):
        assert shown[value] == color


# --- label maps of other make ---


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
    assert found == {
        1: ("1", "reference"),
        2: ("2", "background"),
        3: ("3", "reference"),
        4: ("4", "background"),
    }


def test_classes_come_from_a_paletted_style(build, tmp_path):
    from qgis.PyQt.QtGui import QColor

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


def test_roles_of_the_stored_class_table_count_when_none_are_asked(build, tmp_path):
    path = write_raster(tmp_path / "labels.tif", map_labels())
    labels = gdal.Open(str(path), gdal.GA_Update)
    labels.SetMetadataItem("SEMREF_CLASS_TABLE", CLASSES_CSV)
    del labels
    made = content(build(path, REFERENCE_CLASSES="")["DATABASE"])
    assert [row[2] for row in made["classes"] if row[4] == "reference"] == ["building", "water", "bare_land"]


def test_reference_classes_are_names_or_values_in_any_order_and_case(build, label_map, database):
    made = build(label_map, REFERENCE_CLASSES=" 3;Water ; 1;")["DATABASE"]
    assert content(made) == content(database)


def test_numbers_given_as_text_are_accepted(build, label_map, database):
    made = build(label_map, WINDOW_SIZE="120", STRIDE="50.0", MINIMUM_AREA="40", REFERENCES_PER_VECTOR="10")["DATABASE"]
    assert content(made) == content(database)


def test_windows_that_are_no_whole_pixels_are_rounded_and_that_is_said(run_algorithm, label_map, feedback, tmp_path):
    parameters = {
        "LABELS": str(label_map),
        "REFERENCE_CLASSES": "building",
        "WINDOW_SIZE": 100.4,
        "STRIDE": 49.7,
        "MINIMUM_AREA": MINIMUM_AREA,
        "DATABASE": str(tmp_path / "area.gpkg"),
    }
    made = run_algorithm(BUILD, parameters, feedback)
    assert "window size 100, stride 50" in feedback.textLog()
    assert {row[SIZE_COLUMN] for row in content(made["DATABASE"])["windows"]} == {100.0}


def test_windows_without_vector_are_counted_and_said(run_algorithm, label_map, feedback, tmp_path, query):
    parameters = {
        "LABELS": str(label_map),
        "REFERENCE_CLASSES": "1;2;3",
        "WINDOW_SIZE": SIZE,
        "STRIDE": STRIDE,
        "MINIMUM_AREA": MINIMUM_AREA,
        "DATABASE": str(tmp_path / "area.gpkg"),
    }
    run_algorithm(BUILD, parameters, feedback)
    lacking = query("SELECT count(*) FROM windows WHERE vector IS NULL")[0][0]
    assert f"{lacking} windows" in feedback.textLog()


def test_a_local_crs_that_leads_to_no_longitude_gives_null(build, tmp_path):
    local = 'ENGCRS["site",EDATUM["site"],CS[Cartesian,2],AXIS["x",east],AXIS["y",north],LENGTHUNIT["metre",1]]'
    labels = write_raster(tmp_path / "labels.tif", map_labels(), crs=local, names=NAMES)
    made = content(build(labels)["DATABASE"])
    assert {row[LONGITUDE : LONGITUDE + 2] for row in made["windows"]} == {(None, None)}
