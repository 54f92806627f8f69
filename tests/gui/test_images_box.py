"""The dock's box of images: what is added, dropped and removed there, and the model beside them."""

from __future__ import annotations

import pytest
from dock_area import add_raster_layer, dropped, from_the_layer_tree, messages


def test_dropped_files_are_added_once(dock, area, tab):
    from qgis.PyQt.QtCore import QMimeData, QPointF, Qt, QUrl
    from qgis.PyQt.QtGui import QDropEvent

    dropped = QMimeData()
    dropped.setUrls([QUrl.fromLocalFile(area.image), QUrl("https://example.org/image.png")])
    for _ in range(2):
        event = QDropEvent(
            QPointF(5, 5),
            Qt.DropAction.CopyAction,
            dropped,
            Qt.MouseButton.LeftButton,
            Qt.KeyboardModifier.NoModifier,
        )
        tab.images.list.dropEvent(event)
    assert tab.images.paths() == [area.image]


def test_selected_images_can_be_removed(dock, area, tab):
    tab.images.list.add([area.image, area.unreadable])
    tab.images.list.setCurrentRow(0)
    tab.images.remove.click()
    assert tab.images.paths() == [area.unreadable]


def test_a_raster_layer_of_the_project_is_an_image(dock, area, tab):
    from qgis.core import QgsProject

    tab.images.layers.aboutToShow.emit()
    assert not tab.images.layers.actions()[0].isEnabled()
    add_raster_layer(area.image, "aerial image")
    dock.content.database.file.setFilePath(area.database)
    dock.content.database.add_to_map.click()
    tab.images.layers.aboutToShow.emit()
    (action,) = tab.images.layers.actions()
    assert action.text() == "aerial image"
    QgsProject.instance().clear()
    action.trigger()
    assert tab.images.paths() == [area.image]


def test_layers_dropped_on_the_list_are_images_and_others_are_said(dock, iface, area, issues, tab):
    layer = add_raster_layer(area.image, "aerial image")
    assert dropped(tab.images.list, from_the_layer_tree(layer, issues))
    assert tab.images.paths() == [area.image]
    assert "issues: not added" in messages(iface)[0]


def test_a_dropped_folder_is_an_entry(dock, area, tmp_path, tab):
    from qgis.PyQt.QtCore import QMimeData, QUrl

    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(tmp_path))])
    assert dropped(tab.images.list, data)
    assert tab.images.paths() == [str(tmp_path)]


@pytest.fixture
def training_dialog(tab, monkeypatch):
    """Presses the dock's button; a dialog of ours stands for QGIS's, which needs its main window."""
    import processing
    from qgis.PyQt.QtCore import pyqtSignal
    from qgis.PyQt.QtWidgets import QDialog

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


def test_the_report_of_a_training_is_opened_from_a_message_and_not_in_qgis_s_results_viewer(
    tab, iface, tmp_path, training_dialog, monkeypatch
):
    from qgis.core import QgsApplication, QgsProcessingOutputFile, QgsProcessingOutputHtml
    from qgis.PyQt.QtGui import QDesktopServices
    from qgis.PyQt.QtWidgets import QPushButton

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
    assert messages(iface) == ["The model is trained, and chosen in the dock."]
    (button,) = [b for b in iface.bar.findChildren(QPushButton) if b.text() == "Open report"]
    button.click()
    assert opened == [page]
