"""What a user or their data gets wrong is told in one sentence with the value; older outputs stay as they were."""

from __future__ import annotations

import contextlib
import importlib.util
import re
import shutil
import sqlite3
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from made_inputs import (
    CLASSES_CSV,
    NORTH,
    WEST,
    scattered_objects,
    square,
    write_layer,
    write_raster,
    write_text,
)
from made_models import brightest_color, metadata, write_model
from osgeo import gdal, ogr
from qgis.core import (
    QgsApplication,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)

from semref.processing.packages import components

RASTERIZE, DECODE, BUILD = "semref:rasterizeannotation", "semref:decodecolorlabels", "semref:builddatabase"
DESCRIBE, LOCALIZE = "semref:describeimage", "semref:localizeimages"
SEGMENT, COMPARE = "semref:segmentimage", "semref:comparelabels"

OUTPUT_NAMES = {
    RASTERIZE: ("OUTPUT", "labels_out.tif"),
    DECODE: ("OUTPUT", "decoded_out.tif"),
    BUILD: ("DATABASE", "area_out.gpkg"),
    DESCRIBE: ("VECTOR", "vector_out.json"),
    LOCALIZE: ("OUTPUT", "positions_out.gpkg"),
    SEGMENT: ("OUTPUT", "segmented_out.tif"),
    COMPARE: ("DISAGREEMENTS", "disagreements_out.gpkg"),
}
OLDER = b"an older output"
QGIS_OWN = ("Incorrect parameter value for ", "Could not load source layer for ", "Could not create layer ")
"""How sentences begin that QGIS says before an algorithm is asked."""

NAMES = ["unlabeled", "building", "water", "bare_land", "field"]
LABELS = scattered_objects(150, 200, 40, seed=2)


@pytest.fixture(scope="module")
def good(run_algorithm, tmp_path_factory):
    """A folder with one input of each kind that nothing is wrong with."""
    folder = tmp_path_factory.mktemp("good")
    features = [(square(0, 0, 100), "field", 1), (square(10, 10, 20), "building", 2)]
    write_layer(folder / "annotation.gpkg", features, [("class", "text"), ("zorder", "integer")])
    write_text(folder / "classes.csv", CLASSES_CSV)
    write_raster(folder / "labels.tif", LABELS, names=NAMES)
    write_raster(folder / "photo.png", LABELS[:100, :100], transform=None)
    write_raster(folder / "color.png", np.zeros((3, 20, 20), np.uint8), transform=None)
    write_model(folder / "colors.onnx")
    parameters = {
        "LABELS": str(folder / "labels.tif"),
        "REFERENCE_CLASSES": "1;2;3",
        "WINDOW_SIZE": 100,
        "STRIDE": 50,
        "MINIMUM_AREA": 30,
        "DATABASE": str(folder / "area.gpkg"),
    }
    run_algorithm(BUILD, parameters)
    return folder


@pytest.fixture
def defaults(good, tmp_path):
    """Parameters of each algorithm that work; outputs lie in tmp_path/out."""
    (tmp_path / "out").mkdir()
    found = {
        RASTERIZE: {"INPUT": str(good / "annotation.gpkg"), "CLASS_FIELD": "class", "PIXEL_SIZE": 1},
        DECODE: {"INPUT": str(good / "color.png"), "CLASS_TABLE": str(good / "classes.csv"), "METHOD": 1},
        BUILD: {
            "LABELS": str(good / "labels.tif"),
            "REFERENCE_CLASSES": "1;2;3",
            "WINDOW_SIZE": 100,
            "STRIDE": 50,
            "MINIMUM_AREA": 30,
        },
        DESCRIBE: {
            "INPUT": str(good / "photo.png"),
            "CLASS_TABLE": str(good / "classes.csv"),
            "REFERENCES": "TEMPORARY_OUTPUT",
        },
        LOCALIZE: {"DATABASE": str(good / "area.gpkg"), "IMAGES": [str(good / "photo.png")], "METHOD": 1},
        SEGMENT: {"INPUT": str(good / "color.png"), "MODEL": str(good / "colors.onnx")},
        COMPARE: {"REFERENCE": str(good / "labels.tif"), "PREDICTED": str(good / "labels.tif")},
    }
    for algorithm, (key, name) in OUTPUT_NAMES.items():
        found[algorithm][key] = str(tmp_path / "out" / name)
    return found


def sentence_of(error: Exception) -> str:
    """What the user reads, checked to be one sentence; QGIS's own end without a full stop."""
    text = str(error).replace("Unable to execute algorithm\n", "")
    assert "Traceback" not in text and "\n" not in text.strip(), text
    assert text.endswith(".") or text.startswith(QGIS_OWN), text
    assert re.findall(r"[.!?]\s+[A-Z“]", text) == [], f"more than one sentence: {text}"
    return text


