"""Export the trained network as an ONNX file with metadata for SemRef and Deepness, and check it against torch."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import onnx
import onnxruntime
import torch

from ..core.errors import TrainingError
from ..core.labels.class_table import LandCoverClass
from .metrics import intersection_over_union, rates
from .tiles import standardized

OPSET, IR_VERSION = 17, 8  # supported by onnxruntime from 1.12 on
LARGEST_DIFFERENCE = 1e-3  # of logits, between torch and onnxruntime
UNLABELED = LandCoverClass(0, "unlabeled", "#000000")


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


def metadata_of(
    classes: Sequence[LandCoverClass],
    standardization: tuple[np.ndarray, np.ndarray],
    tile_size: int,
    overlap: int,
    pixel_size: float | None,
    architecture: dict,
    validation: tuple[np.ndarray, np.ndarray] | None = None,
    ground: dict | None = None,
    card: dict | None = None,
) -> dict:
    """Return metadata by key: the keys of the Deepness plugin, and SemRef's own.

    Args:
        classes: One class for each output channel.
        standardization: Mean and deviation (3,) of red, green and blue in 0…1.
        tile_size: Edge in pixels.
        overlap: Percent of a tile.
        pixel_size: In m; None to omit the resolution.
        architecture: Encoder and depth, for further training.
        validation: (L, K) pixels of each label and predicted class on validation tiles, and the classes that each
            label allows (``metrics.partial_labels``).
        card: Data of the model card (docs/reference/file_formats.md#model-card).
    """
    mean, deviation = standardization
    found: dict = {
        "model_type": "Segmentor",
        "class_names": {str(i): c.name for i, c in enumerate(classes)},
        "class_values": {str(i): c.value for i, c in enumerate(classes)},
        "class_colors": {str(i): c.color for i, c in enumerate(classes)},
        "class_roles": {str(i): c.role for i, c in enumerate(classes)},
        "tile_size": tile_size,
        "tiles_overlap": overlap,
        "standardization_mean": [round(float(m), 6) for m in mean],
        "standardization_std": [round(float(d), 6) for d in deviation],
        "architecture": architecture,
    }
    if pixel_size:
        found["resolution"] = round(100 * pixel_size, 3)
    if validation is not None and validation[0].any():
        confusion, allowed = validation
        iou = intersection_over_union(confusion, allowed)
        found["validation_iou"] = {c.name: round(float(v), 4) for c, v in zip(classes, iou) if np.isfinite(v)}
        shares = rates(confusion[: len(classes)])
        found["validation_confusion"] = [[round(float(v), 4) for v in row] for row in shares]
    if ground:
        found["training_ground"] = ground
    if card:
        found["model_card"] = card
    return found
