"""Notice at the top of the dock while a Python package is missing."""

from __future__ import annotations

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton

from ...processing.packages.components import NEEDED, ONNXRUNTIME, OPTIONAL, PACKAGES, missing
from ...processing.translation import tr

_ICON_PX = 16


class MissingNotice(QFrame):
    """Visible while a needed package is missing; ``refresh`` checks again.

    blocks: the dock can't work without the missing packages.
    """

    def __init__(self) -> None:
        super().__init__()
        self.blocks = self._photos = False
        self.setObjectName("SemRefMissing")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        icon = QLabel()
        icon.setPixmap(QgsApplication.getThemeIcon("/mIconWarning.svg").pixmap(_ICON_PX, _ICON_PX))
        self.sentence = QLabel()
        self.sentence.setWordWrap(True)
        self.install = QPushButton(tr("Install…"))
        layout = QHBoxLayout(self)
        layout.addWidget(icon, 0, Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self.sentence, 1)
        layout.addWidget(self.install)
        self.refresh()

    def use_model(self, model: str) -> None:
        """Set the path of the model for photos; empty for label images."""
        if bool(model) != self._photos:
            self._photos = bool(model)
            self.refresh()

    def refresh(self) -> None:
        self.blocks = bool(missing(NEEDED))
        if self.blocks:
            lacking = missing(package for package in PACKAGES if package not in OPTIONAL)
            sentence = tr("SemRef needs Python packages that this QGIS does not have yet: {packages}.")
        else:
            lacking = missing([ONNXRUNTIME]) if self._photos else []
            sentence = tr("{packages} is missing. The model needs it to segment photos.")
        self.setVisible(bool(lacking))
        self.sentence.setText(sentence.format(packages=", ".join(package.title for package in lacking)))
