"""Write small ONNX files for tests and benchmarks with the helpers of the onnx package."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Union

import numpy as np
from onnx import NodeProto, TensorProto, helper, numpy_helper

IR_VERSION, OPSET = 8, 13
FLOAT, INT64, FLOAT16 = TensorProto.FLOAT, TensorProto.INT64, TensorProto.FLOAT16

Size = Union[int, str]
"""A fixed size, or the name of a variable size."""


@dataclass
class Network:
    """Nodes and weights of a network with the input “image” and the output of its last node."""

    nodes: list[NodeProto] = field(default_factory=list)
    weights: list[TensorProto] = field(default_factory=list)
    last: str = "image"

    def add(self, operator: str, *inputs: str, **attributes: Any) -> Network:
        """Apply an ONNX operator to the last output, or to the given inputs."""
        output = f"{operator.lower()}_{len(self.nodes)}"
        self.nodes.append(helper.make_node(operator, inputs or (self.last,), [output], name=output, **attributes))
        self.last = output
        return self

    def weight(self, name: str, values: np.ndarray, external: str = "") -> str:
        """Add an array with a name; with ``external`` the model refers to that file for its data."""
        tensor = numpy_helper.from_array(values, name)
        if external:
            tensor.ClearField("raw_data")
            tensor.data_location = TensorProto.EXTERNAL
            tensor.external_data.add(key="location", value=external)
        self.weights.append(tensor)
        return name

    def convolution(self, kernels: np.ndarray, bias: np.ndarray, stride: int = 1, external: str = "") -> Network:
        """Add a convolution with (out, in, k, k) kernels and zeros around the image."""
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
    """Return the content of the file."""
    image = helper.make_tensor_value_info("image", input_type, input_shape)
    found = helper.make_tensor_value_info(network.last, output_type, output_shape)
    graph = helper.make_graph(network.nodes, "network", [image], [found], network.weights)
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", opset)], ir_version=ir_version)
    helper.set_model_props(model, dict(metadata))
    return model.SerializeToString()
