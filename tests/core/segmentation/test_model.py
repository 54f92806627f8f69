import sys
from concurrent.futures import CancelledError
from threading import Event

import numpy as np
import pytest
from made_models import NAMES, brightest_color, metadata, painted, smallest_model, write_model, writer

from semref.core.errors import ModelError
from semref.core.labels.class_table import class_table_from_csv
from semref.core.segmentation.model import SegmentationModel, averaged_scores

LABELS = np.random.default_rng(2).integers(1, 4, (64, 64)).astype(np.uint8)
PHOTO = painted(LABELS)
GOING_ON = Event()


@pytest.fixture
def load(tmp_path):
    """`load(network, **options)` writes a model and loads it; `classes` may be a class table."""

    def run(network=None, table=None, **options):
        return SegmentationModel(str(write_model(tmp_path / "m.onnx", network, **options)), 1, table)

    return run


def seen_by(model, photo=PHOTO):
    """Return (H, W) class values: the channel with the highest score."""
    scores = model.scores([photo])[0]
    return np.array(model.classes.values)[scores.argmax(0)]


def test_the_highest_score_is_the_class(load):
    model = load()
    np.testing.assert_array_equal(seen_by(model), LABELS)
    assert (model.tile_hw, model.classes.names, model.notes) == ((64, 64), NAMES, [])
    assert model.device.provider.endswith("ExecutionProvider")


def test_images_are_standardized_as_the_model_was_trained(load):
    network = writer.Network().convolution(np.eye(3).reshape(3, 3, 1, 1), np.zeros(3))
    model = load(network, metadata=metadata(standardization_mean=[0.1, 0.2, 0.3], standardization_std=[0.5, 1, 2]))
    wanted = (PHOTO / 255 - (0.1, 0.2, 0.3)) / (0.5, 1, 2)
    np.testing.assert_allclose(np.moveaxis(model.scores([PHOTO])[0], 0, 2), wanted, atol=1e-6)


def test_fixed_sizes_override_the_metadata_with_a_note(load):
    model = load(size=(32, 48))
    assert model.tile_hw == (32, 48)
    assert "tile_size in the model's metadata is 64, but the network takes 48 × 32" in str(model.notes[0])


@pytest.mark.parametrize("keep", [0, 1])
def test_class_numbers_are_taken_as_they_are(load, keep):
    network = brightest_color().add("ArgMax", axis=1, keepdims=keep)
    shape = (1, *((1,) if keep else ()), "height", "width")
    np.testing.assert_array_equal(seen_by(load(network, output_shape=shape, output_type=writer.INT64)), LABELS)


def test_class_numbers_as_floats_are_taken_when_there_are_more_than_two_classes(load):
    network = brightest_color().add("ArgMax", axis=1, keepdims=0).add("Cast", to=writer.FLOAT)
    np.testing.assert_array_equal(seen_by(load(network, output_shape=(1, "height", "width"))), LABELS)


@pytest.mark.parametrize(("threshold", "share"), [(None, 0.5), (0.25, 0.25), (0.9, 0.9)])
@pytest.mark.parametrize("flat", [False, True])
def test_a_single_probability_counts_from_its_threshold_on(load, threshold, share, flat):
    kernels = np.zeros((1, 3, 1, 1))
    kernels[0, 0] = 1
    network, shape = writer.Network().convolution(kernels, np.zeros(1)), (1, 1, "height", "width")
    if flat:
        axes = network.weight("axes", np.array([1], np.int64))
        network.add("Squeeze", network.last, axes)
        shape = (1, "height", "width")
    more = metadata(
        class_names={"0": "building"}, seg_thresh=threshold, standardization_mean=None, standardization_std=None
    )
    photo = np.zeros((64, 64, 3), np.uint8)
    photo[..., 0] = np.arange(0, 256, 4)
    found = seen_by(load(network, output_shape=shape, metadata=more), photo)
    np.testing.assert_array_equal(found, photo[..., 0] / 255 > share)


def test_a_class_table_names_the_channels_of_a_model_that_does_not(load):
    table = class_table_from_csv("value,name\n10,a\n20,b\n30,c\n")
    np.testing.assert_array_equal(seen_by(load(table=table, metadata=metadata(class_names=None))), LABELS * 10)


WHOLE = smallest_model()
CUT = [WHOLE[: int(len(WHOLE) * share)] for share in (0.1, 0.5, 0.9)]


@pytest.mark.parametrize("content", [b"", b"hello", b"\x08\x08", bytes(range(256)) * 40, *CUT], ids=range(7))
def test_a_file_that_is_no_model_or_is_cut_short_is_refused(tmp_path, content):
    path = tmp_path / "m.onnx"
    path.write_bytes(content)
    with pytest.raises(ModelError, match="m.onnx is not an ONNX model, or it is damaged"):
        SegmentationModel(str(path), 1)


