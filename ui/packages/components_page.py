"""Options page: Python packages with their purpose and state, and the installation of missing ones."""

from __future__ import annotations

from qgis.core import QgsApplication
from qgis.gui import QgsOptionsPageWidget
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtGui import QFontDatabase, QTextCursor
from qgis.PyQt.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFrame,
    QGridLayout,
    QGroupBox,
    QLabel,
    QPlainTextEdit,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from ...core.errors import ComponentError
from ...processing.messages.sentences import worded
from ...processing.packages.components import (
    OPTIONAL,
    PACKAGES,
    Package,
    components_root,
    install_command,
    is_missing,
    is_own,
    is_too_old,
    origin,
    purpose,
    remove_components,
)
from ...processing.packages.devices import AUTO, DEVICES, available_devices, choose_device, chosen_device, package_name
from ...processing.packages.install import installing
from ...processing.translation import tr
from ..widgets.controls import ask_folder, message_label
from ..widgets.layouts import row_of
from .component_installer import ComponentInstaller
from .training_group import WHEELS_SETTING, TrainingGroup

_LOG_STRETCH = 100


class ComponentsPage(QgsOptionsPageWidget):
    """Options page. ``installer`` outlives it, so a page that is opened later shows a running installation."""

    removed = pyqtSignal()

    def __init__(self, installer: ComponentInstaller, training_installer: ComponentInstaller, parent=None) -> None:
        super().__init__(parent)
        self._installer = installer
        self.training = TrainingGroup(training_installer)
        self.devices = DeviceGroup()
        self.checks = {package: QCheckBox() for package in PACKAGES}
        self.states = {package: QLabel() for package in PACKAGES}
        self.install = QPushButton(QgsApplication.getThemeIcon("/mActionAdd.svg"), tr("Install"))
        self.install_wheels = QPushButton(tr("Install from a folder of wheels…"))
        self.copy = QPushButton(QgsApplication.getThemeIcon("/mActionEditCopy.svg"), tr("Copy command"))
        self.remove = QPushButton(tr("Remove SemRef’s packages"))
        self.cancel = QPushButton(tr("Cancel"))
        self.progress = QProgressBar()
        self.state = message_label()
        self.log = QPlainTextEdit()
        self._lay_out()
        self._connect()
        self._show_packages()
        self._add_to_log(installer.log)

    def apply(self) -> None:
        """Store the device and the Python for training. All buttons act at once, without OK."""
        self.devices.apply()
        self.training.apply()

    def _lay_out(self) -> None:
        explanation = QLabel(
            tr(
                "Some QGIS installations lack these Python packages. SemRef can install them for this QGIS into "
                "a separate folder. The packages of QGIS itself, such as NumPy, do not change."
            )
        )
        explanation.setWordWrap(True)
        # Busy indicator: pip reports no progress.
        self.progress.setRange(0, 0)
        self.log.setReadOnly(True)
        self.log.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.log.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        buttons = QGridLayout()
        buttons.addWidget(self.install, 0, 0)
        buttons.addWidget(self.install_wheels, 0, 1)
        buttons.addWidget(self.copy, 1, 0)
        buttons.addWidget(self.remove, 1, 1)
        buttons.setColumnStretch(2, 1)
        group = QGroupBox(tr("Python packages"))
        layout = QVBoxLayout(group)
        layout.addWidget(explanation)
        layout.addLayout(self._package_table())
        layout.addLayout(buttons)
        layout.addWidget(self.state)
        layout.addLayout(row_of((self.progress, 1), self.cancel))
        layout.addWidget(self.log, _LOG_STRETCH)
        # Keeps the widgets at the top while there is no log.
        layout.addStretch(1)
        whole = QWidget()
        layout = QVBoxLayout(whole)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(group, 1)
        layout.addWidget(self.devices)
        layout.addWidget(self.training)
        # The page is higher than the dialog on small screens.
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidget(whole)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(area)

    def _package_table(self) -> QGridLayout:
        table = QGridLayout()
        headings = "", tr("Package"), tr("Purpose"), tr("State")
        for column, heading in enumerate(headings):
            table.addWidget(QLabel(f"<b>{heading}</b>"), 0, column)
        for row, package in enumerate(PACKAGES, start=1):
            title, use = QLabel(package.title), QLabel(purpose(package))
            title.setToolTip(package.pip_name)
            title.setBuddy(self.checks[package])
            self.checks[package].setAccessibleName(package.title)
            use.setWordWrap(True)
            for column, widget in enumerate((self.checks[package], title, use, self.states[package])):
                table.addWidget(widget, row, column)
        table.setColumnStretch(2, 1)
        return table

    def _connect(self) -> None:
        for check in self.checks.values():
            check.toggled.connect(self._enable)
        self.install.clicked.connect(lambda: self._start(""))
        self.install_wheels.clicked.connect(self._choose_wheels)
        self.copy.clicked.connect(self._copy_command)
        self.remove.clicked.connect(self._remove)
        self.cancel.clicked.connect(self._installer.cancel)
        self._installer.began.connect(self.state.setText)
        self._installer.outputRead.connect(self._add_to_log)
        self._installer.installed.connect(lambda: self._show_end(tr("Installed. You do not need to restart QGIS.")))
        self._installer.failed.connect(self._show_end)
        self._installer.canceled.connect(lambda: self._show_end(tr("Canceled.")))

    # --- state ---

    def _show_packages(self) -> None:
        for package in PACKAGES:
            lacks = is_missing(package)
            self.checks[package].setVisible(lacks)
            self.checks[package].setChecked(lacks and package not in OPTIONAL)
            self.states[package].setText(_state(package))
            self.states[package].setToolTip("" if lacks else origin(package))
        self._enable()

    def _chosen_packages(self) -> list[Package]:
        return [package for package, check in self.checks.items() if check.isChecked()]

    def _enable(self) -> None:
        running = self._installer.running
        for button in (self.install, self.install_wheels, self.copy):
            button.setEnabled(not running and bool(self._chosen_packages()))
        for check in self.checks.values():
            check.setEnabled(not running)
        self.remove.setEnabled(not running and components_root().is_dir())
        self.progress.setVisible(running)
        self.cancel.setVisible(running)
        self.log.setVisible(bool(self.log.toPlainText()))

    # --- actions ---

    def _choose_wheels(self) -> None:
        folder = ask_folder(self.window(), tr("Choose a folder with wheels (*.whl)"), WHEELS_SETTING)
        if folder:
            self._start(folder)

    def _start(self, wheels: str) -> None:
        self.log.clear()
        self._installer.start(installing(self._chosen_packages(), wheels))
        self._enable()

    def _copy_command(self) -> None:
        command = install_command(self._chosen_packages())
        QgsApplication.clipboard().setText(command)
        self.state.setText(tr("Copied: {command}").format(command=command))

    def _remove(self) -> None:
        try:
            remove_components()
        except ComponentError as error:
            self._show_end(worded(error))
        else:
            self._show_end(tr("Removed. Packages in use stay in memory until you close QGIS."))
        self.removed.emit()

    # --- results ---

    def _add_to_log(self, text: str) -> None:
        self.log.moveCursor(QTextCursor.MoveOperation.End)
        self.log.insertPlainText(text)
        self._enable()

    def _show_end(self, sentence: str) -> None:
        self.state.setText(sentence)
        self._show_packages()
        self.devices.show_devices(self.devices.device.currentData())


def _state(package: Package) -> str:
    if is_too_old(package):
        return tr("Too old")
    if is_missing(package):
        return tr("Missing")
    return tr("Installed by SemRef") if is_own(package) else tr("Ready")


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
