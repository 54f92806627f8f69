"""A progress bar that says how long it still takes."""

from __future__ import annotations

import time

from qgis.PyQt.QtWidgets import QProgressBar

from ...processing.framework.time_left import remaining_text


class RemainingBar(QProgressBar):
    """``begin`` when a run starts, ``show_percent`` as it goes on."""

    def __init__(self) -> None:
        super().__init__()
        self._began = 0.0

    def begin(self) -> None:
        """A run starts now."""
        self._began = time.monotonic()
        self.setValue(0)
        self.setFormat("%p%")

    def show_percent(self, percent: float) -> None:
        """How far it is, and how long it still takes if it goes on as fast."""
        self.setValue(round(percent))
        left = remaining_text(time.monotonic() - self._began, percent)
        self.setFormat(f"%p% · {left}" if left else "%p%")
