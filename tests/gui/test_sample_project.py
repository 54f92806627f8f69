"""The first run: the sample project from the menu, as a person clicks it; the file dialog stubbed."""

from pathlib import Path

import pytest
from dock_area import settle, wait_until
from qgis.core import Qgis, QgsApplication, QgsProject, QgsVectorLayer
from qgis.PyQt.QtWidgets import QFileDialog

from semref.ui import sample_project
from semref.ui.sample_project import DATABASE_FILE, MARKER, sample_folder


@pytest.fixture
def plugin(sample, loaded):
    return loaded


@pytest.fixture
def open_sample(plugin, iface, monkeypatch):
    """`open_sample(folder)` clicks the menu entry and picks that folder."""

    def click(folder: Path) -> None:
        monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(folder))
        action = next(action for action in iface.menu_actions if action.objectName() == "SemRefSampleAction")
        action.trigger()

    return click


def messages(iface) -> list:
    return [(item.level(), item.text()) for item in iface.bar.items()]


def layers() -> dict:
    return {node.name(): node.isVisible() for node in QgsProject.instance().layerTreeRoot().findLayers()}


def is_open() -> bool:
    return "Land cover" in layers()


def wait_until_open(iface) -> None:
    def failed() -> bool:
        return Qgis.MessageLevel.Critical in [level for level, _ in messages(iface)]

    wait_until(lambda: is_open() or failed(), "the sample project")
    assert is_open(), messages(iface)
    settle()


@pytest.mark.slow
def test_the_sample_project_opens_styled_with_the_dock_ready_on_the_first_photo(open_sample, iface, tmp_path):
    (tmp_path / "letter.txt").write_text("of somebody", encoding="utf-8")
    open_sample(tmp_path)
    wait_until_open(iface)
    folder = tmp_path / "semref_sample"
    project, dock = QgsProject.instance(), iface.docks[0]
    assert Path(project.fileName()) == folder / "semref_sample.qgz"
    assert (project.crs().authid(), project.isDirty()) == ("EPSG:25832", False)
    visible, hidden = ("Landmarks", "Land cover", "Orthophoto"), ("Windows", "Overview", "Label map")
    assert layers() == {**dict.fromkeys(visible, True), **dict.fromkeys(hidden, False)}
    cover = project.mapLayersByName("Land cover")[0]
    assert {c.value(): c.symbol().color().name() for c in cover.renderer().categories()}["building"] == "#e3211c"
    assert cover.renderer().orderByEnabled()
    assert dock.isVisible()
    assert dock.content.database.path() == str(folder / "reference_database.gpkg")
    assert Path(dock.content.localize.images.model_path()).name == "sample_area.onnx"
    names = [Path(path).name for path in dock.content.localize.images.paths()]
    assert names == [f"photo_{n:02d}.jpg" for n in range(1, 13)]
    assert dock.content.localize.images.list.currentRow() == 0
    assert dock.content.localize.localize_button.isEnabled()
    assert "Press “Localize”" in messages(iface)[0][1]
    assert (tmp_path / "letter.txt").exists()
    assert not [path for path in folder.iterdir() if path.name.startswith(".")]

    pytest.importorskip("onnxruntime")
    dock.content.localize.images.list.show_only(dock.content.localize.images.paths()[:2])
    dock.content.localize.localize_button.click()
    wait_until(lambda: not dock.content.localize.run.running, "the localization")
    settle()
    state = dock.content.localize.state
    assert state.text().startswith("2 of 2 images have a position.") and "tiles per second" in state.toolTip()

    # The project's own file knows the dock: opened as any project is, it brings all of it back.
    project.clear()
    settle()
    assert dock.content.localize.images.paths() == []
    assert project.read(str(folder / "semref_sample.qgz"))
    settle()
    assert dock.content.database.path() == str(folder / "reference_database.gpkg")
    assert len(dock.content.localize.images.paths()) == 12
    assert not project.isDirty()

    # Once more: what is there is opened, not made again.
    made = (folder / "sample.json").stat().st_mtime_ns, (folder / "reference_database.gpkg").stat().st_ino
    project.clear()
    open_sample(folder)
    wait_until_open(iface)
    assert made == ((folder / "sample.json").stat().st_mtime_ns, (folder / "reference_database.gpkg").stat().st_ino)
    assert len(dock.content.localize.images.paths()) == 12


def test_an_empty_folder_is_used_itself(tmp_path):
    assert sample_folder(tmp_path) == tmp_path
    (tmp_path / "letter.txt").write_text("of somebody", encoding="utf-8")
    assert sample_folder(tmp_path) == tmp_path / "semref_sample"


def test_another_folder_of_that_name_is_reported_and_not_changed(open_sample, iface, tmp_path):
    (tmp_path / "semref_sample").mkdir()
    (tmp_path / "semref_sample" / "letter.txt").write_text("of somebody", encoding="utf-8")
    open_sample(tmp_path)
    wait_until(lambda: [level for level, _ in messages(iface)] == [Qgis.MessageLevel.Critical], "the refusal")
    assert "left alone" in messages(iface)[0][1]
    assert [path.name for path in tmp_path.rglob("*") if path.is_file()] == ["letter.txt"]
    assert not is_open()


def test_a_canceled_task_opens_nothing(open_sample, iface, tmp_path):
    open_sample(tmp_path)
    settle()
    (task,) = QgsApplication.taskManager().activeTasks()
    task.cancel()
    wait_until(lambda: not QgsApplication.taskManager().activeTasks(), "the end")
    assert not [path for path in tmp_path.iterdir() if path.name.startswith((".", "label_map", "reference"))]
    assert not is_open()


def test_a_message_shows_the_path_of_the_sample_if_the_user_keeps_the_open_project(plugin, iface, tmp_path):
    for name in (MARKER, DATABASE_FILE):
        (tmp_path / name).touch()
    QgsProject.instance().addMapLayer(QgsVectorLayer("Point", "unsaved work", "memory"))
    iface.lets_projects_go = False
    plugin._entry._sample_project().make(tmp_path)
    assert list(layers()) == ["unsaved work"]
    assert str(tmp_path) in messages(iface)[0][1]


def test_a_copy_of_the_plugin_without_the_sample_reports_that(open_sample, iface, tmp_path, monkeypatch):
    monkeypatch.setattr(sample_project, "SAMPLE", tmp_path / "nowhere")
    open_sample(tmp_path)
    assert "has no sample area" in messages(iface)[0][1]
    assert list(tmp_path.iterdir()) == []
