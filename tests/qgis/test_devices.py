"""The device in the options: kept, used by algorithms, reported with its speed, replaced only with a note."""

import numpy as np
import pytest
from made_inputs import write_raster
from made_models import metadata, painted, write_model
from qgis.core import QgsSettings

from semref.core.segmentation.devices import AUTO, CPU, CUDA, OPENVINO
from semref.processing.packages import devices

SEGMENT = "semref:segmentimage"
PHOTO = np.moveaxis(painted(np.random.default_rng(1).integers(1, 4, (100, 150))), 2, 0)


@pytest.fixture(autouse=True)
def no_choice():
    QgsSettings().remove(devices.DEVICE_SETTING)
    yield
    QgsSettings().remove(devices.DEVICE_SETTING)


@pytest.fixture
def segment(run_algorithm, feedback, tmp_path):
    def run(**options):
        image, model = write_raster(tmp_path / "a.tif", PHOTO), write_model(tmp_path / "m.onnx", **options)
        given = {"INPUT": str(image), "MODEL": str(model), "OUTPUT": str(tmp_path / "labels.tif")}
        return run_algorithm(SEGMENT, given, feedback)

    return run


def test_the_choice_is_kept_and_an_unknown_one_is_automatic():
    assert devices.chosen_device() == AUTO
    devices.choose_device("cuda")
    assert devices.chosen_device() == "cuda"
    devices.choose_device("of another version")
    assert devices.chosen_device() == AUTO


def test_device_and_speed_are_reported(segment, feedback):
    devices.choose_device("cpu")
    found = segment()
    assert found["DEVICE"] == "CPU" and found["TILES_PER_SECOND"] > 0
    assert "6 tiles in" in feedback.textLog() and "per second) on CPU" in feedback.textLog()


def test_a_missing_device_is_reported_in_log_and_result(segment, feedback, monkeypatch):
    import onnxruntime

    monkeypatch.setattr(onnxruntime, "get_available_providers", lambda: [CPU.provider])
    devices.choose_device("cuda")
    found = segment()
    sentence = "CUDA is selected, but this onnxruntime does not support it"
    assert found["DEVICE"].startswith(f"CPU ({sentence}") and sentence in feedback.textLog()


def test_overridden_metadata_are_reported(segment, feedback):
    segment(size=(64, 64), metadata=metadata(tile_size=32))
    assert "64 × 64" in feedback.textLog() and "32" in feedback.textLog()


def test_what_can_be_chosen_is_what_onnxruntime_reports(monkeypatch):
    import onnxruntime

    there = ["TensorrtExecutionProvider", CUDA.provider, OPENVINO.provider, CPU.provider]
    monkeypatch.setattr(onnxruntime, "get_available_providers", lambda: there)
    assert devices.available_devices() == [CPU, CUDA, OPENVINO]
    monkeypatch.setattr(devices, "is_missing", lambda package: True)
    assert devices.available_devices() == []
