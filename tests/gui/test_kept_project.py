"""A project that an earlier version saved opens forever; tests/data/kept never changes."""

import zipfile
from pathlib import Path

import pytest
from dock_area import messages, results_of, settle, shown_outline, wait_until
from edited_database import KEPT, kept_database
from qgis.core import QgsProject


@pytest.fixture
def kept(tmp_path):
    """The project's folder, moved to another place and perhaps another machine."""
    with zipfile.ZipFile(KEPT / "project.zip") as packed:
        packed.extractall(tmp_path)
    kept_database(tmp_path / "database.gpkg")
    return tmp_path


def test_a_project_of_version_1_brings_dock_layers_and_results_back(dock, iface, tab, kept):
    project = QgsProject.instance()
    assert project.read(str(kept / "project.qgs"))
    settle()
    state = tab.state_now()
    assert (Path(state.database), state.model, state.method) == (kept / "database.gpkg", "", 0)
    assert [Path(path) for path in state.images] == [kept / "here.png", kept / "nothing.png"]
    assert Path(state.results) == kept / "results.gpkg"
    assert state.prior == (600200.0, 5199600.0, 600700.0, 5199600.0, "EPSG:25832")
    (first, found), (second, not_found) = results_of(dock)
    assert (first, second) == ("here.png", "nothing.png")
    assert found == "Position" != not_found
    assert tab.results.list.selected().confidence > 0.9
    assert shown_outline(iface) is not None
    layers = {layer.name(): layer for layer in project.mapLayers().values()}
    assert set(layers) == {"Landmarks", "Windows", "Overview", "results"}
    assert all(layer.isValid() for layer in layers.values())
    assert not project.isDirty() and [text for text in messages(iface) if "SemRef" in text] == []


@pytest.mark.slow
def test_a_project_of_version_1_can_be_worked_with(dock, tab, kept):
    QgsProject.instance().read(str(kept / "project.qgs"))
    settle()
    tab.localize_button.click()
    wait_until(lambda: not tab.run.running, "the end of the run")
    assert tab.state.text_shown == "1 of 2 images have a position."
    assert dock.content.database.path() == str(kept / "database.gpkg")
