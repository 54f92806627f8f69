"""Build parameters are read from a file exactly as written, or refused."""

from __future__ import annotations

import json
from dataclasses import asdict

import pytest

from semref.core.database.parameters import FORMAT_VERSION, BuildParameters, build_parameters
from semref.core.errors import DatabaseError

PARAMETERS = BuildParameters(
    "a metric CRS", (600.5, 2.0, 0.0, 5200.25, 0.0, -2.0), 300, 101, 2.0, 100.0, 50.0, (1.0, 2.0), 10, 100.0, 4,
    "map", "classes", "1.2.3", block_hashes=("a", "b"),
)  # fmt: skip


def stored(**changes):
    return {**json.loads(json.dumps(asdict(PARAMETERS))), **changes}


def test_what_was_written_comes_back_with_others_ignored():
    assert build_parameters(stored(later=5), "a.gpkg") == PARAMETERS


def test_the_overview_covers_the_last_pixels_of_the_map():
    assert PARAMETERS.extent == (600.5, 4998.25, 1200.5, 5200.25)
    assert (PARAMETERS.overview_frame.shape_hw, PARAMETERS.overview_frame.pixel_size) == ((26, 75), 8.0)


def test_a_missing_parameter_is_named():
    values = stored()
    del values["stride"]
    with pytest.raises(KeyError, match="stride"):
        build_parameters(values, "a.gpkg")


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("crs", 5),
        ("pixel_size", 0),
        ("stride", float("nan")),
        ("minimum_area", "100"),
        ("map_width_px", True),
        ("map_height_px", 1 << 31),
        ("overview_factor", 0),
        ("geotransform", [1, 2, 3]),
        ("levels", []),
        ("levels", ["1"]),
        ("block_hashes", [5]),
        ("format_version", "1"),
        ("references_per_vector", 100_000),
        ("geotransform", [600.5, 2.0, 0.5, 5200.25, 0.0, -2.0]),
        ("geotransform", [600.5, 2.0, 0.0, 5200.25, 0.0, -3.0]),
        ("geotransform", [1e300, 2.0, 0.0, 5200.25, 0.0, -2.0]),
    ],
)
def test_an_impossible_value_is_refused_by_name(name, value):
    with pytest.raises(ValueError, match=name):
        build_parameters(stored(**{name: value}), "a.gpkg")


def test_a_newer_version_is_reported_first():
    with pytest.raises(DatabaseError, match=f"a.gpkg has format version {FORMAT_VERSION + 1}, but this"):
        build_parameters({"format_version": FORMAT_VERSION + 1}, "a.gpkg")
