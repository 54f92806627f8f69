"""Progress of a run: one line of text, and a bar with the remaining time."""

from __future__ import annotations

import time

from qgis.PyQt.QtCore import QSize, Qt
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QLabel, QProgressBar

from ...processing.translation import tr
from .controls import plain_tip

_AFTER_S, _AFTER_PERCENT = 3.0, 2.0
"""Seconds and percent before which no estimate is shown."""

_MINUTE_S, _HOUR_S = 60, 3600
_ROUND_S = 5


class StatusLine(QLabel):
    """Label that shortens long texts in the middle instead of widening the dock."""

    _text = ""
    _aside = ""

    def __init__(self) -> None:
        super().__init__()
        # File names may look like HTML.
        self.setTextFormat(Qt.TextFormat.PlainText)

    @property
    def text_shown(self) -> str:
        """Whole text, without shortening."""
        return f"{self._text} {self._aside}".rstrip()

    def show_text(self, text: str, aside: str = "") -> None:
        """Show a sentence, and a second one if there is room for both."""
        self._text, self._aside = text, aside
        self._shorten()

    def minimumSizeHint(self) -> QSize:
        hint = super().minimumSizeHint()
        hint.setWidth(0)
        return hint

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._shorten()

    def _shorten(self) -> None:
        metrics, width = self.fontMetrics(), self.width()
        fits = metrics.horizontalAdvance(self.text_shown) <= width
        text = self.text_shown if fits else self._text
        self.setText(metrics.elidedText(text, Qt.TextElideMode.ElideMiddle, width))
        self.setToolTip(plain_tip(self.text_shown))


class RemainingBar(QProgressBar):
    """Progress bar with the remaining time. Call ``begin``, then ``show_percent``."""

    def __init__(self) -> None:
        super().__init__()
        self._began = 0.0

    def begin(self) -> None:
        self._began = time.monotonic()
        self.setValue(0)
        self.setFormat("%p%")

    def show_percent(self, percent: float) -> None:
        """Show the progress and the remaining time at the average speed so far."""
        self.setValue(round(percent))
        left = remaining_text(time.monotonic() - self._began, percent)
        self.setFormat(f"%p% · {left}" if left else "%p%")


def remaining_text(elapsed_s: float, percent: float) -> str:
    """Return “about 2 min left” at the speed so far; empty while it is too early for an estimate, and at the end."""
    if elapsed_s < _AFTER_S or not _AFTER_PERCENT <= percent < 100:
        return ""
    left = elapsed_s * (100 - percent) / percent
    if left >= _HOUR_S:
        return tr("about {hours:.1f} h left").format(hours=left / _HOUR_S)
    if left >= _MINUTE_S:
        return tr("about {minutes:.0f} min left").format(minutes=left / _MINUTE_S)
    return tr("about {seconds:.0f} s left").format(seconds=max(_ROUND_S * round(left / _ROUND_S), _ROUND_S))
