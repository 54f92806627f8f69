"""Values that no build could write are refused and named."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from onboard_blobs import TABLE, build_blobs

from semref.core import limits
from semref.core.database.checks import require_sound


@pytest.fixture(scope="module")
def database():
    return build_blobs()


def changed(columns, name, value):
    """Return the columns with another value in their last row."""
    array = getattr(columns, name).astype(np.float64)
    array[-1] = value
    return replace(columns, **{name: array})


def test_what_a_build_makes_is_sound(database):
    require_sound(database.windows, database.references, database.parameters, TABLE)


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("centers", np.nan, "a window at nan, nan is outside the map"),
        ("levels", 3, "a window has a level that does not exist"),
        ("levels", 0, "a window has a level that does not exist"),
        ("counts", -1, "a window has an impossible number of landmarks"),
        ("sizes", 0, "a window has an impossible size"),
        ("sizes", 322 * 2.0, "a window has an impossible size"),
        ("vectors", np.inf, "a vector has values that are not valid numbers"),
    ],
)
def test_a_window_that_no_build_makes_is_refused(database, name, value, said):
    windows = changed(database.windows, name, value)
    with pytest.raises(ValueError, match=f"^{said}$"):
        require_sound(windows, database.references, database.parameters, TABLE)


def test_a_distinctiveness_may_be_unknown_but_not_negative(database):
    unknown = np.full(len(database.windows), np.nan)
    windows = replace(database.windows, distinctiveness=unknown)
    require_sound(windows, database.references, database.parameters, TABLE)
    with pytest.raises(ValueError, match="impossible distinctiveness"):
        require_sound(changed(windows, "distinctiveness", -0.1), database.references, database.parameters, TABLE)


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("positions", (600000.0 - 2.1, 5199900.0), "a landmark at 599998, 5.1999e\\+06 is outside the map"),
        ("areas_m2", 0, "a landmark has an impossible area"),
        ("areas_m2", 1e15, "a landmark has an impossible area"),
        ("classes", 3, "a landmark has a class that is not a reference class"),
    ],
)
def test_a_landmark_that_no_build_makes_is_refused(database, name, value, said):
    landmarks = changed(database.references, name, value)
    with pytest.raises(ValueError, match=f"^{said}$"):
        require_sound(database.windows, landmarks, database.parameters, TABLE)


@pytest.mark.parametrize("what", ["WINDOWS", "LANDMARKS"])
def test_more_rows_than_any_map_has_are_refused(database, monkeypatch, what):
    columns = database.windows if what == "WINDOWS" else database.references
    monkeypatch.setattr(limits, what, len(columns) - 1)
    with pytest.raises(ValueError, match=f"^it has {len(columns)} {what.lower()}$"):
        require_sound(database.windows, database.references, database.parameters, TABLE)
    monkeypatch.setattr(limits, what, len(columns))
    require_sound(database.windows, database.references, database.parameters, TABLE)
