"""Lower part of the tab *Localize*: list of results, selected image, and its details."""

from __future__ import annotations

from qgis.core import QgsSettings
from qgis.PyQt.QtCore import QByteArray, Qt
from qgis.PyQt.QtWidgets import QMenu, QPushButton, QSplitter, QToolButton, QVBoxLayout

from ....processing.translation import tr
from ...findings import Finding
from ...widgets.controls import remember, shortcut, tool_button
from ...widgets.layouts import FoldingBox, narrow, row_of
from .details import Details
from .image_view import ImageView
from .results_list import ResultsList

_ZOOM_SETTING = "semref/dock/zoom_to_hit"
_PARTS_SETTING = "semref/dock/results_parts_3"
_SHARES = 2, 3, 0
"""Shares of list, image and details in the remaining height."""


class ResultsBox(FoldingBox):
    """Results with buttons."""

    def __init__(self) -> None:
        super().__init__(tr("Results"), "SemRefResults")
        self.list = ResultsList()
        self.image = ImageView()
        self.details = Details()
        # Icon only: in French its text is as wide as the rest of the row.
        self.zoom = tool_button("/mActionZoomToSelected.svg", tr("Zoom to the position"), checkable=True)
        remember(self.zoom, _ZOOM_SETTING, True)
        self._make_buttons()
        self._lay_out()
        self.list.findingSelected.connect(self._select)
        self.before.clicked.connect(lambda: self.list.step(-1))
        self.after.clicked.connect(lambda: self.list.step(1))
        self._select(None)

    def _make_buttons(self) -> None:
        self.before = tool_button("/mActionArrowLeft.svg", tr("Previous image (Alt+Up)"))
        self.after = tool_button("/mActionArrowRight.svg", tr("Next image (Alt+Down)"))
        for keys, button in (("Alt+Up", self.before), ("Alt+Down", self.after)):
            shortcut(keys, self).activated.connect(button.click)
        self.drape = tool_button("/mActionAddLayer.svg", tr("Add image to map"))
        self.copy = QPushButton(tr("Copy position"))
        self.copy.setToolTip(tr("Copy longitude and latitude (WGS 84)"))
        self.save = QPushButton(tr("Save results…"))
        self.save.setToolTip(
            tr(
                "Save positions, footprints and possible places in a GeoPackage. The dock shows them again with "
                "the project."
            )
        )
        self.save.setEnabled(False)
        self.history = tool_button("/propertyicons/temporal.svg", tr("Earlier results"))
        self.earlier = QMenu(self.history)
        self.history.setMenu(self.earlier)
        self.history.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)

    def _lay_out(self) -> None:
        self.parts = QSplitter(Qt.Orientation.Vertical)
        self.parts.setChildrenCollapsible(False)
        for part in (self.list, self.image, self.details):
            self.parts.addWidget(part)
        for number, share in enumerate(_SHARES):
            self.parts.setStretchFactor(number, share)
        self.parts.restoreState(QgsSettings().value(_PARTS_SETTING, QByteArray(), type=QByteArray))
        self.parts.splitterMoved.connect(lambda *_: QgsSettings().setValue(_PARTS_SETTING, self.parts.saveState()))
        layout = narrow(QVBoxLayout(self.content), 0)
        layout.addWidget(self.parts, 1)
        layout.addLayout(row_of(self.before, self.after, self.zoom, self.drape, (self.copy, 1)))
        layout.addLayout(row_of((self.save, 1), self.history))

    def show_findings(self, findings: list[Finding]) -> None:
        """Replace the results, and select the first one."""
        self.list.show_findings(findings)
        self.save.setEnabled(bool(findings))

    def _select(self, finding: Finding | None) -> None:
        self.details.show_finding(finding)
        has_position = finding is not None and finding.center is not None
        self.copy.setEnabled(has_position)
        self.drape.setEnabled(has_position and finding.heading is not None)
        for button in (self.before, self.after):
            button.setEnabled(finding is not None)
