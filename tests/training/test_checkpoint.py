"""A checkpoint of others is exported and merged: its labels are those of PyTorch.

A program makes random weights of the same architectures as those of the presets, and computes the expected scores.
"""

import json
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation.foreign_network import with_facts
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.network import OnnxNetwork
from semref.core.segmentation.network_facts import BUILDINGS, FLAIR
from semref.core.segmentation.photo_labels import PhotoLabels

ROOT = Path(__file__).parents[2]
SIZE = 512

PROGRAM = """
import numpy
from semref.training.network import allow_torchvision_without_operators
allow_torchvision_without_operators()
import segmentation_models_pytorch

folder, architecture, encoder, outputs = sys.argv[1], sys.argv[2], sys.argv[3], int(sys.argv[4])
network = segmentation_models_pytorch.create_model(architecture, encoder, encoder_weights=None, classes=outputs).eval()
with torch.no_grad():
    # Random weights give outputs of almost the same size everywhere; these differ from place to place.
    image = torch.from_numpy(numpy.load(folder + "/image.npy"))[None]
    head = network.segmentation_head[0]
    before = network(image)
    head.weight *= (3 / before.std((0, 2, 3))).reshape(-1, 1, 1, 1)
    head.bias -= network(image).mean((0, 2, 3))
    numpy.save(folder + "/logits.npy", network(image)[0].numpy())
weights = {"model.seg_model." + name: values for name, values in network.state_dict().items()}
torch.save({"state_dict": {**weights, "criterion.weight": torch.ones(outputs)}, "epoch": 3}, folder + "/others.ckpt")
"""


@pytest.fixture
def image() -> np.ndarray:
    """Return (H, W, 3) uint8 pixels with large and small patches."""
    random = np.random.default_rng(4)
    pixels = [np.kron(random.integers(0, 86, (SIZE // n, SIZE // n, 3)), np.ones((n, n, 1))) for n in (1, 8, 64)]
    return sum(pixels).astype(np.uint8)


def job(folder: Path, **values) -> Path:
    path = folder / "job.json"
    stated = {"checkpoint": str(folder / "others.ckpt"), "output": str(folder / "raw.onnx"), **values}
    path.write_text(json.dumps(stated), encoding="utf-8")
    return path


@pytest.fixture
def export(with_torch, training_python, tmp_path, image):
    """`export(facts, architecture)` exports random weights to raw.onnx; returns torch's (C, H, W) scores."""
    return lambda *asked: exported(with_torch, training_python, tmp_path, image, *asked, "resnet34")


def exported(with_torch, python, folder: Path, image, facts, architecture: str, encoder: str) -> np.ndarray:
    mean, std = (np.array(v, np.float32) for v in (facts.mean, facts.std))
    np.save(folder / "image.npy", ((image.astype(np.float32) / 255 - mean) / std).transpose(2, 0, 1))
    made = with_torch(PROGRAM, folder, architecture, encoder, len(facts.classes))
    assert made.returncode == 0, made.stderr
    stated = job(folder, architecture=architecture, encoder=encoder, outputs=len(facts.classes))
    command = [str(python), str(ROOT / "program.py"), "training.command", "checkpoint", str(stated)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return np.load(folder / "logits.npy")


def labels_of(folder: Path, facts, image: np.ndarray) -> np.ndarray:
    """Return the (H, W) class names by the copy that “Add model” writes; empty for none."""
    (folder / "copy.onnx").write_bytes(with_facts(OnnxNetwork(str(folder / "raw.onnx"), 2), facts))
    model = SegmentationModel(str(folder / "copy.onnx"), 2)
    found = PhotoLabels(model, ArrayImage(image), model.classes.values).found()
    names = {one.value: one.name for one in model.classes.table}
    return np.array([names.get(value, "") for value in range(256)])[found]


@pytest.mark.slow
@pytest.mark.parametrize("architecture", ["unet", "deeplabv3"])
def test_flair_s_merged_labels_are_those_of_torch(export, tmp_path, image, architecture):
    logits = export(FLAIR, architecture)
    used = [n for n, name in enumerate(FLAIR.classes) if name]
    powers = np.exp(logits[used] - logits[used].max(0))
    names = tuple(dict.fromkeys(FLAIR.classes[n] for n in used))
    members = [[FLAIR.classes[n] == name for n in used] for name in names]
    sums = np.einsum("kc,chw->khw", np.array(members, float), powers / powers.sum(0))
    found = labels_of(tmp_path, FLAIR, image)
    expected = np.array(names)[sums.argmax(0)]
    first, second = np.sort(sums, 0)[:-3:-1]
    assert len(np.unique(expected)) == 7 and (first - second < 1e-4)[found != expected].all()
    assert (found == expected).mean() > 0.9999


@pytest.mark.slow
def test_the_labels_of_a_network_of_buildings_are_those_of_torch(export, tmp_path, image):
    facts = replace(BUILDINGS, license="CC0", threshold=0.7)
    logits = export(facts, "unet")[0]
    expected = 1 / (1 + np.exp(-logits)) > 0.7
    found = labels_of(tmp_path, facts, image) == "building"
    assert 0.02 < expected.mean() < 0.98 and (found == expected).mean() > 0.9999


REFUSED = """
import os
from semref.training.command import main


class Bad:
    def __reduce__(self):
        return os.mkdir, (sys.argv[1] + "/ran",)


torch.save({"state_dict": Bad()}, sys.argv[1] + "/bad.pt")
for job in sys.argv[2:]:
    main(["checkpoint", job])
"""


@pytest.mark.slow
def test_checkpoints_that_do_not_fit_are_refused_with_a_sentence(with_torch, tmp_path):
    np.save(tmp_path / "image.npy", np.zeros((3, 64, 64), np.float32))
    assert with_torch(PROGRAM, tmp_path, "unet", "resnet18", 3).returncode == 0
    (tmp_path / "text.pt").write_text("no checkpoint")
    fits = {"architecture": "unet", "encoder": "resnet18", "outputs": 3}
    cases = (
        ({"outputs": 2}, "has 3 outputs, but there are 2 class names"),
        ({"encoder": "resnet34"}, "do not fit the architecture unet with the encoder resnet34"),
        ({"encoder": "resnet1"}, "has no network unet with the encoder resnet1"),
        ({"architecture": "net"}, "has no network net"),
        ({"encoder": "tu-hf-hub:a/b"}, "has no network unet with the encoder tu-hf-hub:a/b"),
        ({"checkpoint": str(tmp_path / "text.pt")}, "is not a checkpoint of segmentation_models_pytorch"),
        ({"checkpoint": str(tmp_path / "bad.pt")}, "that contains weights only"),
    )
    jobs = []
    for number, (changed, _) in enumerate(cases):
        (tmp_path / str(number)).mkdir()
        path = job(tmp_path / str(number), **{"checkpoint": str(tmp_path / "others.ckpt"), **fits, **changed})
        jobs.append(path)
    done = with_torch(REFUSED, tmp_path, *jobs)
    assert done.returncode == 0, done.stderr
    events = [json.loads(line) for line in done.stdout.splitlines() if line.startswith('{"event"')]
    texts = [event.get("text", "") for event in events if event["event"] != "exporting"]
    assert len(texts) == len(cases)
    for text, (_, part) in zip(texts, cases):
        assert part in text
    assert not (tmp_path / "ran").exists()
