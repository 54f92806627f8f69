"""The dock in a real window, with a small database that the algorithms build."""

from __future__ import annotations

import gc
import threading
import time
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from made_models import RGB, metadata, painted, write_model

PIXELS = 600
WINDOW = 200
STRIDE = 50
ORIGIN = (400_000.0, 5_400_000.0)
CRS = "EPSG:25832"
CUT = (150, 250)
"""First column and row of the window that the query image shows."""

DEADLINE_S = 20


def label_map() -> np.ndarray:
    """Small rectangles of three classes, far enough apart to stay regions of their own."""
    generator = np.random.default_rng(7)
    labels = np.zeros((PIXELS, PIXELS), np.uint8)
    for row in range(5, PIXELS - 20, 25):
        for column in range(5, PIXELS - 20, 25):
            if generator.random() < 0.6:
                height, width = generator.integers(6, 14, 2)
                top, left = row + generator.integers(0, 8), column + generator.integers(0, 8)
                labels[top : top + height, left : left + width] = generator.integers(1, 4)
    return labels


def write_raster(path: Path, labels: np.ndarray, georeferenced: bool) -> str:
    from osgeo import gdal, osr

    height, width = labels.shape
    raster = gdal.GetDriverByName("GTiff").Create(str(path), width, height, 1, gdal.GDT_Byte)
    if georeferenced:
        reference = osr.SpatialReference()
        reference.ImportFromEPSG(int(CRS.partition(":")[2]))
        raster.SetProjection(reference.ExportToWkt())
        raster.SetGeoTransform((ORIGIN[0], 1, 0, ORIGIN[1], 0, -1))
    raster.GetRasterBand(1).WriteArray(labels)
    return str(path)


class Area:
    """Paths of a database, of an image cut from one of its windows, and of an image that isn't one."""

    def __init__(self, folder: Path, run_algorithm) -> None:
        labels = label_map()
        column, row = CUT
        self.database = str(folder / "area.gpkg")
        self.image = write_raster(folder / "on_window.tif", labels[row : row + WINDOW, column : column + WINDOW], False)
        self.unreadable = str(folder / "broken.tif")
        Path(self.unreadable).write_text("not an image", encoding="utf-8")
        parameters = {
            "LABELS": write_raster(folder / "labels.tif", labels, True),
            "REFERENCE_CLASSES": "1;2;3",
            "WINDOW_SIZE": WINDOW,
            "STRIDE": STRIDE,
            "MINIMUM_AREA": 20,
            "DATABASE": self.database,
        }
        run_algorithm("semref:builddatabase", parameters)


@pytest.fixture(scope="module")
def area(run_algorithm, tmp_path_factory):
    return Area(tmp_path_factory.mktemp("area"), run_algorithm)


@pytest.fixture
def plugin(area, iface, without_provider):
    from qgis.core import QgsCoordinateReferenceSystem, QgsProject, QgsSettings

    from semref.plugin import SemRefPlugin

    QgsSettings().remove("semref")
    iface.canvas.setDestinationCrs(QgsCoordinateReferenceSystem(CRS))
    loaded = SemRefPlugin(iface)
    loaded.initGui()
    yield loaded
    loaded.unload()
    settle()
    QgsProject.instance().clear()


@pytest.fixture
def dock(plugin, iface):
    iface.tool_bar_actions[0].trigger()
    dock = iface.docks[0]
    # The published method names the window, so the truth is exact.
    choose_method(dock, TOPOLOGY_VECTOR)
    return dock


@pytest.fixture
def slow(monkeypatch, area):
    """Makes a run as long as a thousand images; a cancel is heeded between two of them."""
    from semref.processing.algorithms import localize_images
    from semref.storage import rasters

    localize = localize_images._localize

    def localize_slowly(*arguments):
        time.sleep(0.03)
        return localize(*arguments)

    monkeypatch.setattr(localize_images, "_localize", localize_slowly)
    monkeypatch.setattr(rasters, "image_files", lambda paths: paths * 1000)


def settle() -> None:
    """Lets queued signals and deleteLater happen."""
    from qgis.PyQt.QtCore import QCoreApplication, QEvent

    for _ in range(5):
        QCoreApplication.processEvents()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def wait_until(condition, what: str) -> None:
    from qgis.PyQt.QtCore import QCoreApplication

    deadline = time.monotonic() + DEADLINE_S
    while not condition():
        if time.monotonic() > deadline:
            pytest.fail(f"{what} did not happen within {DEADLINE_S} s.")
        QCoreApplication.processEvents()
        time.sleep(0.005)


AUTOMATIC, TOPOLOGY_VECTOR, CONSTELLATION = range(3)


def choose_method(dock, method: int) -> None:
    dock.content.localize.method.choice.setCurrentIndex(dock.content.localize.method.choice.findData(method))


def start(dock, database: str, images: list[str]) -> None:
    dock.content.database.file.setFilePath(database)
    dock.content.localize.images.list.add(images)
    dock.content.localize.localize_button.click()


def localize(dock, database: str, images: list[str]) -> None:
    start(dock, database, images)
    wait_until(lambda: not dock.content.localize.run.running, "the end of the run")


def table(dock) -> list[list[str]]:
    model = dock.content.localize.results.table.model()
    return [
        [model.index(row, column).data() for column in range(model.columnCount())] for row in range(model.rowCount())
    ]


def messages(iface) -> list[str]:
    return [item.text() for item in iface.bar.items()]


def shown_outline(iface):
    """Extent of the outline on the canvas in the canvas's CRS, None when there is none."""
    from qgis.gui import QgsRubberBand

    bands = [item for item in iface.canvas.scene().items() if isinstance(item, QgsRubberBand)]
    extents = [band.asGeometry().boundingBox() for band in bands if band.numberOfVertices()]
    # The heading's arrow and the error's circle lie inside the outline.
    return max(extents, key=lambda extent: extent.width()) if extents else None


def shown_center(iface):
    from qgis.gui import QgsVertexMarker

    markers = [item for item in iface.canvas.scene().items() if isinstance(item, QgsVertexMarker) and item.isVisible()]
    return markers[0].center() if markers else None


def cut_extent():
    """The window's place on the map."""
    from qgis.core import QgsRectangle

    left, top = ORIGIN[0] + CUT[0], ORIGIN[1] - CUT[1]
    return QgsRectangle(left, top - WINDOW, left + WINDOW, top)


