"""A progress bar that says how long it still takes."""

from __future__ import annotations

import time

from qgis.PyQt.QtWidgets import QProgressBar

from ...processing.translation import tr

_AFTER_S, _AFTER_PERCENT = 3.0, 2.0
"""Before that an estimate would be a guess."""

_MINUTE_S, _HOUR_S = 60, 3600
_ROUND_S = 5


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


def remaining_text(elapsed_s: float, percent: float) -> str:
    """“about 2 min left”; empty while it is too early to tell, and at the end."""
    if elapsed_s < _AFTER_S or not _AFTER_PERCENT <= percent < 100:
        return ""
    left = elapsed_s * (100 - percent) / percent
    if left >= _HOUR_S:
        return tr("about {hours:.1f} h left").format(hours=left / _HOUR_S)
    if left >= _MINUTE_S:
        return tr("about {minutes:.0f} min left").format(minutes=left / _MINUTE_S)
    return tr("about {seconds:.0f} s left").format(seconds=max(_ROUND_S * round(left / _ROUND_S), _ROUND_S))