@pytest.fixture
def refused(run_algorithm, defaults, tmp_path, feedback):
    """`refused(algorithm, **parameters)` gives the sentence; an older output of the same name must stay."""

    def run(algorithm, **parameters):
        older = Path(defaults[algorithm][OUTPUT_NAMES[algorithm][0]])
        older.write_bytes(OLDER)
        with pytest.raises(QgsProcessingException) as caught:
            run_algorithm(algorithm, {**defaults[algorithm], **parameters}, feedback)
        assert older.read_bytes() == OLDER
        assert [path.name for path in older.parent.iterdir()] == [older.name]
        return sentence_of(caught.value)

    return run


def test_the_good_inputs_are_good(run_algorithm, defaults):
    for algorithm, parameters in defaults.items():
        run_algorithm(algorithm, parameters)


# --- annotation ---


def test_a_missing_class_field_is_named_with_the_fields_that_there_are(refused):
    sentence = refused(RASTERIZE, CLASS_FIELD="klass")
    assert "“klass”" in sentence and "class, zorder" in sentence


def test_a_missing_priority_field_is_named(refused):
    assert "“order”" in refused(RASTERIZE, PRIORITY_FIELD="order")


def test_a_priority_field_of_text_is_refused(refused):
    sentence = refused(RASTERIZE, PRIORITY_FIELD="class")
    assert "“class”" in sentence and "number" in sentence


def test_class_values_outside_the_table_are_named_and_counted(refused, tmp_path, good):
    features = [(square(n * 10, 0, 10), name) for n, name in enumerate(["field", "swamp", "swamp", "tundra"])]
    layer = write_layer(tmp_path / "a.gpkg", features)
    sentence = refused(RASTERIZE, INPUT=str(layer), CLASS_TABLE=str(good / "classes.csv"))
    assert "“swamp” (2)" in sentence and "“tundra” (1)" in sentence and "4 field" in sentence


def test_many_unknown_class_values_are_not_all_listed(refused, tmp_path, good):
    features = [(square(n * 10, 0, 10), f"unknown {n}") for n in range(40)]
    layer = write_layer(tmp_path / "a.gpkg", features)
    sentence = refused(RASTERIZE, INPUT=str(layer), CLASS_TABLE=str(good / "classes.csv"))
    assert "and 35 more" in sentence


def test_integer_values_outside_the_table_are_named(refused, tmp_path, good):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), 99)], [("class", "integer")])
    assert "“99”" in refused(RASTERIZE, INPUT=str(layer), CLASS_TABLE=str(good / "classes.csv"))


@pytest.mark.parametrize("wkt", ["LINESTRING (550000 5220000, 550010 5220010)", "POINT (550000 5220000)"])
def test_lines_and_points_are_no_annotation(refused, tmp_path, wkt):
    geometry = ogr.CreateGeometryFromWkt(wkt).GetGeometryType()
    layer = write_layer(tmp_path / "a.gpkg", [(wkt, "road")], geometry=geometry)
    sentence = refused(RASTERIZE, INPUT=str(layer))
    assert "polygon" in sentence


def test_a_table_without_geometry_is_no_annotation(refused, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(None, "road")], geometry=ogr.wkbNone)
    assert "polygon" in refused(RASTERIZE, INPUT=str(layer))


def test_a_missing_annotation_file_is_said(refused):
    assert "INPUT" in refused(RASTERIZE, INPUT="/nowhere/annotation.shp")


def test_more_classes_than_a_label_map_holds_are_refused_with_their_number(refused, tmp_path):
    features = [(square(n % 20 * 10, n // 20 * 10, 10), f"class {n}") for n in range(256)]
    sentence = refused(RASTERIZE, INPUT=str(write_layer(tmp_path / "a.gpkg", features)))
    assert "256" in sentence and "255" in sentence


def test_a_layer_without_features_is_refused(refused, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [], geometry=ogr.wkbPolygon)
    assert "“a”" in refused(RASTERIZE, INPUT=str(layer)).replace("annotation", "a")


@pytest.mark.parametrize("crs", [32632, 4326])
def test_a_layer_with_nothing_but_missing_geometry_is_refused(refused, tmp_path, crs):
    layer = write_layer(tmp_path / "a.gpkg", [(None, "field"), (None, "water")], crs=crs, geometry=ogr.wkbPolygon)
    refused(RASTERIZE, INPUT=str(layer))


def test_a_layer_with_nothing_but_missing_classes_is_refused(refused, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), None)])
    assert "class" in refused(RASTERIZE, INPUT=str(layer))


def test_an_annotation_without_crs_is_refused(refused, tmp_path):
    layer = write_layer(tmp_path / "a.shp", [(square(0, 0, 10), "field")], crs=None, geometry=ogr.wkbPolygon)
    assert "coordinate reference system" in refused(RASTERIZE, INPUT=str(layer))


@pytest.mark.parametrize("target", ["EPSG:4326", "EPSG:2263"])
def test_a_target_crs_that_is_not_metric_is_named(refused, target):
    sentence = refused(RASTERIZE, TARGET_CRS=target)
    assert target in sentence and "meters" in sentence