def corners(extent):
    return [extent.xMinimum(), extent.yMinimum(), extent.xMaximum(), extent.yMaximum()]


def test_the_button_shows_and_hides_the_dock(plugin, iface):
    action, dock = iface.tool_bar_actions[0], iface.docks[0]
    assert (action.isChecked(), dock.isVisible()) == (False, False)
    action.trigger()
    assert (action.isChecked(), dock.isVisible()) == (True, True)
    dock.close()
    assert (action.isChecked(), dock.isVisible()) == (False, False)


def test_an_empty_dock_says_what_to_do(dock, area):
    assert dock.content.localize.state.text() == "Choose a database and add images."
    dock.content.database.file.setFilePath(area.database)
    assert dock.content.localize.state.text() == "Add images."
    assert not dock.content.localize.localize_button.isEnabled()
    dock.content.localize.images.list.add([area.image])
    assert dock.content.localize.state.text() == "Ready to localize."
    assert dock.content.localize.localize_button.isEnabled()


def test_an_image_cut_from_a_window_is_found_there(dock, area):
    localize(dock, area.database, [area.image])
    assert table(dock) == [["on_window.tif", "1.00", "", "", "Unverified match", "150_250", "0.000"]]
    assert dock.content.localize.state.text() == "1 of 1 images have a fix."
    details = dock.content.localize.results.details.toPlainText()
    assert "x, y: 400250.00, 5399650.00 (EPSG:25832)" in details
    assert "lon, lat: 7.6" in details


def test_the_automatic_method_tells_heading_pixel_size_and_error(dock, iface, area):
    choose_method(dock, AUTOMATIC)
    localize(dock, area.database, [area.image])
    ((image, confidence, error, heading, status, window, distance),) = table(dock)
    assert (image, confidence, status, window, distance) == ("on_window.tif", "1.00", "Fix", "", "")
    assert 0 <= float(error) < 0.5 and heading in ("0.0", "360.0")
    details = dock.content.localize.results.details.toPlainText()
    assert "heading" in details and "pixel size 1 m" in details and "(95 %)" in details
    assert corners(shown_outline(iface)) == pytest.approx(corners(cut_extent()), abs=0.5)


def test_the_method_is_remembered(dock, qgis_app):
    from semref.ui.tabs.localize.inputs import MethodRow

    choose_method(dock, TOPOLOGY_VECTOR)
    assert MethodRow().method() == TOPOLOGY_VECTOR
    choose_method(dock, AUTOMATIC)
    assert MethodRow().method() == AUTOMATIC


def test_the_hit_is_outlined_and_its_center_marked(dock, iface, area):
    localize(dock, area.database, [area.image])
    assert corners(shown_outline(iface)) == pytest.approx(corners(cut_extent()), abs=1e-6)
    assert shown_center(iface).x() == pytest.approx(cut_extent().center().x())
    assert shown_center(iface).y() == pytest.approx(cut_extent().center().y())


def test_the_outline_follows_the_canvas_into_another_crs(dock, iface, area):
    from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsProject

    localize(dock, area.database, [area.image])
    mercator = QgsCoordinateReferenceSystem("EPSG:3857")
    iface.canvas.setDestinationCrs(mercator)
    transform = QgsCoordinateTransform(QgsCoordinateReferenceSystem(CRS), mercator, QgsProject.instance())
    expected = transform.transformBoundingBox(cut_extent())
    assert corners(shown_outline(iface)) == pytest.approx(corners(expected), abs=0.5)


def test_the_canvas_moves_to_the_selected_hit(dock, iface, area):
    localize(dock, area.database, [area.image])
    assert iface.canvas.extent().contains(cut_extent())


def test_the_canvas_stays_when_zooming_is_switched_off(dock, iface, area):
    before = corners(iface.canvas.extent())
    dock.content.localize.results.zoom.setChecked(False)
    localize(dock, area.database, [area.image])
    assert shown_outline(iface) is not None
    assert corners(iface.canvas.extent()) == before


def test_an_unreadable_image_has_a_row_with_its_reason_and_no_outline(dock, iface, area):
    localize(dock, area.database, [area.image, area.unreadable])
    dock.content.localize.results.table.selectRow(1)
    assert table(dock)[1] == ["broken.tif", "", "", "", "Unreadable", "", ""]
    assert "broken.tif can't be read" in dock.content.localize.results.details.toPlainText()
    assert (shown_outline(iface), shown_center(iface)) == (None, None)
    assert not dock.content.localize.results.copy.isEnabled()
    assert messages(iface) == []


def test_a_click_on_a_header_sorts_and_the_selection_stays_true(dock, iface, area):
    from qgis.PyQt.QtCore import Qt

    localize(dock, area.database, [area.image, area.unreadable])
    dock.content.localize.results.table.sortByColumn(0, Qt.SortOrder.AscendingOrder)
    assert [row[0] for row in table(dock)] == ["broken.tif", "on_window.tif"]
    dock.content.localize.results.table.selectRow(1)
    assert "on_window.tif" in dock.content.localize.results.details.toPlainText()
    assert shown_outline(iface) is not None


def test_the_position_can_be_copied_in_several_ways(dock, area):
    from qgis.core import QgsApplication, QgsCoordinateReferenceSystem, QgsProject

    QgsProject.instance().setCrs(QgsCoordinateReferenceSystem("EPSG:3857"))
    localize(dock, area.database, [area.image])
    dock.content.localize.results.copy.click()
    assert QgsApplication.clipboard().text().startswith("7.6")
    dock.content.localize.results.formats.aboutToShow.emit()
    copied = []
    for action in dock.content.localize.results.formats.actions():
        action.trigger()
        copied.append(QgsApplication.clipboard().text())
        assert action.text().endswith(copied[-1])
    assert copied[0].startswith("7.6") and copied[1].startswith("48.7") and copied[2].startswith("48°44′")
    assert copied[3].startswith("8") and copied[4] == "400250.00, 5399650.00"
    assert copied[5] == f"POINT ({copied[3].replace(',', '')})"
    # The way chosen last is the button's.
    dock.content.localize.results.formats.actions()[4].trigger()
    QgsApplication.clipboard().clear()
    dock.content.localize.results.copy.click()
    assert QgsApplication.clipboard().text() == "400250.00, 5399650.00"
    assert "400250.00" in dock.content.localize.state.text_shown


