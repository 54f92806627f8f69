"""The header of an ONNX file, read without onnx."""

import numpy as np
import pytest
from made_models import smallest_model

from semref.core.segmentation.onnx_file import read_header


@pytest.mark.parametrize("content", [b"", b"\x08\x08", b"no model at all", b"\xff" * 40, b"\x3a\x7f"])
def test_what_is_no_model_has_no_header(content):
    assert read_header(content) is None


def test_any_bytes_are_read_or_refused():
    random = np.random.default_rng(3)
    whole = smallest_model()
    for _ in range(2000):
        changed = bytearray(whole)
        changed[random.integers(len(whole))] = random.integers(256)
        read_header(bytes(changed[: random.integers(len(whole) + 1)]))


def test_weights_that_are_not_beside_the_model_are_named(tmp_path):
    onnx = pytest.importorskip("onnx")
    weights = onnx.TensorProto(name="w", dims=[1], data_type=1, data_location=1)
    for key, value in (("location", "weights.bin"), ("offset", "0")):
        weights.external_data.add(key=key, value=value)
    graph = onnx.GraphProto(name="g", initializer=[weights])
    header = read_header(onnx.ModelProto(ir_version=8, graph=graph).SerializeToString())
    assert header.missing_weights(str(tmp_path / "m.onnx")) == "weights.bin"
    (tmp_path / "weights.bin").write_bytes(b"1234")
    assert header.missing_weights(str(tmp_path / "m.onnx")) == ""


def enlarging(mode):
    """Return a file with a network that only enlarges; ``mode`` selects aligned corners or centers."""
    onnx = pytest.importorskip("onnx")
    nodes = [onnx.helper.make_node("Relu", ["x"], ["y"])]
    nodes += [onnx.helper.make_node("Resize", ["y"], ["z"], mode="linear", coordinate_transformation_mode=mode)]
    return onnx.ModelProto(ir_version=8, graph=onnx.GraphProto(name="g", node=nodes)).SerializeToString()


def test_a_network_that_enlarges_with_aligned_corners_is_known_by_its_file():
    assert read_header(enlarging("align_corners")).aligns_corners
    assert not read_header(enlarging("half_pixel")).aligns_corners
    assert not read_header(enlarging("pytorch_half_pixel")).aligns_corners
