import html
import json
import os

import numpy as np
import pytest
from dock_area import wait_until
from made_inputs import write_raster
from made_models import smallest_model, write_model
from qgis.core import QgsProcessingContext, QgsProject, QgsRasterLayer, QgsSettings

from semref.core.segmentation.onnx_file import with_metadata
from semref.processing.inspection.models import choose_models_folder
from semref.ui.add_model import AddModelDialog
from semref.ui.model_list import ModelsDialog

CARD = {
    "name": "Houses of two towns",
    "date": "2026-11-22",
    "trained_on": [{"place": "Uganda", "about": "houses and sheds"}, {"place": "Nepal"}],
    "tested_on": [{"place": "Kenya", "how": "left out", "iou": {"building": 0.61}}],
    "good_for": "Buildings from straight above",
    "not_for": "Ships & <boats>",
    "license": "ODbL",
}


@pytest.fixture
def folder(qgis_app, tmp_path):
    """A folder with a model that has a card, a model without one, and a file that is not a model."""
    model = with_metadata(smallest_model(), "class_names", '{"0": "other", "1": "building"}')
    model = with_metadata(with_metadata(model, "resolution", "25"), "model_card", json.dumps(CARD))
    (tmp_path / "houses").mkdir()
    (tmp_path / "houses" / "houses.onnx").write_bytes(model)
    (tmp_path / "silent.onnx").write_bytes(smallest_model())
    (tmp_path / "torn.onnx").write_bytes(b"torn")
    choose_models_folder(str(tmp_path))
    yield tmp_path
    QgsSettings().remove("semref/models_folder")


@pytest.fixture
def dialog(folder):
    made = ModelsDialog()
    made.show()
    yield made
    made.close()
    made.deleteLater()


def rows(dialog) -> list[list[str]]:
    tree = dialog.list
    items = (tree.topLevelItem(row) for row in range(tree.topLevelItemCount()))
    return [[item.text(column).replace("\u00a0", " ") for column in range(4)] for item in items]


def test_models_are_listed_with_classes_pixels_and_how_good_they_are(dialog):
    listed = rows(dialog)
    assert listed[0] == ["Houses of two towns", "other, building", "25 cm", "61 %"]
    assert listed[1] == ["silent", "", "–", "–"] and listed[2][0] == "torn"
    assert listed[3][:3] == ["Buildings (drone photos)", "other, building", "25 cm"]
    assert listed[4][0] == "Sample area (made up)" and listed[4][2:] == ["1 m", "80 %"]


def test_a_click_shows_the_card_and_a_file_that_is_not_a_model_can_t_be_used(dialog):
    text = dialog.card.toPlainText()
    parts = "Houses of two towns", "Uganda: houses and sheds", "Kenya", "61", "Ships & <boats>", "ODbL"
    assert [part for part in parts if part not in text] == []
    for row, words in ((1, "does not state its training"), (2, "is not an ONNX model")):
        dialog.list.setCurrentItem(dialog.list.topLevelItem(row))
        assert words in dialog.card.toPlainText()
    assert not dialog.use.isEnabled() and dialog.path() == ""


def test_a_folder_whose_name_no_system_takes_leaves_the_models_that_ship(dialog):
    dialog.folder.setFilePath("/" + "long" * 2000)
    assert [row[0] for row in rows(dialog)] == ["Buildings (drone photos)", "Sample area (made up)"]


def test_names_that_are_no_text_or_look_like_html_are_shown_as_they_are(dialog, folder):
    image = f"<img src='{folder}/seen.png'>"
    model = with_metadata(smallest_model(), "class_names", json.dumps([image, "b"]))
    (folder / "a.onnx").write_bytes(with_metadata(model, "model_card", json.dumps(dict.fromkeys(CARD, image))))
    with open(os.fsencode(folder) + b"/\xff.onnx", "wb") as file:
        file.write(smallest_model())
    dialog.refresh()
    tree = dialog.list
    tips = [tree.topLevelItem(row).toolTip(1) for row in range(tree.topLevelItemCount())]
    assert [tip for tip in tips if "img" in tip] == [f"<p>{html.escape(image)}, b</p>"]
    for row in range(tree.topLevelItemCount()):
        tree.setCurrentItem(tree.topLevelItem(row))
        assert "\ufffc" not in dialog.card.toPlainText()
    assert len(rows(dialog)) == 7


def test_a_folder_that_links_to_itself_lists_each_model_once(dialog, folder):
    before = rows(dialog)
    (folder / "again").symlink_to(folder)
    dialog.refresh()
    assert rows(dialog) == before


