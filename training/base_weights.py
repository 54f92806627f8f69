"""Load the weights of an earlier network of SemRef to continue its training, from an ONNX file or a torch checkpoint.

In an exported network, normalization layers are merged into the convolutions before them. The convolutions get the
merged weights, and the normalizations after them become the identity. ``restore_normalization`` then sets them to the
statistics of the new photos. The network thus gives the same answers as the model, and can be trained.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import onnx
import torch
from onnx import numpy_helper
from onnx.external_data_helper import uses_external_data

from ..core.errors import TrainingError
from .job import LITE0, NETWORK, SMALL
from .network import pyramid_attention_network

KNOWN = ((SMALL, 5), ("tu-mobilenetv3_small_100", 5), (LITE0, 5), ("tu-resnet10t", 4), ("resnet34", 5))
"""(encoder, depth) of models without the metadata ``architecture``."""


@dataclass(frozen=True)
class Base:
    """A network to continue from.

    Attributes:
        network: The network with its weights and its old classes.
        architecture: Encoder and depth.
        mean: (3,) mean for standardizing photos.
        deviation: (3,) standard deviation for standardizing photos.
        is_merged: Whether its normalizations must be restored.
    """

    network: torch.nn.Module
    architecture: dict
    class_names: tuple[str, ...]
    mean: np.ndarray
    deviation: np.ndarray
    is_merged: bool


def read_base(path: Path) -> Base:
    """Read a base model. Raises TrainingError for a file that is not a network of SemRef."""
    try:
        base = _from_checkpoint(path) if path.suffix == ".pt" else _from_onnx(path)
    except TrainingError:
        raise
    except Exception:  # onnx and torch raise many kinds for foreign files
        base = None
    if base is None:
        raise TrainingError(
            "{path} was not trained by SemRef, so its training can't be continued. Choose another base model, or leave "
            "the field empty.",
            path=path,
        )
    return base


def with_classes(base: Base, class_names: list[str]) -> torch.nn.Module:
    """Return the base's network with a channel for each class; classes with known names keep their weights."""
    last = _convolutions(base.network)[-1][0]
    made = torch.nn.Conv2d(last.in_channels, len(class_names), last.kernel_size, padding=last.padding)
    known = {name.casefold(): channel for channel, name in enumerate(base.class_names)}
    with torch.no_grad():
        for channel, name in enumerate(class_names):
            if name.casefold() in known:
                made.weight[channel] = last.weight[known[name.casefold()]]
                made.bias[channel] = last.bias[known[name.casefold()]]
    for parent in base.network.modules():
        for name, child in parent.named_children():
            if child is last:
                setattr(parent, name, made)
    return base.network


def restore_normalization(network: torch.nn.Module, batches: Iterable[torch.Tensor]) -> None:
    """Set merged normalizations to the mean and variance of their inputs, without changing the network's answers.

    Args:
        batches: Standardized images (N, 3, H, W).
    """
    network.eval()
    sums: dict[torch.nn.Module, list] = {}

    def look(layer: torch.nn.Module, inputs: tuple) -> None:
        values = inputs[0].double()
        count, total, squares = sums.setdefault(layer, [0, 0.0, 0.0])
        axes = (0, 2, 3)
        sums[layer] = [
            count + values.numel() / values.shape[1],
            total + values.sum(axes),
            squares + (values**2).sum(axes),
        ]

    layers = [layer for layer in network.modules() if isinstance(layer, torch.nn.BatchNorm2d)]
    hooks = [layer.register_forward_pre_hook(look) for layer in layers]
    with torch.inference_mode():
        for batch in batches:
            network(batch)
    for hook in hooks:
        hook.remove()
    with torch.no_grad():
        for layer, (count, total, squares) in sums.items():
            mean = total / count
            variance = (squares / count - mean**2).clamp(min=0)
            layer.bias += mean.float()
            layer.running_mean.copy_(mean)
            layer.running_var.copy_(variance)
            layer.weight.copy_(torch.sqrt(layer.running_var + layer.eps))


