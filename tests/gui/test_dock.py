import time

import numpy as np
import pytest
from dock_area import (
    CONSTELLATION,
    choose_method,
    corners,
    cut_extent,
    dropped,
    from_the_layer_tree,
    localize,
    logged,
    messages,
    results_of,
    settle,
    shown_center,
    shown_outline,
    start,
    wait_until,
)
from made_inputs import write_raster
from qgis.core import QgsApplication, QgsCoordinateReferenceSystem, QgsLayerTreeRegistryBridge, QgsProject, QgsSettings
from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtWidgets import QApplication, QDialog, QFileDialog, QTextBrowser

from semref.processing.algorithms import localize_images
from semref.processing.compat import wkt_for_gdal
from semref.processing.inspection.image import ImageInspector
from semref.processing.layers.database_layers import add_database_to_map
from semref.processing.packages import components
from semref.ui.canvas.drapes import PlacedImage, add_placed, place_image
from semref.ui.dock.content import INSPECT, LOCALIZE
from semref.ui.dock.dock import FIRST_WIDTH_PX
from semref.ui.entry import PAGE
from semref.ui.packages import missing_notice
from semref.ui.widgets.progress import StatusLine


def test_the_button_shows_and_hides_the_dock(plugin, iface):
    action, dock = iface.tool_bar_actions[0], iface.docks[0]
    assert (action.isChecked(), dock.isVisible()) == (False, False)
    action.trigger()
    assert (action.isChecked(), dock.isVisible()) == (True, True)
    dock.close()
    assert (action.isChecked(), dock.isVisible()) == (False, False)


def test_a_bug_gives_one_sentence_and_is_logged_whole(dock, iface, area, monkeypatch):
    def break_down(*_arguments):
        raise ZeroDivisionError("a made mistake")

    monkeypatch.setattr(localize_images, "localize_image", break_down)
    with logged() as reports:
        localize(dock, area.database, [area.image])
    (report,) = reports
    assert "break_down" in report and "a made mistake" in report
    assert len(messages(iface)) == 1 and "Traceback" not in messages(iface)[0]


@pytest.mark.slow
@pytest.mark.parametrize("begun", [False, True])
def test_unloading_while_a_run_works_leaves_nothing(plugin, dock, iface, area, slow, begun, tab):
    start(dock, area.database, [area.image])
    if begun:
        wait_until(lambda: tab.progress.value() > 0, "progress")
    plugin.unload()
    wait_until(lambda: QgsApplication.taskManager().countActiveTasks() == 0, "the end of the task")
    settle()
    assert iface.leftovers() == []


def test_closing_the_dock_takes_the_hit_off_the_map_until_it_is_opened_again(dock, iface, area):
    localize(dock, area.database, [area.image])
    dock.close()
    assert (shown_outline(iface), shown_center(iface)) == (None, None)
    iface.tool_bar_actions[0].trigger()
    assert corners(shown_outline(iface)) == pytest.approx(corners(cut_extent()), abs=1e-6)


def test_the_database_goes_to_the_map_as_a_group_with_the_overview_below_and_can_be_dropped(dock, area):
    box = dock.content.database
    box.file.setFilePath(area.database)
    box.add_to_map.click()
    (group,) = QgsProject.instance().layerTreeRoot().children()
    assert group.name() == "area"
    layers = [node.layer() for node in group.children()]
    assert [layer.name() for layer in layers] == ["Landmarks", "Windows", "Overview"]
    assert [entry.value for entry in layers[2].renderer().classes()] == [1, 2, 3]
    settle()
    box.file.setFilePath("")
    assert dropped(box, from_the_layer_tree(layers[1])) and box.path() == area.database


def test_a_dock_that_was_open_is_open_again_after_a_reload(plugin, dock, iface, area):
    assert dock.isVisible()
    try:
        plugin.unload()
        settle()
        plugin.initGui()
        settle()
        assert iface.docks[-1].isVisible()
        assert iface.docks[-1].content.localize.images.paths() == []
    finally:
        QgsSettings().remove("semref/dock/visible")


