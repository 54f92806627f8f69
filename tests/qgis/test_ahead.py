"""Results of items that threads process ahead."""

import threading
import time

import pytest
from qgis.core import QgsProcessingFeedback

from semref.processing.base import algorithm
from semref.processing.base.algorithm import AT_ONCE, Canceled, ahead


@pytest.fixture(autouse=True)
def threads(monkeypatch):
    monkeypatch.setattr(algorithm, "worker_threads", lambda: AT_ONCE)


def test_results_are_in_order_though_the_first_takes_longest():
    def work(number):
        time.sleep(0.1 if number == 0 else 0)
        return number

    assert list(ahead(work, range(20), QgsProcessingFeedback())) == list(range(20))


def test_the_next_items_are_processed_meanwhile_and_no_more():
    begun, go_on = [], threading.Event()

    def work(number):
        begun.append(number)
        assert number == 0 or go_on.wait(10)
        return number

    results = ahead(work, range(20), QgsProcessingFeedback())
    assert next(results) == 0
    end = time.monotonic() + 10
    while len(begun) <= AT_ONCE and time.monotonic() < end:
        time.sleep(0.01)
    assert sorted(begun) == list(range(AT_ONCE + 1))
    go_on.set()
    assert list(results) == list(range(1, 20))


def test_an_error_of_an_item_is_raised_in_its_turn():
    def work(number):
        return 1 // (2 - number)

    results = ahead(work, range(20), QgsProcessingFeedback())
    assert [next(results), next(results)] == [0, 1]
    with pytest.raises(ZeroDivisionError):
        next(results)


def test_a_cancel_does_not_wait_for_the_items():
    feedback, go_on, begun = QgsProcessingFeedback(), threading.Event(), []

    def work(number):
        begun.append(number)
        go_on.wait(10)

    threading.Timer(0.2, feedback.cancel).start()
    at = time.monotonic()
    with pytest.raises(Canceled):
        list(ahead(work, range(20), feedback))
    assert time.monotonic() - at < 5
    go_on.set()
    assert len(begun) <= AT_ONCE