def test_a_file_that_is_no_database_gives_one_sentence(dock, iface, area):
    localize(dock, area.unreadable, [area.image])
    assert len(messages(iface)) == 1
    assert "broken.tif is not a GeoPackage; choose a database" in messages(iface)[0]
    assert dock.content.localize.localize_button.text() == "Localize"
    assert dock.content.localize.localize_button.isEnabled()


def test_a_bug_gives_one_sentence_and_is_logged_whole(dock, iface, area, monkeypatch):
    from qgis.core import QgsApplication

    from semref.processing.algorithms import localize_images

    def break_down(*_arguments):
        raise ZeroDivisionError("a made mistake")

    logged = []
    monkeypatch.setattr(localize_images, "_localize", break_down)
    log = QgsApplication.messageLog()

    def note(*entry):
        logged.append(entry)

    log.messageReceived[str, str, "Qgis::MessageLevel"].connect(note)
    localize(dock, area.database, [area.image])
    log.messageReceived[str, str, "Qgis::MessageLevel"].disconnect(note)
    (report,) = [text for text, tag, *_level in logged if tag == "SemRef"]
    assert "break_down" in report and "a made mistake" in report
    assert len(messages(iface)) == 1
    assert "Traceback" not in messages(iface)[0]


def test_a_missing_package_is_named(dock, iface, area, monkeypatch):
    from semref.processing.framework import base
    from semref.processing.packages.components import OPENCV

    monkeypatch.setattr(base, "missing", lambda _packages: [OPENCV])
    start(dock, area.database, [area.image])
    assert not dock.content.localize.run.running
    assert "OpenCV" in messages(iface)[0] or "opencv" in messages(iface)[0]


def test_cancel_ends_the_run_without_results(dock, iface, area, slow):
    start(dock, area.database, [area.image])
    assert dock.content.localize.localize_button.text() == "Cancel"
    wait_until(lambda: dock.content.localize.progress.value() > 0, "progress")
    dock.content.localize.localize_button.click()
    wait_until(lambda: not dock.content.localize.run.running, "the end of the run")
    assert dock.content.localize.state.text() == "Canceled."
    assert dock.content.localize.localize_button.text() == "Localize"
    assert (table(dock), messages(iface)) == ([], [])


def test_a_cancel_before_the_run_has_begun_ends_it_too(dock, area, slow):
    start(dock, area.database, [area.image])
    dock.content.localize.localize_button.click()
    wait_until(lambda: not dock.content.localize.run.running, "the end of the run")
    assert dock.content.localize.state.text() == "Canceled."


@pytest.mark.parametrize("begun", [False, True])
def test_unloading_while_a_run_works_leaves_nothing(plugin, dock, iface, area, slow, begun):
    from qgis.core import QgsApplication

    start(dock, area.database, [area.image])
    if begun:
        wait_until(lambda: dock.content.localize.progress.value() > 0, "progress")
    plugin.unload()
    wait_until(lambda: QgsApplication.taskManager().countActiveTasks() == 0, "the end of the task")
    settle()
    assert iface.leftovers() == []


def test_a_project_closed_while_a_run_works_does_not_disturb_it(dock, area):
    from qgis.core import QgsProject

    start(dock, area.database, [area.image])
    QgsProject.instance().clear()
    wait_until(lambda: not dock.content.localize.run.running, "the end of the run")
    assert len(table(dock)) == 1


def test_five_loads_and_unloads_leave_nothing(plugin, iface, area):
    from qgis.PyQt.QtWidgets import QDockWidget

    plugin.unload()
    settle()
    bare_canvas = len(iface.canvas.scene().items())
    for _ in range(5):
        plugin.initGui()
        iface.tool_bar_actions[0].trigger()
        localize(iface.docks[0], area.database, [area.image])
        assert shown_outline(iface) is not None
        plugin.unload()
        settle()
    gc.collect()
    assert iface.leftovers() == []
    assert iface.window.findChildren(QDockWidget) == []
    assert len(iface.canvas.scene().items()) == bare_canvas


def test_closing_the_dock_takes_the_hit_off_the_map_until_it_is_opened_again(dock, iface, area):
    localize(dock, area.database, [area.image])
    dock.close()
    assert (shown_outline(iface), shown_center(iface)) == (None, None)
    iface.tool_bar_actions[0].trigger()
    assert corners(shown_outline(iface)) == pytest.approx(corners(cut_extent()), abs=1e-6)


def test_the_database_goes_to_the_map_as_a_group_with_the_overview_below(dock, area):
    from qgis.core import QgsProject

    dock.content.database.file.setFilePath(area.database)
    dock.content.database.add_to_map.click()
    (group,) = QgsProject.instance().layerTreeRoot().children()
    assert group.name() == "area"
    layers = [node.layer() for node in group.children()]
    assert [layer.name() for layer in layers] == ["Landmarks", "Windows", "Overview"]
    assert [entry.value for entry in layers[2].renderer().classes()] == [1, 2, 3]


def test_a_file_that_is_no_database_does_not_go_to_the_map(dock, iface, area):
    from qgis.core import QgsProject

    dock.content.database.file.setFilePath(area.image)
    dock.content.database.add_to_map.click()
    assert QgsProject.instance().mapLayers() == {}
    assert len(messages(iface)) == 1
    assert "is not a SemRef reference database" in messages(iface)[0]


def test_results_can_be_kept_as_a_layer(dock, area):
    from qgis.core import QgsProject

    assert not dock.content.localize.results.keep.isEnabled()
    localize(dock, area.database, [area.image, area.unreadable])
    dock.content.localize.results.keep.click()
    (layer,) = QgsProject.instance().mapLayers().values()
    assert [feature["status"] for feature in layer.getFeatures()] == ["fix", "error"]
    QgsProject.instance().removeAllMapLayers()
    dock.content.localize.results.keep.click()
    assert len(QgsProject.instance().mapLayers()) == 1


def test_dropped_files_are_added_once(dock, area):
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
        dock.content.localize.images.list.dropEvent(event)
    assert dock.content.localize.images.paths() == [area.image]


def test_selected_images_can_be_removed(dock, area):
    dock.content.localize.images.list.add([area.image, area.unreadable])
    dock.content.localize.images.list.setCurrentRow(0)
    dock.content.localize.images.remove.click()
    assert dock.content.localize.images.paths() == [area.unreadable]