def test_meters_that_are_declared_as_degrees_are_refused(refused, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 10), "field")], crs=4326)
    sentence = refused(RASTERIZE, INPUT=str(layer))
    assert "EPSG:4326" in sentence


def test_infinite_coordinates_are_no_crash(refused, tmp_path):
    huge = "POLYGON ((0 0, 1e300 0, 1e300 1e300, 0 1e300, 0 0))"
    layer = write_layer(tmp_path / "a.gpkg", [(huge, "field"), (square(0, 0, 10), "field")])
    assert "PIXEL_SIZE" in refused(RASTERIZE, INPUT=str(layer))


def test_a_pixel_size_that_makes_a_gigantic_map_is_refused_with_the_size(refused, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 500_000), "field")])
    sentence = refused(RASTERIZE, INPUT=str(layer), PIXEL_SIZE=0.01)
    assert "50000000 × 50000000" in sentence and "PIXEL_SIZE" in sentence


@pytest.mark.parametrize("pixel_size", [0, -1, "nothing"])
def test_a_pixel_size_that_is_none_is_refused(refused, pixel_size):
    refused(RASTERIZE, PIXEL_SIZE=pixel_size)


def test_a_layer_removed_while_the_algorithm_runs_does_not_stop_it(tmp_path, defaults, good):
    """Prepared in the main thread, run after the layers are gone, as a background task may meet it."""
    for algorithm, key, layer in (
        (RASTERIZE, "INPUT", QgsVectorLayer(str(good / "annotation.gpkg"), "annotation")),
        (BUILD, "LABELS", QgsRasterLayer(str(good / "labels.tif"), "labels")),
        (DECODE, "INPUT", QgsRasterLayer(str(good / "color.png"), "color")),
        (DESCRIBE, "INPUT", QgsRasterLayer(str(good / "photo.png"), "photo")),
    ):
        project = QgsProject.instance()
        project.addMapLayer(layer)
        context, feedback = QgsProcessingContext(), QgsProcessingFeedback(False)
        context.setProject(project)
        instance = QgsApplication.processingRegistry().createAlgorithmById(algorithm)
        parameters = {**defaults[algorithm], key: layer.id()}
        assert instance.prepare(parameters, context, feedback)
        project.removeMapLayer(layer.id())
        results = instance.runPrepared(parameters, context, feedback)
        assert Path(results[OUTPUT_NAMES[algorithm][0]]).exists()


# --- class tables ---


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "no classes"),
        ("value,name,color,role\n", "no classes"),
        ("number,label\n1,field\n", "value, name"),
        ("value,name,color,role\nx,field,#00ff00,background\n", "“x”"),
        ("value,name,color,role\n300,field,#00ff00,background\n", "300"),
        ("value,name,color,role\n-1,field,#00ff00,background\n", "-1"),
        ("value,name,color,role\n1,,#00ff00,background\n", "no name"),
        ("value,name,color,role\n1,field,green,background\n", "“green”"),
        ("value,name,color,role\n1,field,#00ff00,landmark\n", "“landmark”"),
        ("value,name,color,role\n1,field,#00ff00,\n1,water,#0000ff,\n", "1"),
        ("value,name,color,role\n1,field,#00ff00,\n2,field,#0000ff,\n", "field"),
        ("value,name,color,role,draw_order\n1,field,#00ff00,,top\n", "“top”"),
        ("value,name,color,role,hsv_min,hsv_max\n1,field,#00ff00,,1 2,3 4 5\n", "“1 2”"),
        ("value,name,color,role,hsv_min,hsv_max\n1,field,#00ff00,,1 2 3,\n", "hsv_min"),
        ("value,name,color,role,hsv_min,hsv_max\n1,field,#00ff00,,1 2 3,1 2 300\n", "“1 2 300”"),
    ],
)
@pytest.mark.parametrize("algorithm", [RASTERIZE, DECODE])
def test_a_broken_class_table_is_refused_with_the_place(refused, tmp_path, algorithm, text, said):
    sentence = refused(algorithm, CLASS_TABLE=str(write_text(tmp_path / "broken.csv", text)))
    assert said in sentence


@pytest.mark.parametrize("content", [b"\x00\x01\x02\xff" * 50, b"PK\x03\x04" + bytes(300)])
def test_a_class_table_that_is_no_text_is_refused(refused, tmp_path, content):
    (tmp_path / "binary.csv").write_bytes(content)
    assert "binary.csv" in refused(RASTERIZE, CLASS_TABLE=str(tmp_path / "binary.csv"))


@pytest.mark.parametrize("algorithm", [RASTERIZE, DECODE, DESCRIBE])
def test_a_missing_class_table_is_named(refused, algorithm):
    assert "/nowhere/classes.csv" in refused(algorithm, CLASS_TABLE="/nowhere/classes.csv")


def test_hsv_decoding_without_hsv_ranges_is_refused(refused):
    assert "hsv_min" in refused(DECODE, METHOD=0)


# --- label maps ---


