"""``python -m core --device``: the device of the network, and a warning if another one is used."""

from __future__ import annotations

import json

import pytest
from made_models import NAMES, write_model

from semref.core.labels.class_table import class_table_from_csv
from semref.core.onboard.image_records import label_reader
from semref.core.onboard.log import start_log

TABLE = class_table_from_csv("value,name\n" + "".join(f"{n},{name}\n" for n, name in enumerate(NAMES, start=1)))


@pytest.fixture
def logged(tmp_path, monkeypatch, capsys):
    """`logged(device)` returns the lines of the log where only the CPU exists."""
    import onnxruntime

    monkeypatch.setattr(onnxruntime, "get_available_providers", lambda: ["CPUExecutionProvider"])
    model = write_model(tmp_path / "m.onnx")

    def run(device):
        start_log("info")
        label_reader(str(model), 1, TABLE, device)
        return [json.loads(line) for line in capsys.readouterr().err.splitlines()]

    return run


@pytest.mark.parametrize("device", ["auto", "cpu"])
def test_the_log_names_the_device(logged, device):
    (line,) = logged(device)
    assert (line["event"], line["device"]) == ("model", "CPU")


def test_a_device_that_is_not_there_is_a_warning(logged):
    warning, line = logged("cuda")
    assert (warning["level"], warning["event"]) == ("warning", "device")
    assert "CUDA is selected" in warning["reason"] and line["device"] == "CPU"
