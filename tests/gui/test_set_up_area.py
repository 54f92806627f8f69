import re
import shutil
from pathlib import Path

import pytest
from dock_area import messages, settle, wait_until
from made_inputs import write_photo
from qgis.core import QgsProject, QgsRasterLayer, QgsVectorLayer, QgsWkbTypes
from qgis.PyQt.QtGui import QDesktopServices
from qgis.PyQt.QtWidgets import QCheckBox, QFileDialog

from semref.processing.packages import training_environment
from semref.ui.set_up_area import add_area


@pytest.fixture
def dialog(dock):
    dock.set_up_area()
    return dock.setting_up


@pytest.fixture
def project_map(sample):
    # Not returned: QGIS deletes it with the project.
    QgsProject.instance().addMapLayer(QgsVectorLayer(str(sample / "landcover.shp"), "land cover", "ogr"))


def shows(dialog, text: str) -> None:
    wait_until(lambda: text in dialog.summary.text(), f"“{text}”, not “{dialog.summary.text()}”")


def test_a_dock_without_a_database_offers_it(dock):
    assert not dock.content.database.set_up.isHidden()
    dock.content.database.set_up.click()
    assert dock.setting_up.isVisible()
    dock.content.database.file.setFilePath("any.gpkg")
    assert dock.content.database.set_up.isHidden()


def test_it_asks_for_what_is_missing_and_shows_sizes(project_map, dialog, sample, repository, tmp_path, monkeypatch):
    dialog.model.setFilePath(str(repository / "models" / "sample_area.onnx"))
    shows(dialog, "enter the ground width of a typical photo")
    assert not dialog.start.isEnabled()
    dialog.width_m.setValue(640)
    shows(dialog, "0 photos. Window 480 m")
    # Several photos are chosen at once.
    chosen = [str(sample / "photos" / f"photo_{n:02d}.jpg") for n in (1, 3)]
    monkeypatch.setattr(QFileDialog, "getOpenFileNames", lambda *_: (chosen, ""))
    dialog.add_files.click()
    assert dialog.parameters()["PHOTOS"] == chosen
    shows(dialog, "2 photos.")
    wait_until(lambda: dialog.summary.text().startswith("Choose a folder for the results"), "what is missing, first")
    assert not dialog.start.isEnabled()
    dialog.folder.setFilePath(str(tmp_path / "results"))
    wait_until(dialog.start.isEnabled, "the button Run")
    dialog.minutes.setValue(5)
    shows(dialog, "Training needs a Python with torch.")
    assert not dialog.start.isEnabled()
    monkeypatch.setattr(training_environment, "training_python", lambda: "python")
    dialog.minutes.setValue(6)
    shows(dialog, "The model is trained on the photos that get a position.")
    opened = []
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: opened.append(url.toLocalFile()))
    dialog.help.click()
    assert Path(opened[0]).is_file() and "own_area_and_photos" in opened[0]


def test_a_long_summary_cuts_off_no_field_on_a_small_screen(dialog):
    dialog.summary.setText("A long warning.\n" * 40)
    dialog.resize(dialog.width(), 480)
    settle()
    assert dialog.height() < 650 and dialog.map.height() >= dialog.map.sizeHint().height()


def test_the_only_map_and_orthophoto_of_each_project_are_chosen(dock, sample):
    project = QgsProject.instance()
    for _ in range(2):
        project.clear()
        project.addMapLayer(QgsVectorLayer("Polygon?crs=EPSG:32632", "a sketch", "memory"))
        project.addMapLayer(QgsVectorLayer(str(sample / "landcover.shp"), "land cover", "ogr"))
        project.addMapLayer(QgsRasterLayer(str(sample / "orthophoto.tif"), "orthophoto"))
        dock.set_up_area()
        given = dock.setting_up.parameters()
        names = [project.mapLayer(given[key]).name() for key in ("ANNOTATION", "IMAGERY")]
        assert names == ["land cover", "orthophoto"] and given["LINES"] is None
        dock.setting_up.hide()


