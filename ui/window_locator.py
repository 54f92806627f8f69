"""Windows by name in QGIS's locator bar: “srw 5950_2100”."""

from __future__ import annotations

from typing import Callable

from qgis.core import QgsLocatorFilter, QgsLocatorResult
from qgis.PyQt.QtGui import QIcon

from ..core.errors import SemRefError
from ..processing.framework.base import ICON_PATH
from ..processing.translation import tr

PREFIX = "srw"
"""QGIS takes no notice of a plugin's prefix that is shorter than three characters."""
_MOST_RESULTS = 30


class WindowLocator(QgsLocatorFilter):
    """Searches the windows of the dock's database.

    read: function without arguments → the database, None without one (called in a background thread);
    show: function of a window's name (called in the main thread).
    """

    def __init__(self, read: Callable, show: Callable) -> None:
        super().__init__()
        self._read, self._show = read, show

    def clone(self):
        return WindowLocator(self._read, self._show)

    def name(self):
        return "semref_windows"

    def displayName(self):
        return tr("SemRef windows")

    def prefix(self):
        return PREFIX

    def fetchResults(self, string, context, feedback):
        wanted = string.strip()
        if not wanted:
            return
        try:
            database = self._read()
        except SemRefError:
            # The dock says what is wrong with its database; a search bar has nowhere to say it.
            return
        if database is None:
            return
        names = [str(name) for name in database.windows.names if wanted in name]
        # Names that begin as typed come first.
        for name in sorted(names, key=lambda name: (not name.startswith(wanted), name))[:_MOST_RESULTS]:
            result = QgsLocatorResult()
            result.filter = self
            result.displayString = name
            result.icon = QIcon(str(ICON_PATH))
            result.userData = name
            self.resultFetched.emit(result)

    def triggerResult(self, result):
        self._show(result.userData)
