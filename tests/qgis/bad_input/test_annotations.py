from pathlib import Path

import pytest
from bad_input import BUILD, DECODE, DESCRIBE, OUTPUT_NAMES, RASTERIZE
from made_inputs import square, write_layer
from osgeo import ogr
from qgis.core import (
    QgsApplication,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)


@pytest.mark.slow
def test_the_good_inputs_are_good(run_algorithm, defaults):
    for algorithm, parameters in defaults.items():
        run_algorithm(algorithm, parameters)


@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        ({"CLASS_FIELD": "klass"}, ["“klass”", "class, zorder"]),
        ({"PRIORITY_FIELD": "class"}, ["“class”", "numeric"]),
        ({"INPUT": "/nowhere/annotation.shp"}, ["“Land-cover layer”"]),
        *(({"TARGET_CRS": f"EPSG:{crs}"}, [f"EPSG:{crs}", "meters"]) for crs in (4326, 2263)),
        ({"TARGET_CRS": "EPSG:99999"}, ["“Target CRS” is EPSG:99999", "not a known CRS"]),
    ],
)
def test_a_parameter_that_does_not_fit_the_layer_is_named(refused, parameters, words):
    sentence = refused(RASTERIZE, **parameters)
    assert [word for word in words if word not in sentence] == []


@pytest.mark.parametrize("algorithm", [RASTERIZE, DECODE, DESCRIBE])
def test_a_missing_class_table_is_named(refused, algorithm):
    assert "/nowhere/classes.csv" in refused(algorithm, CLASS_TABLE="/nowhere/classes.csv")


@pytest.mark.parametrize("content", [b"\x00\x01\x02\xff" * 50, b"PK\x03\x04" + bytes(300)])
def test_a_class_table_that_is_no_text_is_refused(refused, tmp_path, content):
    (tmp_path / "binary.csv").write_bytes(content)
    assert "binary.csv" in refused(RASTERIZE, CLASS_TABLE=str(tmp_path / "binary.csv"))


def test_class_values_outside_the_table_are_named_and_counted(refused, tmp_path, good):
    features = [(square(n * 10, 0, 10), name) for n, name in enumerate(["field", "swamp", "swamp", "tundra"])]
    layer = write_layer(tmp_path / "a.gpkg", features)
    sentence = refused(RASTERIZE, INPUT=str(layer), CLASS_TABLE=str(good / "classes.csv"))
    assert "“swamp” (2)" in sentence and "“tundra” (1)" in sentence and "4 field" in sentence


LINE, POINT = "LINESTRING (550000 5220000, 550010 5220010)", "POINT (550000 5220000)"
ENDLESS = "POLYGON ((0 0, 1e300 0, 1e300 1e300, 0 1e300, 0 0))"


@pytest.mark.parametrize(
    ("shapes", "options", "words"),
    [
        ([LINE], {"geometry": ogr.wkbLineString}, "polygon"),
        ([POINT], {"geometry": ogr.wkbPoint}, "polygon"),
        ([], {"geometry": ogr.wkbPolygon}, "“a”"),
        ([None, None], {"geometry": ogr.wkbPolygon}, "a"),
        ([None, None], {"geometry": ogr.wkbPolygon, "crs": 4326}, "a"),
        ([square(0, 0, 10)], {"geometry": ogr.wkbPolygon, "crs": None}, "coordinate reference system"),
        # Meters that are declared as degrees.
        ([square(0, 0, 10)], {"crs": 4326}, "EPSG:4326"),
        ([ENDLESS, square(0, 0, 10)], {}, "choose larger pixels"),
        ([square(0, 0, 500_000)], {}, "50000000 × 50000000"),
    ],
)
def test_a_layer_that_makes_no_map_is_refused(refused, tmp_path, shapes, options, words):
    name = "a.shp" if options.get("crs", 1) is None else "a.gpkg"
    layer = write_layer(tmp_path / name, [(shape, "field") for shape in shapes], **options)
    assert words in refused(RASTERIZE, INPUT=str(layer), PIXEL_SIZE=0.01).replace("annotation", "a")


def test_a_layer_removed_while_the_algorithm_runs_does_not_stop_it(tmp_path, defaults, good):
    """Prepare it in the main thread and run it after the layers are gone, as a background task can."""
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