def test_a_dock_that_is_opened_first_has_room_for_the_titles_of_its_tabs(plugin, iface):
    iface.tool_bar_actions[0].trigger()
    settle()
    dock = iface.docks[0]
    assert FIRST_WIDTH_PX - 10 <= dock.width() <= iface.window.width() / 2
    bar = dock.content.tabs.tabBar()
    for tab in range(bar.count()):
        assert bar.fontMetrics().horizontalAdvance(bar.tabText(tab)) < bar.tabRect(tab).width()


@pytest.mark.slow
def test_removed_layers_and_a_closed_project_break_nothing(dock, iface, area, issues, tab, tmp_path, monkeypatch):
    dock.content.database.file.setFilePath(area.database)
    dock.content.database.add_to_map.click()
    choose_method(dock, CONSTELLATION)
    localize(dock, area.database, [area.image])
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "saved.gpkg"), ""))
    tab.results.save.click()
    tab.results.drape.click()
    dock.content.inspect.show_window("150_250")
    QgsProject.instance().removeAllMapLayers()
    settle()
    tab.results.after.click()
    wait_until(lambda: tab.results.image.canvas.scene().items(), "the picture")
    assert len(results_of(dock)) == 1
    QgsProject.instance().clear()
    settle()
    assert results_of(dock) == []
    assert [text for text in messages(iface) if "error in SemRef" in text] == []


def test_unloading_while_pictures_are_read_leaves_nothing(plugin, dock, iface, area, monkeypatch):
    inspect = ImageInspector.inspect

    def inspect_slowly(*arguments):
        time.sleep(0.3)
        return inspect(*arguments)

    monkeypatch.setattr(ImageInspector, "inspect", inspect_slowly)
    localize(dock, area.database, [area.image])
    dock.content.inspect.show_window("150_250")
    bare = len(iface.canvas.scene().items())
    plugin.unload()
    settle()
    assert iface.leftovers() == []
    assert len(iface.canvas.scene().items()) < bare


def test_photos_without_onnx_runtime_point_to_the_installer(plugin, dock, iface, area, monkeypatch, tmp_path, tab):
    for module in (components, missing_notice):
        monkeypatch.setattr(module, "missing", lambda packages: [p for p in packages if p is components.ONNXRUNTIME])
    assert not dock.notice.isVisible()
    tab.images.model.setFilePath(str(tmp_path / "model.onnx"))
    assert dock.notice.isVisible() and "ONNX Runtime is missing" in dock.notice.sentence.text()
    dock.notice.install.click()
    assert iface.options_pages_shown == [PAGE]
    localize(dock, area.database, [area.image])
    assert "Settings ▸ Options ▸ SemRef" in messages(iface)[0]
    tab.images.model.setFilePath("")
    assert not dock.notice.isVisible()


def test_tab_and_sizes_are_remembered(plugin, dock, iface, area, tab):
    parts = tab.results.parts
    parts.setSizes([300, 200, 100])
    parts.splitterMoved.emit(300, 1)
    sizes = parts.sizes()
    dock.content.tabs.setCurrentIndex(INSPECT)
    plugin.unload()
    settle()
    plugin.initGui()
    iface.tool_bar_actions[0].trigger()
    settle()
    again = iface.docks[0]
    assert again.content.tabs.currentIndex() == INSPECT
    again.content.tabs.setCurrentIndex(LOCALIZE)
    settle()
    assert again.content.localize.results.parts.sizes() == sizes


def test_names_of_files_are_shown_to_the_letter(dock, iface):
    dock.messages.error("<a href='http://example.org'>photo</a> & <b>co</b>.png can't be read.")
    (item,) = iface.bar.items()
    shown = " ".join(browser.toPlainText() for browser in item.findChildren(QTextBrowser))
    assert "<a href='http://example.org'>photo</a> & <b>co</b>.png can't be read." in shown


