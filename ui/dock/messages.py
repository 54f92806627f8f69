"""What the dock tells the user: one sentence in the message bar, the whole of a bug in the log."""

from __future__ import annotations

from qgis.core import Qgis, QgsMessageLog

from ...processing.translation import tr

TAG = "SemRef"


class Messages:
    def __init__(self, message_bar) -> None:
        self._bar = message_bar

    def info(self, sentence: str) -> None:
        self._bar.pushInfo(TAG, sentence)

    def success(self, sentence: str) -> None:
        self._bar.pushSuccess(TAG, sentence)

    def log(self, line: str) -> None:
        """Only for the log panel."""
        QgsMessageLog.logMessage(line, TAG, Qgis.MessageLevel.Info, False)

    def warning(self, sentence: str) -> None:
        self._bar.pushWarning(TAG, sentence)

    def error(self, sentence: str) -> None:
        self._bar.pushCritical(TAG, sentence)

    def bug(self, report: str) -> None:
        QgsMessageLog.logMessage(report, TAG, Qgis.MessageLevel.Critical, False)
        self.error(
            tr("An error in SemRef stopped the work; please report what the log messages panel shows under “SemRef”.")
        )
