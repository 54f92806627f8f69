import contextlib
import sqlite3

import cv2
import numpy as np
import pytest
from dock_area import add_raster_layer, dropped, from_the_layer_tree, messages, settle, wait_until
from qgis.core import QgsApplication, QgsProcessingOutputFile, QgsProcessingOutputHtml
from qgis.PyQt.QtCore import QMimeData, QUrl, pyqtSignal
from qgis.PyQt.QtGui import QDesktopServices
from qgis.PyQt.QtWidgets import QDialog, QPushButton

from semref.processing.inspection.models import PHOTO_MODEL
from semref.storage.pictures import write_png

COLORS = np.random.default_rng(3).integers(0, 255, (3, 40, 40), np.uint8)


def test_dropped_files_and_layers_are_added_once_and_selected_ones_removed(dock, iface, area, issues, tab):
    data, images = QMimeData(), tab.images
    data.setUrls([QUrl.fromLocalFile(area.image), QUrl("https://example.org/image.png")])
    layer = add_raster_layer(area.image, "aerial image")
    for dragged in (data, data, from_the_layer_tree(layer, issues)):
        assert dropped(images.list, dragged)
    assert images.paths() == [area.image] and "not image files: issues" in messages(iface)[0]
    images.list.add([area.unreadable])
    images.list.setCurrentRow(0)
    images.remove.click()
    assert images.paths() == [area.unreadable]


@pytest.fixture
def training_dialog(tab, monkeypatch):
    """Press the dock's button; a stand-in replaces QGIS's dialog, which needs its main window."""
    import processing

    class Dialog(QDialog):
        algorithmFinished = pyqtSignal(bool, dict)

    asked = []
    monkeypatch.setattr(processing, "createAlgorithmDialog", lambda made, given: asked.append(made) or Dialog())
    tab.images.train.click()
    dialog = tab.images.training
    assert dialog.isVisible() and [algorithm.id() for algorithm in asked] == ["semref:trainmodel"]
    dialog.algorithm = asked[0]
    yield dialog
    tab.images.model.setFilePath("")
    dialog.close()


def test_a_model_that_is_trained_from_the_dock_is_the_chosen_one(tab, tmp_path, training_dialog):
    training_dialog.algorithmFinished.emit(False, {})
    assert tab.images.model_path() == ""
    training_dialog.algorithmFinished.emit(True, {"OUTPUT": str(tmp_path / "own.onnx")})
    assert tab.images.model_path() == str(tmp_path / "own.onnx")


def test_the_report_of_training_is_opened_from_a_message_not_by_qgis(
    tab, iface, tmp_path, training_dialog, monkeypatch
):
    # Dialogs and tasks make their own copies.
    for algorithm in (training_dialog.algorithm, training_dialog.algorithm.create()):
        report = algorithm.outputDefinition("REPORT")
        assert isinstance(report, QgsProcessingOutputFile) and not isinstance(report, QgsProcessingOutputHtml)
        assert algorithm.parameterDefinition("REPORT").defaultFileExtension() == "html"
    usual = QgsApplication.processingRegistry().createAlgorithmById("semref:trainmodel")
    assert isinstance(usual.outputDefinition("REPORT"), QgsProcessingOutputHtml)
    opened = []
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda address: opened.append(address.toLocalFile()))
    page = str(tmp_path / "report.html")
    training_dialog.algorithmFinished.emit(True, {"OUTPUT": str(tmp_path / "own.onnx"), "REPORT": page})
    settle()
    assert messages(iface) == ["The model is trained and selected in the dock."]
    (button,) = [b for b in iface.bar.findChildren(QPushButton) if b.text() == "Open report"]
    button.click()
    assert opened == [page]


@pytest.fixture
def photo_folder(tmp_path):
    folder = tmp_path / "photos"
    folder.mkdir()
    for number in range(3):
        cv2.imwrite(str(folder / f"{number}.jpg"), COLORS.transpose(1, 2, 0))
    (folder / "notes.txt").write_text("of the flight", encoding="utf-8")
    return folder


def test_photos_get_the_model_of_buildings_and_are_not_ready_without_it(dock, area, tab, photo_folder):
    dock.content.database.file.setFilePath(area.database)
    tab.images.list.add([str(photo_folder)])
    wait_until(lambda: tab.images.title() == "Images (3)", "the count")
    assert tab.images.model_path() == str(PHOTO_MODEL)
    assert tab.state.text_shown == "Ready to localize."
    tab.images.model.setFilePath("")
    assert tab.state.text_shown.startswith("These are photos: choose a model.")
    tab.images.list.add([area.image])
    wait_until(lambda: tab.images.title() == "Images (4)", "the count")


def test_pictures_with_the_colors_of_photos_are_photos_whatever_their_names(dock, area, tab, tmp_path):
    photo, labels = tmp_path / "photo.png", tmp_path / "labels.png"
    write_png(photo, COLORS)
    write_png(labels, COLORS // 100 * 100)
    dock.content.database.file.setFilePath(area.database)
    tab.images.list.show_only([str(labels)])
    wait_until(lambda: tab.images._reader._task is None, "the look")
    assert tab.state.text_shown == "Ready to localize."
    assert tab.images.model_path() == ""
    tab.images.list.show_only([str(photo)])
    wait_until(lambda: tab.images.model_path() == str(PHOTO_MODEL), "the look")


def test_a_folder_without_images_is_refused_before_a_run(dock, area, tab, tmp_path):
    dock.content.database.file.setFilePath(area.database)
    tab.images.list.add([str(tmp_path)])
    wait_until(lambda: tab.images.fault, "the look")
    assert "no image" in tab.state.text_shown and not tab.localize_button.isEnabled()
    tab.images.list.show_only([area.image])
    assert tab.state.text_shown == "Ready to localize." and tab.localize_button.isEnabled()


def test_what_is_found_out_about_images_does_not_replace_the_end_of_a_run(dock, area, tab, photo_folder):
    dock.content.database.file.setFilePath(area.database)
    tab.images.model.setFilePath(str(PHOTO_MODEL))
    tab.images.list.add([str(photo_folder)])
    tab.state.show_text("2 of 3 images have a position.")
    wait_until(lambda: tab.images.title() == "Images (3)", "the count")
    assert tab.state.text_shown == "2 of 3 images have a position."


@pytest.mark.slow
@pytest.mark.parametrize("content", [b"<html>no database</html>", b"", None], ids=["html", "empty", "of others"])
def test_a_file_that_is_no_database_is_refused_before_a_run(dock, area, tab, tmp_path, content):
    path = tmp_path / "index.html"
    if content is None:
        with contextlib.closing(sqlite3.connect(path)) as other:
            other.execute("CREATE TABLE features (fid INTEGER)")
    else:
        path.write_bytes(content)
    box = dock.content.database
    tab.images.list.add([area.image])
    box.setCollapsed(True)
    box.file.setFilePath(str(path))
    wait_until(lambda: box.fault, "the look")
    assert not tab.localize_button.isEnabled() and tab.state.text_shown == "Choose a database."
    assert box.fault.startswith("index.html is not a") and "choose" in box.fault
    assert box.fault_label.isVisible() and box.fault_label.text() == box.fault and not box.add_to_map.isEnabled()
    box.file.setFilePath(area.database)
    wait_until(lambda: box._reader._task is None, "the look")
    assert box.fault_label.isHidden() and tab.localize_button.isEnabled()
    assert tab.state.text_shown == "Ready to localize."
