"""SCHEDULER: errors and cancels; cluster/test_same_files.py has the results of workers."""

import importlib.util

import pytest
from built_database import BUILD
from made_inputs import scattered_objects, write_raster
from qgis.core import QgsProcessingException

from semref.processing.packages import components

SEGMENT = "semref:segmentimage"
SETTINGS = {"REFERENCE_CLASSES": "building;water", "WINDOW_SIZE": 320, "STRIDE": 140, "MINIMUM_AREA": 40}
needs_dask = pytest.mark.skipif(importlib.util.find_spec("distributed") is None, reason="Dask is not here")


@pytest.fixture(scope="module")
def label_map(tmp_path_factory):
    labels = scattered_objects(900, 800, 900, seed=8)
    path = tmp_path_factory.mktemp("map") / "labels.tif"
    return write_raster(path, labels, names=["", "building", "water", "bare_land"])


@pytest.mark.slow
@needs_dask
def test_errors_of_the_process_are_errors_of_the_algorithm(run_algorithm, label_map, tmp_path):
    asked = {"LABELS": str(label_map), **SETTINGS, "DATABASE": str(tmp_path / "none.gpkg")}
    with pytest.raises(QgsProcessingException, match="no scheduler at tcp://127.0.0.1:1 "):
        run_algorithm(BUILD, {**asked, "SCHEDULER": "tcp://127.0.0.1:1"})
    with pytest.raises(QgsProcessingException, match="forest"):
        run_algorithm(BUILD, {**asked, "REFERENCE_CLASSES": "forest", "SCHEDULER": "local:1"})
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("text", ["4", "local:", "local:0", "local:4x", "http://a:1", "tcp://", "tcp://host", "-h"])
def test_what_is_no_scheduler_is_refused_before_any_work(run_algorithm, label_map, tmp_path, text):
    asked = {"LABELS": str(label_map), **SETTINGS, "SCHEDULER": text, "DATABASE": str(tmp_path / "a.gpkg")}
    with pytest.raises(
        QgsProcessingException, match="“Scheduler” is “.*”, which is not a scheduler. Enter local: and a number"
    ):
        run_algorithm(BUILD, asked)


@pytest.mark.parametrize("package", [components.DASK, components.CRYPTOGRAPHY], ids=["dask", "cryptography"])
def test_a_qgis_without_dask_names_the_package_to_install(run_algorithm, label_map, tmp_path, monkeypatch, package):
    monkeypatch.setattr(components, "is_missing", lambda asked: asked is package)
    asked = {"LABELS": str(label_map), **SETTINGS, "DATABASE": str(tmp_path / "a.gpkg")}
    with pytest.raises(QgsProcessingException, match=package.pip_name):
        run_algorithm(BUILD, {**asked, "SCHEDULER": "local:2"})
    assert run_algorithm(BUILD, asked)["WINDOW_COUNT"] > 10


@pytest.mark.slow
@needs_dask
def test_a_cancel_stops_at_once_and_leaves_neither_files_nor_workers(run_algorithm, label_map, feedback, tmp_path):
    psutil = pytest.importorskip("psutil")
    before = psutil.Process().children(recursive=True)
    others: list[psutil.Process] = []

    def cancel(share):
        if share > 0 and not others:
            others.extend(one for one in psutil.Process().children(recursive=True) if one not in before)
            feedback.cancel()

    feedback.progressChanged.connect(cancel)
    asked = {"LABELS": str(label_map), **SETTINGS, "SCHEDULER": "local:1", "DATABASE": str(tmp_path / "a.gpkg")}
    with pytest.raises(QgsProcessingException, match="Canceled"):
        run_algorithm(BUILD, asked, feedback)
    assert list(tmp_path.iterdir()) == []
    # At least the command and its worker; all of them end soon after the algorithm.
    assert len(others) >= 2
    _, alive = psutil.wait_procs(others, timeout=60)
    assert alive == []


@pytest.mark.slow
@needs_dask
def test_confidence_is_refused_together_with_workers(run_algorithm, good, tmp_path):
    asked = {"INPUT": str(good / "color.png"), "MODEL": str(good / "colors.onnx"), "SCHEDULER": "local:1"}
    with pytest.raises(QgsProcessingException, match="cannot be used together with “Confidence”"):
        run_algorithm(SEGMENT, {**asked, "OUTPUT": "a.tif", "CONFIDENCE": str(tmp_path / "confidence.tif")})
