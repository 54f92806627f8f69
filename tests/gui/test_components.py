import os

import pytest
from qgis.core import Qgis, QgsApplication, QgsMessageLog, QgsSettings
from qgis.PyQt.QtWidgets import QTabWidget

from semref.processing.packages import components
from semref.processing.packages.components import DASK, ONNXRUNTIME, OPENCV, install_command
from semref.processing.packages.devices import DEVICE_SETTING, chosen_device
from semref.processing.packages.training_environment import PYTHON_SETTING
from semref.ui.entry import PAGE
from semref.ui.packages import components_page


@pytest.fixture
def lacking(monkeypatch):
    """OpenCV, ONNX Runtime and Dask are missing until taken out of this list."""
    packages = [components.OPENCV, components.ONNXRUNTIME, components.DASK]
    for module in (components, components_page):
        monkeypatch.setattr(module, "is_missing", lambda package: package in packages)
    return packages


@pytest.fixture
def plugin(lacking, loaded):
    return loaded


@pytest.fixture
def page(plugin, iface):
    made = iface.options_factories[0].createWidget(None)
    made.resize(760, 460)
    made.show()
    yield made
    made.deleteLater()


def test_the_page_lists_what_is_missing_and_copies_the_command_for_what_is_ticked(page, lacking):
    states = [state.text() for state in page.states.values()]
    assert states == ["Missing", "Ready", "Ready", "Missing", "Missing", "Ready"]
    # Dask is there for who wants it; nothing suggests it.
    assert not page.checks[DASK].isChecked()
    assert page.install.isEnabled() and not page.progress.isVisible() and not page.log.isVisible()
    page.checks[OPENCV].setChecked(False)
    page.copy.click()
    assert QgsApplication.clipboard().text() == install_command([ONNXRUNTIME])


def test_the_dock_shows_missing_packages_until_they_are_installed(plugin, iface, lacking):
    iface.tool_bar_actions[0].trigger()
    dock = iface.docks[0]
    assert dock.notice.isVisible() and "does not have yet: OpenCV, ONNX Runtime." in dock.notice.sentence.text()
    assert dock.findChild(QTabWidget) is None
    dock.notice.install.click()
    assert iface.options_pages_shown == [PAGE]
    lacking.clear()
    plugin._entry._installer.installed.emit()
    assert not dock.notice.isVisible() and dock.findChild(QTabWidget).isVisible()


def test_the_page_keeps_which_python_trains_and_shows_errors_of_the_environment(page, iface, plugin):
    box, installer = page.training, plugin._entry._training_installer
    assert "no training environment" in box.state.text() and box.make.isEnabled() and not box.remove.isEnabled()
    for path in ("/opt/torch/bin/python", ""):
        box.python.setFilePath(path)
        page.apply()
        assert (QgsSettings().value(PYTHON_SETTING) or "") == path
    installer.began.emit("Making the training environment…")
    assert box.state.text() == "Making the training environment…"
    installer.failed.emit("The packages of the training environment could not be installed: no network.")
    assert "no network" in box.state.text() and box.make.isEnabled()
    assert "no network" in iface.bar.currentItem().text()


@pytest.fixture
def no_choice():
    QgsSettings().remove(DEVICE_SETTING)
    yield
    QgsSettings().remove(DEVICE_SETTING)


def fake_providers(monkeypatch, *there):
    import onnxruntime

    monkeypatch.setattr(onnxruntime, "get_available_providers", lambda: [f"{name}ExecutionProvider" for name in there])


def test_devices_of_onnxruntime_can_be_chosen_and_the_choice_is_kept(lacking, no_choice, plugin, iface, monkeypatch):
    lacking.clear()
    fake_providers(monkeypatch, "CUDA", "CPU")
    page = iface.options_factories[0].createWidget(None)
    only = {"auto": True, "cpu": True, "cuda": True, "directml": False, "coreml": False, "openvino": False}
    box = page.devices.device
    assert {box.itemData(place): box.model().item(place).isEnabled() for place in range(box.count())} == only
    assert page.devices.device.currentData() == "auto"
    text = page.devices.missing.text()
    assert "DirectML (onnxruntime-directml, Windows)" in text and "OpenVINO (onnxruntime-openvino)" in text
    assert "CUDA" not in text
    page.devices.device.setCurrentIndex(page.devices.device.findData("cuda"))
    page.apply()
    assert chosen_device() == "cuda"
    # Without its package the choice stays, for it to come back.
    fake_providers(monkeypatch, "CPU")
    again = iface.options_factories[0].createWidget(None)
    assert again.devices.device.currentData() == "cuda" and "CUDA (onnxruntime-gpu)" in again.devices.missing.text()


def test_diagnostics_are_copied_from_the_menu_with_the_last_messages_of_semref(plugin, iface):
    path = os.path.expanduser("~/maps.gpkg")
    QgsMessageLog.logMessage(f"{path} is damaged.", "SemRef", Qgis.MessageLevel.Warning)
    QgsMessageLog.logMessage("Something of another plugin", "Other", Qgis.MessageLevel.Warning)
    action = next(action for action in iface.menu_actions if action.objectName() == "SemRefDiagnosticsAction")
    action.trigger()
    text = QgsApplication.clipboard().text()
    assert text.startswith("SemRef ") and "\nOpenCV: " in text
    assert "SemRef: ~/maps.gpkg is damaged." in text
    assert "another plugin" not in text
    assert "on the clipboard" in iface.bar.currentItem().text()
