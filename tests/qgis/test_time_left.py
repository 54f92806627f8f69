"""Time left of a run in the progress text of a dialog."""

from __future__ import annotations

import pytest
from qgis.core import QgsProcessingContext, QgsProcessingFeedback
from qgis.PyQt.QtCore import QLocale


class Dialog(QgsProcessingFeedback):
    """Dialog that records its texts."""

    def __init__(self):
        super().__init__(False)
        self.texts = []
        self.percents = []
        self.progressChanged.connect(self.percents.append)

    def setProgressText(self, text):
        self.texts.append(text)


@pytest.fixture
def dialog(qgis_app):
    return Dialog()


@pytest.fixture
def clock(monkeypatch):
    """Clock of the estimates in seconds; it can be set."""
    from semref.processing.base import time_left

    now = [0.0]
    monkeypatch.setattr(time_left.time, "monotonic", lambda: now[0])
    return now


def run_for(feedback, clock, seconds, steps=1000):
    """Simulate a run of even speed."""
    for step in range(1, steps + 1):
        clock[0] = seconds * step / steps
        feedback.setProgress(100 * step / steps)


@pytest.fixture
def telling(dialog, clock):
    from semref.processing.base.time_left import TimeLeftFeedback

    return TimeLeftFeedback(dialog)


def test_a_long_run_shows_the_time_left_and_its_end(dialog, clock, telling, monkeypatch):
    from semref.processing.base import time_left

    class Noon:
        @staticmethod
        def currentDateTime():
            return time_left_clock

    from qgis.PyQt.QtCore import QDate, QDateTime, QTime

    time_left_clock = QDateTime(QDate(2026, 11, 22), QTime(12, 0))
    monkeypatch.setattr(time_left, "QDateTime", Noon)
    telling.setProgressText("Localizing")
    clock[0] = 60.0
    telling.setProgress(10)
    at = QLocale().toString(QTime(12, 9), QLocale.FormatType.ShortFormat)
    assert dialog.texts == ["Localizing", f"Localizing – about 9 min left, until {at}"]


def test_a_run_that_slows_down_corrects_its_estimate(dialog, clock, telling):
    clock[0] = 30.0
    telling.setProgress(50)
    clock[0] = 120.0
    telling.setProgress(60)
    assert [text.split(",")[0] for text in dialog.texts] == ["about 30 s left", "about 1 min left"]


def test_what_is_done_next_keeps_the_time_beside_it(dialog, clock, telling):
    clock[0] = 60.0
    telling.setProgress(20)
    telling.setProgressText("Epoch 2")
    assert dialog.texts[-1].startswith("Epoch 2 – about 4 min left, until ")


def test_the_time_left_is_shown_once_in_the_dock(dialog, clock):
    from semref.processing.base.time_left import TimeLeftFeedback

    dialog.shows_time_left = True
    telling = TimeLeftFeedback(dialog)
    telling.setProgressText("Localizing")
    run_for(telling, clock, 3600)
    telling.setProgressText("Writing")
    assert dialog.texts == ["Localizing", "Writing"]


def test_a_cancel_is_passed_on_whenever_it_came(dialog, telling):
    from semref.processing.base.time_left import TimeLeftFeedback

    assert not telling.isCanceled()
    dialog.cancel()
    assert telling.isCanceled() and TimeLeftFeedback(dialog).isCanceled()


def test_every_algorithm_works_with_feedback_of_the_time_left(dialog, clock):
    from semref.processing.base.algorithm import SemRefAlgorithm

    class Slow(SemRefAlgorithm):
        ID, GROUP = "slow", "annotation"

        def title(self):
            return "Slow"

        def summary(self):
            return "Slow."

        def parameters(self):
            return ()

        def work(self, values, outputs, feedback):
            clock[0] += 60.0
            feedback.setProgress(50)

    algorithm = Slow()
    algorithm.initAlgorithm()
    _, succeeded = algorithm.run({}, QgsProcessingContext(), dialog)
    assert succeeded and [text.split(",")[0] for text in dialog.texts] == ["about 1 min left"]
