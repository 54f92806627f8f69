"""Copy diagnostics: keeps the last messages that speak of SemRef, and puts what a report needs on the clipboard."""

from __future__ import annotations

from collections import deque

from qgis.core import Qgis, QgsApplication
from qgis.PyQt.QtCore import QObject, pyqtSlot

from ..processing.translation import tr
from ..processing.version import tracker_url
from .widgets.messages import TAG

_MOST_MESSAGES = 30
_LONGEST_MESSAGE = 4000
"""Characters of which the end is kept: of a traceback the end says what went wrong."""


class Diagnostics(QObject):
    """From now on the log is followed, until it is shut down."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._lines: deque[str] = deque(maxlen=_MOST_MESSAGES)
        QgsApplication.messageLog().messageReceived.connect(self._keep)

    def shut_down(self) -> None:
        """Follows the log no longer."""
        QgsApplication.messageLog().messageReceived.disconnect(self._keep)

    @pyqtSlot(str, str, Qgis.MessageLevel)
    def _keep(self, message: str, tag: str, level: Qgis.MessageLevel) -> None:
        if tag == TAG or TAG.lower() in message.lower():
            self._lines.append(f"{tag}: {message[-_LONGEST_MESSAGE:]}")

    def copy(self) -> str:
        """Puts it on the clipboard; a sentence for the user that says so."""
        # Not at the top: few sessions ask for them.
        from ..processing.packages.diagnostics import diagnostics

        QgsApplication.clipboard().setText(diagnostics(tuple(self._lines)))
        copied = tr(
            "Diagnostics are on the clipboard: versions, packages, devices and the last messages. Read them through, "
            "and paste them into a new issue."
        )
        return f"{copied} {tracker_url()}".strip()
