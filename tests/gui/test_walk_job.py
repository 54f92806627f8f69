"""The whole job on the sample area, in desktop QGIS, by mouse and by the keyboard alone; each is counted and timed."""

from __future__ import annotations

from pathlib import Path

import pytest
from desktop_qgis import walk

pytestmark = pytest.mark.slow  # a QGIS of its own is started


@pytest.fixture(scope="module")
def sample(tmp_path_factory) -> Path:
    """The folder of the sample: made in the first session, opened in the second."""
    return tmp_path_factory.mktemp("sample")


@pytest.fixture(scope="module", params=["mouse", "keys"])
def walks(request, repository, display, sample, tmp_path_factory) -> dict:
    """What walk_job_session.py saw."""
    variables = {"SEMREF_SAMPLE": str(sample), "SEMREF_WAY": request.param}
    script, home = Path(__file__).with_name("walk_job_session.py"), tmp_path_factory.mktemp(request.param)
    return walk(repository, home, display, script, variables, f"walk_job_{request.param}.json")


def most(walked: dict, clicks: int, keys: int) -> bool:
    """Whether a walk took so many clicks, and none by keys, or so many keys at most, and no click."""
    return (walked["clicks"], walked["keys"]) == (clicks, 0) or (walked["clicks"] == 0 < walked["keys"] <= keys)


def test_no_walk_ends_in_a_python_error(walks):
    assert walks["messages"] == [] and "Traceback" not in walks["output"]


def test_the_sample_closed_and_reopened_shows_what_was_found(walks):
    walked = walks["sample, closed, reopened"]
    assert (walked["before"], walked["emptied"], walked["after"]) == (12, 0, 12)
    assert most(walked, 4, 40)


def test_own_photos_are_found_and_laid_on_the_map(walks):
    walked = walks["own photos"]
    assert walked["listed"] == 3 and walked["statuses"] == ["Fix"] * 3 and walked["layers"] == 1
    assert walked["values"] == 3 and most(walked, 4, 90)


def test_windows_are_inspected_in_turn_by_name_and_on_the_map(walks):
    walked = walks["inspect"]
    assert all(walked["names"]) and len(set(walked["names"])) == 3
    assert walked["compared"] and walked["rows"] > 0 and most(walked, 6, 60)


def test_a_layer_of_openstreetmap_becomes_the_dock_s_database(walks):
    walked = walks["own area"]
    assert walked["in_the_dock"] and walked["groups"] == ["own"]


def test_the_model_runs_as_other_algorithms_do(walks):
    assert most(walks["own area"], 6, 30)


def test_a_route_is_planned_and_the_file_for_the_aircraft_written(walks):
    walked = walks["assess, route, export"]
    assert walked["report"] > 5_000 and walked["file"] > 5_000 and walked["gap"] >= 0


def test_a_flight_is_placed_as_a_whole(walks):
    walked = walks["flight"]
    assert walked["is_flight"] and len(walked["statuses"]) == walked["listed"] == 6
    assert all(status in ("Fix", "By the flight") for status in walked["statuses"])


def test_a_batch_is_opened_from_its_file_and_runs(walks):
    if "batch" not in walks:
        pytest.skip("without the mouse QGIS's table of a batch is not left again")
    walked = walks["batch"]
    assert walked["listed"] == 2 and walked["made"] == [True, True]