def test_the_database_is_remembered(plugin, dock, iface, area):
    dock.content.database.file.setFilePath(area.database)
    plugin.unload()
    plugin.initGui()
    assert iface.docks[0].content.database.path() == area.database


def test_every_status_has_words(qgis_app):
    from semref.core import localization as localizer
    from semref.processing.framework.localized_image import ERROR
    from semref.ui.findings import FIX, TOPOLOGY_VECTOR, status_text

    assert localizer.FIX == FIX
    assert localizer.TOPOLOGY_VECTOR == TOPOLOGY_VECTOR
    for status in (localizer.FIX, localizer.AMBIGUOUS, localizer.NO_MATCH, localizer.TOO_FEW_REFERENCES, ERROR):
        assert status_text(SimpleNamespace(status=status, is_verified=True)) != status
    assert "nverified" in status_text(SimpleNamespace(status=FIX, is_verified=False))


def rubber_bands(iface, geometry_type: str) -> list:
    """Geometries of what is drawn on the canvas, 'Polygon' or 'Line'."""
    from qgis.gui import QgsRubberBand

    bands = [item for item in iface.canvas.scene().items() if isinstance(item, QgsRubberBand)]
    found = [band.asGeometry() for band in bands if band.numberOfVertices()]
    return [geometry for geometry in found if geometry_type in type(geometry.constGet()).__name__]


def test_the_heading_arrow_points_where_the_top_of_the_image_is(dock, iface, area):
    choose_method(dock, AUTOMATIC)
    localize(dock, area.database, [area.image])
    (arrow,) = rubber_bands(iface, "Line")
    center, top = cut_extent().center(), cut_extent().yMaximum()
    assert (arrow.boundingBox().center().x(), arrow.boundingBox().yMaximum()) == pytest.approx(
        (center.x(), top), abs=0.5
    )


def test_the_selected_image_is_shown_with_its_landmarks_and_its_vector(dock, area):
    localize(dock, area.database, [area.image])
    canvas = dock.content.localize.results.image.canvas
    wait_until(lambda: canvas.scene().items(), "the image")
    assert (canvas.sceneRect().width(), canvas.sceneRect().height()) == (WINDOW, WINDOW)
    dock.content.localize.results.image.opacity.setValue(30)
    dock.content.localize.results.image.star.setChecked(True)
    assert canvas._labels.opacity() == pytest.approx(0.3)
    assert canvas._star.isVisible() and len(canvas._star._ends) == 10
    dock.content.localize.results.image.landmarks.setChecked(False)
    assert not canvas._landmarks.isVisible()


def test_an_image_that_cannot_be_shown_says_why(dock, area):
    localize(dock, area.database, [area.unreadable])
    wait_until(lambda: "can't be read" in dock.content.localize.results.image.canvas._text, "the reason")


def test_a_window_is_inspected_by_name_with_its_vector_and_its_look_alikes(dock, iface, area):
    dock.content.database.file.setFilePath(area.database)
    dock.content.inspect.name.setText("150_250")
    dock.content.inspect.name.returnPressed.emit()
    wait_until(lambda: dock.content.inspect.numbers.rowCount(), "the window")
    assert dock.content.inspect.numbers.rowCount() == 10
    assert dock.content.inspect.numbers.item(0, 1).text() == "1.000"
    assert dock.content.inspect.look_alikes.rowCount() > 0
    extents = [corners(band.boundingBox()) for band in rubber_bands(iface, "Polygon")]
    assert any(extent == pytest.approx(corners(cut_extent())) for extent in extents)
    assert iface.canvas.extent().contains(cut_extent())


def test_a_click_on_the_map_inspects_the_window_whose_middle_is_nearest(dock, iface, area):
    from qgis.core import QgsPointXY

    dock.content.database.file.setFilePath(area.database)
    dock.content.inspect.pick.click()
    assert iface.canvas.mapTool() is dock.content.inspect.tool
    middle = cut_extent().center()
    dock.content.inspect.tool.picked.emit(QgsPointXY(middle.x() + 9, middle.y() - 9))
    wait_until(lambda: dock.content.inspect.name.text(), "the window")
    assert dock.content.inspect.name.text() == "150_250"


def test_an_unknown_window_name_is_said(dock, iface, area):
    dock.content.database.file.setFilePath(area.database)
    dock.content.inspect.show_window("1_2")
    wait_until(lambda: messages(iface), "a message")
    assert "no window “1_2”" in messages(iface)[0]


def test_an_image_is_compared_with_the_window_element_by_element(dock, area):
    localize(dock, area.database, [area.image])
    wait_until(dock.content.inspect.compare.isEnabled, "the image's vector")
    dock.content.inspect.show_window("150_250")
    wait_until(lambda: dock.content.inspect.numbers.rowCount(), "the window")
    dock.content.inspect.compare.click()
    assert "distance 0.000, confidence 1.00" in dock.content.inspect.title.text()
    assert {dock.content.inspect.numbers.item(row, 3).text() for row in range(10)} == {"0.000"}


@pytest.mark.parametrize(("away_m", "fixes"), [(0, 1), (250, 0)])
def test_only_the_circle_drawn_on_the_map_is_searched(dock, area, away_m, fixes):
    from qgis.core import QgsPointXY

    choose_method(dock, CONSTELLATION)
    middle = cut_extent().center()
    middle = QgsPointXY(middle.x() + away_m, middle.y())
    dock.content.localize.prior.set_circle(middle, QgsPointXY(middle.x() + 60, middle.y()))
    assert dock.content.localize.prior.text.text() == "Search: within 60 m"
    localize(dock, area.database, [area.image])
    assert dock.content.localize.state.text().startswith(f"{fixes} of 1")
    dock.content.localize.prior.clear.click()
    assert dock.content.localize.prior.parameters() == {}


def test_an_image_is_laid_on_the_map_where_it_was_taken(dock, area):
    from qgis.core import QgsProject

    choose_method(dock, AUTOMATIC)
    localize(dock, area.database, [area.image])
    dock.content.localize.results.drape.click()
    wait_until(QgsProject.instance().mapLayers, "the layer")
    (layer,) = QgsProject.instance().mapLayers().values()
    assert corners(layer.extent()) == pytest.approx(corners(cut_extent()), abs=1.0)
    assert layer.opacity() == pytest.approx(0.6)