@pytest.mark.parametrize(
    ("crs", "transform", "said"),
    [
        (4326, (9.5, 0.00001, 0, 47.2, 0, -0.00001), "EPSG:4326"),
        (2263, (985000, 1, 0, 200000, 0, -1), "EPSG:2263"),
        (None, (WEST, 1, 0, NORTH, 0, -1), "coordinate reference system"),
        (32632, (WEST, 1, 0.2, NORTH, 0.2, -1), "rotated"),
        (32632, (WEST, 1, 0, NORTH, 0, 1), "mirrored"),
        (32632, (WEST, 1, 0, NORTH, 0, -2), "1 × 2"),
    ],
)
def test_a_label_map_that_is_not_metric_north_up_and_square_is_refused(refused, tmp_path, crs, transform, said):
    labels = write_raster(tmp_path / "labels.tif", LABELS, crs=crs, transform=transform)
    sentence = refused(BUILD, LABELS=str(labels))
    assert said in sentence and "labels.tif" in sentence


def test_a_label_map_without_georeference_is_refused(refused, tmp_path):
    refused(BUILD, LABELS=str(write_raster(tmp_path / "labels.tif", LABELS, transform=None)))


@pytest.mark.parametrize("kind", ["Float32", "Float64", "CInt16"])
def test_a_label_map_that_is_not_of_whole_numbers_is_refused(refused, tmp_path, kind):
    labels = write_raster(tmp_path / "labels.tif", LABELS, kind=gdal.GetDataTypeByName(kind))
    assert kind in refused(BUILD, LABELS=str(labels))


def test_a_label_map_of_several_bands_is_refused(refused, tmp_path):
    labels = write_raster(tmp_path / "labels.tif", np.stack([LABELS] * 3))
    assert "3 bands" in refused(BUILD, LABELS=str(labels))


@pytest.mark.parametrize(("value", "kind"), [(256, gdal.GDT_UInt16), (70000, gdal.GDT_Int32), (-1, gdal.GDT_Int16)])
def test_a_label_map_with_a_value_that_is_no_class_value_is_refused_with_it(refused, tmp_path, value, kind):
    labels = LABELS.astype(np.int32)
    labels[100, 100] = value
    sentence = refused(BUILD, LABELS=str(write_raster(tmp_path / "labels.tif", labels, kind=kind)))
    assert f" {value}" in sentence and "255" in sentence


def test_a_missing_label_map_is_said(refused):
    assert "LABELS" in refused(BUILD, LABELS="/nowhere/labels.tif")


