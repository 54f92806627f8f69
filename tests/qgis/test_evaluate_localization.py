import json
import threading
from pathlib import Path

import numpy as np
import pytest
from made_inputs import METRIC_CRS, NAMES, NORTH, WEST, read_rows, scattered_objects, write_raster
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback

from semref.core.evaluation.evaluation import Evaluation

EVALUATE = "semref:evaluatelocalization"
SIZE, STRIDE = 160, 40
LABELS = scattered_objects(420, 480, 260, seed=21)
CLEAN = dict.fromkeys(("MISSED", "INVENTED", "MISNAMED", "RAGGED", "BACKGROUND", "DISPLACED", "SHIFTED"), "0,0")
CLEAN |= dict.fromkeys(("LEANING", "LENS", "TILT"), "0,0")
BOTH = [0, 1]


@pytest.fixture(scope="module")
def inputs(build_area):
    """Return the parameters LABELS and DATABASE of a made area."""
    database = build_area(LABELS, NAMES, SIZE, STRIDE)
    return {"LABELS": str(Path(database).with_name("labels.tif")), "DATABASE": database}


@pytest.fixture
def evaluate(run_algorithm, inputs, tmp_path, feedback):
    """`evaluate(**parameters)` returns (features of OUTPUT as dicts with their point, results)."""

    def run(**parameters):
        defaults = {"TRIALS": 12, "METHODS": BOTH, "OUTPUT": str(tmp_path / "trials.gpkg"), "REPORT": None}
        results = run_algorithm(EVALUATE, {**inputs, **defaults, **parameters}, feedback)
        found = [{**row, "point": row["geometry"].GetPoint_2D()} for row in read_rows(results["OUTPUT"])]
        return found, results

    return run


def of(found, method, kind="map"):
    return [row for row in found if (row["method"], row["kind"]) == (method, kind)]


@pytest.mark.slow
def test_every_trial_has_a_point_where_its_image_was_cut_and_rates_are_those_of_the_points(evaluate):
    found, results = evaluate(TRIALS=16)
    for method in ("automatic", "topology vector"):
        assert (len(of(found, method)), len(of(found, method, "mirrored"))) == (12, 4)
        assert sorted(row["trial"] for row in of(found, method)) == list(range(12))
    for row in found:
        assert row["point"] == (row["true_x"], row["true_y"])
        assert WEST < row["true_x"] < WEST + 480 and NORTH - 420 < row["true_y"] < NORTH
        if row["error"] is not None:
            assert row["error"] == pytest.approx(np.hypot(row["x"] - row["true_x"], row["y"] - row["true_y"]))
    tried, mirrored = of(found, "automatic"), of(found, "automatic", "mirrored")
    right = [row for row in tried if row["right"]]
    assert results["SUCCESS_RATE"] == len(right) / len(tried) > 0
    assert results["MEDIAN_ERROR"] == pytest.approx(np.median([row["error"] for row in right]))
    assert results["FALSE_ACCEPT_RATE"] == sum(row["status"] == "fix" for row in mirrored) / len(mirrored)


def test_ranges_come_back_in_the_points(evaluate):
    ranges = {"SCALE": [1.1, 1.2], "ROTATION": "30,40", "MISSED": "10,15", "OFFSET": "0.2,0.3"}
    found, _ = evaluate(**ranges, METHODS="1")
    for row in found:
        assert 1.1 <= row["scale"] <= 1.2 and 30 <= row["heading"] <= 40
        assert 10 <= row["missed"] <= 15 and 0.2 <= row["offset"] <= 0.3 and row["invented"] == 20


@pytest.fixture(scope="module")
def reported(run_algorithm, inputs, tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    outputs = {"OUTPUT": str(folder / "t.gpkg"), "REPORT": str(folder / "r.html"), "JSON": str(folder / "n.json")}
    results = run_algorithm(EVALUATE, {**inputs, **outputs, "TRIALS": 8, "METHODS": BOTH})
    report, numbers = (Path(results[key]).read_text(encoding="utf-8") for key in ("REPORT", "JSON"))
    return report, json.loads(numbers), results


@pytest.mark.slow
def test_the_report_has_the_papers_tables_and_needs_nothing_else(reported):
    report, _, _ = reported
    assert "The images cover" in report
    for title in ("Table 4", "Table 5", "False accepts", "Reliability", "Success against offset", "Spurious landmarks"):
        assert title in report
    assert report.count("<svg") == 3
    for name in ("http://", "https://", "<script", "src="):
        assert name not in report.replace('xmlns="http://www.w3.org/2000/svg"', "")
    table_4, table_5 = report.split("Table 4")[1].split("Table 5")
    assert [table_4.count("<tr>"), table_5.split("Settings</h2>")[0].count("<tr>")] == [1 + 30, 1 + 36]


@pytest.mark.slow
def test_the_numbers_agree_with_the_outputs_and_include_the_tables(reported):
    _, numbers, results = reported
    summary = numbers["methods"]["automatic"]
    assert list(numbers["methods"]) == ["automatic", "topology vector"]
    assert summary["right"]["share"] == results["SUCCESS_RATE"]
    assert summary["false_accepts"]["share"] == results["FALSE_ACCEPT_RATE"]
    assert (len(numbers["trials"]), len(numbers["scaling"]), len(numbers["rotation"])) == (16, 60, 72)
    assert [[cell["trials"] for cell in row] for row in numbers["noise"]["missed_by_invented"]] == [[2] * 4] * 4
    assert 0 < numbers["windows"]["tried"] <= numbers["windows"]["all"]
    assert numbers["settings"]["TRIALS"] == 8 and numbers["settings"]["SCALE"] == [0.8, 1.25]


def test_a_map_in_another_crs_is_refused_with_both(evaluate, tmp_path):
    path = write_raster(tmp_path / "other.tif", LABELS, names=NAMES, crs=METRIC_CRS + 1)
    with pytest.raises(QgsProcessingException, match="(?=.*EPSG:32633)(?=.*EPSG:32632).*Warp"):
        evaluate(LABELS=str(path))


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"SCALE": "1.2,0.8"}, "range of scale is 1.2 to 0.8"),
        ({"RAGGED": "a,b"}, "Boundary jitter"),
        ({"MINIMUM_REFERENCES": 999}, "at least 999 landmarks"),
    ],
)
def test_wrong_values_are_named(evaluate, wrong, said):
    with pytest.raises(QgsProcessingException, match=said):
        evaluate(**wrong)


def test_a_cancel_during_an_image_stops_before_the_image_is_done(inputs, tmp_path, monkeypatch):
    go_on, ended = threading.Event(), []
    monkeypatch.setattr(Evaluation, "run", lambda self, query, methods: ended.append(go_on.wait(600)))
    feedback = QgsProcessingFeedback(False)
    algorithm = QgsApplication.processingRegistry().createAlgorithmById(EVALUATE)
    parameters = {**inputs, "METHODS": [1], "OUTPUT": str(tmp_path / "trials.gpkg")}
    threading.Timer(0.5, feedback.cancel).start()
    with pytest.raises(QgsProcessingException, match="Canceled"):
        algorithm.run(parameters, QgsProcessingContext(), feedback, {}, False)
    assert ended == []
    go_on.set()
