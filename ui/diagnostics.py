"""Collect the last log messages about SemRef, and copy them with versions and devices for a bug report."""

from __future__ import annotations

from collections import deque

from qgis.core import Qgis, QgsApplication
from qgis.PyQt.QtCore import QObject, pyqtSlot

from ..processing.translation import tr
from ..processing.version import tracker_url
from .widgets.messages import TAG

_MOST_MESSAGES = 30
_LONGEST_MESSAGE = 4000
"""Characters. The end of a message is kept, because the end of a traceback names the error."""


class Diagnostics(QObject):
    """Records log messages about SemRef until ``shut_down``."""

    def __init__(self) -> None:
        super().__init__()
        self._lines: deque[str] = deque(maxlen=_MOST_MESSAGES)
        QgsApplication.messageLog().messageReceived.connect(self._keep)

    def shut_down(self) -> None:
        QgsApplication.messageLog().messageReceived.disconnect(self._keep)

    @pyqtSlot(str, str, Qgis.MessageLevel)
    def _keep(self, message: str, tag: str, level: Qgis.MessageLevel) -> None:
        if tag == TAG or TAG.lower() in message.lower():
            self._lines.append(f"{tag}: {message[-_LONGEST_MESSAGE:]}")

    def copy(self) -> str:
        """Copy the diagnostics to the clipboard. Return a sentence for the user."""
        # Imported here because few sessions need it.
        from ..processing.packages.diagnostics import diagnostics

        QgsApplication.clipboard().setText(diagnostics(tuple(self._lines)))
        copied = tr(
            "Diagnostics are on the clipboard: versions, packages, devices and the last messages. Check "
            "them, then paste them into a new issue."
        )
        return f"{copied} {tracker_url()}".strip()
