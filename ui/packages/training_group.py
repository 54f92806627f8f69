"""The part of the options page about training: which Python trains networks, and how to get one."""

from __future__ import annotations

import sys

from qgis.core import QgsApplication, QgsSettings
from qgis.gui import QgsFileWidget
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import (
    QCheckBox,
    QFileDialog,
    QGroupBox,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
)

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
from ..widgets.layouts import row_of
from .component_installer import ComponentInstaller


class TrainingGroup(QGroupBox):
    """``installer`` outlives the page: what it does when the options are opened again is shown again."""

    def __init__(self, installer: ComponentInstaller) -> None:
        super().__init__(tr("Training"))
        self._installer = installer
        self.python = QgsFileWidget()
        self.python.setFilePath(QgsSettings().value(PYTHON_SETTING, "", type=str))
        self.python.lineEdit().setPlaceholderText(tr("SemRef’s own environment"))
        self.make = QPushButton(QgsApplication.getThemeIcon("/mActionAdd.svg"), tr("Make environment"))
        self.make_from_wheels = QPushButton(tr("Make it from a folder of wheels…"))
        self.remove = QPushButton(tr("Remove environment"))
        self.small = QCheckBox(tr("Without graphics cards: about a fifth of the size"))
        self.cancel = QPushButton(tr("Cancel"))
        self.progress = QProgressBar()
        self.state = QLabel()
        self._lay_out()
        self._connect()
        self._show_state()

    def apply(self) -> None:
        """Keeps which Python trains."""
        QgsSettings().setValue(PYTHON_SETTING, self.python.filePath().strip())

    def _lay_out(self) -> None:
        explanation = QLabel(
            tr(
                "“Train model” needs a Python of its own with torch. SemRef can make one in your profile: about 1.5 GB "
                "on disk, and up to 7 GB with support for NVIDIA’s graphics cards. Or name a Python that has it."
            )
        )
        for label in (explanation, self.state):
            label.setWordWrap(True)
        self.state.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        # Busy: pip does not tell how far it is.
        self.progress.setRange(0, 0)
        # Elsewhere the common index has builds for processors alone.
        self.small.setVisible(sys.platform.startswith("linux"))
        self.small.setChecked(True)
        layout = QVBoxLayout(self)
        layout.addWidget(explanation)
        chosen = QLabel(tr("Python that trains")), self.python
        for row in (chosen, (self.make, self.remove), (self.make_from_wheels,)):
            layout.addLayout(row_of(*row))
        layout.addWidget(self.small)
        layout.addWidget(self.state)
        layout.addLayout(row_of((self.progress, 1), self.cancel))

    def _connect(self) -> None:
        self.make.clicked.connect(self._make)
        self.make_from_wheels.clicked.connect(self._choose_wheels)
        self.remove.clicked.connect(self._remove)
        self.cancel.clicked.connect(self._installer.cancel)
        self._installer.began.connect(self._show_step)
        self._installer.said.connect(self._show_last_line)
        self._installer.installed.connect(self._show_state)
        self._installer.failed.connect(self._show_end)
        self._installer.broke.connect(self._show_bug)
        self._installer.canceled.connect(self._show_state)

    def _make(self) -> None:
        self._start("")

    def _choose_wheels(self) -> None:
        folder = QFileDialog.getExistingDirectory(self.window(), tr("Choose a folder with wheels (*.whl)"))
        if folder:
            self._start(folder)

    def _start(self, wheels: str) -> None:
        # isHidden, not isVisible: the page itself may not be shown yet.
        is_small = self.small.isChecked() and not self.small.isHidden()
        self._installer.follow(making_environment(wheels, is_small))
        self._enable()

    def _remove(self) -> None:
        try:
            remove_environment()
        except ComponentError as error:
            self._show_end(worded(error))
        else:
            self._show_state()

    # --- what is there ---

    def _show_step(self, sentence: str) -> None:
        self.state.setText(sentence)
        self._enable()

    def _show_last_line(self, text: str) -> None:
        lines = text.strip().splitlines()
        if lines:
            self.state.setToolTip(lines[-1])

    def _show_state(self) -> None:
        ready = tr("The environment is ready: {folder}").format(folder=environment_folder())
        self._show_end(ready if is_environment_ready() else tr("There is no environment for training yet."))

    def _show_bug(self, report: str) -> None:
        self._show_end(
            tr("An error in SemRef stopped the installation; please report what stands below.") + f"\n{report}"
        )

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