def test_the_locator_bar_finds_windows_by_name(dock, iface, area):
    from qgis.core import QgsFeedback, QgsLocatorContext

    (locator,) = iface.locator_filters
    found = []
    searching = locator.clone()
    searching.resultFetched.connect(found.append)
    searching.fetchResults("150", QgsLocatorContext(), QgsFeedback())
    assert found == []
    dock.content.database.file.setFilePath(area.database)
    searching.fetchResults("150_2", QgsLocatorContext(), QgsFeedback())
    assert [result.displayString for result in found] == ["150_200", "150_250"]
    locator.triggerResult(found[1])
    wait_until(lambda: dock.content.inspect.numbers.rowCount(), "the window")
    assert dock.content.inspect.isVisible()
    assert dock.content.inspect.name.text() == "150_250"


def test_a_photo_is_shown_with_what_the_model_makes_of_it(dock, area, tmp_path):
    from osgeo import gdal
    from qgis.PyQt.QtGui import QColor
    from qgis.PyQt.QtWidgets import QGraphicsPixmapItem

    model = write_model(tmp_path / "colors.onnx", metadata=metadata(class_names={"0": "1", "1": "2", "2": "3"}))
    labels = np.zeros((80, 120), np.uint8)
    labels[20:40, 30:60] = 2
    photo = gdal.GetDriverByName("GTiff").Create(str(tmp_path / "photo.tif"), 120, 80, 3, gdal.GDT_Byte)
    photo.WriteArray(np.moveaxis(painted(labels), 2, 0))
    # Written when it is closed.
    del photo
    dock.content.localize.images.model.setFilePath(str(model))
    localize(dock, area.database, [str(tmp_path / "photo.tif")])
    canvas = dock.content.localize.results.image.canvas
    wait_until(lambda: canvas.scene().items(), "the photo")
    pictures = [item for item in canvas.scene().items() if isinstance(item, QGraphicsPixmapItem)]
    shown_labels, shown_photo = (item.pixmap().toImage() for item in pictures)
    assert QColor(shown_photo.pixel(45, 30)).getRgb()[:3] == RGB["water"]
    assert (canvas.sceneRect().width(), canvas.sceneRect().height()) == (120, 80)
    assert QColor(shown_labels.pixel(45, 30)) != QColor(shown_labels.pixel(5, 5))


def test_the_places_where_an_ambiguous_image_may_lie_are_outlined(dock, iface, run_algorithm, area, tmp_path):
    labels = label_map()
    twins = np.hstack([labels[:, :300], labels[:, :300]])
    parameters = {
        "LABELS": write_raster(tmp_path / "twins.tif", twins, True),
        "REFERENCE_CLASSES": "1;2;3",
        "WINDOW_SIZE": WINDOW,
        "STRIDE": STRIDE,
        "MINIMUM_AREA": 20,
        "DATABASE": str(tmp_path / "twins.gpkg"),
    }
    run_algorithm("semref:builddatabase", parameters)
    image = write_raster(tmp_path / "image.tif", twins[200:400, 50:250], False)
    choose_method(dock, CONSTELLATION)
    localize(dock, parameters["DATABASE"], [image])
    assert table(dock)[0][4] == "Ambiguous"
    (places,) = rubber_bands(iface, "Polygon")
    lefts = sorted(part.boundingBox().xMinimum() - ORIGIN[0] for part in places.asGeometryCollection())
    assert lefts == pytest.approx([50, 350], abs=2)
    assert shown_center(iface) is None
    assert iface.canvas.extent().contains(places.boundingBox())


@pytest.fixture
def issues(qgis_app, dock):
    """Three findings in a row, 100 m apart, as “Check annotation” gives them."""
    from qgis.core import QgsFeature, QgsGeometry, QgsProject, QgsRectangle, QgsVectorLayer

    fields = "field=kind:string&field=severity:string&field=message:string&field=area:double"
    layer = QgsVectorLayer(f"Polygon?crs={CRS}&{fields}", "issues", "memory")
    for number, kind in enumerate(("overlap", "gap", "sliver")):
        feature = QgsFeature(layer.fields())
        left, top = ORIGIN[0] + 100 * number, ORIGIN[1]
        feature.setGeometry(QgsGeometry.fromRect(QgsRectangle(left, top - 10, left + 10, top)))
        feature.setAttributes([kind, "warning", f"Here is a {kind}.", 100.0])
        layer.dataProvider().addFeature(feature)
    layer.updateExtents()
    QgsProject.instance().addMapLayer(layer)
    dock.content.correct.layer.setLayer(layer)
    return layer


def listed(tab) -> list[str]:
    return [tab.places.item(row, 0).text() for row in range(tab.places.rowCount())]


def test_an_annotator_goes_through_the_places_and_marks_what_is_done(dock, iface, issues):
    tab = dock.content.correct
    assert listed(tab) == ["overlap", "gap", "sliver"]
    tab.after.click()
    assert "Here is a overlap." in tab.text.text()
    assert iface.canvas.extent().contains(next(issues.getFeatures()).geometry().boundingBox())
    (mark,) = rubber_bands(iface, "Polygon")
    assert mark.area() == pytest.approx(100)
    tab.done.click()
    assert "Here is a gap." in tab.text.text()
    assert (tab.progress.value(), tab.progress.maximum()) == (1, 3)
    tab.open.setChecked(True)
    assert listed(tab) == ["gap", "sliver"]


def test_what_is_done_is_remembered_in_the_project_and_not_in_the_table(dock, issues):
    fields = issues.fields().names()
    dock.content.correct.places.selectRow(2)
    dock.content.correct.done.click()
    dock.content.correct.layer.setLayer(None)
    dock.content.correct.layer.setLayer(issues)
    assert dock.content.correct.progress.value() == 1
    assert issues.fields().names() == fields


def test_the_done_places_go_to_the_update_of_the_database(dock, issues):
    asked = []
    dock.content.correct.updateAsked.disconnect()
    dock.content.correct.updateAsked.connect(asked.append)
    assert not dock.content.correct.update_button.isEnabled()
    dock.content.correct.places.selectRow(1)
    dock.content.correct.done.click()
    dock.content.correct.update_button.click()
    (places,) = asked
    assert [feature["kind"] for feature in places.getFeatures()] == ["gap"]


