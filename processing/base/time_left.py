"""The remaining time of a run, for all algorithms and the dock."""

from __future__ import annotations

import time

from qgis.core import QgsProcessingFeedback, QgsProcessingMultiStepFeedback
from qgis.PyQt.QtCore import QDateTime, QLocale

from ..translation import tr

_AFTER_S, _AFTER_PERCENT = 3.0, 2.0
"""Seconds and percent before which no estimate is shown."""

_MINUTE_S, _HOUR_S = 60, 3600
_ROUND_S = 5

_WORTH_S = 20.0
"""Seconds below which the progress bar is enough."""

_SHOWN_AGAIN = 0.5
"""The estimate is shown again if it has halved, or grown by half since it was shown: dialogs write each text into their
log."""


class TimeLeftFeedback(QgsProcessingMultiStepFeedback):
    """Passes everything on, and adds the remaining time and the end time to the progress text.

    Feedback with a true attribute ``shows_time_left`` does this itself.
    """

    def __init__(self, feedback: QgsProcessingFeedback) -> None:
        super().__init__(1, feedback)
        self._feedback = feedback
        self._is_silent = bool(getattr(feedback, "shows_time_left", False))
        self._began = time.monotonic()
        self._what, self._percent = "", 0.0
        self._shown_s: float | None = None

    def isCanceled(self) -> bool:
        # The user may have canceled before this object existed.
        return self._feedback.isCanceled()

    def setProgressText(self, text: str) -> None:
        self._what = text
        left_s = None if self._shown_s is None else self._left_s()
        self._show(left_s)

    def setProgress(self, progress: float) -> None:
        super().setProgress(progress)
        self._percent = progress
        left_s = None if self._is_silent else self._left_s()
        if left_s is not None and left_s >= _WORTH_S and self._is_news(left_s):
            self._show(left_s)

    def _left_s(self) -> float | None:
        return _left_s(time.monotonic() - self._began, self._percent)

    def _is_news(self, left_s: float) -> bool:
        return self._shown_s is None or not _SHOWN_AGAIN < left_s / self._shown_s < 1 + _SHOWN_AGAIN

    def _show(self, left_s: float | None) -> None:
        """Show what is being done and, if known, the end time."""
        texts = [self._what] if self._what else []
        if left_s is not None:
            self._shown_s = left_s
            end = QDateTime.currentDateTime().addSecs(round(left_s)).time()
            clock = QLocale().toString(end, QLocale.FormatType.ShortFormat)
            texts.append(tr("{left}, until {time}").format(left=_words(left_s), time=clock))
        self._feedback.setProgressText(" – ".join(texts))


def remaining_text(elapsed_s: float, percent: float) -> str:
    """Return “about 2 min left”; empty while it is too early for an estimate, and at the end."""
    left = _left_s(elapsed_s, percent)
    return "" if left is None else _words(left)


def _words(left: float) -> str:
    """Return rounded seconds."""
    if left >= _HOUR_S:
        return tr("about {hours:.1f} h left").format(hours=left / _HOUR_S)
    if left >= _MINUTE_S:
        return tr("about {minutes:.0f} min left").format(minutes=left / _MINUTE_S)
    return tr("about {seconds:.0f} s left").format(seconds=max(_ROUND_S * round(left / _ROUND_S), _ROUND_S))


def _left_s(elapsed_s: float, percent: float) -> float | None:
    """Return seconds at the speed so far; None while it is too early for an estimate, and at the end."""
    if elapsed_s < _AFTER_S or not _AFTER_PERCENT <= percent < 100:
        return None
    return elapsed_s * (100 - percent) / percent
