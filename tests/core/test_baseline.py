"""The tool that compares two recordings separates changes from rounding."""

import importlib
import importlib.util
import sys
from pathlib import Path

import numpy as np
import pytest

FOLDER = Path(__file__).parents[2] / "tools" / "baseline"
MANIFEST = {"complete": True, "quick": True, "commit": "abc", "versions": "none"}
ROWS = [{"name": f"window {n}", "x": n / 7, "plugin_version": "1"} for n in range(9)]
FIXES = {
    "a.png": {"status": "fix", "x": 0.1 + 0.2, "heading": float("nan")},
    "b.png": {"status": "no_match", "x": None},
}
PIXELS = np.arange(12, dtype=np.uint8).reshape(3, 4)


@pytest.fixture
def baseline(monkeypatch):
    """`baseline("compare")` returns that module of tools/baseline."""
    places = [str(FOLDER)]
    spec = importlib.util.spec_from_file_location("baseline", FOLDER / "__init__.py", submodule_search_locations=places)
    monkeypatch.setitem(sys.modules, "baseline", importlib.util.module_from_spec(spec))
    return lambda name: importlib.import_module(f"baseline.{name}")


@pytest.fixture
def compared(baseline, tmp_path, capsys):
    """`compared(rows, fixes, pixels)` returns exit status and text of comparing them with the ones above."""

    def run(rows=ROWS, fixes=FIXES, pixels=PIXELS, **options):
        store = baseline("store")
        for name, values in (("a", (ROWS, FIXES, PIXELS)), ("b", (rows, fixes, pixels))):
            folder = tmp_path / name
            store.empty_folder(folder)
            store.write_section(folder, "area", {"windows": values[0], "fixes": values[1]}, {"map/pixels": values[2]})
            store.write_json(folder / store.MANIFEST, MANIFEST)
        status = baseline("compare").compare(tmp_path / "a", tmp_path / "b", **{"every": True, **options})
        return status, capsys.readouterr().out

    return run


def counts(text, what):
    """Return the items, identical, close and different ones in the table's line of `what`."""
    line = next(line for line in text.splitlines() if line.startswith(f"{what} "))
    return tuple(int(cell) for cell in line.split("|")[1:])


def test_the_same_is_identical(compared):
    status, text = compared()
    assert status == 0 and "Nothing is different." in text
    assert counts(text, "area/windows") == (9, 9, 0, 0)
    assert counts(text, "area/fixes") == (2, 2, 0, 0)
    assert counts(text, "area/map/pixels") == (12, 12, 0, 0)


def test_what_is_identical_is_summed_up(compared):
    pixels = PIXELS + 1
    rows = [{**row, "x": 5.0} for row in ROWS]
    assert counts(compared(every=False)[1], "area/map") == (12, 12, 0, 0)
    text = compared(rows=rows, pixels=pixels, every=False)[1]
    assert counts(text, "area/map/pixels") == (12, 0, 0, 12) and counts(text, "all") == (23, 2, 0, 21)


def test_a_changed_value_is_found_and_named(compared):
    rows = [{**row, "x": 5.0} if row["name"] == "window 4" else row for row in ROWS]
    status, text = compared(rows=rows)
    assert status == 1 and counts(text, "area/windows") == (9, 8, 0, 1)
    assert f"row 4.x: {4 / 7!r} is 5.0" in text


def test_a_missing_row_is_one_difference(compared):
    status, text = compared(rows=ROWS[:3] + ROWS[4:])
    assert status == 1 and counts(text, "area/windows") == (9, 8, 0, 1)
    assert "row only in A" in text and "window 3" in text
    status, text = compared(fixes={"a.png": FIXES["a.png"]})
    assert status == 1 and "b.png: only in A" in text


def test_rounding_is_tolerated_and_counted(compared):
    rows = [{**row, "x": row["x"] * (1 + 1e-12)} for row in ROWS]
    status, text = compared(rows=rows, fixes={**FIXES, "a.png": {**FIXES["a.png"], "x": 0.3}})
    assert status == 0 and counts(text, "area/fixes") == (2, 1, 1, 0)
    assert counts(text, "area/windows")[3] == 0 and counts(text, "area/windows")[2] > 0
    assert compared(rows=[{**row, "x": row["x"] * (1 + 1e-8)} for row in ROWS])[0] == 1


def test_a_changed_pixel_is_found_and_other_shapes_are(compared):
    pixels = PIXELS.copy()
    pixels[1, 2] = 99
    status, text = compared(pixels=pixels)
    assert status == 1 and counts(text, "area/map/pixels") == (12, 11, 0, 1) and "[1, 2]: 6 is 99" in text
    assert compared(pixels=PIXELS.T)[0] == compared(pixels=PIXELS.astype(int))[0] == 1


def test_another_kind_of_value_is_a_difference(compared):
    assert compared(fixes={**FIXES, "b.png": {"status": "no_match", "x": 0}})[0] == 1
    assert compared(fixes={**FIXES, "b.png": {"status": "fix", "x": None}})[0] == 1


def test_versions_are_not_compared_and_rows_can_be_left_out(compared):
    assert compared(rows=[{**row, "plugin_version": "2"} for row in ROWS])[0] == 0
    status, text = compared(rows=[], ignore=["*/windows"])
    assert status == 0 and "Left out on request: */windows" in text


def test_additions_are_differences_unless_they_are_allowed(compared):
    rows = [{**row, "new": 1} for row in ROWS]
    fixes = {key: {**row, "new": 1} for key, row in FIXES.items()}
    assert compared(rows=rows)[0] == compared(fixes=fixes)[0] == 1
    status, text = compared(rows=rows, fixes={**fixes, "c.png": {}}, additions=True)
    assert status == 0 and "Only in B, and allowed: 4 things" in text
    assert compared(rows=ROWS[1:], additions=True)[0] == compared(rows=[*ROWS, ROWS[0]], additions=True)[0] == 1


def test_lines_may_be_added_between_others(baseline):
    without_additions = baseline("additions").without_additions
    assert without_additions(["a", "b"], ["a", "new", "b"]) == (["a", "b"], 1)
    assert without_additions(["a", "b"], ["b", "new", "a"]) == (["b", "new", "a"], 0)


def test_a_recording_that_was_cut_short_is_refused(baseline, tmp_path):
    store = baseline("store")
    store.write_json(tmp_path / store.MANIFEST, {"complete": False})
    with pytest.raises(store.RecordingError, match="cut short"):
        store.read_recording(tmp_path)
