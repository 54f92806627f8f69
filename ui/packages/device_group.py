"""Part of the options page: the device that runs models, and packages for further devices."""

from __future__ import annotations

from functools import partial

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtWidgets import QComboBox, QGroupBox, QLabel, QMenu, QPushButton, QVBoxLayout

from ...processing.packages.devices import (
    AUTO,
    DEVICES,
    Device,
    available_devices,
    choose_device,
    chosen_device,
    package_name,
    package_of,
)
from ...processing.translation import tr
from ..widgets.layouts import row_of


class DeviceGroup(QGroupBox):
    """installAsked: package for a device, and whether to install it from a folder of wheels."""

    installAsked = pyqtSignal(object, bool)

    def __init__(self) -> None:
        super().__init__(tr("Device"))
        self.device = QComboBox()
        self.missing = QLabel()
        self.install = QPushButton(QgsApplication.getThemeIcon("/mActionAdd.svg"), tr("Install a package for…"))
        self.install.setMenu(QMenu(self.install))
        self._lay_out()
        self.show_devices(chosen_device())

    def apply(self) -> None:
        """Store the chosen device."""
        choose_device(self.device.currentData())

    def _lay_out(self) -> None:
        explanation = QLabel(
            tr(
                "Device that runs the models. If it does not start, SemRef uses the processor. The log and the "
                "results show the device and the tiles per second."
            )
        )
        for label in (explanation, self.missing):
            label.setWordWrap(True)
        label = QLabel(tr("Run models on"))
        label.setBuddy(self.device)
        layout = QVBoxLayout(self)
        layout.addWidget(explanation)
        choice, offer = row_of(label, self.device), row_of(self.install)
        layout.addLayout(choice)
        layout.addWidget(self.missing)
        layout.addLayout(offer)
        for row in (choice, offer):
            row.addStretch(1)

    def show_devices(self, chosen: str) -> None:
        """List the devices, and select the one with this key."""
        there = available_devices()
        self.device.clear()
        self.device.addItem(tr("Auto"), AUTO)
        for device in DEVICES:
            self.device.addItem(device.title, device.key)
            if device not in there:
                place = self.device.count() - 1
                self.device.model().item(place).setEnabled(device.key == chosen)
                self.device.setItemData(place, _where(device), Qt.ItemDataRole.ToolTipRole)
        self.device.setCurrentIndex(max(0, self.device.findData(chosen)))
        lacking = [device for device in DEVICES if device not in there]
        each = ", ".join(f"{device.title} ({package_name(device)})" for device in lacking)
        self.missing.setText(tr("Not available (required Python package in brackets): {devices}.").format(devices=each))
        self.missing.setVisible(bool(lacking))
        self._offer([device for device in lacking if package_of(device) is not None])

    def _offer(self, devices: list[Device]) -> None:
        menu = self.install.menu()
        menu.clear()
        for text, from_folder in ((tr("{device} ({package})"), False), (tr("{device} from a folder of wheels…"), True)):
            for device in devices:
                named = text.format(device=device.title, package=device.package)
                menu.addAction(named, partial(self.installAsked.emit, package_of(device), from_folder))
        self.install.setVisible(bool(devices))


def _where(device: Device) -> str:
    """Return the package that a device needs."""
    text = tr("{device} is not available. It needs the Python package {package}.")
    return text.format(device=device.title, package=package_name(device))
