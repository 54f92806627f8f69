"""SCHEDULER: workers give the same results as QGIS; without Dask a message names the package."""

import importlib.util

import numpy as np
import pytest
from built_database import BUILD, content
from made_inputs import scattered_objects, write_raster
from made_models import painted, write_model
from qgis.core import QgsProcessingException, QgsVectorLayer

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
def test_workers_build_the_database_that_qgis_builds(run_algorithm, label_map, feedback, tmp_path):
    asked = {"LABELS": str(label_map), **SETTINGS}
    expected = run_algorithm(BUILD, {**asked, "DATABASE": str(tmp_path / "qgis.gpkg")})
    found = run_algorithm(BUILD, {**asked, "SCHEDULER": "local:1", "DATABASE": str(tmp_path / "dask.gpkg")}, feedback)
    assert found["WINDOW_COUNT"] == expected["WINDOW_COUNT"] > 10
    assert found["REFERENCE_COUNT"] == expected["REFERENCE_COUNT"] > 100
    assert content(found["DATABASE"])["windows"] == content(expected["DATABASE"])["windows"]
    assert content(found["DATABASE"])["references"] == content(expected["DATABASE"])["references"]
    assert feedback.progress() == 100
    (line,) = QgsVectorLayer(f"{found['DATABASE']}|layername=windows", "windows", "ogr").metadata().history()
    assert "processing.run" in line


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
def test_workers_segment_what_qgis_segments(run_algorithm, tmp_path):
    model = write_model(tmp_path / "colors.onnx")
    labels = scattered_objects(170, 230, 60, seed=3, background=0)
    photo = write_raster(tmp_path / "photo.tif", np.moveaxis(painted(labels), 2, 0))
    asked = {"INPUT": str(photo), "MODEL": str(model)}
    expected = run_algorithm(SEGMENT, {**asked, "OUTPUT": str(tmp_path / "qgis.tif")})
    found = run_algorithm(SEGMENT, {**asked, "SCHEDULER": "local:1", "OUTPUT": str(tmp_path / "dask.tif")})
    assert (tmp_path / "dask.tif").read_bytes() == (tmp_path / "qgis.tif").read_bytes()
    assert found["CERTAINTY"] == pytest.approx(expected["CERTAINTY"])
    with pytest.raises(QgsProcessingException, match="cannot be used together with “Confidence”"):
        confidence = str(tmp_path / "confidence.tif")
        run_algorithm(SEGMENT, {**asked, "SCHEDULER": "local:1", "OUTPUT": "a.tif", "CONFIDENCE": confidence})
