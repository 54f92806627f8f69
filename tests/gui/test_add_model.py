"""The dialog *Add a model*: fields from the file or a preset, a test picture, and a new model in the list."""

import os

import numpy as np
import pytest
from dock_area import wait_until
from made_inputs import write_raster
from made_models import write_model
from qgis.core import QgsProcessingContext, QgsProject, QgsRasterLayer, QgsSettings

from semref.processing.inspection.models import choose_models_folder
from semref.ui.add_model import AddModelDialog
from semref.ui.model_list import ModelsDialog


@pytest.fixture
def models(plugin, tmp_path):
    """The list of models of an empty folder."""
    choose_models_folder(str(tmp_path / "models"))
    made = ModelsDialog()
    made.show()
    yield made
    made.close()
    made.deleteLater()
    QgsSettings().remove("semref/models_folder")


@pytest.fixture
def dialog(models):
    models.add.click()
    yield models.adding
    if models.adding is not None:
        models.adding.close()


@pytest.fixture
def photo(tmp_path):
    """A picture whose left half is blue, and whose right half is red."""
    pixels = np.zeros((3, 96, 128), np.uint8)
    pixels[2, :, :64] = pixels[0, :, 64:] = 250
    return str(write_raster(tmp_path / "photo.tif", pixels, transform=(0, 0.25, 0, 0, 0, -0.25)))


def name_classes(dialog, *names):
    for row, name in enumerate(names):
        dialog.classes.item(row, 0).setText(name)


def says(dialog, text: str) -> None:
    wait_until(lambda: text in dialog.state.text(), f"“{text}”, not “{dialog.state.text()}”")


def test_a_network_without_names_is_tested_and_added(models, dialog, photo, tmp_path):
    dialog.file.setFilePath(str(write_model(tmp_path / "bare.onnx", metadata={}, size=(64, 64))))
    says(dialog, "3 outputs")
    assert dialog.classes.rowCount() == 3 and not dialog.threshold.isEnabled()
    name_classes(dialog, "building", "water", "building")
    dialog.resolution_cm.setValue(25)
    dialog.picture.setValue(photo, QgsProcessingContext())
    dialog.test.click()
    says(dialog, "Enter the license")
    dialog.license.setText("CC0")
    dialog.test.click()
    says(dialog, "Check that the classes")
    assert [dialog.legend.item(n).text().replace("\u00a0", " ") for n in range(2)] == ["building: 50 %", "water: 50 %"]
    assert not dialog.labels.pixmap().isNull()
    assert not list((tmp_path / "models").glob("*.onnx"))
    dialog.add.click()
    wait_until(lambda: models.path() == str(tmp_path / "models" / "bare.onnx"), "the new model")
    assert "CC0" in models.card.toPlainText()


def test_the_test_picture_is_the_photo_of_the_project_not_its_label_map(models, photo, tmp_path):
    labels = write_raster(tmp_path / "labels.tif", np.ones((9, 9), np.uint8), names=["", "building"])
    layers = [QgsRasterLayer(str(path), name) for path, name in ((labels, "A labels"), (photo, "Photo"))]
    QgsProject.instance().addMapLayers(layers)
    dialog = AddModelDialog()
    assert dialog.picture.currentLayer().name() == "Photo"
    dialog.close()
    QgsProject.instance().removeAllMapLayers()
    dialog = AddModelDialog()
    assert dialog.picture.currentLayer() is None
    dialog.close()


def test_a_preset_fills_the_fields_and_a_checkpoint_asks_for_its_architecture(dialog, tmp_path):
    dialog.preset.setCurrentIndex(1)
    assert dialog.classes.rowCount() == 19 and dialog.classes.item(2, 0).text() == "road"
    assert dialog.mean.text() == "0.4121; 0.4348; 0.3993" and dialog.resolution_cm.value() == 20
    assert dialog.license.text().startswith("Etalab 2.0")
    dialog.preset.setCurrentIndex(2)
    assert dialog.classes.rowCount() == 1 and dialog.threshold.isEnabled()
    dialog.preset.setCurrentIndex(0)
    assert dialog.architecture.isHidden() and dialog.outputs.isHidden()
    (tmp_path / "others.pth").write_bytes(b"PK")
    dialog.file.setFilePath(str(tmp_path / "others.pth"))
    assert not dialog.architecture.isHidden() and not dialog.encoder.isHidden()
    dialog.outputs.setValue(5)
    assert dialog.classes.rowCount() == 5


def test_files_that_are_no_network_are_one_sentence(dialog, tmp_path):
    (tmp_path / "text.onnx").write_text("no network")
    dialog.file.setFilePath(str(tmp_path / "text.onnx"))
    says(dialog, "is not an ONNX model")
    dialog.file.setFilePath(str(write_model(tmp_path / "eight.onnx", metadata={}, batch=8)))
    says(dialog, "takes 8 images at once")


def test_a_dialog_that_is_closed_while_it_reads_leaves_nothing(dialog, photo, tmp_path):
    folder = dialog._folder.name
    dialog.file.setFilePath(str(write_model(tmp_path / "bare.onnx", metadata={})))
    dialog.close()
    assert not os.path.exists(folder)
