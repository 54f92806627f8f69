"""Loads the dock's modules one at a time while nobody waits, so that the dock opens at once."""

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
"""The small ones first: each then takes a few milliseconds."""


class Preload(QObject):
    """Begins when Qt has nothing else to do; ``stop`` ends it."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._left: list[str] = list(_MODULES)
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._load_next)
        self._timer.start(_PAUSE_MS)

    def stop(self) -> None:
        """What is not loaded yet is loaded when it is needed."""
        self._timer.stop()

    def _load_next(self) -> None:
        if self._left:
            import_module(f"{_ROOT}.{self._left.pop(0)}")
        else:
            self.stop()
