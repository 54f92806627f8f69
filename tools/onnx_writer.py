"""Small ONNX files for tests and benchmarks, written without the onnx package (which not every QGIS's Python has).

A model is protobuf: messages of (field number, value). Numbers of fields and types are those of onnx.proto3.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass, field
from typing import List, Mapping, Sequence, Union

import numpy as np

IR_VERSION, OPSET = 8, 13
FLOAT, INT64, FLOAT16 = 1, 7, 10
_TYPES = {"float32": FLOAT, "int64": INT64, "float16": FLOAT16, "uint8": 2}

Size = Union[int, str]
"""A fixed size, or the name of one that is open."""


@dataclass
class Network:
    """Nodes and weights of a network with the input “image” and the output that its last node writes."""

    nodes: List[bytes] = field(default_factory=list)
    weights: List[bytes] = field(default_factory=list)
    last: str = "image"

    def add(self, operator: str, *inputs: str, **attributes) -> "Network":
        """Applies an ONNX operator to what came last (or to the inputs named) and to further named inputs."""
        output = f"{operator.lower()}_{len(self.nodes)}"
        names = inputs or (self.last,)
        body = b"".join(_bytes(1, name.encode()) for name in names) + _bytes(2, output.encode())
        body += _bytes(3, output.encode()) + _bytes(4, operator.encode())
        self.nodes.append(body + b"".join(_bytes(5, _attribute(*item)) for item in sorted(attributes.items())))
        self.last = output
        return self

    def weight(self, name: str, values: np.ndarray, external: str = "") -> str:
        """Keeps an array under a name; with ``external`` the model only says that it lies in that file."""
        body = b"".join(_number(1, size) for size in values.shape) + _number(2, _TYPES[str(values.dtype)])
        body += _bytes(8, name.encode())
        if external:
            body += _bytes(13, _bytes(1, b"location") + _bytes(2, external.encode())) + _number(14, 1)
        else:
            body += _bytes(9, np.ascontiguousarray(values).tobytes())
        self.weights.append(body)
        return name

    def convolution(self, kernels: np.ndarray, bias: np.ndarray, stride: int = 1, external: str = "") -> "Network":
        """A convolution with (out, in, k, k) kernels and zeros around the image."""
        number, half = len(self.nodes), kernels.shape[2] // 2
        weight = self.weight(f"kernels_{number}", kernels.astype(np.float32), external)
        offset = self.weight(f"bias_{number}", bias.astype(np.float32))
        return self.add("Conv", self.last, weight, offset, pads=[half] * 4, strides=[stride] * 2)


def model_bytes(
    network: Network,
    input_shape: Sequence[Size],
    output_shape: Sequence[Size],
    metadata: Mapping[str, str],
    output_type: int = FLOAT,
    input_type: int = FLOAT,
    ir_version: int = IR_VERSION,
    opset: int = OPSET,
) -> bytes:
    """The file's content."""
    graph = b"".join(_bytes(1, node) for node in network.nodes) + _bytes(2, b"network")
    graph += b"".join(_bytes(5, weight) for weight in network.weights)
    graph += _bytes(11, _value("image", input_type, input_shape))
    graph += _bytes(12, _value(network.last, output_type, output_shape))
    properties = [_bytes(1, key.encode()) + _bytes(2, value.encode()) for key, value in metadata.items()]
    model = _number(1, ir_version) + _bytes(7, graph) + _bytes(8, _bytes(1, b"") + _number(2, opset))
    return model + b"".join(_bytes(14, item) for item in properties)


def _value(name: str, kind: int, shape: Sequence[Size]) -> bytes:
    sizes = [_number(1, size) if isinstance(size, int) else _bytes(2, size.encode()) for size in shape]
    tensor = _number(1, kind) + _bytes(2, b"".join(_bytes(1, size) for size in sizes))
    return _bytes(1, name.encode()) + _bytes(2, _bytes(1, tensor))


def _attribute(name: str, value) -> bytes:
    head = _bytes(1, name.encode())
    if isinstance(value, float):
        return head + _key(2, 5) + struct.pack("<f", value) + _number(20, 1)
    if isinstance(value, int):
        return head + _number(3, value) + _number(20, 2)
    if isinstance(value, str):
        return head + _bytes(4, value.encode()) + _number(20, 3)
    return head + b"".join(_number(8, number) for number in value) + _number(20, 7)


def _key(number: int, wire: int) -> bytes:
    return _varint(number << 3 | wire)


def _number(number: int, value: int) -> bytes:
    return _key(number, 0) + _varint(value)


def _bytes(number: int, content: bytes) -> bytes:
    return _key(number, 2) + _varint(len(content)) + content


def _varint(value: int) -> bytes:
    value &= (1 << 64) - 1
    found = bytearray()
    while value > 0x7F:
        found.append(value & 0x7F | 0x80)
        value >>= 7
    found.append(value)
    return bytes(found)
