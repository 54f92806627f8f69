"""Messages for the user: one sentence in the message bar, details of bugs in the log."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from html import escape

from qgis.core import Qgis, QgsMessageLog, QgsProject
from qgis.gui import QgsMessageBar, QgsMessageBarItem
from qgis.PyQt.QtCore import QTimer, QUrl
from qgis.PyQt.QtGui import QDesktopServices
from qgis.PyQt.QtWidgets import QPushButton

from ...processing.translation import tr
from ...processing.version import guide_url
from .controls import plain_tip

TAG = "SemRef"


class Messages:
    """SemRef's messages in a message bar of QGIS."""

    def __init__(self, message_bar: QgsMessageBar) -> None:
        self._bar = message_bar

    def info(self, sentence: str) -> None:
        self._bar.pushInfo(TAG, _escaped(sentence))

    def success(self, sentence: str) -> None:
        self._bar.pushSuccess(TAG, _escaped(sentence))

    def log(self, line: str) -> None:
        """Write a line to the log panel only."""
        QgsMessageLog.logMessage(line, TAG, Qgis.MessageLevel.Info, False)

    def warning(self, sentence: str) -> None:
        self._bar.pushWarning(TAG, _escaped(sentence))

    def error(self, sentence: str) -> None:
        self._bar.pushCritical(TAG, _escaped(sentence))

    def error_with(self, sentence: str, button: str, pressed: Callable[[], None]) -> QgsMessageBarItem:
        """Show an error with a button that solves it. The tool tip has the whole sentence."""
        item = self._message_with(sentence, button, pressed)
        self._bar.pushWidget(item, Qgis.MessageLevel.Critical)
        return item

    def success_with(self, sentence: str, button: str, pressed: Callable[[], None]) -> None:
        """Show a success with a button for the next step, until the project is closed."""
        item = self._message_with(sentence, button, pressed)
        # After QGIS's “Task complete”, which would cover it.
        QTimer.singleShot(0, partial(self._bar.pushWidget, item, Qgis.MessageLevel.Success))
        QgsProject.instance().cleared.connect(item.dismiss)

    def _message_with(self, sentence: str, button: str, pressed: Callable[[], None]) -> QgsMessageBarItem:
        item = self._bar.createMessage(TAG, _escaped(sentence))
        next_step = QPushButton(button)
        next_step.clicked.connect(pressed)
        next_step.clicked.connect(item.dismiss)
        item.setToolTip(plain_tip(sentence))
        item.layout().addWidget(next_step)
        return item


def bug_sentence(traceback: str) -> str:
    """Write the traceback of a bug to the log panel. Return a sentence that asks to report it."""
    QgsMessageLog.logMessage(traceback, TAG, Qgis.MessageLevel.Critical, False)
    return tr("An error in SemRef stopped the work. Please report the text under “SemRef” in the log messages panel.")


def open_file(path: str) -> None:
    """Open a file with the program of the operating system."""
    QDesktopServices.openUrl(QUrl.fromLocalFile(path))


def open_guide(*, page: str = "README.md") -> None:
    """Open a page of the user guide in the browser, by default its index."""
    QDesktopServices.openUrl(QUrl(guide_url(page)))


def _escaped(sentence: str) -> str:
    """Escape a sentence: the message bar shows HTML, and file names may look like HTML."""
    return escape(sentence, quote=False)
