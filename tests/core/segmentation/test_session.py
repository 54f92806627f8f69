"""Sessions of onnxruntime use the given provider or fail."""

import pytest
from made_models import write_model

from semref.core.errors import ModelError
from semref.core.segmentation.devices import CPU, CUDA
from semref.core.segmentation.session import available_providers, open_session


@pytest.fixture
def model(tmp_path):
    return str(write_model(tmp_path / "m.onnx"))


def test_a_network_is_opened_on_the_provider_that_was_asked_for(model):
    assert CPU.provider in available_providers()
    assert open_session(model, 1, CPU.provider).get_providers() == [CPU.provider]


def test_a_provider_that_onnxruntime_leaves_out_is_an_error(model, monkeypatch, capfd):
    import onnxruntime

    real = onnxruntime.InferenceSession
    monkeypatch.setattr(
        onnxruntime, "InferenceSession", lambda path, options, providers: real(path, options, [CPU.provider])
    )
    monkeypatch.delattr(onnxruntime, "preload_dlls", raising=False)
    with pytest.raises(ModelError, match="its driver or its libraries could not be loaded"):
        open_session(model, 1, CUDA.provider)
    assert capfd.readouterr() == ("", "")


def test_a_run_that_fails_is_not_tried_elsewhere(model):
    assert open_session(model, 1, CPU.provider)._enable_fallback is False
