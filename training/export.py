"""Export the trained network as an ONNX file with metadata for SemRef and Deepness, and check it against torch."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import onnx
import onnxruntime
import torch

from ..core.errors import TrainingError
from .metrics import confusion_matrix
from .tiles import TileClass, TileReader

OPSET, IR_VERSION = 17, 8  # supported by onnxruntime from 1.12 on
LARGEST_DIFFERENCE = 1e-3  # of logits, between torch and onnxruntime
UNLABELED = TileClass(0, "unlabeled", "#000000", "background")


def write_onnx(network: torch.nn.Module, tile_size: int, target: Path) -> None:
    """Export a network; height and width of the input are free multiples of 16."""
    network = network.cpu().eval()
    example = torch.zeros(1, 3, tile_size, tile_size)
    torch.onnx.export(
        network,
        (example,),
        str(target),
        dynamo=False,
        opset_version=OPSET,
        input_names=["image"],
        output_names=["logits"],
        dynamic_axes={"image": {2: "height", 3: "width"}, "logits": {2: "height", 3: "width"}},
    )


def add_metadata(target: Path, entries: dict) -> None:
    """Write metadata into the file; values other than text are written as JSON."""
    model = onnx.load(target)
    model.ir_version = IR_VERSION
    for key, value in entries.items():
        entry = model.metadata_props.add()
        entry.key, entry.value = key, value if isinstance(value, str) else json.dumps(value)
    onnx.checker.check_model(model)
    onnx.save(model, target)


def largest_difference(network: torch.nn.Module, target: Path, images: list[np.ndarray]) -> float:
    """Return the largest difference of logits between torch and onnxruntime, for standardized images (3, H, W).

    Raises:
        TrainingError: The difference is larger than LARGEST_DIFFERENCE.
    """
    session = onnxruntime.InferenceSession(str(target), providers=["CPUExecutionProvider"])
    network = network.cpu().eval()
    largest = 0.0
    for image in images:
        batch = image[None].astype(np.float32)
        with torch.inference_mode():
            expected = network(torch.from_numpy(batch)).numpy()
        largest = max(largest, float(np.abs(session.run(None, {"image": batch})[0] - expected).max()))
    if largest > LARGEST_DIFFERENCE:
        raise TrainingError(
            "The exported model {path} differs from the trained network by {difference:.2g} in a logit.",
            path=target,
            difference=largest,
        )
    return largest


def scoring(target: Path, mean, deviation):
    """Return a function from an image (H, W, 3) in 0…1 to the model's scores (C, H, W)."""
    session = onnxruntime.InferenceSession(str(target), providers=["CPUExecutionProvider"])

    def scores_of(image: np.ndarray) -> np.ndarray:
        batch = ((image - mean) / deviation).astype(np.float32).transpose(2, 0, 1)[None].copy()
        return session.run(None, {"image": batch})[0][0]

    return scores_of


def answering(scores_of):
    """Return a function from an image to the channels (H, W) with the highest score."""
    return lambda image: scores_of(image).argmax(0).astype(np.uint8)


def compare(network: torch.nn.Module, target: Path, reader: TileReader, mean, deviation):
    """Return the confusion matrices of the network in torch and in onnxruntime, and the share of equal pixels."""
    session = onnxruntime.InferenceSession(str(target), providers=["CPUExecutionProvider"])
    network = network.cpu().eval()
    count = session.get_outputs()[0].shape[1]
    by_torch, by_onnx = (np.zeros((count, count), np.int64) for _ in range(2))
    same = total = 0
    for index in range(len(reader)):
        image, labels = reader(index)
        batch = ((image - mean) / deviation).astype(np.float32).transpose(2, 0, 1)[None].copy()
        with torch.inference_mode():
            first = network(torch.from_numpy(batch)).argmax(1)[0].numpy()
        second = session.run(None, {"image": batch})[0].argmax(1)[0]
        by_torch += confusion_matrix(labels, first, count)
        by_onnx += confusion_matrix(labels, second, count)
        same, total = same + int((first == second).sum()), total + first.size
    return by_torch, by_onnx, same / total
