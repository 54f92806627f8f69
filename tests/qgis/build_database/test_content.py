"""Landmarks, windows, overview, classes and parameters of a database."""

import json

import numpy as np
import pytest
from built_database import HEIGHT, MINIMUM_AREA, SIZE, STRIDE, WIDTH, map_labels, most_frequent
from made_inputs import METRIC_CRS, NAMES, NORTH, WEST, read_rows, spatial_reference
from osgeo import gdal, osr

from semref.core.landmarks.landmarks import extract_landmarks
from semref.storage.database import overview_file


def test_the_references_are_the_objects_of_the_whole_map(built, database):
    objects = extract_landmarks(map_labels(), (1, 2, 3), MINIMUM_AREA)
    rows = read_rows(database, "references")
    assert len(rows) == len(objects) == built["REFERENCE_COUNT"]
    for n, row in enumerate(rows):
        x, y = objects.centers_xy[n]
        assert row["geometry"].GetPoint_2D() == pytest.approx((WEST + x, NORTH - y))
        found = row["class"], row["class_name"], row["area"], bool(row["touches_edge"])
        value = objects.classes[n]
        assert found == (value, NAMES[value], objects.areas_px[n], objects.touches_edge[n])


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
    expected = {"format_version": 1, "window_size": SIZE, "stride": STRIDE, "minimum_area": MINIMUM_AREA}
    expected |= {"levels": [1.0], "pixel_size": 1.0, "map_width_px": WIDTH, "map_height_px": HEIGHT}
    assert stored.items() >= expected.items() and stored["plugin_version"]
    assert osr.SpatialReference(stored["crs"]).IsSame(spatial_reference(METRIC_CRS))
    assert len(stored["map_hash"]) == len(stored["class_table_hash"]) == 64


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


def test_every_window_is_its_square_on_the_ground(database):
    for row in read_rows(database, "windows"):
        column, line = map(int, row["name"].split("_"))
        left, top = WEST + column, NORTH - line
        assert row["geometry"].GetEnvelope() == (left, left + SIZE, top - SIZE, top)
        assert row["geometry"].GetArea() == SIZE**2


def test_longitude_and_latitude_are_those_of_the_center(query):
    degrees = osr.CoordinateTransformation(spatial_reference(METRIC_CRS), spatial_reference(4326))
    for x, y, longitude, latitude in query("SELECT center_x, center_y, longitude, latitude FROM windows"):
        expected = degrees.TransformPoint(x, y)
        assert (longitude, latitude) == pytest.approx(expected[:2], abs=1e-9)
        assert 9 < longitude < 10 and 47 < latitude < 48


def test_a_vector_has_three_rows_of_float32_and_is_null_with_fewer_than_three_references(query):
    rows = query("SELECT reference_count, vector FROM windows")
    assert {count >= 3 for count, _ in rows} == {True, False}
    for count, blob in rows:
        assert (blob is None) == (count < 3)
        assert blob is None or len(blob) == 4 * 3 * 10
