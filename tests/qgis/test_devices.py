import os

import numpy
import numpy as np
import pytest
from made_inputs import write_raster
from made_models import metadata, painted, write_model
from qgis.core import Qgis, QgsSettings

from semref.core.segmentation.devices import AUTO, CPU, CUDA, OPENVINO
from semref.processing import version
from semref.processing.packages import devices
from semref.processing.packages.diagnostics import diagnostics, without_home
from semref.processing.version import plugin_version

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


@pytest.mark.parametrize(
    ("home", "line", "left"),
    [
        ("/home/jane", "/home/jane/maps/base.gpkg is damaged.", "~/maps/base.gpkg is damaged."),
        ("/home/jane/", "“/home/jane” and file:///home/jane/x", "“~” and file:~/x"),
        ("/home/jane", "/home/janet/x, /mnt/home/jane/x", "/home/janet/x, /mnt/home/jane/x"),
        (r"C:\Users\Jane Doe", r"C:\Users\Jane Doe\a.tif, c:/users/Jane Doe/b.tif", r"~\a.tif, ~/b.tif"),
        (r"C:\Users\Jane", r"'C:\\Users\\Jane\\a.tif'", r"'~\\a.tif'"),
        ("/", "/usr/share/x", "/usr/share/x"),
    ],
)
def test_the_home_folder_is_left_out(qgis_app, home, line, left):
    assert without_home(line, home) == left


def test_diagnostics_have_versions_packages_settings_and_messages(qgis_app):
    text = diagnostics([f"SemRef: {os.path.expanduser('~')}/x.gpkg can't be read."])
    versions = f"SemRef {plugin_version()}", f"QGIS {Qgis.QGIS_VERSION}", f"numpy {numpy.__version__}"
    assert [part for part in (*versions, "OpenCV: ", "ONNX Runtime: ") if part not in text] == []
    assert "Device: auto chosen" in text and "Training: " in text
    assert text.endswith("Last messages:\nSemRef: ~/x.gpkg can't be read.\n")
    assert diagnostics().endswith("Last messages:\n(none)\n")


def test_nobody_is_led_to_a_tracker_that_nobody_filled_in(qgis_app, monkeypatch):
    monkeypatch.setattr(version, "_metadata", lambda: {"tracker": "https://example.org/semref/issues"})
    assert version.tracker_url() == ""
    monkeypatch.setattr(version, "_metadata", lambda: {"tracker": "https://forge.net/semref/issues"})
    assert version.tracker_url() == "https://forge.net/semref/issues"