def test_a_file_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(ModelError, match="none.onnx does not exist; choose a model file"):
        SegmentationModel(str(tmp_path / "none.onnx"), 1)


@pytest.mark.parametrize(
    ("network", "options", "message"),
    [
        (brightest_color(bands=4), {"input_shape": (1, 4, "h", "w")}, "takes input of the shape 1 × 4 × any × any"),
        (brightest_color(), {"batch": 8}, "takes 8 images at once"),
        (brightest_color().add("Frobnicate"), {}, "can't be run by onnxruntime"),
        (
            writer.Network().convolution(np.ones((3, 3, 3, 3)), np.zeros(3), stride=2),
            {"output_shape": (1, 3, "h", "w")},
            "outputs the shape 1 × 3 × 32 × 32 for an image of 64 × 64",
        ),
        (brightest_color().add("Flatten"), {"output_shape": (1, "n")}, "outputs the shape 1 × 12288"),
        (brightest_color(), {"metadata": metadata(class_names=["a", "b"])}, "outputs 3 classes"),
        (brightest_color(external="weights.bin"), {}, "are in another file, which is missing"),
        (None, {"ir_version": 99}, "can't be run by onnxruntime .*99"),
        (None, {"opset": 99}, "can't be run by onnxruntime .*99"),
    ],
)
def test_networks_that_do_not_segment_are_refused(load, network, options, message):
    with pytest.raises(ModelError, match=message):
        load(network, **options)


def test_values_that_are_no_numbers_and_class_numbers_beyond_the_names_are_refused(load):
    model = load(brightest_color().add("Sqrt"))
    with pytest.raises(ModelError, match=r"values that are not numbers \(NaN"):
        model.scores([PHOTO])
    network = brightest_color().add("ArgMax", axis=1, keepdims=0)
    names = metadata(class_names=["a", "b"])
    model = load(network, output_shape=(1, "height", "width"), output_type=writer.INT64, metadata=names)
    with pytest.raises(ModelError, match="outputs the class number 2, but names only 2 classes"):
        model.scores([PHOTO])


def test_a_missing_onnxruntime_is_reported_with_its_installation(load, monkeypatch):
    monkeypatch.setitem(sys.modules, "onnxruntime", None)
    with pytest.raises(ModelError, match="Segmentation needs the Python package onnxruntime .*pip install onnxruntime"):
        load()


class Shifting:
    """Network that returns the colors of an image, moved to the right and down, as shadows move what it sees."""

    def __init__(self, tile_hw, right=1, down=2):
        self.tile_hw, self._moved, self.seen = tile_hw, (down, right), 0

    def scores(self, images):
        assert {image.shape[:2] for image in images} == {self.tile_hw} and all(i.flags.c_contiguous for i in images)
        self.seen += len(images)
        moved = [np.roll(image, self._moved, axis=(0, 1)) for image in images]
        return np.stack(moved).transpose(0, 3, 1, 2).astype(np.float32)


def images(height, width):
    return list(np.random.default_rng(3).integers(0, 255, (2, height, width, 3)).astype(np.uint8))


@pytest.mark.parametrize(("tile_hw", "count"), [((16, 16), 8), ((12, 20), 4)])
def test_a_tile_in_each_orientation_has_the_same_average(tile_hw, count):
    model, (first, second) = Shifting(tile_hw), images(*tile_hw)
    whole = averaged_scores(model, [first, second], GOING_ON)
    assert whole.shape == (2, 3, *tile_hw) and whole.dtype == np.float32 and model.seen == 2 * count
    turned = averaged_scores(model, [np.ascontiguousarray(first[::-1, ::-1])], GOING_ON)
    np.testing.assert_allclose(turned[0], whole[0, :, ::-1, ::-1], rtol=1e-6)
    mirrored = averaged_scores(model, [np.ascontiguousarray(second[:, ::-1])], GOING_ON)
    np.testing.assert_allclose(mirrored[0], whole[1, :, :, ::-1], rtol=1e-6)


def test_errors_that_depend_on_a_direction_average_out_and_a_network_without_them_gives_its_own_scores():
    image = np.zeros((16, 16, 3), np.uint8)
    image[8, 4] = 255
    found = averaged_scores(Shifting((16, 16)), [image], GOING_ON)[0, 0]
    rows, columns = np.indices(found.shape)
    center = (found * rows).sum() / found.sum(), (found * columns).sum() / found.sum()
    assert center == pytest.approx((8, 4))
    model, tiles = Shifting((12, 20), 0, 0), images(12, 20)
    np.testing.assert_array_equal(averaged_scores(model, tiles, GOING_ON), model.scores(tiles))


def test_it_stops_between_two_orientations():
    model, stop = Shifting((12, 20)), Event()
    model.scores = lambda images: stop.set() or np.zeros((1, 3, 12, 20), np.float32)
    with pytest.raises(CancelledError):
        averaged_scores(model, images(12, 20)[:1], stop)
