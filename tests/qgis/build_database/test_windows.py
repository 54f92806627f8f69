"""Windows of a database and their columns."""

import pytest
from built_database import SIZE
from made_inputs import METRIC_CRS, NORTH, WEST, spatial_reference
from osgeo import ogr, osr


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


def test_a_vector_has_three_rows_of_float32_and_is_null_with_fewer_than_three_references(query):
    rows = query("SELECT reference_count, vector FROM windows")
    assert {count >= 3 for count, _ in rows} == {True, False}
    for count, blob in rows:
        assert (blob is None) == (count < 3)
        assert blob is None or len(blob) == 4 * 3 * 10
