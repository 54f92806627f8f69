"""The dock's box of images: what is added, dropped and removed there, and the model beside them."""

from __future__ import annotations

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


def test_a_model_that_is_trained_from_the_dock_is_the_chosen_one(tab, tmp_path, monkeypatch):
    import processing
    from qgis.PyQt.QtCore import pyqtSignal
    from qgis.PyQt.QtWidgets import QDialog

    class Dialog(QDialog):
        """Stands for QGIS's, which needs its main window."""

        algorithmFinished = pyqtSignal(bool, dict)

    asked = []
    monkeypatch.setattr(processing, "createAlgorithmDialog", lambda name, given: asked.append(name) or Dialog())
    tab.images.train.click()
    dialog = tab.images.training
    assert dialog.isVisible() and asked == ["semref:trainmodel"]
    dialog.algorithmFinished.emit(False, {})
    assert tab.images.model_path() == ""
    dialog.algorithmFinished.emit(True, {"OUTPUT": str(tmp_path / "own.onnx")})
    assert tab.images.model_path() == str(tmp_path / "own.onnx")
    tab.images.model.setFilePath("")
    dialog.close()
