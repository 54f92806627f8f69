import json
from dataclasses import asdict, replace

import numpy as np
import pytest
from onboard_blobs import TABLE, build_blobs

from semref.core import limits
from semref.core.database.checks import require_sound
from semref.core.database.parameters import FORMAT_VERSION, BuildParameters, build_parameters
from semref.core.errors import DatabaseError


@pytest.fixture(scope="module")
def database():
    return build_blobs()


def changed(columns, name, value):
    array = getattr(columns, name).astype(np.float64)
    array[-1] = value
    return replace(columns, **{name: array})


def test_what_a_build_makes_is_sound(database):
    require_sound(database.windows, database.references, database.parameters, TABLE)


@pytest.mark.parametrize(
    ("group", "name", "value", "said"),
    [
        ("windows", "centers", np.nan, "a window at nan, nan is outside the map"),
        *(("windows", "levels", value, "a window has a level that does not exist") for value in (3, 0)),
        ("windows", "counts", -1, "a window has an impossible number of landmarks"),
        *(("windows", "sizes", value, "a window has an impossible size") for value in (0, 322 * 2.0)),
        ("windows", "vectors", np.inf, "a vector has values that are not valid numbers"),
        ("references", "positions", (599997.9, 5199900.0), "a landmark at 599998, 5.1999e\\+06 is outside the map"),
        *(("references", "areas_m2", value, "a landmark has an impossible area") for value in (0, 1e15)),
        ("references", "classes", 3, "a landmark has a class that is not a reference class"),
    ],
)
def test_a_window_or_landmark_that_no_build_makes_is_refused(database, group, name, value, said):
    parts = {"windows": database.windows, "references": database.references}
    parts[group] = changed(parts[group], name, value)
    with pytest.raises(ValueError, match=f"^{said}$"):
        require_sound(parts["windows"], parts["references"], database.parameters, TABLE)


def test_a_distinctiveness_may_be_unknown_but_not_negative(database):
    unknown = np.full(len(database.windows), np.nan)
    windows = replace(database.windows, distinctiveness=unknown)
    require_sound(windows, database.references, database.parameters, TABLE)
    with pytest.raises(ValueError, match="impossible distinctiveness"):
        require_sound(changed(windows, "distinctiveness", -0.1), database.references, database.parameters, TABLE)


@pytest.mark.parametrize("what", ["WINDOWS", "LANDMARKS"])
def test_more_rows_than_any_map_has_are_refused(database, monkeypatch, what):
    columns = database.windows if what == "WINDOWS" else database.references
    monkeypatch.setattr(limits, what, len(columns) - 1)
    with pytest.raises(ValueError, match=f"^it has {len(columns)} {what.lower()}$"):
        require_sound(database.windows, database.references, database.parameters, TABLE)
    monkeypatch.setattr(limits, what, len(columns))
    require_sound(database.windows, database.references, database.parameters, TABLE)


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
        *{"pixel_size": 0, "stride": float("nan"), "minimum_area": "100", "map_width_px": True, "crs": 5}.items(),
        *{"map_height_px": 1 << 31, "references_per_vector": 100_000, "overview_factor": 0}.items(),
        *{"levels": [], "block_hashes": [5], "format_version": "1", "geotransform": [1, 2, 3]}.items(),
        ("levels", ["1"]),
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
