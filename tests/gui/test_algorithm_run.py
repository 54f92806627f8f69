import threading
import time
from unittest.mock import Mock

import pytest
from dock_area import logged, settle, wait_until
from qgis.core import QgsCoordinateReferenceSystem, QgsVectorLayer
from qgis.PyQt.QtCore import QObject

from semref.core.errors import LabelMapError
from semref.processing.algorithms.rasterize_annotation import RasterizeAnnotation
from semref.ui.running.algorithm_run import AlgorithmRun
from semref.ui.running.background import Reader, task_threads

ALGORITHM = "semref:rasterizeannotation"
SUCCEEDS = "native:centroids"


@pytest.fixture
def run(qgis_app):
    """An AlgorithmRun with what it said: (signal, what came with it)."""
    parent = QObject()
    made, ends = AlgorithmRun(parent), []
    for name in ("done", "failed", "canceled"):
        getattr(made, name).connect(lambda *values, name=name: ends.append((name, *values)))
    made.ends = ends
    yield made
    made.shut_down()
    parent.deleteLater()


@pytest.fixture
def broken(monkeypatch):
    """Rasterize land-cover layer with a fault of its own before its work begins."""
    monkeypatch.setattr(RasterizeAnnotation, "read_layers", Mock(side_effect=RuntimeError("a fault in preparing")))


def ended(run) -> list:
    wait_until(lambda: not run.running, "the end")
    settle()
    return run.ends


@pytest.mark.slow
def test_an_error_in_preparation_is_reported_and_ends_the_run(run, broken):
    given = {"INPUT": QgsVectorLayer("Polygon?field=a:int", "p", "memory"), "CLASS_FIELD": "a", "OUTPUT": "a.tif"}
    with logged() as reports:
        assert run.start_algorithm(ALGORITHM, given, "Rasterizing")
        ((name, sentence),) = ended(run)
    assert name == "failed" and "error in SemRef" in sentence
    assert len(reports) == 1 and "a fault in preparing" in reports[0]


def test_a_run_that_is_canceled_before_its_error_is_reported_is_canceled(run, broken):
    assert run.start_algorithm(ALGORITHM, {}, "Rasterizing")
    run.cancel()
    assert ended(run) == [("canceled",)]


def test_missing_parameters_are_reported(run):
    assert run.start_algorithm(ALGORITHM, {}, "Rasterizing")
    assert [(name, bool(sentence)) for name, sentence in ended(run)] == [("failed", True)]


def test_a_run_whose_task_qgis_never_starts_is_started_again_and_ends_once(run, first_task_lost, monkeypatch):
    begun, parameters = [], {"INPUT": QgsVectorLayer("Point?crs=EPSG:32632", "p", "memory"), "OUTPUT": "memory:"}
    whole = run.start_algorithm
    monkeypatch.setattr(run, "start_algorithm", lambda *asked: begun.append(asked) or whole(*asked))
    asked = (SUCCEEDS, parameters, "Points along nothing")
    assert run.start_algorithm(*asked)
    assert [name for name, *_ in ended(run)] == ["done"]
    assert begun == [asked, asked] and len(first_task_lost) == 1


@pytest.fixture
def reader(qgis_app):
    """A Reader with what it said: (signal, what came with it)."""
    parent = QObject()
    made, said = Reader(parent), []
    for name in ("answered", "failed"):
        getattr(made, name).connect(lambda value, name=name: said.append((name, value)))
    made.said = said
    yield made
    made.shut_down()
    parent.deleteLater()


def answer_of(reader) -> list:
    wait_until(lambda: reader.said, "an answer")
    settle()
    return reader.said


def test_a_crs_stays_whole_after_the_task_that_used_it_first(iface, reader, request):
    # QGIS's threads end after 30 s without a task.
    task_threads().setExpiryTimeout(20)
    request.getfixturevalue("loaded")
    reader.read("Reading", lambda: QgsCoordinateReferenceSystem("EPSG:31370"))
    ((_, crs),) = answer_of(reader)
    time.sleep(0.2)
    assert crs.isValid() and crs.toWkt()


def test_errors_are_for_the_user_and_bugs_are_logged(reader):
    error = LabelMapError("Image {path} can't be read: {reason}.", path="photo.jpg", reason="no image")
    reader.read("Reading", Mock(side_effect=error))
    ((name, sentence),) = answer_of(reader)
    assert name == "failed" and "photo.jpg" in sentence
    reader.said.clear()
    with logged() as reports:
        reader.read("Reading", lambda: 1 / 0)
        ((name, sentence),) = answer_of(reader)
    assert name == "failed" and "error in SemRef" in sentence
    assert len(reports) == 1 and "ZeroDivisionError" in reports[0]


def test_of_many_that_are_asked_while_one_runs_the_last_is_answered(reader):
    waits, read = threading.Event(), []

    def slowly(number):
        waits.wait(20)
        read.append(number)
        return number

    for number in range(5):
        reader.read("Reading", slowly, number)
    waits.set()
    assert answer_of(reader) == [("answered", 4)]
    assert read == [0, 4]


def test_a_function_whose_task_qgis_never_starts_is_started_again(reader, first_task_lost):
    reader.read("Reading", len, "four")
    assert answer_of(reader) == [("answered", 4)]
    assert len(first_task_lost) == 1


@pytest.mark.parametrize("is_discarded", [False, True])
def test_what_was_asked_since_is_read_instead_of_a_lost_or_discarded_one(reader, first_task_lost, is_discarded):
    read = []
    reader.read("Reading", read.append, 1)
    if is_discarded:
        reader.forget()
        wait_until(lambda: reader._task is None, "the loss to be seen")
    reader.read("Reading", read.append, 2)
    assert answer_of(reader) == [("answered", None)]
    assert read == [2] and len(first_task_lost) == 1
