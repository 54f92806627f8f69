"""The windows of a database and what is known of each."""

from __future__ import annotations

import numpy as np
import pytest
from built_database import (
    HEIGHT,
    LEVEL,
    MINIMUM_AREA,
    NAME,
    SIZE,
    SIZE_COLUMN,
    STRIDE,
    VECTOR,
    WIDTH,
    content,
    map_labels,
)
from made_inputs import METRIC_CRS, NORTH, WEST, spatial_reference
from osgeo import ogr, osr


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