def test_only_the_selected_polygons_are_read_if_the_user_wants_that(project_map, dialog, repository):
    (layer,) = QgsProject.instance().mapLayersByName("land cover")
    layer.selectByExpression("class = 'building'", QgsVectorLayer.SetSelection)
    layer.selectByIds(layer.selectedFeatureIds()[:40])
    dialog.model.setFilePath(str(repository / "models" / "sample_area.onnx"))
    dialog.width_m.setValue(640)
    (selected_only,) = dialog.map.findChildren(QCheckBox)
    selected_only.setChecked(True)
    shows(dialog, "(building)")
    (count,) = re.findall(r"(\d+) polygons", dialog.summary.text())
    assert 0 < int(count) <= 40
    dialog.width_m.setValue(6400)
    shows(dialog, "A typical photo shows 6400 m of ground, more than the map")


def test_photos_with_times_are_one_flight_until_the_user_says_no(project_map, dialog, repository, tmp_path):
    for n in range(3):
        write_photo(tmp_path / f"{n}.jpg", DateTimeOriginal=f"2026:05:01 10:00:{n:02}")
    dialog.model.setFilePath(str(repository / "models" / "sample_area.onnx"))
    dialog.width_m.setValue(640)
    dialog.photos.setFilePath(str(tmp_path))
    shows(dialog, "3 photos.")
    assert dialog.flight.isChecked() and dialog.parameters()["FLIGHT"]
    dialog.flight.setChecked(False)
    dialog.width_m.setValue(6400)
    shows(dialog, "more than the map")
    assert not dialog.flight.isChecked()


@pytest.fixture
def started(project_map, dialog, sample, repository, tmp_path, request):
    photos = tmp_path / "photos"
    photos.mkdir()
    for n in (1, 2):
        shutil.copy(sample / "photos" / f"photo_{n:02d}.jpg", photos)
    dialog.photos.setFilePath(str(photos))
    dialog.width_m.setValue(640)
    dialog.model.setFilePath(str(repository / "models" / "sample_area.onnx"))
    dialog.folder.setFilePath(str(tmp_path / "results"))
    wait_until(dialog.start.isEnabled, "the button Run")
    dialog.flight.setChecked(getattr(request, "param", False))
    dialog.start.click()
    assert dialog.start.text() == "Cancel"
    return dialog


@pytest.mark.slow
@pytest.mark.parametrize("started", [False, True], indirect=True, ids=["images", "flight"])
def test_a_run_shows_map_landmarks_and_positions(dock, iface, started, tmp_path):
    wait_until(lambda: not started.isVisible() or started.start.text() == "Run", "the end of the run")
    assert not started.isVisible(), started.summary.text()
    names = [node.name() for node in QgsProject.instance().layerTreeRoot().findLayers()]
    is_flight = dock.content.localize.images.flight.isChecked()
    track = ["SemRef track"] if is_flight else []
    shown = ["SemRef positions", "SemRef footprints", *track, "Landmarks"]
    assert is_flight is started.flight.isChecked() and [*names[: len(shown)], names[-1]] == [*shown, "land cover"]
    assert dock.content.database.path() == str(tmp_path / "results" / "reference_database.gpkg")
    assert dock.content.localize.state.text_shown.startswith("2 of 2 images have a position")
    wait_until(lambda: any("The area is set up" in text for text in messages(iface)), "the message")
    assert Path(started.folder.filePath(), "report.html").is_file()


def test_the_polygons_of_an_extract_join_the_project(loaded, area, tmp_path):
    corners = ((1, 0, 0), (2, 0, 1), (3, 1, 0))
    nodes = "".join(f'<node id="{n}" lat="{y}" lon="{x}"><tag k="name" v="a"/></node>' for n, y, x in corners)
    way = "".join(f'<nd ref="{n}"/>' for n in (1, 2, 3, 1))
    extract = tmp_path / "town.osm"
    extract.write_text(f'<osm version="0.6">{nodes}<way id="9">{way}<tag k="building" v="yes"/></way></osm>')
    add_area({"DATABASE": area.database}, {"ANNOTATION": str(extract)}, QgsProject.instance())
    (layer,) = QgsProject.instance().mapLayersByName("town")
    assert layer.geometryType() == QgsWkbTypes.GeometryType.PolygonGeometry


@pytest.mark.slow
def test_a_run_of_a_closed_project_adds_nothing_to_the_next_one(dock, started, tmp_path):
    QgsProject.instance().clear()
    wait_until(lambda: started.start.text() == "Run", "the end of the run")
    assert f"The files are in {tmp_path / 'results'}" in started.summary.text()
    assert not QgsProject.instance().mapLayers() and not dock.content.database.path()
