"""Networks of others: copy an ONNX file with the metadata that SemRef reads, and merge its outputs to classes.

A class can have several outputs: its probability is the sum of theirs, after a softmax over all outputs that are used.
Outputs of a single class get a sigmoid, if they are not probabilities yet. Both become operators of the copy, so its
reader needs no second form of metadata, and Deepness runs the copy, too (docs/reference/networks.md).
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ..errors import ModelError
from .metadata import read_classes
from .model_card import KEY as CARD
from .model_card import card_of_texts
from .network import OnnxNetwork
from .network_facts import NetworkFacts, require_facts
from .onnx_file import header_of, with_only_metadata
from .onnx_nodes import FLOAT, Operator, with_operators

_KEPT = ("tile_size", "tiles_size", "tiles_overlap")
"""Keys of metadata that stay: those of the tiles."""

_LEAST_PROBABILITY = np.float32(1e-30)
"""Added to probabilities before the logarithm."""

_SEED = 1671


def stated_facts(network: OnnxNetwork) -> NetworkFacts:
    """Return what the metadata of a network state; empty class names and 0 for what is missing."""
    card, settings = card_of_texts(network.texts, network.path), network.settings
    return NetworkFacts(
        card.classes or ("",) * network.channels,
        settings.resolution_m or 0.0,
        settings.mean,
        settings.std,
        card.license,
        card.name,
        settings.threshold,
    )


def with_facts(network: OnnxNetwork, facts: NetworkFacts) -> bytes:
    """Return a copy of the file of a network with metadata and merged classes, which ``SegmentationModel`` opens.

    Raises:
        ModelError: ``facts`` do not fit the network, or its file can't be copied.
        OSError: Its file cannot be read.
    """
    require_facts(facts)
    path, names = network.path, tuple(dict.fromkeys(filter(None, facts.classes)))
    header = header_of(path)
    if header is not None and header.weight_files:
        raise ModelError(
            "The weights of {path} are in another file ({name}). Export the network as one file.",
            path=path,
            name=header.weight_files[0],
        )
    if network.gives_integers:
        raise ModelError(
            "{path} outputs class numbers. Export it without argmax, with an output for each class.", path=path
        )
    if network.channels != len(facts.classes):
        raise ModelError(
            "{path} has {channels} outputs, but there are {count} class names. Enter one class for each output, empty "
            "for outputs that are not used.",
            path=path,
            channels=network.channels,
            count=len(facts.classes),
        )
    if not network.is_single and len(names) < 2:
        raise ModelError(
            "All used outputs of {path} have the class {name}, so every pixel would have it. Enter at least two "
            "classes; a class without interest can be “other”.",
            path=path,
            name=names[0],
        )
    kept = {key: network.texts[key] for key in _KEPT if key in network.texts}
    texts = {**kept, **_metadata(facts, names)}
    # Raises for names that can't be those of classes, before anything is written.
    read_classes(texts, 2 if network.is_single else len(names), path)
    data = Path(path).read_bytes()
    operators = _sigmoid(network) if network.is_single else _merged(facts.classes, names, network.sums_to_one)
    if operators:
        shape = (None,) * network.output_axes if network.is_single else (None, len(names), None, None)
        data = with_operators(data, operators, shape)
    return with_only_metadata(data, texts)


def _sigmoid(network: OnnxNetwork) -> list[Operator]:
    """Return a sigmoid if the output is not a probability yet: scores leave 0…1 on an image of random colors."""
    height, width = network.tile_hw
    noise = np.random.default_rng(_SEED).integers(0, 256, (height, width, 3), dtype=np.uint8)
    outputs = network.run([noise])
    if outputs.min() >= 0 and outputs.max() <= 1:
        return []
    return [Operator("Cast", {"to": FLOAT}), Operator("Sigmoid")]


def _merged(classes: Sequence[str], names: Sequence[str], are_probabilities: bool) -> list[Operator]:
    """Return operators from (N, C, H, W) outputs to (N, K, H, W) probabilities; none if each output is a class."""
    if len(names) == len(classes):
        return []
    used = [channel for channel, name in enumerate(classes) if name]
    matrix = np.array([[classes[channel] == name for name in names] for channel in used], np.float32)
    # The softmax of logarithms is the probability among the outputs that are used.
    logarithm = [Operator("Add", constant=_LEAST_PROBABILITY.reshape(1)), Operator("Log")] if are_probabilities else []
    return [
        Operator("Cast", {"to": FLOAT}),
        Operator("Gather", {"axis": 1}, np.array(used, np.int64)),
        # Up to opset 12, a softmax is along all axes from the stated one on, so the classes are the last axis.
        Operator("Transpose", {"perm": (0, 2, 3, 1)}),
        *logarithm,
        Operator("Softmax", {"axis": 3}),
        Operator("MatMul", constant=matrix),
        Operator("Transpose", {"perm": (0, 3, 1, 2)}),
    ]


def _metadata(facts: NetworkFacts, names: Sequence[str]) -> dict[str, str]:
    """Return metadata by key."""
    card = {"name": facts.name, "license": facts.license}
    found = {
        "model_type": "Segmentor",
        "class_names": {str(number): name for number, name in enumerate(names)},
        "resolution": round(100 * facts.resolution_m, 4),
        "standardization_mean": list(facts.mean),
        "standardization_std": list(facts.std),
        "seg_thresh": facts.threshold,
        CARD: {key: text for key, text in card.items() if text},
    }
    return {key: text if isinstance(text, str) else json.dumps(text) for key, text in found.items()}