def test_a_layer_that_is_removed_while_it_is_corrected_leaves_an_empty_list(dock, iface, issues):
    from qgis.core import QgsProject

    dock.content.correct.places.selectRow(1)
    QgsProject.instance().removeMapLayer(issues.id())
    settle()
    assert dock.content.correct.places.rowCount() == 0
    assert rubber_bands(iface, "Polygon") == []


# --- image and map joined ---


def pointed_numbers(dock) -> tuple:
    return (
        dock.content.localize.results.image.canvas._landmarks._pointed,
        dock.content.localize.hit.matches._item._pointed,
    )


def test_landmarks_that_agree_are_joined_between_the_image_and_the_map(dock, iface, area):
    choose_method(dock, CONSTELLATION)
    localize(dock, area.database, [area.image])
    wait_until(lambda: dock.content.localize.hit.matches.pairs, "the matches")
    pairs, marks = (
        dock.content.localize.hit.matches.pairs,
        dock.content.localize.results.image.canvas._landmarks.matched,
    )
    assert f"{len(pairs)} agree with the map" in dock.content.localize.results.details.toPlainText()
    assert len(pairs) == len(marks) > 20
    for (seen, on_map), (_, pixel) in zip(pairs, marks):
        truth = ORIGIN[0] + CUT[0] + pixel.x(), ORIGIN[1] - CUT[1] - pixel.y()
        assert (on_map.x(), on_map.y()) == pytest.approx(truth, abs=0.01)
        assert (seen.x(), seen.y()) == pytest.approx(truth, abs=0.5)
    dock.close()
    assert dock.content.localize.hit.matches.pairs == []
    iface.tool_bar_actions[0].trigger()
    assert len(dock.content.localize.hit.matches.pairs) == len(marks)


def test_the_landmark_under_the_mouse_is_stressed_on_both_sides(dock, iface, area):
    from qgis.PyQt.QtCore import QPoint
    from qgis.PyQt.QtTest import QTest

    choose_method(dock, CONSTELLATION)
    localize(dock, area.database, [area.image])
    wait_until(lambda: dock.content.localize.hit.matches.pairs, "the matches")
    settle()
    view = dock.content.localize.results.image.canvas
    number, pixel = view._landmarks.matched[2]
    QTest.mouseMove(view.viewport(), view.mapFromScene(pixel))
    wait_until(lambda: pointed_numbers(dock) == (number, number), "the stressed landmark")
    place = iface.canvas.getCoordinateTransform().transform(dock.content.localize.hit.matches.pairs[4][1])
    QTest.mouseMove(iface.canvas.viewport(), QPoint(round(place.x()), round(place.y())))
    wait_until(lambda: pointed_numbers(dock) == (5, 5), "the other stressed landmark")
    # Drawn without an error, which pytest would see.
    dock.content.localize.results.image.grab()
    iface.canvas.grab()


def test_the_published_methods_runners_up_are_outlined_paler(dock, iface, area):
    localize(dock, area.database, [area.image])
    wait_until(lambda: "next best" in dock.content.localize.results.details.toPlainText(), "the runners-up")
    bands = [band for name, band in dock.content.localize.hit.highlight._bands.items() if "runner" in name]
    extents = [band.asGeometry().boundingBox() for band in bands]
    assert len(extents) == 4
    assert all(extent.width() == pytest.approx(WINDOW) for extent in extents)
    assert all((extent.xMinimum() - ORIGIN[0]) % STRIDE == pytest.approx(0) for extent in extents)
    assert corners(cut_extent()) not in [corners(extent) for extent in extents]
    opacities = [band.strokeColor().alpha() for band in bands]
    assert opacities == sorted(opacities, reverse=True) and opacities[0] < 255
    choose_method(dock, CONSTELLATION)
    dock.content.localize.localize_button.click()
    wait_until(lambda: not dock.content.localize.run.running, "the end of the run")
    assert all(not band.numberOfVertices() for band in bands)


def test_a_key_goes_from_image_to_image(dock, iface, area):
    from qgis.PyQt.QtCore import Qt
    from qgis.PyQt.QtTest import QTest

    localize(dock, area.database, [area.image, area.unreadable])
    iface.window.activateWindow()
    dock.content.localize.results.table.setFocus()
    wait_until(dock.content.localize.results.table.hasFocus, "the focus")
    names = []
    for key in (Qt.Key.Key_Down, Qt.Key.Key_Down, Qt.Key.Key_Up):
        QTest.keyClick(dock.content.localize.results.table, key, Qt.KeyboardModifier.AltModifier)
        names.append(dock.content.localize.results.table.selected().name)
    assert names == ["broken.tif", "on_window.tif", "broken.tif"]
    dock.content.localize.results.after.click()
    assert dock.content.localize.results.table.selected().name == "on_window.tif"


def test_going_through_many_images_quickly_reads_the_first_and_the_last(dock, area, monkeypatch, tmp_path):
    import shutil

    from semref.ui.tabs.localize import picture as image_picture

    images = [str(shutil.copy(area.image, tmp_path / f"{number:02d}.tif")) for number in range(30)]
    read, read_picture, go_on = [], image_picture.read_picture, threading.Event()

    def read_slowly(hit, *arguments):
        read.append(Path(hit.image).name)
        go_on.wait(DEADLINE_S)
        return read_picture(hit, *arguments)

    monkeypatch.setattr(image_picture, "read_picture", read_slowly)
    localize(dock, area.database, images)
    for _ in range(29):
        wait_until(lambda: read, "the first reading")
        dock.content.localize.results.after.click()
    go_on.set()
    wait_until(lambda: dock.content.localize.results.image.canvas.scene().items(), "the picture")
    assert read == ["00.tif", "29.tif"]


# --- layers as input, results as a file, the project ---


def add_raster_layer(path: str, name: str):
    from qgis.core import QgsProject, QgsRasterLayer

    layer = QgsRasterLayer(path, name, "gdal")
    QgsProject.instance().addMapLayer(layer)
    return layer


def dropped(widget, data) -> bool:
    """Drags `data` over a widget and drops it; whether it was taken."""
    from qgis.PyQt.QtCore import QPoint, QPointF, Qt
    from qgis.PyQt.QtGui import QDragEnterEvent, QDropEvent

    how = Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    entering = QDragEnterEvent(QPoint(5, 5), *how)
    widget.dragEnterEvent(entering)
    if entering.isAccepted():
        widget.dropEvent(QDropEvent(QPointF(5, 5), *how))
    return entering.isAccepted()