def test_a_truncated_label_map_is_refused(refused, tmp_path):
    big = np.random.default_rng(1).integers(1, 5, (600, 600)).astype(np.uint8)
    labels = write_raster(tmp_path / "labels.tif", big)
    content = labels.read_bytes()
    labels.write_bytes(content[: len(content) // 2])
    assert "labels.tif" in refused(BUILD, LABELS=str(labels), WINDOW_SIZE=100)


def test_a_stride_larger_than_the_window_is_refused_with_both(refused):
    sentence = refused(BUILD, WINDOW_SIZE=100, STRIDE=150)
    assert "150" in sentence and "100" in sentence


def test_a_window_larger_than_the_map_is_refused_with_both(refused):
    sentence = refused(BUILD, WINDOW_SIZE=1000)
    assert "1000" in sentence and "200 × 150" in sentence


def test_a_level_larger_than_the_map_is_refused(refused):
    assert "200 × 150" in refused(BUILD, LEVELS="1;4")


@pytest.mark.parametrize("levels", ["one", "1;x", "0", "-1;1", "nan", "inf"])
def test_levels_that_are_no_multipliers_are_refused(refused, levels):
    assert "LEVELS" in refused(BUILD, LEVELS=levels)


@pytest.mark.parametrize("key", ["WINDOW_SIZE", "STRIDE"])
@pytest.mark.parametrize("value", [0, -5, "wide"])
def test_a_window_or_stride_that_is_no_length_is_refused_by_name(refused, key, value):
    assert key in refused(BUILD, **{key: value})


def test_a_minimum_area_of_nothing_is_refused(refused):
    assert "minimum area" in refused(BUILD, MINIMUM_AREA=0)


def test_a_window_smaller_than_a_pixel_is_refused(refused):
    assert "pixel" in refused(BUILD, WINDOW_SIZE=0.2, STRIDE=0.1)


def test_a_map_without_reference_class_is_refused_with_its_classes(refused):
    sentence = refused(BUILD, REFERENCE_CLASSES="")
    assert "REFERENCE_CLASSES" in sentence and "1 building" in sentence


def test_an_unknown_reference_class_is_named_with_the_classes_there_are(refused):
    sentence = refused(BUILD, REFERENCE_CLASSES="building;lighthouse")
    assert "“lighthouse”" in sentence and "1 building" in sentence


def test_a_map_without_any_object_is_refused_with_the_area(refused):
    sentence = refused(BUILD, MINIMUM_AREA=1e6)
    assert "1e+06 m²" in sentence and "building" in sentence


def test_a_map_of_nothing_but_zeros_is_refused(refused, tmp_path):
    refused(BUILD, LABELS=str(write_raster(tmp_path / "labels.tif", np.zeros((150, 150), np.uint8))))


# --- databases ---


@pytest.fixture
def copied(good, tmp_path):
    return Path(shutil.copy(good / "area.gpkg", tmp_path / "copy.gpkg"))


@contextlib.contextmanager
def edited(path):
    with contextlib.closing(sqlite3.connect(path)) as connection:
        # The triggers of GeoPackage call functions that plain SQLite does not have.
        for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'trigger'").fetchall():
            connection.execute(f'DROP TRIGGER "{name}"')
        # As whoever changes a database on purpose would.
        connection.execute("DELETE FROM parameters WHERE key = 'checksums'")
        yield connection
        connection.commit()


@pytest.mark.parametrize("algorithm", [LOCALIZE, DESCRIBE])
def test_a_missing_database_is_named(refused, algorithm):
    assert "/nowhere/area.gpkg" in refused(algorithm, DATABASE="/nowhere/area.gpkg")


@pytest.mark.parametrize("content", [b"", b"hello", b"SQLite format 3\x00", b"SQLite format 3\x00" + bytes(200)])
def test_a_file_that_is_no_geopackage_is_refused(refused, tmp_path, content):
    (tmp_path / "notes.gpkg").write_bytes(content)
    assert "notes.gpkg" in refused(LOCALIZE, DATABASE=str(tmp_path / "notes.gpkg"))


def test_a_folder_is_no_database(refused, tmp_path):
    assert "DATABASE" in refused(LOCALIZE, DATABASE=str(tmp_path))


def test_a_foreign_geopackage_is_refused_with_what_it_lacks(refused, good):
    sentence = refused(LOCALIZE, DATABASE=str(good / "annotation.gpkg"))
    assert "annotation.gpkg" in sentence and "windows" in sentence and "parameters" in sentence


@pytest.mark.parametrize("share", [0.001, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99])
def test_a_truncated_database_is_refused_at_whatever_length(refused, copied, share):
    content = copied.read_bytes()
    copied.write_bytes(content[: int(len(content) * share)])
    assert "copy.gpkg" in refused(LOCALIZE, DATABASE=str(copied))


def test_a_newer_format_version_is_refused_with_both_numbers(refused, copied):
    with edited(copied) as connection:
        connection.execute("UPDATE parameters SET value = '7' WHERE key = 'format_version'")
        connection.execute("INSERT INTO parameters (key, value) VALUES ('new_in_7', '1')")
    sentence = refused(LOCALIZE, DATABASE=str(copied))
    assert "7" in sentence and "update" in sentence


def test_vectors_of_another_length_are_refused(refused, copied):
    with edited(copied) as connection:
        connection.execute("UPDATE parameters SET value = '11' WHERE key = 'references_per_vector'")
    assert "33" in refused(LOCALIZE, DATABASE=str(copied))


@pytest.mark.parametrize(
    "statement",
    [
        "DELETE FROM parameters",
        "DELETE FROM parameters WHERE key = 'references_per_vector'",
        "UPDATE parameters SET value = '{broken' WHERE key = 'levels'",
        "UPDATE parameters SET value = '\"ten\"' WHERE key = 'references_per_vector'",
        "UPDATE parameters SET value = 'null' WHERE key = 'window_size'",
        "UPDATE parameters SET value = '\"\"' WHERE key = 'crs'",
        "UPDATE classes SET role = 'landmark' WHERE value = 1",
        "DELETE FROM classes",
        "UPDATE windows SET size = NULL",
        "UPDATE windows SET center_x = 'east'",
        'UPDATE "references" SET geom = NULL',
        "ALTER TABLE windows RENAME COLUMN vector TO vektor",
    ],
)
def test_a_database_that_was_edited_into_nonsense_is_refused(refused, copied, statement):
    with edited(copied) as connection:
        connection.execute(statement)
    refused(LOCALIZE, DATABASE=str(copied))


@pytest.mark.parametrize("statement", ["DELETE FROM windows", "UPDATE windows SET vector = NULL"])
def test_a_database_without_vectors_is_refused_by_the_method_that_needs_them(refused, copied, statement):
    with edited(copied) as connection:
        connection.execute(statement)
    assert "topology vector" in refused(LOCALIZE, DATABASE=str(copied), METHOD=1)


# --- images ---


def reason_of(run_algorithm, defaults, path) -> str:
    parameters = {**defaults[LOCALIZE], "IMAGES": [str(path)]}
    source = ogr.Open(run_algorithm(LOCALIZE, parameters)["OUTPUT"])
    (row,) = list(source.GetLayer(0))
    assert row["status"] == "error"
    return sentence_of(ValueError(row["reason"]))


def truncated_png(path: Path) -> Path:
    noise = np.random.default_rng(1).integers(0, 255, (200, 200)).astype(np.uint8)
    content = write_raster(path, noise, transform=None).read_bytes()
    path.write_bytes(content[: len(content) // 2])
    return path


@pytest.fixture(params=["missing", "empty", "text", "truncated", "huge", "16-bit color", "two bands", "float", "300"])
def bad_image(request, tmp_path):
    path = tmp_path / "bad.png"
    if request.param == "empty":
        path.touch()
    elif request.param == "text":
        path.write_text("This is no picture.")
    elif request.param == "truncated":
        truncated_png(path)
    elif request.param == "huge":
        path = tmp_path / "bad.vrt"
        path.write_text(
            '<VRTDataset rasterXSize="100000" rasterYSize="100000">'
            '<VRTRasterBand dataType="Byte" band="1"/></VRTDataset>'
        )
    elif request.param == "16-bit color":
        write_raster(path, np.full((3, 50, 50), 300, np.uint16), transform=None, kind=gdal.GDT_UInt16)
    elif request.param == "two bands":
        write_raster(path, np.full((2, 50, 50), 1, np.uint8), transform=None)
    elif request.param == "float":
        path = write_raster(tmp_path / "bad.tif", LABELS, kind=gdal.GDT_Float32)
    elif request.param == "300":
        write_raster(path, np.full((50, 50), 300, np.uint16), transform=None, kind=gdal.GDT_UInt16)
    return path


def test_a_bad_image_has_a_row_with_one_sentence_that_names_it(run_algorithm, defaults, bad_image):
    assert bad_image.name in reason_of(run_algorithm, defaults, bad_image)


def test_a_bad_image_cannot_be_described(refused, bad_image):
    sentence = refused(DESCRIBE, INPUT=str(bad_image))
    assert bad_image.name in sentence or "INPUT" in sentence


@pytest.mark.parametrize("name", ["empty.png", "text.png", "missing.png"])
def test_an_unreadable_image_cannot_be_decoded(refused, tmp_path, name):
    (tmp_path / "empty.png").touch()
    (tmp_path / "text.png").write_text("This is no picture.")
    assert "INPUT" in refused(DECODE, INPUT=str(tmp_path / name))


def test_a_truncated_image_cannot_be_decoded(refused, tmp_path):
    noise = np.random.default_rng(1).integers(0, 255, (3, 200, 200)).astype(np.uint8)
    path = write_raster(tmp_path / "cut.png", noise, transform=None)
    path.write_bytes(path.read_bytes()[:60_000])
    assert "cut.png" in refused(DECODE, INPUT=str(path))


@pytest.mark.parametrize(
    ("pixels", "kind", "said"),
    [
        (np.zeros((3, 9, 9), np.uint16), gdal.GDT_UInt16, "UInt16"),
        (np.zeros((9, 9), np.uint8), gdal.GDT_Byte, "1 band"),
        (np.zeros((2, 9, 9), np.uint8), gdal.GDT_Byte, "2 band"),
    ],
)
def test_an_image_that_is_not_rgb_of_8_bits_cannot_be_decoded(refused, tmp_path, pixels, kind, said):
    path = write_raster(tmp_path / "image.tif", pixels, kind=kind)
    assert said in refused(DECODE, INPUT=str(path))


def test_an_image_of_one_pixel_is_decoded(run_algorithm, defaults, tmp_path):
    path = write_raster(tmp_path / "pixel.png", np.zeros((3, 1, 1), np.uint8), transform=None)
    run_algorithm(DECODE, {**defaults[DECODE], "INPUT": str(path)})


def test_a_folder_without_images_is_named(refused, tmp_path):
    (tmp_path / "flight").mkdir()
    (tmp_path / "flight" / "notes.txt").write_text("fog")
    assert "flight" in refused(LOCALIZE, IMAGES=[str(tmp_path / "flight")])


@pytest.mark.parametrize("images", ["", ";", []])
def test_no_images_at_all_are_refused(refused, images):
    assert "IMAGES" in refused(LOCALIZE, IMAGES=images)


def test_scales_the_wrong_way_round_are_refused(refused):
    assert "(2)" in refused(LOCALIZE, SCALE_MINIMUM=2, SCALE_MAXIMUM=0.5)


def test_one_scale_beyond_the_other_ones_default_is_refused(refused):
    assert "(1.5)" in refused(LOCALIZE, METHOD=3, SCALE_MINIMUM=1.5)


def test_an_image_without_classes_of_its_own_needs_a_table(refused):
    assert "CLASS_TABLE" in refused(DESCRIBE, CLASS_TABLE=None)


# --- models and photos ---

BAD_MODELS = {
    "missing weights": ({"network": brightest_color(external="weights.bin")}, "keeps its weights in another file"),
    "newer format": ({"ir_version": 99}, "ONNX format 99"),
    "newer operators": ({"opset": 99}, "version 99 (opset)"),
    "four bands": (
        {"network": brightest_color(bands=4), "input_shape": (1, 4, "h", "w")},
        "takes input of the shape 1 × 4 × any × any",
    ),
    "unknown operator": ({"network": brightest_color().add("Frobnicate")}, "can't be run by onnxruntime"),
    "too few names": ({"metadata": metadata(class_names=["a", "b"])}, "tells 3 classes apart"),
    "no names": ({"metadata": metadata(class_names=None)}, "metadata key class_names"),
    "a detector": ({"metadata": metadata(model_type="Detector")}, "model of type Detector"),
    "no resolution": ({"metadata": metadata(resolution="fine")}, "resolution"),
}


@pytest.mark.parametrize("algorithm", [SEGMENT, LOCALIZE])
@pytest.mark.parametrize("name", BAD_MODELS)
def test_a_bad_model_is_told_in_one_sentence(refused, tmp_path, name, algorithm):
    options, words = BAD_MODELS[name]
    sentence = refused(algorithm, MODEL=str(write_model(tmp_path / "bad.onnx", **options)))
    assert "bad.onnx" in sentence and words in sentence


@pytest.mark.parametrize("algorithm", [SEGMENT, LOCALIZE])
@pytest.mark.parametrize("content", [b"", b"hello", b"\x89PNG\r\n\x1a\n" * 50])
def test_a_file_that_is_no_model_is_named(refused, tmp_path, content, algorithm):
    path = tmp_path / "notes.onnx"
    path.write_bytes(content)
    assert "notes.onnx is not an ONNX model" in refused(algorithm, MODEL=str(path))


def test_a_missing_model_is_named(refused, tmp_path):
    assert "none.onnx does not exist" in refused(SEGMENT, MODEL=str(tmp_path / "none.onnx"))


def test_values_that_are_no_numbers_are_told(refused, tmp_path):
    model = write_model(tmp_path / "bad.onnx", brightest_color().add("Sqrt"))
    assert "bad.onnx gives values that are not numbers (NaN" in refused(SEGMENT, MODEL=str(model))


def test_a_photo_that_makes_a_network_give_no_numbers_has_no_fix(run_algorithm, defaults, tmp_path):
    model = write_model(tmp_path / "bad.onnx", brightest_color().add("Sqrt"))
    parameters = {**defaults[LOCALIZE], "MODEL": str(model)}
    source = ogr.Open(run_algorithm(LOCALIZE, parameters)["OUTPUT"])
    (row,) = [feature.items() for feature in source.GetLayer(0)]
    assert row["status"] == "error" and "not numbers" in row["reason"]


def test_a_photo_of_one_pixel_is_refused(refused, tmp_path):
    photo = write_raster(tmp_path / "tiny.png", np.zeros((3, 1, 1), np.uint8), transform=None)
    assert "1 × 1 pixels" in refused(SEGMENT, INPUT=str(photo))


def test_a_photo_cut_short_is_told(refused, tmp_path):
    image = np.random.default_rng(1).integers(0, 255, (3, 400, 400)).astype(np.uint8)
    path = write_raster(tmp_path / "cut.tif", image)
    path.write_bytes(path.read_bytes()[:200_000])
    assert "cut.tif is damaged or cut short" in refused(SEGMENT, INPUT=str(path))


def test_a_class_table_that_does_not_fit_the_model_is_told(refused, tmp_path):
    table = write_text(tmp_path / "classes.csv", "value,name\n1,building\n")
    assert "CLASS_TABLE lacks the class water, bare_land" in refused(SEGMENT, CLASS_TABLE=str(table))


def test_a_missing_onnxruntime_is_told_with_how_to_install_it(qgis_app, monkeypatch):
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name, *a: None if name == "onnxruntime" else find_spec(name, *a)
    )
    registry = QgsApplication.processingRegistry()
    possible, reason = registry.createAlgorithmById(SEGMENT).canExecute()
    assert not possible
    # Which command fits which release: test_components.py.
    assert 'install --no-deps "onnxruntime' in reason or "install python3-onnxruntime" in reason
    assert registry.createAlgorithmById(LOCALIZE).canExecute() == (True, "")


# --- outputs ---

WRITERS = list(OUTPUT_NAMES)


def output_refused(run_algorithm, defaults, algorithm, path) -> str:
    key = OUTPUT_NAMES[algorithm][0]
    with pytest.raises(QgsProcessingException) as caught:
        run_algorithm(algorithm, {**defaults[algorithm], key: str(path)})
    return sentence_of(caught.value)


@pytest.mark.parametrize("algorithm", WRITERS)
def test_a_missing_output_folder_is_named_and_not_made(run_algorithm, defaults, tmp_path, algorithm):
    path = tmp_path / "nowhere" / OUTPUT_NAMES[algorithm][1]
    if algorithm not in (LOCALIZE, COMPARE):
        assert "nowhere" in output_refused(run_algorithm, defaults, algorithm, path)
        assert not path.parent.exists()


@pytest.mark.parametrize("algorithm", WRITERS)
def test_an_output_below_a_file_is_refused(run_algorithm, defaults, tmp_path, algorithm):
    (tmp_path / "file").write_text("a file")
    sentence = output_refused(run_algorithm, defaults, algorithm, tmp_path / "file" / OUTPUT_NAMES[algorithm][1])
    assert "file" in sentence


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="no /proc on this machine")
@pytest.mark.parametrize("algorithm", WRITERS)
def test_an_output_folder_that_cannot_be_written_is_refused(run_algorithm, defaults, algorithm):
    # Not even root writes there.
    assert "/proc" in output_refused(run_algorithm, defaults, algorithm, Path("/proc") / OUTPUT_NAMES[algorithm][1])


@pytest.mark.parametrize("algorithm", [RASTERIZE, DECODE, BUILD, DESCRIBE, SEGMENT])
def test_an_output_that_is_a_folder_is_refused(run_algorithm, defaults, tmp_path, algorithm):
    folder = tmp_path / OUTPUT_NAMES[algorithm][1]
    folder.mkdir()
    assert folder.name in output_refused(run_algorithm, defaults, algorithm, folder)
    assert list(folder.iterdir()) == []


@pytest.fixture
def small_disk(tmp_path):
    """A file system of 60 kB."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mounted = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=60k", "tmpfs", str(folder)], capture_output=True, check=False
    )
    if mounted.returncode:
        pytest.skip("mounting a small file system is not permitted here")
    yield folder
    subprocess.run(["umount", "--lazy", str(folder)], check=True)


@pytest.mark.parametrize("algorithm", [RASTERIZE, DECODE, BUILD])
def test_a_full_disk_is_told_and_leaves_nothing(run_algorithm, defaults, small_disk, tmp_path, algorithm):
    random = np.random.default_rng(1)
    parameters = defaults[algorithm]
    if algorithm == RASTERIZE:
        features = [(square(*random.uniform(0, 600, 2), 4), n % 200 + 1) for n in range(8_000)]
        parameters["INPUT"] = str(write_layer(tmp_path / "a.shp", features, [("class", "integer")]))
        parameters["PIXEL_SIZE"] = 0.2
    elif algorithm == DECODE:
        image = random.integers(0, 255, (3, 600, 600)).astype(np.uint8)
        parameters["INPUT"] = str(write_raster(tmp_path / "a.tif", image))
    else:
        labels = write_raster(tmp_path / "a.tif", LABELS, names=NAMES)
        parameters.update(LABELS=str(labels), WINDOW_SIZE=50, STRIDE=5)
    target = small_disk / OUTPUT_NAMES[algorithm][1]
    target.write_bytes(OLDER)
    output_refused(run_algorithm, defaults, algorithm, target)
    assert target.read_bytes() == OLDER
    assert [path.name for path in small_disk.iterdir()] == [target.name]


# --- Python packages ---


def test_a_missing_opencv_is_told_with_how_to_install_it_and_the_algorithms_stay_listed(qgis_app, monkeypatch):
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name, *a: None if name == "cv2" else find_spec(name, *a))
    registry = QgsApplication.processingRegistry()
    listed = [algorithm.id() for algorithm in registry.providerById("semref").algorithms()]
    for algorithm_id in WRITERS:
        assert algorithm_id in listed
        possible, reason = registry.createAlgorithmById(algorithm_id).canExecute()
        assert not possible
        assert "opencv-python-headless" in reason and "python3-opencv" in reason


@pytest.mark.parametrize("name", ["is_missing", "is_too_old"])
@pytest.mark.parametrize("algorithm", ["semref:checkannotation", "semref:repairannotation"])
def test_a_missing_or_old_shapely_is_told_where_it_is_needed(qgis_app, monkeypatch, name, algorithm):
    monkeypatch.setattr(components, name, lambda package: package is components.SHAPELY)
    registry = QgsApplication.processingRegistry()
    needy = registry.createAlgorithmById(algorithm)
    possible, reason = needy.canExecute()
    assert not possible
    assert '"shapely>=2' in reason or "install python3-shapely" in reason
    rasterize = registry.createAlgorithmById(RASTERIZE)
    assert rasterize.canExecute()[0]


def test_provider_and_dock_can_be_made_without_opencv_shapely_and_onnxruntime(repository):
    code = (
        "import sys, importlib.util\n"
        "sys.modules.update(cv2=None, shapely=None, onnxruntime=None)\n"
        f"spec = importlib.util.spec_from_file_location('semref', {str(repository / '__init__.py')!r},"
        f" submodule_search_locations=[{str(repository)!r}])\n"
        "package = importlib.util.module_from_spec(spec)\n"
        "sys.modules['semref'] = package\n"
        "spec.loader.exec_module(package)\n"
        "from qgis.core import QgsApplication\n"
        "application = QgsApplication([], False)\n"
        "application.initQgis()\n"
        "import semref.ui.entry\n"
        "from semref.processing.provider import SemRefProvider\n"
        "provider = SemRefProvider()\n"
        "QgsApplication.processingRegistry().addProvider(provider)\n"
        "print(sorted(a.name() for a in provider.algorithms()))\n"
        "sys.stdout.flush()\n"
        "import os\n"
        "os._exit(0)\n"
    )
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=600, check=False)
    assert answer.returncode == 0, answer.stderr
    assert "'builddatabase', 'checkannotation', 'comparelabels', 'decodecolorlabels', 'describeimage'" in answer.stdout
