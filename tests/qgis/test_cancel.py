import os
import shutil
import time
from pathlib import Path

import numpy as np
import pytest
from made_inputs import (
    CLASSES_CSV,
    NAMES,
    scattered_objects,
    square,
    write_layer,
    write_older,
    write_raster,
    write_text,
)
from made_models import write_model
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingException, QgsProcessingFeedback

from semref.processing.algorithms import decode_color_labels
from semref.storage import atomic_output, label_comparison, rasterize

LOCALIZE = "semref:localizeimages"
PROMPT_S = 1.0
"""Processor time, which does not depend on other programs."""


class CancelAt(QgsProcessingFeedback):
    """Feedback that cancels at ``percent`` (None: never) and remembers the progress and the time of the cancel."""

    def __init__(self, percent):
        super().__init__(False)
        self.percent = percent
        self.shown = []
        self.canceled_at = None
        self.progressChanged.connect(self._look)
        if percent == 0:
            self._stop()

    def _look(self, progress):
        self.shown.append(progress)
        if self.percent is not None and progress >= self.percent and self.canceled_at is None:
            self._stop()

    def _stop(self):
        self.canceled_at = time.process_time()
        self.cancel()


@pytest.fixture(scope="module")
def jobs(run_algorithm, tmp_path_factory):
    """Return (algorithm id, parameters, key of its output, name of its output) of jobs with many steps."""
    folder = tmp_path_factory.mktemp("inputs")
    random = np.random.default_rng(4)
    features = [(square(*random.uniform(0, 900, 2), 12), f"class {n % 7}") for n in range(3000)]
    write_layer(folder / "overlapping.shp", features[:1200])
    labels = write_raster(folder / "labels.tif", scattered_objects(700, 700, 500, seed=6), names=NAMES)
    color = write_raster(folder / "color.tif", random.integers(0, 255, (3, 700, 700)).astype(np.uint8))
    windows = {"REFERENCE_CLASSES": "1;2;3", "WINDOW_SIZE": 120, "STRIDE": 20, "MINIMUM_AREA": 30}
    build, area = {"LABELS": str(labels), **windows}, str(folder / "area.gpkg")
    run_algorithm("semref:builddatabase", {**build, "DATABASE": area})
    flight = folder / "flight"
    flight.mkdir()
    for n in range(20):
        write_raster(flight / f"{n}.png", scattered_objects(120, 120, 10, seed=n), transform=None)
    six = [str(flight / f"{n}.png") for n in range(6)]
    coarse = np.kron(random.integers(1, 4, (70, 70)), np.ones((10, 10))).astype(np.uint8)
    predicted = str(write_raster(folder / "p.tif", coarse, names=NAMES))
    compared = {"REFERENCE": str(labels), "PREDICTED": predicted}
    of_class = {"INPUT": str(folder / "overlapping.shp"), "CLASS_FIELD": "class"}
    burnt = {**of_class, "INPUT": str(write_layer(folder / "annotation.shp", features)), "PIXEL_SIZE": 0.2}
    decoded = {"INPUT": str(color), "CLASS_TABLE": str(write_text(folder / "classes.csv", CLASSES_CSV)), "METHOD": 1}
    assessed = {"DATABASE": area, "SPACING": 400, "TRIALS": 40, "FOOTPRINT": "120", "MAP_CORRELATION": False}
    segmented = {"INPUT": str(color), "MODEL": str(write_model(folder / "colors.onnx"))}
    return {
        "segment": ("semref:segmentimage", segmented, "OUTPUT", "out.tif"),
        "compare": ("semref:comparelabels", {**compared, "MINIMUM_AREA": 3}, "DISAGREEMENTS", "out.gpkg"),
        "rasterize": ("semref:rasterizeannotation", burnt, "OUTPUT", "out.tif"),
        "check": ("semref:checkannotation", {**of_class, "PIXEL_SIZE": 1}, "ISSUES", "out.gpkg"),
        "repair": ("semref:repairannotation", of_class, "OUTPUT", "out.gpkg"),
        "decode": ("semref:decodecolorlabels", decoded, "OUTPUT", "out.tif"),
        "build": ("semref:builddatabase", build, "DATABASE", "out.gpkg"),
        "update": ("semref:updatedatabase", {"DATABASE": area, "LABELS": predicted}, "OUTPUT", "out.gpkg"),
        "assess": ("semref:assessdatabase", assessed, "OUTPUT", "out.gpkg"),
        "localize": (LOCALIZE, {"DATABASE": area, "IMAGES": [str(flight)], "METHOD": 1}, "OUTPUT", "out.gpkg"),
        "flight": ("semref:localizeflight", {"DATABASE": area, "IMAGES": six, "METHOD": 2}, "OUTPUT", "out.gpkg"),
    }


