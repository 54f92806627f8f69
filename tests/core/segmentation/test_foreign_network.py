import json
from dataclasses import replace

import numpy as np
import pytest
from made_models import brightest_color, write_model, writer

from semref.core.errors import ModelError
from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation.foreign_network import stated_facts, with_facts
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.model_card import read_card
from semref.core.segmentation.network import OnnxNetwork
from semref.core.segmentation.network_facts import BUILDINGS, FLAIR, NetworkFacts
from semref.core.segmentation.onnx_file import read_header
from semref.core.segmentation.photo_labels import PhotoLabels

FACTS = NetworkFacts(("building", "water", "bare_land"), 0.25, (0.5,) * 3, (0.5,) * 3, "CC0", "Colors")
SIZE = 64
IMAGE = np.random.default_rng(5).integers(0, 256, (SIZE, SIZE, 3), np.uint8)
STANDARD = ((IMAGE / 255 - 0.5) / 0.5).transpose(2, 0, 1)


def bare(path, network=None, **options):
    """Write a network without metadata, as exporters do."""
    return str(write_model(path, network, metadata={}, size=(SIZE, SIZE), **options))


def copied(source, facts, tmp_path):
    (tmp_path / "copy.onnx").write_bytes(with_facts(OnnxNetwork(source, 1), facts))
    return SegmentationModel(str(tmp_path / "copy.onnx"), 1)


def named_labels(model) -> np.ndarray:
    """Return (H, W) class names of the image."""
    found = PhotoLabels(model, ArrayImage(IMAGE), model.classes.values).found()
    names = dict(zip(model.classes.values, model.classes.names))
    return np.vectorize(names.get)(found)


def refusal(source, facts, tmp_path) -> str:
    with pytest.raises(ModelError) as refused:
        copied(str(source), facts, tmp_path)
    text = str(refused.value)
    assert "\n" not in text and len(text) < 400
    return text


def test_a_copy_has_classes_resolution_license_and_the_same_labels(tmp_path):
    source = bare(tmp_path / "bare.onnx")
    model = copied(source, FACTS, tmp_path)
    expected = np.array(FACTS.classes)[STANDARD[[0, 2, 1]].argmax(0)]
    assert (named_labels(model) == expected).all()
    assert stated_facts(model) == FACTS
    card = read_card(model.path)
    assert (card.name, card.license, card.resolution_m) == ("Colors", "CC0", 0.25)
    assert card.classes == FACTS.classes


@pytest.mark.parametrize("opset", [9, 12, 13, 17])
def test_outputs_of_one_class_are_merged_by_the_sum_of_their_probabilities(tmp_path, opset):
    network = six_outputs()
    source = bare(tmp_path / "bare.onnx", network, opset=opset, classes=6)
    classes = "field", "trees", "field", "", "water", "trees"
    model = copied(source, replace(FACTS, classes=classes), tmp_path)
    scores = logits()
    used = [0, 1, 2, 4, 5]
    powers = np.exp(scores[used])
    sums = {name: sum(powers[n] for n, u in enumerate(used) if classes[u] == name) for name in classes if name}
    expected = np.array(list(sums))[np.stack(list(sums.values())).argmax(0)]
    assert (named_labels(model) == expected).all()
    # The sum decides at some pixels: without merging, another class would have the highest single score.
    assert (np.array(classes)[used][scores[used].argmax(0)] != expected).any()
    probabilities = model.probabilities(model.scores([IMAGE])[0])
    np.testing.assert_allclose(probabilities, np.stack(list(sums.values())) / powers.sum(0), atol=1e-5)


def six_outputs():
    kernels = np.random.default_rng(7).normal(size=(6, 3, 1, 1))
    return writer.Network().convolution(kernels, np.zeros(6))


def logits() -> np.ndarray:
    kernels = np.random.default_rng(7).normal(size=(6, 3, 1, 1)).astype(np.float32)[:, :, 0, 0]
    return np.einsum("cb,bhw->chw", kernels, STANDARD.astype(np.float32))


def test_probabilities_are_merged_without_a_second_softmax(tmp_path):
    source = bare(tmp_path / "bare.onnx", six_outputs().add("Softmax", axis=1), classes=6)
    model = copied(source, replace(FACTS, classes=("a", "b", "a", "", "b", "a")), tmp_path)
    powers = np.exp(logits())
    first, second = powers[[0, 2, 5]].sum(0), powers[[1, 4]].sum(0)
    np.testing.assert_allclose(model.scores([IMAGE])[0][0], first / (first + second), atol=1e-5)


def redness(bias: float):
    kernel = np.zeros((1, 3, 1, 1))
    kernel[0, 0] = 4
    return writer.Network().convolution(kernel, np.array([bias]))


@pytest.mark.parametrize("has_sigmoid", [False, True])
def test_a_single_output_becomes_a_probability_with_a_threshold(tmp_path, has_sigmoid):
    network = redness(0.5).add("Sigmoid") if has_sigmoid else redness(0.5)
    source = bare(tmp_path / "bare.onnx", network, classes=1)
    model = copied(source, replace(FACTS, classes=("building",), threshold=0.8), tmp_path)
    expected = 1 / (1 + np.exp(-(4 * STANDARD[0] + 0.5))) > 0.8
    assert 0 < expected.mean() < 1
    assert ((named_labels(model) == "building") == expected).all()