def _from_onnx(path: Path) -> Base | None:
    model = onnx.load(path, load_external_data=False)
    texts = {entry.key: entry.value for entry in model.metadata_props}
    stored = {tensor.name: tensor for tensor in model.graph.initializer}
    stored |= {
        node.output[0]: node.attribute[0].t
        for node in model.graph.node
        if node.op_type == "Constant" and node.attribute and node.attribute[0].name == "value"
    }
    # 16-bit weights are converted when the network is loaded.
    casts = [node for node in model.graph.node if node.op_type == "Cast" and node.input[0] in stored]
    stored |= {node.output[0]: stored[node.input[0]] for node in casts}
    if any(map(uses_external_data, stored.values())):
        # SemRef's models are one file. External data could name any file of the user.
        return None
    weights = [
        [numpy_helper.to_array(stored[name]).astype(np.float32) for name in node.input[1:]]
        for node in model.graph.node
        if node.op_type == "Conv"
    ]
    names = json.loads(texts["class_names"])
    stated = json.loads(texts.get("architecture", "null"))
    for encoder, depth in [_architecture(stated)] if stated else KNOWN:
        network = pyramid_attention_network(encoder, depth, len(weights[-1][0]), False)
        if _fill(network, weights):
            mean, deviation = (np.array(json.loads(texts[f"standardization_{key}"])) for key in ("mean", "std"))
            listed = tuple(names[str(channel)] for channel in range(len(names)))
            return Base(network, {"encoder": encoder, "depth": depth}, listed, mean, deviation, True)
    return None


def _fill(network: torch.nn.Module, weights: list[list[np.ndarray]]) -> bool:
    """Set the weights of the convolutions in execution order. If shapes differ, return False without changes."""
    pairs = _convolutions(network)
    shapes = [tuple(convolution.weight.shape) for convolution, _ in pairs]
    if shapes != [one[0].shape for one in weights]:
        return False
    with torch.no_grad():
        for (convolution, normalization), (weight, *bias) in zip(pairs, weights):
            convolution.weight.copy_(torch.tensor(weight))
            shift = torch.tensor(bias[0]) if bias else torch.zeros(len(weight))
            if convolution.bias is not None:
                convolution.bias.copy_(torch.zeros_like(shift) if normalization is not None else shift)
            if normalization is not None:
                normalization.weight.fill_(1)
                normalization.bias.copy_(shift)
                normalization.running_mean.zero_()
                normalization.running_var.fill_(1 - normalization.eps)
    return True


def _convolutions(network: torch.nn.Module) -> list[tuple[torch.nn.Conv2d, torch.nn.BatchNorm2d | None]]:
    """Return the convolutions in execution order, each with the normalization after it, if any."""
    order: list[list] = []

    def ran(layer: torch.nn.Module, inputs: tuple, output: torch.Tensor) -> None:
        if isinstance(layer, torch.nn.Conv2d):
            order.append([layer, None, output])
        elif order and inputs[0] is order[-1][2]:
            order[-1][1] = layer

    kinds = (torch.nn.Conv2d, torch.nn.BatchNorm2d)
    hooks = [layer.register_forward_hook(ran) for layer in network.modules() if isinstance(layer, kinds)]
    with torch.inference_mode():
        network.eval()(torch.zeros(1, 3, 128, 128))
    for hook in hooks:
        hook.remove()
    return [(layer, normalization) for layer, normalization, _ in order]


def _from_checkpoint(path: Path) -> Base | None:
    stated = json.loads((path.parent / NETWORK).read_text(encoding="utf-8"))
    encoder, depth = _architecture(stated)
    network = pyramid_attention_network(encoder, depth, len(stated["class_names"]), False)
    network.load_state_dict(torch.load(path, map_location="cpu", weights_only=True))
    mean, deviation = (np.array(stated[f"standardization_{key}"]) for key in ("mean", "std"))
    return Base(network, {"encoder": encoder, "depth": depth}, tuple(stated["class_names"]), mean, deviation, False)


def _architecture(stated: dict) -> tuple[str, int]:
    """Return encoder and depth from metadata. Raises ValueError for an address, which timm would download."""
    if not re.fullmatch(r"[\w.-]+", stated["encoder"]):
        raise ValueError(stated["encoder"])
    return stated["encoder"], stated["depth"]
