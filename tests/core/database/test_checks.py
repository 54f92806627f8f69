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
    ("group", "name", "value", "said"),
    [
        ("windows", "centers", np.nan, "a window at nan, nan is outside the map"),
        ("windows", "levels", 3, "a window has a level that does not exist"),
        ("windows", "levels", 0, "a window has a level that does not exist"),
        ("windows", "counts", -1, "a window has an impossible number of landmarks"),
        ("windows", "sizes", 0, "a window has an impossible size"),
        ("windows", "sizes", 322 * 2.0, "a window has an impossible size"),
        ("windows", "vectors", np.inf, "a vector has values that are not valid numbers"),
        ("references", "positions", (599997.9, 5199900.0), "a landmark at 599998, 5.1999e\\+06 is outside the map"),
        ("references", "areas_m2", 0, "a landmark has an impossible area"),
        ("references", "areas_m2", 1e15, "a landmark has an impossible area"),
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
