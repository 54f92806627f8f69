import numpy as np
import pytest
from made_models import brightest_color, metadata, smallest_model, write_model, writer
from onnx import TensorProto, helper

from semref.core.errors import ModelError
from semref.core.segmentation import onnx_file
from semref.core.segmentation.class_bias import read_class_bias
from semref.core.segmentation.metadata import read_classes, read_settings
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.onnx_file import read_header


def refusal(path) -> str:
    with pytest.raises(ModelError) as refused:
        SegmentationModel(str(path), 1)
    text = str(refused.value)
    assert "\n" not in text and len(text) < 1000, text
    return text


@pytest.mark.parametrize(
    ("network", "shape"),
    [
        (brightest_color().add("ReduceSum", keepdims=0), ()),
        (brightest_color().add("Flatten", axis=0).add("Squeeze"), ("n",)),
        (brightest_color().add("Shape"), (4,)),
    ],
)
def test_an_output_that_is_no_picture_is_refused(tmp_path, network, shape):
    kind = TensorProto.INT64 if shape == (4,) else TensorProto.FLOAT
    path = write_model(tmp_path / "odd.onnx", network, output_shape=shape, output_type=kind)
    assert "outputs the shape" in refusal(path)


def test_a_sequence_of_outputs_and_texts_as_output_are_refused(tmp_path):
    image = helper.make_tensor_value_info("image", TensorProto.FLOAT, (1, 3, "h", "w"))
    found = helper.make_tensor_sequence_value_info("list", TensorProto.FLOAT, None)
    node = helper.make_node("SequenceConstruct", ["image"], ["list"])
    graph = helper.make_graph([node], "network", [image], [found])
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 13)], ir_version=8)
    helper.set_model_props(model, metadata())
    (tmp_path / "odd.onnx").write_bytes(model.SerializeToString())
    assert "one array of numbers" in refusal(tmp_path / "odd.onnx")
    texts = {"output_type": TensorProto.STRING, "output_shape": (1, 3, "height", "width")}
    path = write_model(tmp_path / "odd.onnx", writer.Network().add("Cast", to=TensorProto.STRING), **texts)
    assert "one array of numbers" in refusal(path)


def test_a_huge_fixed_input_and_metadata_that_are_no_text_are_refused(tmp_path):
    path = write_model(tmp_path / "huge.onnx", size=(1 << 20, 1 << 20))
    assert "takes images of 1048576 × 1048576 pixels" in refusal(path)
    path = write_model(tmp_path / "odd.onnx")
    data = path.read_bytes()
    place = data.index(b"Segmentor")
    path.write_bytes(data[:place] + b"\xff\xfe" + data[place + 2 :])
    assert "not UTF-8 text" in refusal(path)


ODD = ["{(1,):2}", "[" * 99_999, "(" * 5000, "{1: {2: " * 3000, "1" * 5000, "1e400", "-", "{null: 1}", "\0", "9" * 9999]


@pytest.mark.parametrize("text", ODD, ids=range(len(ODD)))
@pytest.mark.parametrize(
    "key",
    [
        *("class_names", "class_values", "class_colors", "class_roles", "resolution", "tile_size"),
        *("standardization_std", "class_bias"),
    ],
)
def test_odd_metadata_are_refused_in_a_sentence(key, text):
    texts = {**metadata(), key: text}
    with pytest.raises(ModelError) as refused:
        read_settings(texts, "odd.onnx")
        read_class_bias(texts, read_classes(texts, 3, "odd.onnx").names, "odd.onnx")
    assert len(str(refused.value)) < 1000


def test_any_bytes_are_read_or_refused_and_what_is_no_model_has_no_header():
    for content in (b"", b"\x08\x08", b"no model at all", b"\xff" * 40, b"\x3a\x7f"):
        assert read_header(content) is None
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


def test_a_header_is_read_while_a_profiler_keeps_views_of_the_file(tmp_path, monkeypatch):
    kept = []
    monkeypatch.setattr(onnx_file, "_entry", lambda _, value: kept.append(value))
    assert onnx_file.header_of(str(write_model(tmp_path / "model.onnx"))) is not None and kept
