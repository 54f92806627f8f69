"""The selected image beside the map: its picture, its landmarks, and those that agree with the map."""

import shutil
import threading
from pathlib import Path

import numpy as np
import pytest
from dock_area import CONSTELLATION, CUT, DEADLINE_S, ORIGIN, WINDOW, choose_method, localize, wait_until
from made_models import RGB, metadata, painted, write_model
from osgeo import gdal
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtWidgets import QGraphicsPixmapItem

from semref.processing.inspection.image import ImageInspector

pytestmark = pytest.mark.slow


def test_the_selected_image_is_shown_with_its_landmarks(dock, area, tab):
    localize(dock, area.database, [area.image])
    canvas = tab.results.image.canvas
    wait_until(lambda: canvas.scene().items(), "the image")
    assert (canvas.sceneRect().width(), canvas.sceneRect().height()) == (WINDOW, WINDOW)
    tab.results.image.opacity.setValue(30)
    assert canvas._labels.opacity() == pytest.approx(0.3)
    tab.results.image.landmarks.setChecked(False)
    assert not canvas._landmarks.isVisible()


def test_the_view_shows_why_an_image_cannot_be_shown(dock, area, tab):
    localize(dock, area.database, [area.unreadable])
    wait_until(lambda: "can't be read" in tab.results.image.canvas._text, "the reason")


def test_a_photo_is_shown_with_what_the_model_makes_of_it(dock, area, tmp_path, tab):
    model = write_model(tmp_path / "colors.onnx", metadata=metadata(class_names={"0": "1", "1": "2", "2": "3"}))
    labels = np.zeros((80, 120), np.uint8)
    labels[20:40, 30:60] = 2
    photo = gdal.GetDriverByName("GTiff").Create(str(tmp_path / "photo.tif"), 120, 80, 3, gdal.GDT_Byte)
    photo.WriteArray(np.moveaxis(painted(labels), 2, 0))
    # Written when it is closed.
    del photo
    tab.images.model.setFilePath(str(model))
    localize(dock, area.database, [str(tmp_path / "photo.tif")])
    canvas = tab.results.image.canvas
    wait_until(lambda: canvas.scene().items(), "the photo")
    pictures = [item for item in canvas.scene().items() if isinstance(item, QGraphicsPixmapItem)]
    shown_labels, shown_photo = (item.pixmap().toImage() for item in pictures)
    assert QColor(shown_photo.pixel(45, 30)).getRgb()[:3] == RGB["water"]
    assert (canvas.sceneRect().width(), canvas.sceneRect().height()) == (120, 80)
    assert QColor(shown_labels.pixel(45, 30)) != QColor(shown_labels.pixel(5, 5))


def test_landmarks_that_agree_are_joined_between_the_image_and_the_map(dock, iface, area, tab):
    choose_method(dock, CONSTELLATION)
    localize(dock, area.database, [area.image])
    wait_until(lambda: tab.results.image.canvas.scene().items(), "the picture")
    pairs, marks = (tab.hit.matches.pairs, tab.results.image.canvas._landmarks.matched)
    assert f"{len(pairs)} agree with the map" in tab.results.details.toPlainText()
    assert len(pairs) == len(marks) > 20
    for (seen, on_map), (_, pixel) in zip(pairs, marks):
        truth = ORIGIN[0] + CUT[0] + pixel.x(), ORIGIN[1] - CUT[1] - pixel.y()
        assert (on_map.x(), on_map.y()) == pytest.approx(truth, abs=0.01)
        assert (seen.x(), seen.y()) == pytest.approx(truth, abs=0.5)
    dock.close()
    assert tab.hit.matches.pairs == []
    iface.tool_bar_actions[0].trigger()
    assert len(tab.hit.matches.pairs) == len(marks)
    # Drawn without an error, which pytest would see.
    tab.results.image.grab()
    iface.canvas.grab()


def test_going_through_many_images_quickly_reads_the_first_and_the_last(dock, area, monkeypatch, tmp_path, tab):
    images = [str(shutil.copy(area.image, tmp_path / f"{number:02d}.tif")) for number in range(30)]
    read, inspect, go_on = [], ImageInspector.inspect, threading.Event()

    def inspect_slowly(inspector, query, database):
        read.append(Path(query.image).name)
        go_on.wait(DEADLINE_S)
        return inspect(inspector, query, database)

    monkeypatch.setattr(ImageInspector, "inspect", inspect_slowly)
    localize(dock, area.database, images)
    for _ in range(29):
        wait_until(lambda: read, "the first reading")
        tab.results.after.click()
    go_on.set()
    wait_until(lambda: tab.results.image.canvas.scene().items(), "the picture")
    assert read == ["00.tif", "29.tif"]
