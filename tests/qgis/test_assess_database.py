from pathlib import Path

import numpy as np
import pytest
from made_inputs import NAMES, landmarks_in_the_west, read_rows
from qgis.core import QgsVectorLayer

ASSESS = "semref:assessdatabase"
LABELS = landmarks_in_the_west()


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, 250, 125)


@pytest.fixture(scope="module")
def assessed(run_algorithm, database, tmp_path_factory):
    """Return results and rows of an assessment with two footprints."""
    folder = tmp_path_factory.mktemp("assessed")
    asked = {"DATABASE": database, "FOOTPRINT": "250; 160", "SPACING": 100, "TRIALS": 80}
    outputs = {"OUTPUT": str(folder / "map.gpkg"), "REPORT": str(folder / "report.html")}
    results = run_algorithm(ASSESS, {**asked, **outputs})
    return results, read_rows(results["OUTPUT"])


@pytest.mark.slow
def test_every_square_has_a_row_for_every_footprint_and_success_is_where_landmarks_are(assessed):
    results, rows = assessed
    assert [sum(row["footprint"] == size for row in rows) for size in (250, 160)] == [40, 40]
    assert all(0 <= row["success_low"] <= row["success"] <= row["success_high"] <= 1 for row in rows)
    large = [row for row in rows if row["footprint"] == 250]
    assert results["LOCALIZABLE_FRACTION"] == pytest.approx(np.mean([row["success"] >= 0.9 for row in large]))
    west, east = [row for row in large if row["objects"] > 20], [row for row in large if row["objects"] == 0]
    assert len(west) > 5 and len(east) >= 4
    assert sum(row["success"] for row in west) > 0.85 * len(west)
    assert all(row["success"] < 0.15 and row["verdict"] == "hardly_ever" for row in east)
    assert all(row["reason"].startswith("Too few landmarks") for row in east)
    assert all(not row["reason"] for row in large if row["success"] >= 0.9)


@pytest.mark.slow
def test_the_layer_brings_its_style_and_the_report_states_the_assumptions(assessed):
    layer = QgsVectorLayer(assessed[0]["OUTPUT"], "map", "ogr")
    labels = [one.label() for one in layer.renderer().ranges()]
    assert labels[0] == "very reliably (95–100 %)" and labels[-1] == "hardly ever (0–30 %)"
    # Squares of other footprints are not drawn over the first one's.
    assert '"footprint" = 250' in layer.renderer().classAttribute()
    text = Path(assessed[0]["REPORT"]).read_text(encoding="utf-8")
    assumed = ("<svg", "Footprint 160", "Assumptions: ", "camera tilt 2°", "In the 95 % ellipse")
    for part in (*assumed, "too few landmarks", "Brier score", "building"):
        assert part in text


@pytest.mark.slow
def test_a_footprint_beyond_what_is_searched_is_warned_of(run_algorithm, database, tmp_path, feedback):
    parameters = {"DATABASE": database, "TRIALS": 20, "SPACING": 250, "OUTPUT": str(tmp_path / "map.gpkg")}
    run_algorithm(ASSESS, {**parameters, "FOOTPRINT": "700"}, feedback)
    assert "not searched without a known pixel size" in feedback.textLog()