def from_the_layer_tree(*layers):
    from qgis.core import QgsLayerTreeModel, QgsProject

    root = QgsProject.instance().layerTreeRoot()
    model = QgsLayerTreeModel(root)
    return model.mimeData([model.node2index(root.findLayer(layer.id())) for layer in layers])


def test_a_raster_layer_of_the_project_is_an_image(dock, area):
    from qgis.core import QgsProject

    dock.content.localize.images.layers.aboutToShow.emit()
    assert not dock.content.localize.images.layers.actions()[0].isEnabled()
    add_raster_layer(area.image, "aerial image")
    dock.content.database.file.setFilePath(area.database)
    dock.content.database.add_to_map.click()
    dock.content.localize.images.layers.aboutToShow.emit()
    (action,) = dock.content.localize.images.layers.actions()
    assert action.text() == "aerial image"
    QgsProject.instance().clear()
    action.trigger()
    assert dock.content.localize.images.paths() == [area.image]


def test_layers_dropped_on_the_list_are_images_and_others_are_said(dock, iface, area, issues):
    layer = add_raster_layer(area.image, "aerial image")
    assert dropped(dock.content.localize.images.list, from_the_layer_tree(layer, issues))
    assert dock.content.localize.images.paths() == [area.image]
    assert "issues: not added" in messages(iface)[0]


def test_a_dropped_folder_is_an_entry(dock, area, tmp_path):
    from qgis.PyQt.QtCore import QMimeData, QUrl

    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(tmp_path))])
    assert dropped(dock.content.localize.images.list, data)
    assert dock.content.localize.images.paths() == [str(tmp_path)]


def test_a_database_of_the_project_can_be_chosen_or_dropped(dock, area):
    from qgis.core import QgsProject

    dock.content.database.file.setFilePath(area.database)
    assert not dock.content.database.in_project.isVisibleTo(dock)
    dock.content.database.add_to_map.click()
    settle()
    box = dock.content.database.in_project
    assert box.isVisibleTo(dock)
    assert [box.itemText(row) for row in range(1, box.count())] == ["area"]
    assert box.currentText() == "area"
    dock.content.database.file.setFilePath("")
    assert box.currentIndex() == 0
    box.setCurrentIndex(1)
    box.activated.emit(1)
    assert dock.content.database.path() == area.database
    dock.content.database.file.setFilePath("")
    windows = QgsProject.instance().mapLayersByName("Windows")[0]
    assert dropped(dock.content.database, from_the_layer_tree(windows))
    assert dock.content.database.path() == area.database
    QgsProject.instance().clear()
    settle()
    assert not box.isVisibleTo(dock)


def test_the_project_brings_the_dock_back_as_it_was_saved(dock, iface, area, tmp_path, monkeypatch):
    from qgis.core import QgsPointXY, QgsProject
    from qgis.PyQt.QtWidgets import QFileDialog

    saved = str(tmp_path / "results.gpkg")
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (saved, ""))
    localize(dock, area.database, [area.image, area.unreadable])
    dock.content.localize.results.save.trigger()
    dock.content.localize.results.image.opacity.setValue(35)
    dock.content.localize.images.model.setFilePath("")
    dock.content.localize.prior.set_circle(QgsPointXY(400_100, 5_399_900), QgsPointXY(400_160, 5_399_900))
    shown, before = table(dock), dock.content.localize.state_now()
    project = QgsProject.instance()
    assert project.write(str(tmp_path / "project.qgs"))
    assert "/" + Path(area.database).name in (tmp_path / "project.qgs").read_text(encoding="utf-8")

    dock.prepare("", "", [])
    project.clear()
    assert (table(dock), dock.content.localize.prior.circle()) == ([], None)
    assert project.read(str(tmp_path / "project.qgs"))
    assert not project.isDirty()
    assert dock.content.localize.state_now() == before
    assert before.opacity == 35 and before.prior[:2] == (400_100, 5_399_900) and before.results == saved
    assert table(dock) == shown
    assert corners(shown_outline(iface)) is not None
    assert dock.content.localize.prior.text.text() == "Search: within 60 m"


def test_a_project_whose_results_are_gone_is_opened_with_a_sentence(dock, iface, area, tmp_path, monkeypatch):
    from qgis.core import QgsProject
    from qgis.PyQt.QtWidgets import QFileDialog

    saved = tmp_path / "results.gpkg"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(saved), ""))
    localize(dock, area.database, [area.image])
    dock.content.localize.results.save.trigger()
    QgsProject.instance().write(str(tmp_path / "project.qgs"))
    QgsProject.instance().clear()
    saved.unlink()
    iface.bar.clearWidgets()
    QgsProject.instance().read(str(tmp_path / "project.qgs"))
    assert "results.gpkg holds no results" in messages(iface)[0]
    assert table(dock) == []


def test_a_project_without_the_dock_leaves_it_as_it_is(dock, area, tmp_path):
    from qgis.core import QgsProject

    (tmp_path / "other.qgs").write_text("<qgis version='3.22.0'/>", encoding="utf-8")
    localize(dock, area.database, [area.image])
    QgsProject.instance().read(str(tmp_path / "other.qgs"))
    assert len(table(dock)) == 1
    assert dock.content.database.path() == area.database


def test_the_search_circle_follows_the_canvas_into_another_crs(dock, iface, area):
    from qgis.core import QgsCoordinateReferenceSystem, QgsPointXY

    dock.content.localize.prior.set_circle(QgsPointXY(400_100, 5_399_900), QgsPointXY(400_160, 5_399_900))
    before = dock.content.localize.prior.parameters()
    iface.canvas.setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:3857"))
    (circle,) = rubber_bands(iface, "Polygon")
    assert abs(circle.boundingBox().center().x() - 400_100) > 100_000
    assert dock.content.localize.prior.parameters() == before


