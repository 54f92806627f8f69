"""A land-cover layer that can’t be rasterized is refused in one sentence with the value."""

from __future__ import annotations

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


def test_a_missing_class_field_is_named_with_the_fields_that_there_are(refused):
    sentence = refused(RASTERIZE, CLASS_FIELD="klass")
    assert "“klass”" in sentence and "class, zorder" in sentence


def test_a_priority_field_of_text_is_refused(refused):
    sentence = refused(RASTERIZE, PRIORITY_FIELD="class")
    assert "“class”" in sentence and "numeric" in sentence


def test_class_values_outside_the_table_are_named_and_counted(refused, tmp_path, good):
    features = [(square(n * 10, 0, 10), name) for n, name in enumerate(["field", "swamp", "swamp", "tundra"])]
    layer = write_layer(tmp_path / "a.gpkg", features)
    sentence = refused(RASTERIZE, INPUT=str(layer), CLASS_TABLE=str(good / "classes.csv"))
    assert "“swamp” (2)" in sentence and "“tundra” (1)" in sentence and "4 field" in sentence


@pytest.mark.parametrize("wkt", ["LINESTRING (550000 5220000, 550010 5220010)", "POINT (550000 5220000)"])
def test_lines_and_points_are_no_annotation(refused, tmp_path, wkt):
    geometry = ogr.CreateGeometryFromWkt(wkt).GetGeometryType()
    layer = write_layer(tmp_path / "a.gpkg", [(wkt, "road")], geometry=geometry)
    sentence = refused(RASTERIZE, INPUT=str(layer))
    assert "polygon" in sentence


def test_a_missing_annotation_file_is_reported(refused):
    assert "INPUT" in refused(RASTERIZE, INPUT="/nowhere/annotation.shp")


def test_a_layer_without_features_is_refused(refused, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [], geometry=ogr.wkbPolygon)
    assert "“a”" in refused(RASTERIZE, INPUT=str(layer)).replace("annotation", "a")


@pytest.mark.parametrize("crs", [32632, 4326])
def test_a_layer_with_nothing_but_missing_geometry_is_refused(refused, tmp_path, crs):
    layer = write_layer(tmp_path / "a.gpkg", [(None, "field"), (None, "water")], crs=crs, geometry=ogr.wkbPolygon)
    refused(RASTERIZE, INPUT=str(layer))


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
    assert "choose larger pixels" in refused(RASTERIZE, INPUT=str(layer))


def test_a_pixel_size_that_makes_a_gigantic_map_is_refused_with_the_size(refused, tmp_path):
    layer = write_layer(tmp_path / "a.gpkg", [(square(0, 0, 500_000), "field")])
    sentence = refused(RASTERIZE, INPUT=str(layer), PIXEL_SIZE=0.01)
    assert "50000000 × 50000000" in sentence and "choose larger pixels" in sentence


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
