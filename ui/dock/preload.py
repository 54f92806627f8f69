"""Load the dock's modules one by one while QGIS is idle, so that the dock opens without delay."""

from __future__ import annotations

from importlib import import_module

from qgis.PyQt.QtCore import QObject, QTimer

_PAUSE_MS = 50
_ROOT = __package__.rpartition(".")[0]
_MODULES = (
    "findings",
    "canvas.highlight",
    "canvas.prior_tool",
    "canvas.match_marks",
    "packages.missing_notice",
    "fields.recent_files",
    "widgets.database_box",
    "tabs.correct.tab",
    "tabs.inspect.vector_plot",
    "tabs.inspect.tab",
    "tabs.localize.inputs",
    "tabs.localize.image_view",
    "tabs.localize.results_table",
    "tabs.localize.results",
    "tabs.localize.tab",
    "dock.content",
)
"""In this order each module takes a few milliseconds."""


class Preload(QObject):
    """Starts when Qt is idle; ``stop`` ends it."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._left: list[str] = list(_MODULES)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._load_next)
        self._timer.start(_PAUSE_MS)

    def stop(self) -> None:
        """Stop; remaining modules load when they are needed."""
        self._timer.stop()

    def _load_next(self) -> None:
        if self._left:
            import_module(f"{_ROOT}.{self._left.pop(0)}")
        else:
            self.stop()
