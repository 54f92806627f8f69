"""Part of the options page: the device that runs models."""

from __future__ import annotations

from qgis.PyQt.QtWidgets import QComboBox, QGroupBox, QLabel, QVBoxLayout

from ...processing.packages.devices import AUTO, DEVICES, available_devices, choose_device, chosen_device, package_name
from ...processing.translation import tr
from ..widgets.layouts import row_of


class DeviceGroup(QGroupBox):
    """Choice of the device, and the packages that other devices need."""

    def __init__(self) -> None:
        super().__init__(tr("Device"))
        self.device = QComboBox()
        self.missing = QLabel()
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
        choice = row_of(label, self.device)
        choice.addStretch(1)
        layout.addLayout(choice)
        layout.addWidget(self.missing)

    def show_devices(self, chosen: str) -> None:
        """List the devices, and select the one with this key."""
        there = available_devices()
        self.device.clear()
        self.device.addItem(tr("Auto"), AUTO)
        for device in DEVICES:
            self.device.addItem(device.title, device.key)
            if device not in there:
                self.device.model().item(self.device.count() - 1).setEnabled(device.key == chosen)
        self.device.setCurrentIndex(max(0, self.device.findData(chosen)))
        lacking = [device for device in DEVICES if device not in there]
        each = ", ".join(f"{device.title} ({package_name(device)})" for device in lacking)
        self.missing.setText(tr("Not available (required Python package in brackets): {devices}.").format(devices=each))
        self.missing.setVisible(bool(lacking))
