"""Fixtures with real QGIS windows; tools/pytest_suites.sh runs these tests in a virtual display."""

import os
import sys
import time

import pytest
from dock_area import CRS, ORIGIN, TOPOLOGY_VECTOR, Area, choose_method, rectangles, settle
from qgis.core import QgsApplication, QgsCoordinateReferenceSystem, QgsProject, QgsSettings
from qgis.gui import QgsBrowserGuiModel
from qgis.PyQt.QtGui import QClipboard
from qgis.PyQt.QtWidgets import QApplication

from semref.plugin import SemRefPlugin
from semref.processing.algorithms import localize_images
from semref.storage import rasters
from semref.ui.running import algorithm_run


@pytest.fixture(scope="session")
def display():
    name = os.environ.get("DISPLAY")
    if not name:
        pytest.skip("no display: run under xvfb-run")
    return name


@pytest.fixture(scope="session")
def qgis_app(start_qgis, display):
    os.environ.pop("QT_QPA_PLATFORM", None)
    return start_qgis(window=True)


@pytest.fixture(autouse=True)
def clipboard_left_empty():
    """Clear clipboard and selection after each test, so that another QGIS does not wait for this process.

    QGIS reads X's clipboard and selection whenever the layer changes. Qt 5 waits five seconds for each format while
    their owner is busy, as pytest is while it waits for a QGIS that it started.
    """
    yield
    if QApplication.instance() is not None:
        for mode in (QClipboard.Mode.Clipboard, QClipboard.Mode.Selection):
            QApplication.clipboard().clear(mode)
        QApplication.processEvents()


@pytest.fixture
def filled_at_once(qgis_app, monkeypatch):
    """Fill lists in one slice of time, however busy the machine is."""
    from semref.ui.tabs.correct import tab

    monkeypatch.setattr(tab, "_FILL_S", 600.0)


@pytest.fixture
def iface(qgis_app, filled_at_once):
    """Stand-in of QGIS's interface that records what the plugin adds, so that a test sees what remains."""
    from stand_in_interface import InterfaceStandIn

    stand_in = InterfaceStandIn()
    stand_in.window.show()
    yield stand_in
    stand_in.window.close()
    stand_in.window.deleteLater()


@pytest.fixture(scope="session")
def area(run_algorithm, tmp_path_factory):
    return Area(tmp_path_factory.mktemp("area"), run_algorithm)


@pytest.fixture
def loaded(iface, without_provider):
    """The plugin in a profile without its settings."""
    QgsSettings().remove("semref")
    plugin = SemRefPlugin(iface)
    plugin.initGui()
    yield plugin
    plugin.unload()
    settle()
    QgsProject.instance().clear()


@pytest.fixture
def plugin(area, iface, loaded):
    iface.canvas.setDestinationCrs(QgsCoordinateReferenceSystem(CRS))
    return loaded


@pytest.fixture
def dock(plugin, iface):
    iface.tool_bar_actions[0].trigger()
    dock = iface.docks[0]
    # The published method names the window, so the truth is exact.
    choose_method(dock, TOPOLOGY_VECTOR)
    return dock


@pytest.fixture
def slow(monkeypatch, area):
    """Make a run as long as a thousand images; a cancel takes effect between two images."""
    localize = localize_images.localize_image

    def localize_slowly(*arguments):
        time.sleep(0.03)
        return localize(*arguments)

    monkeypatch.setattr(localize_images, "localize_image", localize_slowly)
    monkeypatch.setattr(rasters, "image_files", lambda paths: paths * 1000)


class LosingManager:
    def __init__(self, manager):
        self.manager, self.lost = manager, []

    def addTask(self, task):
        if self.lost:
            self.manager.addTask(task)
        else:
            self.lost.append(task)

    def __getattr__(self, name):
        return getattr(self.manager, name)


@pytest.fixture
def first_task_lost(qgis_app, monkeypatch):
    """Make QGIS never start its first task; a list with the lost task."""
    manager = LosingManager(QgsApplication.taskManager())
    monkeypatch.setattr(QgsApplication, "taskManager", lambda: manager)
    monkeypatch.setattr(algorithm_run, "BEGINS_WITHIN_MS", 50)
    return manager.lost


@pytest.fixture
def issues(qgis_app, dock):
    """A layer of three issues in a row, 100 m apart, as “Check land-cover layer” creates it."""
    fields = {"kind": "string", "severity": "string", "message": "string", "area": "double"}
    rows = [
        ((ORIGIN[0] + 100 * number, ORIGIN[1] - 10, 10, 10), kind, "warning", f"Here is a {kind}.", 100.0)
        for number, kind in enumerate(("overlap", "gap", "sliver"))
    ]
    layer = rectangles("issues", fields, rows)
    dock.content.correct.layer.setLayer(layer)
    return layer


@pytest.fixture
def tab(dock):
    return dock.content.localize


@pytest.fixture
def open_dialog(plugin, iface, monkeypatch):
    """`open_dialog(id, parameters)` opens and returns QGIS's dialog of one of SemRef's algorithms."""
    import processing
    from processing.gui import AlgorithmDialog

    assert AlgorithmDialog
    browser = QgsBrowserGuiModel()
    monkeypatch.setattr(iface, "browserModel", lambda: browser, raising=False)
    monkeypatch.setattr(iface, "activeLayer", lambda: None, raising=False)
    # Each of Processing's modules took the window when it was imported.
    for module in [module for name, module in sys.modules.items() if name.startswith("processing.")]:
        if hasattr(module, "iface"):
            monkeypatch.setattr(module, "iface", iface)
    kept = []

    def make(name: str, given: dict):
        dialog = processing.createAlgorithmDialog(f"semref:{name}", given)
        dialog.show()
        settle()
        kept.append(dialog)
        return dialog

    yield make
    for dialog in kept:
        dialog.close()
        dialog.deleteLater()
    settle()
