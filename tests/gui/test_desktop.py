"""Desktop QGIS, as a user starts it, with the zip installed in a fresh profile."""

import os
from pathlib import Path

import pytest
from desktop_qgis import install_package, run_desktop
from osgeo import ogr

pytestmark = pytest.mark.slow  # a QGIS of its own is started


@pytest.fixture(scope="module")
def desktop(repository, display, area, tmp_path_factory) -> dict:
    """What desktop_session.py saw in QGIS, with `exit_status` and `output` of the process."""
    home = tmp_path_factory.mktemp("desktop")
    install_package(repository, home / "profiles" / "default" / "python" / "plugins")
    other = home / "other.gpkg"
    for table in ("roads", "rivers"):
        write_layer(str(other), table)
    variables = {"SEMREF_DATABASE": area.database, "SEMREF_OTHER": str(other)}
    return run_desktop(home, display, Path(__file__).with_name("desktop_session.py"), variables)


def write_layer(path: str, table: str) -> None:
    driver = ogr.GetDriverByName("GPKG")
    source = driver.Open(path, 1) if os.path.exists(path) else driver.CreateDataSource(path)
    source.CreateLayer(table, geom_type=ogr.wkbPoint)
    del source


def test_a_database_that_is_dropped_on_qgis_comes_without_a_question(desktop):
    assert desktop["drops"]["database"] == {"asked": [], "layers": ["Landmarks", "Overview", "Windows"]}


def test_other_files_that_are_dropped_are_left_to_qgis(desktop):
    (asked,) = desktop["drops"]["other"]["asked"]
    assert asked.startswith("Select Items to Add")


def test_no_python_error_is_logged(desktop):
    assert [message["text"] for message in desktop["messages"] if "Traceback" in message["text"]] == []
    assert "Traceback" not in desktop["output"]


def test_the_plugin_loads_and_unloads_five_times(desktop):
    assert [(one["loaded"], one["unloaded"]) for one in desktop["rounds"]] == [(True, True)] * 5


def test_each_load_brings_the_algorithms_and_a_place_in_the_window(desktop):
    for one in desktop["rounds"]:
        assert "semref:rasterizeannotation" in one["algorithms"]
        assert one["added"] != []


def test_unloading_leaves_nothing_behind(desktop):
    assert [one["left"] for one in desktop["rounds"]] == [[]] * 5


def test_qgis_quits_cleanly_with_the_plugin_loaded(desktop):
    assert desktop["stays"] is True
    assert desktop["exit_status"] == 0, desktop["output"]


def test_annotations_are_checked_and_repaired_beside_the_geos_of_qgis(desktop):
    assert "invalid" in " ".join(desktop["check"]["kinds"])
    # The bow tie's two triangles of 100 m², and the square.
    assert abs(desktop["check"]["area"] - 600) < 0.1