@pytest.fixture
def small_steps(monkeypatch):
    """Use small slices, so that small inputs take many steps."""
    monkeypatch.setattr(label_comparison, "_PIXELS_AT_ONCE", 10_000)
    monkeypatch.setattr(decode_color_labels, "ROWS_PIXELS", 10_000)
    monkeypatch.setattr(rasterize, "STRIP_PIXELS", 1)


def run(job, folder: Path, feedback):
    algorithm, parameters, key, name = job
    instance = QgsApplication.processingRegistry().createAlgorithmById(algorithm)
    return instance.run({**parameters, key: str(folder / name)}, QgsProcessingContext(), feedback, {}, False)


JOBS = (
    *("rasterize", "check", "repair", "decode", "build", "update", "assess", "localize"),
    *("flight", "segment", "compare"),
)


@pytest.mark.parametrize("percent", [50, *(pytest.param(n, marks=pytest.mark.slow) for n in (0, 10, 31, 86))])
@pytest.mark.parametrize("name", JOBS)
def test_cancel_stops_at_once_and_leaves_nothing_new(jobs, small_steps, tmp_path, name, percent):
    older = tmp_path / jobs[name][3]
    before = write_older(older)
    feedback = CancelAt(percent)
    with pytest.raises(QgsProcessingException) as caught:
        run(jobs[name], tmp_path, feedback)
    assert time.process_time() - feedback.canceled_at < PROMPT_S
    assert "Canceled" in str(caught.value)
    assert older.read_bytes() == before
    assert [path.name for path in tmp_path.iterdir()] == [older.name]


@pytest.mark.slow
@pytest.mark.parametrize("name", JOBS)
def test_a_cancel_leaves_nothing_and_the_next_run_succeeds_with_smooth_progress(jobs, small_steps, tmp_path, name):
    with pytest.raises(QgsProcessingException):
        run(jobs[name], tmp_path, CancelAt(40))
    assert list(tmp_path.iterdir()) == []
    feedback = CancelAt(None)
    results, succeeded = run(jobs[name], tmp_path, feedback)
    assert succeeded and Path(results[jobs[name][2]]).stat().st_size > 1000
    assert (np.diff([0.0, *feedback.shown]) >= 0).all() and len(set(feedback.shown)) >= 10
    assert feedback.shown[-1] >= 95 and max(feedback.shown) <= 100


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/fd").exists(), reason="open files can't be listed here")
@pytest.mark.parametrize("name", ["rasterize", "decode", "build", "segment"])
@pytest.mark.parametrize("percent", [50, pytest.param(90, marks=pytest.mark.slow)])
def test_files_are_closed_before_they_are_removed(jobs, small_steps, tmp_path, monkeypatch, name, percent):
    """Windows can't remove open files."""
    remove, still_open, looked = shutil.rmtree, [], []

    def look_and_remove(workplace, **options):
        looked.append(workplace)
        links = [os.path.realpath(f"/proc/self/fd/{number}") for number in os.listdir("/proc/self/fd")]
        still_open.extend(link for link in links if link.startswith(str(workplace)))
        remove(workplace, **options)

    monkeypatch.setattr(atomic_output.shutil, "rmtree", look_and_remove)
    with pytest.raises(QgsProcessingException):
        run(jobs[name], tmp_path, CancelAt(percent))
    assert still_open == []
    assert looked
