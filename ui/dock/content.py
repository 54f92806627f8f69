"""Content of the dock: the database, and one tab each to localize, inspect and correct."""

from __future__ import annotations

from qgis.core import QgsProject, QgsSettings
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QSize, Qt
from qgis.PyQt.QtWidgets import QFrame, QScrollArea, QTabWidget, QVBoxLayout, QWidget

from ...core.errors import DatabaseError
from ...processing.layers.database_layers import add_database_to_map
from ...processing.messages.sentences import worded
from ...processing.translation import tr
from ..tabs.correct.tab import CorrectTab
from ..tabs.inspect.tab import InspectTab
from ..tabs.localize.tab import LocalizeTab
from ..widgets.controls import tool_button
from ..widgets.database_box import DatabaseBox
from ..widgets.layouts import narrow
from ..widgets.messages import Messages, open_guide

LOCALIZE, INSPECT, CORRECT = range(3)
"""Indexes of the tabs."""

_TAB_SETTING = "semref/dock/tab"

_LEAST_WIDTH_PX = 300
"""Least width at which the texts are readable."""


class DockContent(QWidget):
    """Connects the tabs with the database and with each other."""

    def __init__(self, canvas: QgsMapCanvas, messages: Messages) -> None:
        super().__init__()
        self._messages = messages
        self.database = DatabaseBox()
        self.localize = LocalizeTab(canvas, self.database, messages)
        self.inspect = InspectTab(canvas, self.database, messages)
        self.correct = CorrectTab(canvas, self.database, messages)
        self.tabs = QTabWidget()
        self._lay_out()
        self._connect()

    def _lay_out(self) -> None:
        self.tabs.setDocumentMode(True)
        # Long titles are shortened, so that all tabs stay visible.
        self.tabs.setUsesScrollButtons(False)
        self.tabs.setElideMode(Qt.TextElideMode.ElideRight)
        for page, title in (
            (self.localize, tr("Localize")),
            (self.inspect, tr("Inspect")),
            (self.correct, tr("Correct")),
        ):
            self.tabs.setTabToolTip(self.tabs.addTab(_scrolling(page), title), title)
        self.help = tool_button("/mActionHelpContents.svg", tr("User guide"))
        self.help.setAutoRaise(True)
        self.tabs.setCornerWidget(self.help)
        self.tabs.setCurrentIndex(QgsSettings().value(_TAB_SETTING, LOCALIZE, type=int))
        layout = narrow(QVBoxLayout(self))
        layout.addWidget(self.database)
        layout.addWidget(self.tabs, 1)

    def _connect(self) -> None:
        self.database.add_to_map.clicked.connect(self._add_database_to_map)
        self.tabs.currentChanged.connect(lambda tab: QgsSettings().setValue(_TAB_SETTING, tab))
        self.help.clicked.connect(open_guide)
        self.localize.hit.described.connect(self.inspect.compare_with)

    def minimumSizeHint(self) -> QSize:
        least = super().minimumSizeHint()
        return QSize(max(least.width(), _LEAST_WIDTH_PX), least.height())

    def _add_database_to_map(self) -> None:
        try:
            add_database_to_map(self.database.path(), QgsProject.instance())
        except DatabaseError as error:
            self._messages.error(worded(error))


class _Page(QScrollArea):
    """Scroll area that is never narrower than its page, whatever the font."""

    def minimumSizeHint(self) -> QSize:
        least = super().minimumSizeHint()
        width = self.widget().minimumSizeHint().width() + self.verticalScrollBar().sizeHint().width()
        return QSize(max(least.width(), width), least.height())


def _scrolling(page: QWidget) -> QScrollArea:
    """Return a scroll area for the page: the dock can be lower than a page, but not narrower."""
    area = _Page()
    area.setFrameShape(QFrame.Shape.NoFrame)
    # The Tab key goes to the widgets inside, not to the area.
    area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    area.setWidgetResizable(True)
    area.setWidget(page)
    return area
