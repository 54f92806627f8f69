"""Landmarks, overview, classes and parameters of a database."""

import json

import numpy as np
import pytest
from built_database import HEIGHT, MINIMUM_AREA, SIZE, STRIDE, WIDTH, map_labels, most_frequent
from made_inputs import METRIC_CRS, NAMES, NORTH, WEST, spatial_reference
from osgeo import gdal, ogr, osr

from semref.core.landmarks.landmarks import extract_landmarks
from semref.storage.database import overview_file


def test_the_references_are_the_objects_of_the_whole_map(built, database):
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


def test_the_values_of_the_overview_come_back_exactly(database):
    overview = gdal.Open(f"GPKG:{database}:overview")
    assert overview.RasterCount == 1
    np.testing.assert_array_equal(overview.ReadAsArray(), most_frequent(map_labels(), 4))
    assert overview.GetGeoTransform() == (WEST, 4, 0, NORTH, 0, -4)


def test_the_classes_are_the_table_of_the_map_with_the_asked_roles(query):
    found = query("SELECT value, name, role FROM classes ORDER BY value")
    assert found == [(n, NAMES[n], "background" if n == 4 else "reference") for n in range(1, 5)]


def test_the_parameters_show_how_it_was_built(query):
    stored = {key: json.loads(value) for key, value in query("SELECT key, value FROM parameters")}
    assert stored["format_version"] == 1
    assert stored["window_size"] == SIZE and stored["stride"] == STRIDE
    assert stored["minimum_area"] == MINIMUM_AREA and stored["levels"] == [1.0]
    assert stored["pixel_size"] == 1.0
    assert stored["map_width_px"] == WIDTH and stored["map_height_px"] == HEIGHT
    assert osr.SpatialReference(stored["crs"]).IsSame(spatial_reference(METRIC_CRS))
    assert len(stored["map_hash"]) == len(stored["class_table_hash"]) == 64
    assert stored["plugin_version"]


def test_an_overview_too_large_for_memory_uses_a_temporary_file(build, label_map, tmp_path, monkeypatch):
    monkeypatch.setattr(overview_file, "HELD_PIXELS", 0)
    caches, before = [], gdal.GetCacheMax()
    put = overview_file.OverviewFile.put
    monkeypatch.setattr(
        overview_file.OverviewFile, "put", lambda *piece: caches.append(gdal.GetCacheMax()) or put(*piece)
    )
    folder = tmp_path / "R&D"
    folder.mkdir()
    built = build(label_map, DATABASE=str(folder / "filed.gpkg"))
    overview = gdal.Open(f"GPKG:{built['DATABASE']}:overview")
    np.testing.assert_array_equal(overview.ReadAsArray(), most_frequent(map_labels(), 4))
    assert set(caches) == {overview_file.CACHE_BYTES} and gdal.GetCacheMax() == before
    assert [path.name for path in folder.iterdir() if path.suffix != ".qml"] == ["filed.gpkg"]
