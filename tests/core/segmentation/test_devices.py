import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from made_models import painted, write_model

from semref.core.segmentation.devices import (
    AUTO,
    AUTOMATIC,
    CPU,
    CUDA,
    DEVICES,
    DIRECTML,
    KEYS,
    device_of,
    devices_to_try,
)
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.network import TILES_AT_ONCE
from semref.core.segmentation.session import open_session
from semref.core.sentences import english

EVERY = [device.provider for device in AUTOMATIC]


class FakeOnnxruntime:
    """onnxruntime with more providers than this machine has; sessions run on the CPU."""

    def __init__(self, monkeypatch, there, refused=(), left_out=(), fails=()):
        import onnxruntime

        self.opened = []
        real = onnxruntime.InferenceSession

        def open_session(path, options=None, providers=()):
            first = providers[0]
            self.opened.append(first)
            if first in refused:
                raise RuntimeError("no card in this computer")
            session = real(path, options, providers=[CPU.provider])
            if first == CPU.provider:
                return session
            return Session(session, [CPU.provider] if first in left_out else list(providers), first in fails)

        monkeypatch.setattr(onnxruntime, "get_available_providers", lambda: list(there))
        monkeypatch.setattr(onnxruntime, "InferenceSession", open_session)
        monkeypatch.delattr(onnxruntime, "preload_dlls", raising=False)


class Session:
    """Session on the CPU that reports other providers; it can fail when it is run."""

    def __init__(self, session, providers, fails):
        self._session, self._providers, self._fails = session, providers, fails

    def get_providers(self):
        return self._providers

    def run(self, *arguments):
        if self._fails:
            raise RuntimeError("out of memory on the card")
        return self._session.run(*arguments)

    def __getattr__(self, name):
        return getattr(self._session, name)


@pytest.fixture
def load(tmp_path):
    def make(device=AUTO, threads=3, **options):
        path = write_model(tmp_path / "m.onnx", **options)
        return SegmentationModel(str(path), threads, device=device)

    return make


def test_automatic_tries_what_is_there_the_cpu_last_and_each_device_has_its_key():
    assert devices_to_try(AUTO, ["Provider", CPU.provider, DIRECTML.provider, CUDA.provider]) == [CUDA, DIRECTML, CPU]
    assert devices_to_try(AUTO, EVERY) == list(AUTOMATIC) and AUTOMATIC[-1] is CPU
    assert devices_to_try("something of another version", [CPU.provider]) == [CPU]
    assert KEYS == ("auto", "cpu", "cuda", "directml", "coreml", "openvino")
    assert [device_of(key) for key in KEYS] == [None, *DEVICES]


def test_the_first_that_starts_runs_the_network(load, monkeypatch):
    fake = FakeOnnxruntime(monkeypatch, EVERY)
    model = load()
    assert (model.device, model.fallbacks, fake.opened) == (CUDA, [], [CUDA.provider])


def test_on_a_card_the_network_gets_several_tiles_and_one_run(load, monkeypatch):
    FakeOnnxruntime(monkeypatch, EVERY)
    on_card, on_cpu = load("cuda", batch="batch"), load("cpu", batch="batch")
    assert (on_card.tiles_at_once, on_card.runs_at_once) == (TILES_AT_ONCE, 1)
    assert (on_cpu.tiles_at_once, on_cpu.runs_at_once) == (1, 2)


def test_images_that_are_labeled_at_a_time_share_the_runs_of_a_network(load, monkeypatch):
    FakeOnnxruntime(monkeypatch, EVERY)
    model, runs, most = load("cuda"), [], []

    class Slow:
        def run(self, _, given):
            runs.append(1)
            most.append(len(runs))
            time.sleep(0.01)
            runs.pop()
            return [np.zeros((1, 2, *model.tile_hw), np.float32)]

    model._session = Slow()
    with ThreadPoolExecutor(4) as pool:
        list(pool.map(lambda _: model.run([np.zeros((*model.tile_hw, 3), np.uint8)]), range(8)))
    assert most == [1] * 8


@pytest.mark.parametrize(
    ("trouble", "said"),
    [
        ({"refused": [CUDA.provider]}, "no card in this computer"),
        ({"left_out": [CUDA.provider]}, "its driver or its libraries could not be loaded"),
        ({"fails": [CUDA.provider]}, "out of memory on the card"),
    ],
    ids=["refused", "left out without a word", "fails when it is run"],
)
@pytest.mark.parametrize("asked", [AUTO, "cuda"])
def test_a_device_that_does_not_start_is_replaced_with_a_note(load, monkeypatch, trouble, said, asked):
    FakeOnnxruntime(monkeypatch, [CUDA.provider, CPU.provider], **trouble)
    model = load(asked)
    assert model.device is CPU
    (fallback,) = map(english, model.fallbacks)
    assert fallback == f"CUDA could not be started ({said}); the network runs on CPU."
    photo = painted(np.ones((64, 64), int))
    assert model.scores([photo]).argmax(axis=1).max() == 0


def test_each_device_that_does_not_start_is_named(load, monkeypatch):
    FakeOnnxruntime(monkeypatch, EVERY, refused=[CUDA.provider, "ROCMExecutionProvider"])
    model = load()
    assert model.device is DIRECTML
    assert [english(fallback).split()[0] for fallback in model.fallbacks] == ["CUDA", "ROCm"]
    assert all("runs on DirectML" in english(fallback) for fallback in model.fallbacks)


def test_a_missing_device_is_replaced_with_a_note_on_its_package(load, monkeypatch):
    FakeOnnxruntime(monkeypatch, [CPU.provider])
    model = load("openvino")
    assert model.device is CPU
    (fallback,) = map(english, model.fallbacks)
    assert "OpenVINO is selected" in fallback and "onnxruntime-openvino" in fallback


def test_what_onnxruntime_prints_of_missing_libraries_is_the_reason(load, monkeypatch, capsys):
    import onnxruntime

    FakeOnnxruntime(monkeypatch, [CUDA.provider, CPU.provider], left_out=[CUDA.provider])
    words = "Failed to load libcublasLt.so.12: no such file\nFailed to load libcudnn.so.9: no such file\n"
    monkeypatch.setattr(onnxruntime, "preload_dlls", lambda directory: print(words), raising=False)
    (fallback,) = map(english, load("cuda").fallbacks)
    assert "CUDA could not be started (Failed to load libcublasLt.so.12: no such file)" in fallback
    assert capsys.readouterr().out == ""


def test_a_run_that_fails_is_not_tried_elsewhere(load, tmp_path):
    load()
    session = open_session(str(tmp_path / "m.onnx"), 1, CPU.provider)
    assert session.get_providers() == [CPU.provider] and session._enable_fallback is False


def test_images_that_were_looked_at_are_counted(load):
    model = load()
    photo = painted(np.ones((64, 64), int))
    model.scores([photo])
    model.scores([photo, photo][:1])
    assert model.tiles_seen == 2