def test_an_image_that_is_laid_on_the_map_has_its_crs_always(qgis_app, tmp_path):
    write_raster(tmp_path / "photo.png", np.zeros((3, 20, 20), np.uint8), transform=None)
    crs = QgsCoordinateReferenceSystem("EPSG:32632")
    level = ((400_000, 5_400_020), (400_020, 5_400_020), (400_020, 5_400_000), (400_000, 5_400_000))
    tilted = ((400_000, 5_400_020), (400_022, 5_400_021), (400_019, 5_400_001), (400_001, 5_400_000))
    for ground in (level, tilted, level):
        placed = place_image(str(tmp_path / "photo.png"), ground, wkt_for_gdal(crs))
        layer = add_placed(placed, "", QgsProject.instance())
        assert layer.crs().authid() == "EPSG:32632"
    QgsProject.instance().clear()


def test_an_image_that_is_added_to_the_map_is_above_all_other_layers(qgis_app, area, tmp_path):
    project = QgsProject.instance()
    group = add_database_to_map(area.database, project)
    bridge, root = project.layerTreeRegistryBridge(), project.layerTreeRoot()
    # As where the overview is selected among the layers.
    bridge.setLayerInsertionPoint(QgsLayerTreeRegistryBridge.InsertionPoint(group, 2))
    raster = str(write_raster(tmp_path / "a.tif", np.zeros((3, 20, 20), np.uint8)))
    photo = add_placed(PlacedImage(raster, "photo", ""), "", project)
    assert project.layerTreeRoot().layerOrder()[0] is photo
    assert root.children()[0].layerId() == photo.id()
    bridge.setLayerInsertionPoint(QgsLayerTreeRegistryBridge.InsertionPoint(root, 0))
    project.clear()


def open_windows() -> set[str]:
    return {window.objectName() for window in QApplication.topLevelWidgets() if window.isVisible()}


def fold_each_box_and_change_tabs(dock) -> None:
    for tab in (*range(dock.content.tabs.count()), 0):
        dock.content.tabs.setCurrentIndex(tab)
        settle()
    for box in dock.content.findChildren(QgsCollapsibleGroupBox):
        for folded in (True, False):
            box.setCollapsed(folded)
            settle()


def test_a_dialog_that_was_closed_stays_closed_when_boxes_unfold_and_tabs_change(dock, tab):
    tab.images.models.click()
    settle()
    assert "SemRefModels" in open_windows()
    tab.images.choosing.reject()
    settle()
    fold_each_box_and_change_tabs(dock)
    assert "SemRefModels" not in open_windows()


def test_what_is_hidden_in_a_box_stays_hidden_when_it_unfolds(dock, tab):
    wait_until(tab.images.isVisible, "the dock")
    correct = dock.content.correct.updating
    parts = tab.progress, correct.progress, correct.undo
    assert [part.isHidden() for part in parts] == [True] * 3
    fold_each_box_and_change_tabs(dock)
    assert [part.isHidden() for part in parts] == [True] * 3


def test_there_is_one_list_of_models_at_a_time_and_it_goes_with_the_dock(dock, tab):
    tab.images.models.click()
    tab.images.models.click()
    settle()
    dialogs = dock.window().findChildren(QDialog, "SemRefModels")
    assert len(dialogs) == 1
    assert dialogs[0].parent() is dock.window()
    tab.images.shut_down()
    settle()
    assert dock.window().findChildren(QDialog, "SemRefModels") == []


SAID, ASIDE = "2 of 2 images have a position.", "CPU, 11.6 tiles per second."


def test_a_narrow_line_shows_the_second_sentence_in_the_tool_tip_and_is_shortened_in_the_middle(qgis_app):
    line = StatusLine()
    line.show_text(SAID, ASIDE)
    line.show()
    line.resize(2000, 20)
    assert line.text() == f"{SAID} {ASIDE}"
    line.resize(line.fontMetrics().horizontalAdvance(SAID) + 5, 20)
    assert line.text() == SAID
    assert line.toolTip() == line.text_shown == f"{SAID} {ASIDE}"
    line.resize(line.fontMetrics().horizontalAdvance(SAID) // 2, 20)
    assert "…" in line.text() and line.text().startswith("2 of") and line.text().endswith("ition.")
