"""Networks of others: copy an ONNX file with the metadata that SemRef reads, and merge its outputs to classes.

A class can have several outputs: its probability is the sum of theirs, after a softmax over all outputs that are used.
Outputs of a single class get a sigmoid, if they are not probabilities yet. Both become operators of the copy, so its
reader needs no second form of metadata, and Deepness runs the copy, too (docs/reference/networks.md).
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from ..errors import ModelError
from .metadata import read_classes
from .model_card import KEY as CARD
from .model_card import card_of_texts
from .network import OnnxNetwork
from .network_facts import NetworkFacts, require_facts
from .onnx_file import GRAPH, field_of, fields, header_of, parts, with_only_metadata

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


_NODE, _NAME, _OUTPUT = 1, 1, 12
_TYPES = {"float32": 1, "int64": 7}
"""ONNX's numbers of types."""

FLOAT = _TYPES["float32"]
_INT, _INTS, _TENSOR = 2, 7, 4
"""ONNX's numbers of types of attributes."""


@dataclass(frozen=True)
class Operator:
    """An operator with one output.

    Attributes:
        name: In ONNX. Its meaning must be the same in all versions (opset).
        attributes: By name.
        constant: Second input; None without one. float32 or int64.
    """

    name: str
    attributes: Mapping[str, int | Sequence[int]] = field(default_factory=dict)
    constant: np.ndarray | None = None


def with_operators(data: bytes, operators: Sequence[Operator], shape: Sequence[int | None]) -> bytes:
    """Return an ONNX file whose output is the result of operators that are applied one after another to its output.

    Args:
        data: Bytes of a file that ``read_header`` accepts, with one output.
        operators: Not empty; the last one returns float32.
        shape: Of the new output; None for sizes that vary.
    """
    prefix = next(f"semref{n}_" for n in range(len(data)) if f"semref{n}_".encode() not in data)
    model = list(parts(memoryview(data)))
    graph = next(value for number, value, _ in model if number == GRAPH and isinstance(value, memoryview))
    output = next(value for number, value, _ in parts(graph) if number == _OUTPUT and isinstance(value, memoryview))
    name = dict(fields(output))[_NAME]
    last = b"" if isinstance(name, int) else bytes(name)
    nodes = []
    for count, operator in enumerate(operators):
        result, inputs = f"{prefix}{count}".encode(), [last]
        if operator.constant is not None:
            inputs.append(result + b"_constant")
            nodes.append(_node("Constant", [], inputs[1], _tensor_attribute(operator.constant)))
        nodes.append(_node(operator.name, inputs, result, *(_attribute(*one) for one in operator.attributes.items())))
        last = result
    kept = [part for number, _, part in parts(graph) if number != _OUTPUT]
    changed = b"".join([*kept, *(field_of(_NODE, node) for node in nodes), field_of(_OUTPUT, _value(last, shape))])
    return b"".join(field_of(GRAPH, changed) if number == GRAPH else part for number, _, part in model)


def _node(operator: str, inputs: Sequence[bytes], output: bytes, *attributes: bytes) -> bytes:
    """Return a NodeProto: input 1, output 2, operator 4, attribute 5."""
    named = b"".join(field_of(1, name) for name in inputs)
    return named + field_of(2, output) + field_of(4, operator.encode()) + b"".join(field_of(5, a) for a in attributes)


def _attribute(name: str, value: int | Sequence[int]) -> bytes:
    """Return an AttributeProto: name 1, i 3, ints 8, type 20."""
    if isinstance(value, int):
        return field_of(1, name.encode()) + field_of(3, value) + field_of(20, _INT)
    return field_of(1, name.encode()) + b"".join(field_of(8, one) for one in value) + field_of(20, _INTS)


def _tensor_attribute(values: np.ndarray) -> bytes:
    """Return the attribute of an operator Constant: a TensorProto (dims 1, data_type 2, raw_data 9) as t 5."""
    sizes = b"".join(field_of(1, size) for size in values.shape)
    raw = values.astype(values.dtype.newbyteorder("<")).tobytes()
    tensor = sizes + field_of(2, _TYPES[values.dtype.name]) + field_of(9, raw)
    return field_of(1, b"value") + field_of(5, tensor) + field_of(20, _TENSOR)


def _value(name: bytes, shape: Sequence[int | None]) -> bytes:
    """Return a ValueInfoProto: name 1, type 2 with tensor_type 1 of elem_type 1 and shape 2."""
    sizes = b"".join(field_of(1, b"" if size is None else field_of(1, size)) for size in shape)
    return field_of(1, name) + field_of(2, field_of(1, field_of(1, FLOAT) + field_of(2, sizes)))
