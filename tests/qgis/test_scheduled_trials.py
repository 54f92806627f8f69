"""SCHEDULER of Assess reference database and Evaluate localization: workers give QGIS's results."""

import importlib.util
import json
from pathlib import Path

import pytest
from made_inputs import scattered_objects, write_raster
from osgeo import ogr
from qgis.core import QgsProcessingException

from semref.processing.base.scheduler import Workers

ASSESS, EVALUATE = "semref:assessdatabase", "semref:evaluatelocalization"
SIZE = 160
NAMES = ["unlabeled", "building", "water", "bare_land"]
LABELS = scattered_objects(420, 480, 300, seed=21, background=0)
pytestmark = [
    pytest.mark.skipif(importlib.util.find_spec("distributed") is None, reason="Dask is not here"),
    pytest.mark.slow,  # tests/qgis/test_scheduler.py has a quick test.
]


@pytest.fixture(scope="module")
def database(build_area):
    return build_area(LABELS, NAMES, SIZE, 40)


@pytest.fixture(scope="module")
def label_map(tmp_path_factory):
    return str(write_raster(tmp_path_factory.mktemp("map") / "labels.tif", LABELS, names=NAMES))


def rows(path):
    source = ogr.Open(path)
    return [(feature.items(), feature.GetGeometryRef().ExportToIsoWkt()) for feature in source.GetLayer(0)]


def require_same(found, expected):
    """Compare with a tolerance: sums depend on the threads of OpenBLAS, and workers use one."""
    assert len(found) == len(expected) > 0
    for (values, shape), (others, other) in zip(found, expected):
        assert shape == other and values.keys() == others.keys()
        for name, value in values.items():
            if isinstance(value, float):
                assert value == pytest.approx(others[name], rel=1e-5, abs=1e-7), name
            else:
                assert value == others[name], name


def test_workers_assess_what_qgis_assesses(run_algorithm, database, tmp_path, feedback):
    asked = {"DATABASE": database, "TRIALS": 60, "FOOTPRINT": "160;120", "SPACING": 80}
    expected = run_algorithm(ASSESS, {**asked, "OUTPUT": str(tmp_path / "qgis.gpkg")})
    scheduled = {**asked, "SCHEDULER": "local:1", "OUTPUT": str(tmp_path / "dask.gpkg")}
    scheduled["REPORT"] = str(tmp_path / "report.html")
    found = run_algorithm(ASSESS, scheduled, feedback)
    assert found["LOCALIZABLE_FRACTION"] == pytest.approx(expected["LOCALIZABLE_FRACTION"])
    require_same(rows(found["OUTPUT"]), rows(expected["OUTPUT"]))
    assert (tmp_path / "report.html").stat().st_size > 10_000 and feedback.progress() == 100


def test_workers_evaluate_what_qgis_evaluates(run_algorithm, database, label_map, tmp_path, feedback):
    asked = {"DATABASE": database, "LABELS": label_map, "TRIALS": 12, "METHODS": [0, 1]}
    expected = run_algorithm(EVALUATE, {**asked, "OUTPUT": str(tmp_path / "qgis.gpkg"), "REPORT": None})
    scheduled = {**asked, "SCHEDULER": "local:1", "OUTPUT": str(tmp_path / "dask.gpkg")}
    scheduled["JSON"] = str(tmp_path / "numbers.json")
    found = run_algorithm(EVALUATE, scheduled, feedback)
    for key in ("SUCCESS_RATE", "MEDIAN_ERROR", "FALSE_ACCEPT_RATE"):
        assert found[key] == pytest.approx(expected[key], rel=1e-5)
    assert found["SUCCESS_RATE"] > 0.3
    require_same(rows(found["OUTPUT"]), rows(expected["OUTPUT"]))
    numbers = json.loads((tmp_path / "numbers.json").read_text(encoding="utf-8"))
    assert len(numbers["trials"]) == 24 and numbers["scaling"]


def test_a_database_that_changes_before_workers_begin_is_noticed(
    run_algorithm, build_area, database, tmp_path, monkeypatch
):
    area, wait = tmp_path / "area.gpkg", Workers.wait
    area.write_bytes(Path(database).read_bytes())
    other = Path(build_area(scattered_objects(420, 480, 280, seed=5, background=0), NAMES, SIZE, 40)).read_bytes()

    def late(run):
        area.write_bytes(other)
        wait(run)

    monkeypatch.setattr(Workers, "wait", late)
    asked = {"DATABASE": str(area), "TRIALS": 20, "SCHEDULER": "local:1", "OUTPUT": str(tmp_path / "never.gpkg")}
    with pytest.raises(QgsProcessingException, match="area.gpkg was changed while it was read"):
        run_algorithm(ASSESS, asked)
    assert [path.name for path in tmp_path.iterdir()] == ["area.gpkg"]
