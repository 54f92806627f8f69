import shutil
import time
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest
from dock_area import corners, localize, messages, results_of, settle, shown_outline, start, wait_until
from edited_database import KEPT, kept_database
from qgis.core import QgsPointXY, QgsProject, QgsSettings
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QFileDialog

from semref.core.localization import Method
from semref.processing.inspection.models import SHIPPED
from semref.ui.tabs.localize.inputs import ImageBox, MethodRow


@pytest.fixture
def saved(dock, area, tab, tmp_path, monkeypatch):
    """Path of a GeoPackage of the results of one image, which the dock shows."""
    path = tmp_path / "elsewhere" / "results.gpkg"
    path.parent.mkdir()
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    localize(dock, area.database, [area.image])
    tab.results.save.click()
    return path


@pytest.mark.parametrize("wait_s", [0, 2])
def test_a_project_closed_while_or_just_after_a_run_works_shows_nothing(dock, area, tab, wait_s):
    start(dock, area.database, [area.image])
    # The run ends in its thread, while the main thread hears nothing of it.
    time.sleep(wait_s)
    QgsProject.instance().clear()
    wait_until(lambda: not tab.run.running, "the end of the run")
    assert results_of(dock) == []


@pytest.mark.slow
def test_clearing_the_project_clears_the_dock(dock, iface, area, tab):
    localize(dock, area.database, [area.image])
    assert shown_outline(iface) is not None
    QgsProject.instance().clear()
    state = tab.state_now()
    assert (state.database, state.images, state.results, results_of(dock)) == ("", [], "", [])
    assert shown_outline(iface) is None
    # The next session offers it again.
    assert QgsSettings().value("semref/dock/database", "", type=str) == area.database


def test_a_project_without_model_and_method_leaves_those_of_the_next_session(dock, tab, repository):
    model = str(repository / "models" / "sample_area.onnx")
    tab.images.model.setFilePath(model)
    before = tab.method.method()
    QTest.keyClick(tab.method.choice, Qt.Key_Up)
    picked = tab.method.method()
    assert picked not in (before, Method.AUTOMATIC.number)
    QgsProject.instance().clear()
    assert (tab.images.model_path(), tab.method.method()) == ("", Method.AUTOMATIC.number)
    assert (ImageBox(dock.messages).model_path(), MethodRow().method()) == (model, picked)


@pytest.mark.slow
def test_the_project_brings_the_dock_back_as_it_was_saved(dock, iface, area, tmp_path, monkeypatch, tab):
    saved = str(tmp_path / "results.gpkg")
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (saved, ""))
    localize(dock, area.database, [area.image, area.unreadable])
    tab.results.save.click()
    tab.images.model.setFilePath("")
    tab.prior.set_circle(QgsPointXY(400_100, 5_399_900), QgsPointXY(400_160, 5_399_900))
    shown, before = results_of(dock), tab.state_now()
    project = QgsProject.instance()
    assert project.write(str(tmp_path / "project.qgs"))
    assert "/" + Path(area.database).name in (tmp_path / "project.qgs").read_text(encoding="utf-8")

    dock.prepare("", "", [])
    project.clear()
    assert (results_of(dock), tab.prior.circle) == ([], None)
    assert project.read(str(tmp_path / "project.qgs"))
    assert not project.isDirty()
    assert tab.state_now() == before
    assert before.prior[:2] == (400_100, 5_399_900) and before.results == saved
    assert results_of(dock) == shown
    assert corners(shown_outline(iface)) is not None
    assert tab.prior.text.text_shown == "Search area: radius 60 m"


@pytest.mark.slow
def test_a_project_whose_results_are_gone_is_opened_with_a_sentence(dock, iface, saved, tmp_path):
    QgsProject.instance().write(str(tmp_path / "project.qgs"))
    QgsProject.instance().clear()
    saved.unlink()
    iface.bar.clearWidgets()
    QgsProject.instance().read(str(tmp_path / "project.qgs"))
    assert "results.gpkg has no results" in messages(iface)[0]
    assert results_of(dock) == []


