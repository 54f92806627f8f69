"""Desktop QGIS, as a user starts it, with the zip installed in a fresh profile."""

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
    source = ogr.GetDriverByName("GPKG").CreateDataSource(str(other))
    for table in ("roads", "rivers"):
        source.CreateLayer(table, geom_type=ogr.wkbPoint)
    del source
    variables = {"SEMREF_DATABASE": area.database, "SEMREF_OTHER": str(other)}
    return run_desktop(home, display, Path(__file__).with_name("desktop_session.py"), variables)


def test_a_database_that_is_dropped_on_qgis_comes_without_a_question_and_other_files_are_left_to_qgis(desktop):
    assert desktop["drops"]["database"] == {"asked": [], "layers": ["Landmarks", "Overview", "Windows"]}
    (asked,) = desktop["drops"]["other"]["asked"]
    assert asked.startswith("Select Items to Add")


def test_no_python_error_is_logged_and_qgis_quits_cleanly_with_the_plugin_loaded_after_a_failed_batch(desktop):
    assert desktop["tasks"] == 0
    assert desktop["messages"] == [] and [text for text in desktop["logged"] if "Traceback" in text] == []
    assert "Traceback" not in desktop["output"]
    assert desktop["stays"] is True
    assert desktop["exit_status"] == 0, desktop["output"]


def test_each_of_five_loads_brings_algorithms_and_parts_of_the_window_and_unloading_takes_them(desktop):
    assert len(desktop["rounds"]) == 5
    for one in desktop["rounds"]:
        assert (one["loaded"], one["unloaded"], one["left"]) == (True, True, [])
        assert "semref:rasterizeannotation" in one["algorithms"] and one["added"] != []


def test_annotations_are_checked_and_repaired_beside_the_geos_of_qgis(desktop):
    assert "invalid" in " ".join(desktop["check"]["kinds"])
    # The bow tie's two triangles of 100 m², and the square.
    assert abs(desktop["check"]["area"] - 600) < 0.1