def test_a_leveled_image_is_laid_on_the_map_as_the_trapezoid_it_shows(dock, area):
    from qgis.core import QgsGeometry, QgsPointXY, QgsProject

    localize(dock, area.database, [area.image])
    left, bottom, right, top = corners(cut_extent())
    trapezoid = [(left, top), (right, top), (right - 40, bottom), (left + 40, bottom)]
    outline = QgsGeometry.fromPolygonXY([[QgsPointXY(*corner) for corner in trapezoid]])
    finding = dock.content.localize.results.table.selected()
    dock.content.localize.hit.drape(
        replace(finding, method="constellation", heading=0.0, pixel_size=1.0, outline=outline)
    )
    wait_until(QgsProject.instance().mapLayers, "the layer")
    (layer,) = QgsProject.instance().mapLayers().values()
    known = {True: 0, False: 0}
    for x, y in ((left + 20, bottom + 5), (right - 20, bottom + 5), (left + 45, bottom + 5), (left + 2, top - 2)):
        value, valid = layer.dataProvider().sample(QgsPointXY(x, y), 1)
        inside = outline.contains(QgsPointXY(x, y))
        known[inside] += 1
        assert inside or not valid or value == 0
    assert known == {True: 2, False: 2}


def test_layers_removed_and_the_project_closed_while_everything_is_shown_break_nothing(dock, iface, area, issues):
    from qgis.core import QgsProject

    dock.content.database.file.setFilePath(area.database)
    dock.content.database.add_to_map.click()
    choose_method(dock, CONSTELLATION)
    localize(dock, area.database, [area.image])
    dock.content.localize.results.keep.click()
    dock.content.localize.results.drape.click()
    dock.content.inspect.show_window("150_250")
    QgsProject.instance().removeAllMapLayers()
    settle()
    dock.content.localize.results.after.click()
    QgsProject.instance().clear()
    wait_until(lambda: dock.content.localize.results.image.canvas.scene().items(), "the picture")
    settle()
    assert len(table(dock)) == 1
    assert [text for text in messages(iface) if "error in SemRef" in text] == []


def test_unloading_while_pictures_are_read_leaves_nothing(plugin, dock, iface, area, monkeypatch):
    from semref.ui.tabs.localize import picture as image_picture

    read_picture = image_picture.read_picture

    def read_slowly(*arguments):
        time.sleep(0.3)
        return read_picture(*arguments)

    monkeypatch.setattr(image_picture, "read_picture", read_slowly)
    localize(dock, area.database, [area.image])
    dock.content.inspect.show_window("150_250")
    bare = len(iface.canvas.scene().items())
    plugin.unload()
    settle()
    assert iface.leftovers() == []
    assert len(iface.canvas.scene().items()) < bare


def test_photos_without_onnx_runtime_point_to_the_installer(plugin, dock, iface, area, monkeypatch, tmp_path):
    from semref.processing.framework import photo_labels
    from semref.processing.packages.components import ONNXRUNTIME
    from semref.ui.packages import missing_notice
    from semref.ui.packages.components_page import PAGE

    for module in (photo_labels, missing_notice):
        monkeypatch.setattr(module, "missing", lambda packages: [p for p in packages if p is ONNXRUNTIME])
    assert not dock.content.notice.isVisible()
    dock.content.localize.images.model.setFilePath(str(tmp_path / "model.onnx"))
    assert dock.content.notice.isVisible() and "ONNX Runtime is missing" in dock.content.notice.sentence.text()
    dock.content.notice.install.click()
    assert iface.options_pages_shown == [PAGE]
    localize(dock, area.database, [area.image])
    assert "Settings ▸ Options ▸ SemRef" in messages(iface)[0]
    dock.content.localize.images.model.setFilePath("")
    assert not dock.content.notice.isVisible()


def test_what_a_run_says_is_in_the_log_panel_and_a_hidden_dock_tells_the_outcome(dock, iface, area):
    from qgis.core import QgsApplication

    logged = []
    log = QgsApplication.messageLog()

    def note(*entry):
        logged.append(entry)

    log.messageReceived[str, str, "Qgis::MessageLevel"].connect(note)
    start(dock, area.database, [area.image])
    dock.close()
    wait_until(lambda: not dock.content.localize.run.running, "the end of the run")
    log.messageReceived[str, str, "Qgis::MessageLevel"].disconnect(note)
    assert any("on_window.tif: 400250.0" in text for text, tag, *_ in logged if tag == "SemRef")
    assert messages(iface) == ["1 of 1 images have a fix."]


def test_tab_and_sizes_are_remembered(plugin, dock, iface, area):
    from semref.ui.dock.content import INSPECT, LOCALIZE

    parts = dock.content.localize.results.parts
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


def test_a_list_of_many_places_is_filled_without_holding_up_qgis(dock, iface, issues):
    from qgis.core import QgsFeature, QgsGeometry, QgsProject, QgsRectangle

    features = []
    for number in range(20_000):
        feature = QgsFeature(issues.fields())
        feature.setGeometry(QgsGeometry.fromRect(QgsRectangle(number, 0, number + 1, 1)))
        feature.setAttributes(["gap", "warning", "A gap.", 1.0])
        features.append(feature)
    issues.dataProvider().addFeatures(features)
    dock.content.correct.layer.setLayer(None)
    dock.content.correct.layer.setLayer(issues)
    places = dock.content.correct.places
    assert 0 < places.rowCount() < 20_003
    places.selectRow(1)
    dock.content.correct.done.click()
    wait_until(lambda: places.rowCount() == 20_003, "the whole list")
    assert (dock.content.correct.progress.value(), dock.content.correct.progress.maximum()) == (1, 20_003)
    assert places.selectionModel().selectedRows()[0].row() == 2
    # Removed halfway.
    dock.content.correct.open.setChecked(True)
    assert 0 < places.rowCount() < 20_003
    QgsProject.instance().removeMapLayer(issues.id())
    settle()
    assert places.rowCount() == 0


def test_pictures_need_no_conversion_to_be_shown(qgis_app):
    """Qt would convert them in its thread pool, which the main thread must never wait for."""
    import numpy as np
    from qgis.PyQt.QtGui import QColor, QImage

    from semref.ui.tabs.localize.picture import label_picture

    image = label_picture(np.array([[0, 1], [2, 1]], np.uint8), {1: (250, 20, 30), 2: (1, 2, 200)})
    assert image.format() == QImage.Format.Format_ARGB32_Premultiplied
    assert image.pixelColor(1, 0) == QColor(250, 20, 30) and image.pixelColor(0, 1) == QColor(1, 2, 200)
    assert image.pixelColor(0, 0).alpha() == 0