def test_a_project_without_the_dock_gets_an_empty_one(dock, area, tmp_path):
    (tmp_path / "other.qgs").write_text("<qgis version='3.22.0'/>", encoding="utf-8")
    localize(dock, area.database, [area.image])
    QgsProject.instance().read(str(tmp_path / "other.qgs"))
    assert (results_of(dock), dock.content.database.path()) == ([], "")


def test_a_project_of_another_profile_works_with_the_model_that_ships_here(dock, tab, tmp_path):
    elsewhere = tmp_path.joinpath("other profile", *SHIPPED.parts[-3:])
    own = tmp_path / "own" / "sample_area.onnx"
    for model, expected in ((elsewhere / "sample_area.onnx", SHIPPED / "sample_area.onnx"), (own, own)):
        tab.images.model.setFilePath(str(model))
        assert QgsProject.instance().write(str(tmp_path / "project.qgs"))
        QgsProject.instance().clear()
        assert QgsProject.instance().read(str(tmp_path / "project.qgs"))
        assert tab.images.model_path() == str(expected)


def test_results_go_and_come_back_with_their_database_and_stay_with_other_images(dock, iface, area, tab, tmp_path):
    localize(dock, area.database, [area.image])
    shown, other = results_of(dock), str(shutil.copy(area.database, tmp_path / "other.gpkg"))
    dock.content.database.file.setFilePath(other)
    assert (results_of(dock), shown_outline(iface), tab.state_now().results) == ([], None, "")
    dock.content.database.file.setFilePath(area.database)
    assert results_of(dock) == shown and shown_outline(iface) is not None and tab.state_now().results
    tab.images.list.add([area.unreadable])
    assert results_of(dock) == shown


@pytest.mark.slow
def test_earlier_results_are_shown_until_another_choice(dock, area, tab, tmp_path):
    localize(dock, area.database, [area.image])
    shown = results_of(dock)
    # The database is replaced, then another one is chosen.
    dock.choose_database(area.database)
    assert results_of(dock) == []
    dock.content.database.file.setFilePath(str(shutil.copy(area.database, tmp_path / "other.gpkg")))
    tab.results.earlier.aboutToShow.emit()
    tab.results.earlier.actions()[0].trigger()
    tab.images.list.add([area.unreadable])
    assert results_of(dock) == shown
    tab.images.model.setFilePath("/models/other.onnx")
    assert results_of(dock) == []


def test_a_message_that_waits_for_a_click_covers_others_and_goes_with_its_project(dock, iface, tab):
    tab.images._take_model(True, {"OUTPUT": "/models/own.onnx", "REPORT": "/models/report.html"})
    # QGIS reports the end of a run right after it.
    iface.bar.pushInfo("Task complete", "Executing")
    settle()
    assert iface.bar.currentItem().text() == "The model is trained and selected in the dock."
    QgsProject.instance().clear()
    settle()
    assert messages(iface) == ["Executing"]


@pytest.mark.slow
def test_saved_results_that_are_dropped_on_qgis_come_with_all_their_layers(iface, area, saved):
    QgsProject.instance().clear()
    (handler,) = iface.drop_handlers
    assert handler.handleFileDrop(str(saved)) and not handler.handleFileDrop(area.image)
    names = sorted(layer.name() for layer in QgsProject.instance().mapLayers().values())
    assert {f"results · SemRef {kind}" for kind in ("footprints", "positions", "matches")} <= set(names)


@pytest.mark.slow
def test_results_from_a_stranger_show_only_images_in_their_folder_or_in_the_list(iface, area, saved, monkeypatch, tab):
    state = tab.state_now()
    QgsProject.instance().clear()
    drawn = []
    monkeypatch.setattr(tab.hit._picture_reader, "read", lambda *given: drawn.append(given[2].image))
    tab.show_state(replace(state, images=[]))
    assert drawn == [] and "not in the folder of the results" in tab.results.image.canvas._text
    tab.hit.drape()
    assert any("not in the folder of the results" in text for text in messages(iface))
    tab.show_state(replace(state, images=[area.image]))
    assert drawn == [area.image]


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
    assert tab.state.text_shown == "1 of 2 images has a position."
    assert dock.content.database.path() == str(kept / "database.gpkg")
