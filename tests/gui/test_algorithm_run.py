"""One algorithm in the background ends with exactly one signal, whatever becomes of it."""

import pytest
from dock_area import settle, wait_until
from qgis.core import QgsVectorLayer
from qgis.PyQt.QtCore import QObject

from semref.processing.algorithms.rasterize_annotation import RasterizeAnnotation
from semref.ui.running.algorithm_run import AlgorithmRun

ALGORITHM = "semref:rasterizeannotation"
SUCCEEDS = "native:centroids"


@pytest.fixture
def run(qgis_app):
    """An AlgorithmRun with what it said: (signal, what came with it)."""
    parent = QObject()
    made, ends = AlgorithmRun(parent), []
    for name in ("done", "failed", "broke", "canceled"):
        getattr(made, name).connect(lambda *values, name=name: ends.append((name, *values)))
    made.ends = ends
    yield made
    made.abandon()
    parent.deleteLater()


@pytest.fixture
def broken(monkeypatch):
    """Rasterize land-cover layer with a fault of its own before its work begins."""

    def read_layers(self, values):
        raise RuntimeError("a fault in preparing")

    monkeypatch.setattr(RasterizeAnnotation, "read_layers", read_layers)


def ended(run) -> list:
    wait_until(lambda: not run.running, "the end")
    settle()
    return run.ends


@pytest.mark.slow
def test_an_error_in_preparation_is_reported_and_ends_the_run(run, broken):
    assert run.start_algorithm(ALGORITHM, {}, "Rasterizing")
    ((name, report),) = ended(run)
    assert name == "broke" and "a fault in preparing" in report


def test_a_run_that_is_canceled_before_its_error_is_reported_is_canceled(run, broken):
    assert run.start_algorithm(ALGORITHM, {}, "Rasterizing")
    run.cancel()
    assert ended(run) == [("canceled",)]


def test_missing_parameters_are_reported(run):
    assert run.start_algorithm(ALGORITHM, {}, "Rasterizing")
    ((name, sentence),) = ended(run)
    assert name == "failed" and sentence


def test_a_run_whose_task_qgis_never_starts_is_started_again_and_ends_once(run, first_task_lost, monkeypatch):
    begun, parameters = [], {"INPUT": QgsVectorLayer("Point?crs=EPSG:32632", "p", "memory"), "OUTPUT": "memory:"}
    whole = run.start_algorithm
    monkeypatch.setattr(run, "start_algorithm", lambda *asked: begun.append(asked) or whole(*asked))
    asked = (SUCCEEDS, parameters, "Points along nothing")
    assert run.start_algorithm(*asked)
    assert [name for name, *_ in ended(run)] == ["done"]
    assert begun == [asked, asked] and len(first_task_lost) == 1
