"""The whole job in desktop QGIS, its dialogs and its project: the sample, one's own photos and area, the correction."""

from __future__ import annotations

from pathlib import Path

import pytest
from desktop_qgis import walk

pytestmark = pytest.mark.slow  # a QGIS of its own is started


@pytest.fixture(scope="module")
def walks(repository, display, tmp_path_factory) -> dict:
    """What walk_job_session.py saw."""
    variables = {"SEMREF_SAMPLE": str(tmp_path_factory.mktemp("sample"))}
    script = Path(__file__).with_name("walk_job_session.py")
    return walk(repository, tmp_path_factory.mktemp("walks"), display, script, variables)


def test_no_walk_ends_in_a_python_error(walks):
    assert walks["messages"] == [] and "Traceback" not in walks["output"]


def test_the_sample_closed_and_reopened_shows_what_was_found(walks):
    assert walks["sample"] == {"before": 12, "emptied": 0, "after": 12}


def test_own_photos_are_found_and_laid_on_the_map(walks):
    assert walks["own_photos"] == {"listed": 3, "statuses": ["Position"] * 3, "layers": 1}


def test_windows_are_inspected_in_turn_by_name_and_on_the_map(walks):
    walked = walks["inspected"]
    assert all(walked["names"]) and len(set(walked["names"])) == 3
    assert walked["compared"] and walked["rows"] > 0


def test_a_layer_of_openstreetmap_becomes_the_dock_s_database(walks):
    walked = walks["own_area"]
    assert walked["in_the_dock"] and [name for name, _ in walked["groups"]] == ["own"]


def test_a_route_is_planned_and_the_file_for_the_aircraft_written(walks):
    walked = walks["planned"]
    assert walked["report"] > 5_000 and walked["file"] > 5_000 and walked["gap"] >= 0


def test_a_flight_is_placed_as_a_whole(walks):
    walked = walks["flown"]
    assert walked["is_flight"] and len(walked["statuses"]) == walked["listed"] == 6
    assert all(status in ("Position", "Position from the flight") for status in walked["statuses"])


def test_a_batch_is_opened_from_its_file_and_runs(walks):
    assert walks["batch"] == {"listed": 2, "made": [True, True]}


def test_a_database_built_in_the_toolbox_is_on_the_map_and_in_the_dock(walks):
    built = walks["built_by_keys"]
    assert built["groups"] == [["built", ["Landmarks", "Windows", "Overview"]]]
    assert built["in_the_dock"] and built["in_a_dialog"]


def test_a_check_is_gone_through_and_ends_in_the_updated_database(walks):
    walked = walks["corrected"]
    assert walked["is_chosen"] and walked["places"] and walked["has_undo"] and walked["left"] == 0
    assert walked["state"].startswith("The database is up to date")
