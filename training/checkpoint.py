"""Export a checkpoint of segmentation_models_pytorch as an ONNX file.

A checkpoint contains weights only. Architecture, encoder and number of outputs are those that its maker states.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import torch

from ..core.errors import TrainingError
from .export import IR_VERSION, add_metadata, largest_difference, write_onnx
from .loop import Report
from .network import allow_torchvision_without_operators

TILE_PX = 512
"""Edge of the images that the network is exported and checked with."""

_INSIDE = ("state_dict", "model_state_dict", "model")
"""Keys of the weights in checkpoints that contain more."""

_HEAD = "segmentation_head.0.weight"


def run(job: Path, report: Report) -> None:
    """Export the checkpoint of a job: JSON with checkpoint, architecture, encoder, outputs and output.

    Raises:
        TrainingError: The checkpoint is unusable, or does not fit the architecture.
    """
    stated = json.loads(job.read_text(encoding="utf-8"))
    report("exporting", share=0.2)
    network = _network(stated["architecture"], stated["encoder"], stated["outputs"])
    _fill(network, read_weights(Path(stated["checkpoint"])), stated)
    target = Path(stated["output"])
    write_onnx(network, TILE_PX, target)
    report("exporting", share=0.6)
    add_metadata(target, {"tile_size": TILE_PX})
    image = np.random.default_rng(IR_VERSION).normal(size=(1, 3, TILE_PX, TILE_PX)).astype(np.float32)
    largest_difference(network, target, [image])
    report("exporting", share=0.9)


def read_weights(path: Path) -> dict[str, torch.Tensor]:
    """Return the weights of a checkpoint by name, as segmentation_models_pytorch names them. Raises TrainingError."""
    try:
        # Nothing but numbers is loaded: a file from others could contain a program.
        found = torch.load(path, map_location="cpu", weights_only=True)
    except Exception:  # torch raises many kinds for foreign files
        found = None
    for key in _INSIDE:
        found = found[key] if isinstance(found, dict) and isinstance(found.get(key), dict) else found
    weights = {n: w for n, w in found.items() if isinstance(w, torch.Tensor)} if isinstance(found, dict) else {}
    prefix = next((name[: -len(_HEAD)] for name in weights if name.endswith(_HEAD)), None)
    if prefix is None:
        raise TrainingError(
            "{path} is not a checkpoint of segmentation_models_pytorch that contains weights only. Save the network’s "
            "state_dict with torch.save.",
            path=path,
        )
    return {name[len(prefix) :]: w for name, w in weights.items() if name.startswith(prefix)}


def _network(architecture: str, encoder: str, outputs: int) -> torch.nn.Module:
    allow_torchvision_without_operators()
    import segmentation_models_pytorch

    # timm would download an encoder that is an address.
    is_name = re.fullmatch(r"[\w.-]+", encoder) is not None
    try:
        if is_name:
            return segmentation_models_pytorch.create_model(
                architecture, encoder, encoder_weights=None, classes=outputs
            )
    except (KeyError, ValueError, RuntimeError):
        is_name = False
    raise TrainingError(
        "segmentation_models_pytorch has no network {architecture} with the encoder {encoder}. Enter both as the maker "
        "of the checkpoint states them, for example unet and resnet34.",
        architecture=architecture,
        encoder=encoder,
    )


def _fill(network: torch.nn.Module, weights: dict[str, torch.Tensor], stated: dict) -> None:
    outputs = weights[_HEAD].shape[0]
    if outputs != stated["outputs"]:
        raise TrainingError(
            "{path} has {channels} outputs, but there are {count} class names. Enter one class for each output, empty "
            "for outputs that are not used.",
            path=stated["checkpoint"],
            channels=outputs,
            count=stated["outputs"],
        )
    try:
        network.load_state_dict(weights)
    except RuntimeError:
        raise TrainingError(
            "The weights of {path} do not fit the architecture {architecture} with the encoder {encoder} and three "
            "bands. Enter both as the maker of the checkpoint states them.",
            path=stated["checkpoint"],
            architecture=stated["architecture"],
            encoder=stated["encoder"],
        ) from None
