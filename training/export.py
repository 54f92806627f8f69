"""Export the trained network as an ONNX file with metadata for SemRef and Deepness, and check it against torch."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import onnx
import onnxruntime
import torch

from ..core.errors import TrainingError
from .tiles import TileClass, standardized

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


def largest_difference(network: torch.nn.Module, target: Path, batches: list[np.ndarray]) -> float:
    """Return the largest difference of logits between torch and onnxruntime, for standardized images (N, 3, H, W).

    Raises:
        TrainingError: The difference is larger than LARGEST_DIFFERENCE.
    """
    session = onnxruntime.InferenceSession(str(target), providers=["CPUExecutionProvider"])
    network = network.cpu().eval()
    largest = 0.0
    for batch in batches:
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
        return session.run(None, {"image": standardized(image, mean, deviation)})[0][0]

    return scores_of