def test_the_dock_takes_the_model_that_is_chosen(dock, tab, folder):
    tab.images.models.click()
    dialog = tab.images.choosing
    assert dialog.isVisible()
    dialog.use.click()
    assert tab.images.model_path() == str(folder / "houses" / "houses.onnx") and not dialog.isVisible()
    tab.images.models.click()
    assert tab.images.choosing.path() == tab.images.model_path()
    tab.images.choosing.close()
    tab.images.model.setFilePath("")


@pytest.fixture
def models(plugin, tmp_path):
    choose_models_folder(str(tmp_path / "models"))
    made = ModelsDialog()
    made.show()
    yield made
    made.close()
    made.deleteLater()
    QgsSettings().remove("semref/models_folder")


@pytest.fixture
def adding(models):
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


def says(adding, text: str) -> None:
    wait_until(lambda: text in adding.state.text(), f"“{text}”, not “{adding.state.text()}”")


def test_a_network_without_names_is_tested_and_added(models, adding, photo, tmp_path):
    adding.file.setFilePath(str(write_model(tmp_path / "bare.onnx", metadata={}, size=(64, 64))))
    says(adding, "3 outputs")
    assert adding.classes.rowCount() == 3 and not adding.threshold.isEnabled()
    for row, name in enumerate(("building", "water", "building")):
        adding.classes.item(row, 0).setText(name)
    adding.resolution_cm.setValue(25)
    adding.picture.setValue(photo, QgsProcessingContext())
    adding.test.click()
    says(adding, "Enter the license")
    adding.license.setText("CC0")
    adding.test.click()
    says(adding, "Check that the classes")
    assert [adding.legend.item(n).text().replace("\u00a0", " ") for n in range(2)] == ["building: 50 %", "water: 50 %"]
    assert not adding.labels.pixmap().isNull()
    assert not list((tmp_path / "models").glob("*.onnx"))
    adding.add.click()
    wait_until(lambda: models.path() == str(tmp_path / "models" / "bare.onnx"), "the new model")
    assert "CC0" in models.card.toPlainText()


def test_the_test_picture_is_the_photo_of_the_project_not_its_label_map(models, photo, tmp_path):
    labels = write_raster(tmp_path / "labels.tif", np.ones((9, 9), np.uint8), names=["", "building"])
    layers = [QgsRasterLayer(str(path), name) for path, name in ((labels, "A labels"), (photo, "Photo"))]
    QgsProject.instance().addMapLayers(layers)
    adding = AddModelDialog()
    assert adding.picture.currentLayer().name() == "Photo"
    adding.close()
    QgsProject.instance().removeAllMapLayers()
    adding = AddModelDialog()
    assert adding.picture.currentLayer() is None
    adding.close()


def test_a_preset_fills_the_fields_and_a_checkpoint_asks_for_its_architecture(adding, tmp_path):
    adding.preset.setCurrentIndex(1)
    assert adding.classes.rowCount() == 19 and adding.classes.item(2, 0).text() == "road"
    assert adding.mean.text() == "0.4121; 0.4348; 0.3993" and adding.resolution_cm.value() == 20
    assert adding.license.text().startswith("Etalab 2.0")
    adding.preset.setCurrentIndex(2)
    assert adding.classes.rowCount() == 1 and adding.threshold.isEnabled()
    adding.preset.setCurrentIndex(0)
    assert adding.architecture.isHidden() and adding.outputs.isHidden()
    (tmp_path / "others.pth").write_bytes(b"PK")
    adding.file.setFilePath(str(tmp_path / "others.pth"))
    assert not adding.architecture.isHidden() and not adding.encoder.isHidden()
    adding.outputs.setValue(5)
    assert adding.classes.rowCount() == 5


def test_files_that_are_no_network_are_one_sentence(adding, tmp_path):
    (tmp_path / "text.onnx").write_text("no network")
    adding.file.setFilePath(str(tmp_path / "text.onnx"))
    says(adding, "is not an ONNX model")
    adding.file.setFilePath(str(write_model(tmp_path / "eight.onnx", metadata={}, batch=8)))
    says(adding, "takes 8 images at once")


def test_a_dialog_that_is_closed_while_it_reads_leaves_nothing(adding, photo, tmp_path):
    folder = adding._folder.name
    adding.file.setFilePath(str(write_model(tmp_path / "bare.onnx", metadata={})))
    adding.close()
    assert not os.path.exists(folder)
