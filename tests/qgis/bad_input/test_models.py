"""Bad models, photos that a model can’t read, and missing packages are reported in one sentence."""

import importlib.util
import re

import pytest
from bad_input import LOCALIZE, OUTPUT_NAMES, RASTERIZE, SEGMENT
from made_inputs import read_rows, write_text
from made_models import brightest_color, metadata, write_model
from qgis.core import QgsApplication

from semref.processing.packages import components


@pytest.mark.parametrize("algorithm", [SEGMENT, LOCALIZE])
@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"network": brightest_color(external="weights.bin")}, "are in another file, which is missing"),
        ({"network": brightest_color().add("Frobnicate")}, "can't be run by onnxruntime"),
        ({"metadata": metadata(resolution="fine")}, "resolution"),
    ],
)
def test_a_bad_model_is_reported_in_one_sentence(refused, tmp_path, options, words, algorithm):
    """More models: tests/core/segmentation."""
    sentence = refused(algorithm, MODEL=str(write_model(tmp_path / "bad.onnx", **options)))
    assert "bad.onnx" in sentence and words in sentence


def test_a_photo_that_makes_a_network_give_no_numbers_has_no_fix(run_algorithm, defaults, tmp_path):
    model = write_model(tmp_path / "bad.onnx", brightest_color().add("Sqrt"))
    (row,) = read_rows(run_algorithm(LOCALIZE, {**defaults[LOCALIZE], "MODEL": str(model)})["OUTPUT"])
    assert row["status"] == "error" and "not numbers" in row["reason"]


def test_no_speed_is_reported_if_the_network_saw_no_photo(run_algorithm, defaults, feedback, tmp_path):
    parameters = {"MODEL": str(write_model(tmp_path / "m.onnx")), "IMAGES": str(write_text(tmp_path / "a.png", "text"))}
    found = run_algorithm(LOCALIZE, {**defaults[LOCALIZE], **parameters}, feedback)
    assert found["FIX_COUNT"] == 0 and "DEVICE" not in found and "per second" not in feedback.textLog()


@pytest.fixture
def lacking(qgis_app, monkeypatch):
    """`lacking(module)` makes Python find no such module; returns ``canExecute`` by the id of an algorithm."""

    def of(module):
        find_spec = importlib.util.find_spec
        monkeypatch.setattr(
            importlib.util, "find_spec", lambda name, *a: None if name == module else find_spec(name, *a)
        )
        return lambda name: QgsApplication.processingRegistry().createAlgorithmById(name).canExecute()

    return of


def test_a_missing_onnxruntime_is_reported_with_how_to_install_it(lacking):
    can_execute = lacking("onnxruntime")
    possible, reason = can_execute(SEGMENT)
    # Which command fits which release: test_components.py.
    assert not possible and re.search('install --no-deps [^“”]*"onnxruntime', reason)
    assert can_execute(LOCALIZE) == (True, "")


def test_a_missing_opencv_is_reported_and_the_algorithms_stay_listed(lacking):
    can_execute = lacking("cv2")
    provider = QgsApplication.processingRegistry().providerById("semref")
    assert set(OUTPUT_NAMES) <= {algorithm.id() for algorithm in provider.algorithms()}
    for algorithm in OUTPUT_NAMES:
        possible, reason = can_execute(algorithm)
        assert not possible and "pip install" in reason and "opencv-python-headless>=" in reason


@pytest.mark.parametrize("name", ["is_missing", "is_too_old"])
@pytest.mark.parametrize("algorithm", ["semref:checkannotation", "semref:repairannotation"])
def test_a_missing_or_old_shapely_is_reported_by_its_algorithms(qgis_app, monkeypatch, name, algorithm):
    monkeypatch.setattr(components, name, lambda package: package is components.SHAPELY)
    create = QgsApplication.processingRegistry().createAlgorithmById
    possible, reason = create(algorithm).canExecute()
    assert not possible and '"shapely>=2' in reason
    assert create(RASTERIZE).canExecute()[0]
