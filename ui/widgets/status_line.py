"""What goes on, in one line."""

from __future__ import annotations

from qgis.PyQt.QtCore import QSize, Qt
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QLabel


class StatusLine(QLabel):
    """Shortens long file names in the middle instead of widening the dock."""

    _full_text = ""

    @property
    def text_shown(self) -> str:
        """As a whole."""
        return self._full_text

    def show_text(self, text: str) -> None:
        """Shows a sentence, shortened to what fits."""
        self._full_text = text
        self._shorten()

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        hint.setWidth(0)
        return hint

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._shorten()

    def _shorten(self) -> None:
        self.setText(self.fontMetrics().elidedText(self._full_text, Qt.TextElideMode.ElideMiddle, self.width()))
        self.setToolTip(self._full_text)