def test_a_single_output_without_an_axis_for_classes_gets_a_sigmoid_too(tmp_path):
    network = redness(0.0)
    network.add("Squeeze", network.last, network.weight("axes", np.array([1], np.int64)))
    source = bare(tmp_path / "bare.onnx", network, output_shape=(1, SIZE, SIZE))
    model = copied(source, replace(FACTS, classes=("building",)), tmp_path)
    assert ((named_labels(model) == "building") == (STANDARD[0] > 0)).all()


def test_old_metadata_of_the_classes_do_not_stay(tmp_path):
    more = {"class_colors": '{"0": "#000000"}', "temperature": "2", "tile_size": "64", "secret": "x"}
    source = str(write_model(tmp_path / "named.onnx", metadata=more, size=(SIZE, SIZE)))
    copied(source, FACTS, tmp_path)
    texts = read_header((tmp_path / "copy.onnx").read_bytes()).texts
    assert texts["tile_size"] == "64" and not {"class_colors", "temperature", "secret"} & set(texts)


def test_a_copy_of_a_copy_can_be_merged_again(tmp_path):
    source = bare(tmp_path / "bare.onnx", six_outputs(), classes=6)
    first = copied(source, replace(FACTS, classes=("a", "b", "a", "c", "b", "d")), tmp_path)
    assert stated_facts(first).classes == ("a", "b", "c", "d")
    again = copied(first.path, replace(FACTS, classes=("a", "b", "a", "b")), tmp_path)
    powers = np.exp(logits())
    share = powers[[0, 2, 3]].sum(0) / powers.sum(0)
    np.testing.assert_allclose(again.scores([IMAGE])[0][0], share, atol=1e-5)


def test_the_copy_is_a_file_that_onnx_accepts(tmp_path):
    onnx = pytest.importorskip("onnx")
    source = bare(tmp_path / "bare.onnx", six_outputs(), classes=6)
    copied(source, replace(FACTS, classes=("a", "b", "a", "", "b", "a")), tmp_path)
    model = onnx.load(tmp_path / "copy.onnx")
    onnx.checker.check_model(model, full_check=True)
    assert [size.dim_value for size in model.graph.output[0].type.tensor_type.shape.dim] == [0, 2, 0, 0]
    assert json.loads({p.key: p.value for p in model.metadata_props}["class_names"]) == {"0": "a", "1": "b"}


def test_the_preset_of_flair_uses_15_of_19_outputs_for_7_classes():
    assert len(FLAIR.classes) == 19 and len([name for name in FLAIR.classes if name]) == 15
    seven = "building", "bare land", "road", "water", "trees", "low vegetation", "field"
    assert tuple(dict.fromkeys(filter(None, FLAIR.classes))) == seven


def test_other_inputs_than_three_bands_first_are_refused(tmp_path):
    network = writer.Network().add("Transpose", perm=(0, 3, 1, 2))
    for shape in ((1, SIZE, SIZE, 3), ("n", "h", "w", 3)):
        last = write_model(tmp_path / "last.onnx", network, metadata={}, input_shape=shape)
        assert "it must be 1 × 3 × height × width" in refusal(last, FACTS, tmp_path)


def test_classes_that_do_not_match_and_missing_statements_are_refused(tmp_path):
    source = bare(tmp_path / "bare.onnx")
    text = refusal(source, replace(FACTS, classes=("a", "b")), tmp_path)
    assert "has 3 outputs, but there are 2 class names" in text
    assert "every pixel would have it" in refusal(source, replace(FACTS, classes=("a", "", "a")), tmp_path)
    assert "Enter the class of each output" in refusal(source, replace(FACTS, classes=("", "", "")), tmp_path)
    assert "bare.onnx: " in refusal(source, replace(FACTS, classes=("a" * 300, "b", "c")), tmp_path)
    assert "Enter the license" in refusal(source, replace(FACTS, license=" "), tmp_path)
    assert "Enter the resolution" in refusal(source, replace(FACTS, resolution_m=0.0), tmp_path)
    assert "three numbers" in refusal(source, replace(FACTS, std=(1.0, 0.0, 1.0)), tmp_path)
    assert "Enter the license" in refusal(source, BUILDINGS, tmp_path)


def test_class_numbers_and_weights_in_other_files_are_refused(tmp_path):
    network = brightest_color().add("ArgMax", axis=1)
    numbers = write_model(tmp_path / "numbers.onnx", network, metadata={}, output_type=writer.INT64, classes=1)
    assert "outputs class numbers" in refusal(numbers, FACTS, tmp_path)
    outside = write_model(tmp_path / "outside.onnx", brightest_color(external="weights.bin"), metadata={})
    kernels = np.zeros((3, 3, 1, 1), np.float32)
    (tmp_path / "weights.bin").write_bytes(kernels.tobytes())
    assert "are in another file (weights.bin)" in refusal(outside, FACTS, tmp_path)
    assert read_header((tmp_path / "outside.onnx").read_bytes()).weight_files == ("weights.bin",)
