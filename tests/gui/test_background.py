"""Reading in the background answers once, with what was asked last, whatever QGIS does with its tasks."""

import threading

import pytest
from dock_area import settle, wait_until
from qgis.PyQt.QtCore import QObject

from semref.core.errors import LabelMapError
from semref.ui.running.background import Reader


@pytest.fixture
def reader(qgis_app):
    """A Reader with what it said: (signal, what came with it)."""
    parent = QObject()
    made, said = Reader(parent), []
    for name in ("answered", "failed", "broke"):
        getattr(made, name).connect(lambda value, name=name: said.append((name, value)))
    made.said = said
    yield made
    made.shut_down()
    parent.deleteLater()


def ended(reader) -> list:
    wait_until(lambda: reader.said, "an answer")
    settle()
    return reader.said


def test_errors_for_the_user_and_bugs_have_different_signals(reader):
    def refuses():
        raise LabelMapError("Image {path} can't be read: {reason}.", path="photo.jpg", reason="no image")

    reader.read("Reading", refuses)
    ((name, sentence),) = ended(reader)
    assert name == "failed" and "photo.jpg" in sentence
    reader.said.clear()
    reader.read("Reading", lambda: 1 / 0)
    ((name, report),) = ended(reader)
    assert name == "broke" and "ZeroDivisionError" in report


def test_of_many_that_are_asked_while_one_runs_the_last_is_answered(reader):
    waits, read = threading.Event(), []

    def slowly(number):
        waits.wait(20)
        read.append(number)
        return number

    for number in range(5):
        reader.read("Reading", slowly, number)
    waits.set()
    assert ended(reader) == [("answered", 4)]
    assert read == [0, 4]


def test_a_function_whose_task_qgis_never_starts_is_started_again(reader, first_task_lost):
    reader.read("Reading", len, "four")
    assert ended(reader) == [("answered", 4)]
    assert len(first_task_lost) == 1


@pytest.mark.parametrize("is_discarded", [False, True])
def test_what_was_asked_since_is_read_instead_of_a_lost_or_discarded_one(reader, first_task_lost, is_discarded):
    read = []
    reader.read("Reading", read.append, 1)
    if is_discarded:
        reader.forget()
        wait_until(lambda: reader._task is None, "the loss to be seen")
    reader.read("Reading", read.append, 2)
    assert ended(reader) == [("answered", None)]
    assert read == [2] and len(first_task_lost) == 1
