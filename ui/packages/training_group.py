"""Part of the options page: the Python for training, and creating a training environment."""

from __future__ import annotations

import sys

from qgis.core import QgsApplication, QgsSettings
from qgis.gui import QgsFileWidget
from qgis.PyQt.QtWidgets import QCheckBox, QGroupBox, QLabel, QProgressBar, QPushButton, QVBoxLayout

from ...core.errors import ComponentError
from ...processing.messages.sentences import worded
from ...processing.packages.training_environment import (
    PYTHON_SETTING,
    environment_folder,
    is_environment_ready,
    making_environment,
    remove_environment,
)
from ...processing.translation import tr
from ..widgets.controls import ask_folder, message_label
from ..widgets.layouts import row_of
from .component_installer import ComponentInstaller

WHEELS_SETTING = "semref/options/wheels_folder"


class TrainingGroup(QGroupBox):
    """``installer`` outlives the page, so a page that is opened later shows a running installation."""

    def __init__(self, installer: ComponentInstaller) -> None:
        super().__init__(tr("Training"))
        self._installer = installer
        self.python = QgsFileWidget()
        self.python.setFilePath(QgsSettings().value(PYTHON_SETTING, "", type=str))
        self.python.lineEdit().setPlaceholderText(tr("Training environment of SemRef"))
        self.make = QPushButton(QgsApplication.getThemeIcon("/mActionAdd.svg"), tr("Create environment"))
        self.make_from_wheels = QPushButton(tr("Create it from a folder of wheels…"))
        self.remove = QPushButton(tr("Remove environment"))
        self.small = QCheckBox(tr("Without GPU support (about one fifth of the size)"))
        self.cancel = QPushButton(tr("Cancel"))
        self.progress = QProgressBar()
        self.state = message_label()
        self._lay_out()
        self._connect()
        self._show_state()

    def apply(self) -> None:
        QgsSettings().setValue(PYTHON_SETTING, self.python.filePath().strip())

    def _lay_out(self) -> None:
        explanation = QLabel(
            tr(
                "“Train model” needs a training environment: a separate Python with torch. SemRef can create one "
                "in your profile. It needs about 1.5 GB on disk, or up to 7 GB with support for NVIDIA GPUs. You "
                "can also choose another Python that has torch."
            )
        )
        explanation.setWordWrap(True)
        # Busy indicator: pip reports no progress.
        self.progress.setRange(0, 0)
        # On other systems the package index has builds without GPU support only.
        self.small.setVisible(sys.platform.startswith("linux"))
        self.small.setChecked(True)
        layout = QVBoxLayout(self)
        layout.addWidget(explanation)
        chosen = QLabel(tr("Python for training")), self.python
        for row in (chosen, (self.make, self.remove), (self.make_from_wheels,)):
            layout.addLayout(row_of(*row))
        layout.addWidget(self.small)
        layout.addWidget(self.state)
        layout.addLayout(row_of((self.progress, 1), self.cancel))

    def _connect(self) -> None:
        self.make.clicked.connect(lambda: self._start(""))
        self.make_from_wheels.clicked.connect(self._choose_wheels)
        self.remove.clicked.connect(self._remove)
        self.cancel.clicked.connect(self._installer.cancel)
        self._installer.began.connect(self._show_step)
        self._installer.outputRead.connect(self._show_last_line)
        self._installer.installed.connect(self._show_state)
        self._installer.failed.connect(self._show_end)
        self._installer.canceled.connect(self._show_state)

    def _choose_wheels(self) -> None:
        folder = ask_folder(self.window(), tr("Choose a folder with wheels (*.whl)"), WHEELS_SETTING)
        if folder:
            self._start(folder)

    def _start(self, wheels: str) -> None:
        # Not isVisible: the page itself may not be shown yet.
        is_small = self.small.isChecked() and not self.small.isHidden()
        self._installer.start(making_environment(wheels, is_small))
        self._enable()

    def _remove(self) -> None:
        try:
            remove_environment()
        except ComponentError as error:
            self._show_end(worded(error))
        else:
            self._show_state()

    # --- state ---

    def _show_step(self, sentence: str) -> None:
        self.state.setText(sentence)
        self._enable()

    def _show_last_line(self, text: str) -> None:
        lines = text.strip().splitlines()
        if lines:
            self.state.setToolTip(lines[-1])

    def _show_state(self) -> None:
        ready = tr("The training environment is ready: {folder}").format(folder=environment_folder())
        self._show_end(ready if is_environment_ready() else tr("There is no training environment yet."))

    def _show_end(self, sentence: str) -> None:
        self.state.setText(sentence)
        self._enable()

    def _enable(self) -> None:
        running = self._installer.running
        for button in (self.make, self.make_from_wheels, self.small):
            button.setEnabled(not running)
        self.remove.setEnabled(not running and environment_folder().exists())
        self.progress.setVisible(running)
        self.cancel.setVisible(running)
