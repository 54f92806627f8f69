"""Bad models, and photos that a model can’t read, are reported in one sentence."""

from __future__ import annotations

import importlib.util
import re

import numpy as np
import pytest
from bad_input import LOCALIZE, SEGMENT
from made_inputs import write_raster, write_text
from made_models import brightest_color, metadata, write_model
from osgeo import ogr
from qgis.core import QgsApplication

BAD_MODELS = {
    "missing weights": ({"network": brightest_color(external="weights.bin")}, "are in another file, which is missing"),
    "newer format": ({"ir_version": 99}, "can't be run by onnxruntime"),
    "four bands": (
        {"network": brightest_color(bands=4), "input_shape": (1, 4, "h", "w")},
        "takes input of the shape 1 × 4 × any × any",
    ),
    "unknown operator": ({"network": brightest_color().add("Frobnicate")}, "can't be run by onnxruntime"),
    "too few names": ({"metadata": metadata(class_names=["a", "b"])}, "outputs 3 classes"),
    "no names": ({"metadata": metadata(class_names=None)}, "metadata key class_names"),
    "a detector": ({"metadata": metadata(model_type="Detector")}, "model of type Detector"),
    "no resolution": ({"metadata": metadata(resolution="fine")}, "resolution"),
}


@pytest.mark.parametrize("algorithm", [SEGMENT, LOCALIZE])
@pytest.mark.parametrize("name", BAD_MODELS)
def test_a_bad_model_is_reported_in_one_sentence(refused, tmp_path, name, algorithm):
    options, words = BAD_MODELS[name]
    sentence = refused(algorithm, MODEL=str(write_model(tmp_path / "bad.onnx", **options)))
    assert "bad.onnx" in sentence and words in sentence


def test_a_photo_that_makes_a_network_give_no_numbers_has_no_fix(run_algorithm, defaults, tmp_path):
    model = write_model(tmp_path / "bad.onnx", brightest_color().add("Sqrt"))
    parameters = {**defaults[LOCALIZE], "MODEL": str(model)}
    source = ogr.Open(run_algorithm(LOCALIZE, parameters)["OUTPUT"])
    (row,) = [feature.items() for feature in source.GetLayer(0)]
    assert row["status"] == "error" and "not numbers" in row["reason"]


def test_no_speed_is_reported_if_the_network_saw_no_photo(run_algorithm, defaults, feedback, tmp_path):
    parameters = {"MODEL": str(write_model(tmp_path / "m.onnx")), "IMAGES": str(write_text(tmp_path / "a.png", "text"))}
    found = run_algorithm(LOCALIZE, {**defaults[LOCALIZE], **parameters}, feedback)
    assert found["FIX_COUNT"] == 0 and "DEVICE" not in found and "per second" not in feedback.textLog()


def test_a_truncated_photo_is_reported(refused, tmp_path):
    image = np.random.default_rng(1).integers(0, 255, (3, 400, 400)).astype(np.uint8)
    path = write_raster(tmp_path / "cut.tif", image)
    path.write_bytes(path.read_bytes()[:200_000])
    assert "cut.tif is damaged or cut short" in refused(SEGMENT, INPUT=str(path))


def test_a_class_table_that_does_not_fit_the_model_is_reported(refused, tmp_path):
    table = write_text(tmp_path / "classes.csv", "value,name\n1,building\n")
    assert "The class table has no class water, bare_land" in refused(SEGMENT, CLASS_TABLE=str(table))


def test_a_missing_onnxruntime_is_reported_with_how_to_install_it(qgis_app, monkeypatch):
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name, *a: None if name == "onnxruntime" else find_spec(name, *a)
    )
    registry = QgsApplication.processingRegistry()
    possible, reason = registry.createAlgorithmById(SEGMENT).canExecute()
    assert not possible
    # Which command fits which release: test_components.py.
    assert re.search('install --no-deps [^“”]*"onnxruntime', reason)
    assert registry.createAlgorithmById(LOCALIZE).canExecute() == (True, "")
