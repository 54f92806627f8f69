"""A job makes the evaluation that it tells of."""

from semref.core.evaluation import job
from semref.core.evaluation.evaluation import TrialRanges
from semref.core.geometry.frame import MapFrame


def test_the_evaluation_gets_all_that_the_job_tells(monkeypatch):
    monkeypatch.setattr(job, "Evaluation", lambda *given: given)
    frame, ranges = MapFrame.at((1.0, 2.0), 0.5), TrialRanges(missed=(1.0, 2.0))
    told = job.EvaluationJob("area.gpkg", "labels.tif", frame, ranges, 7, 20, 2.5)
    assert told.evaluation("database", "labels") == ("database", "labels", frame, ranges, 7, 20, 2.5)
