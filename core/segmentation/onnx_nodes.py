"""Append operators to the output of an ONNX file, without the package onnx: the file is protobuf (``onnx_file``)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from .onnx_file import GRAPH, field_of, fields, parts

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
