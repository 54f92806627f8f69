import numpy as np
import pytest
from made_models import brightest_color, metadata, write_model, writer

from semref.core.labels.image_source import ArrayImage, MaskedImage
from semref.core.segmentation import grid_means
from semref.core.segmentation.certainty import NO_DATA, Certainty, Sureness, are_probabilities, percents, softmax
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.photo_labels import ScoreShares
from semref.core.segmentation.tiling import SegmentedRows, segment
from semref.core.steps import result_of

VALUES = (1, 2, 3)
ALL = Certainty(of_label=True, of_each=True)


@pytest.fixture
def made(tmp_path):
    """`made(network, **metadata)` opens a model with that network."""

    def make(network=None, **more):
        return SegmentationModel(str(write_model(tmp_path / "m.onnx", network, metadata=metadata(**more))), 1)

    return make


def ended_by(kind: str, network=None) -> writer.Network:
    """Return the brightest-color network with another last layer."""
    network = network or brightest_color()
    network.add(kind, **({"axis": 1} if kind == "Softmax" else {}))
    return network


def segmented(model, image, overlap=0.25, wanted=ALL):
    """Return (labels, percent of the label, percent of each class) of an image."""
    rows = [rows for _, rows in segment(model, image, VALUES, overlap, wanted) if rows is not None]
    labels = np.concatenate([r.labels_hw for r in rows])
    return labels, np.concatenate([r.percent_hw for r in rows]), np.concatenate([r.percents_chw for r in rows], axis=1)


def photo(shape=(150, 190), seed=1):
    return np.random.default_rng(seed).integers(0, 256, (*shape, 3)).astype(np.uint8)


@pytest.mark.parametrize("overlap", [0, 0.25, 0.6])
@pytest.mark.parametrize("shape", [(150, 190), (64, 64), (40, 300), (64, 65)])
def test_scores_become_the_softmax_whatever_the_tiles(made, overlap, shape):
    image = photo(shape)
    labels, percent, each = segmented(made(), ArrayImage(image), overlap)
    standardized = (image.astype(np.float32) / 255 - 0.5) / 0.5
    # Red, blue and green, standardized by the metadata.
    wanted = softmax(np.moveaxis(standardized[:, :, [0, 2, 1]], 2, 0)) * 100
    np.testing.assert_allclose(each, wanted, atol=0.51)
    np.testing.assert_array_equal(percent, each.max(axis=0))
    is_alone = (each == each.max(axis=0)).sum(axis=0) == 1
    np.testing.assert_array_equal(labels[is_alone], (each.argmax(axis=0) + 1)[is_alone])


def test_scores_are_divided_by_the_temperature_that_the_model_states(made):
    scores = np.random.default_rng(1).normal(0, 3, (3, 5, 6)).astype(np.float32)
    model = made(temperature=2.5)
    assert model.temperature == 2.5
    np.testing.assert_allclose(model.probabilities(scores), softmax(scores / 2.5), rtol=1e-5)
    np.testing.assert_array_equal(made().probabilities(scores), softmax(scores))
    assert made(ended_by("Softmax"), temperature=2.5).temperature is None


def test_probabilities_of_a_network_are_used_unchanged(made):
    image = photo()
    scores, probabilities = (segmented(made(network), ArrayImage(image)) for network in (None, ended_by("Softmax")))
    np.testing.assert_array_equal(scores[0], probabilities[0])
    assert np.abs(scores[2].astype(int) - probabilities[2]).max() <= 1


@pytest.mark.parametrize("threshold", [0.2, 0.5, 0.8])
def test_one_probability_gives_its_class_and_the_rest(made, threshold):
    kernel = np.zeros((1, 3, 1, 1), np.float32)
    kernel[0, 0] = 1
    network = ended_by("Sigmoid", writer.Network().convolution(kernel, np.zeros(1)))
    model = made(network, class_names=["building"], seg_thresh=threshold)
    image = photo()
    rows = [rows for _, rows in segment(model, ArrayImage(image), (0, 1), 0.25, ALL) if rows is not None]
    labels, percent = (np.concatenate([getattr(r, name) for r in rows]) for name in ("labels_hw", "percent_hw"))
    probability = 1 / (1 + np.exp(-(image[:, :, 0] / 127.5 - 1)))
    sure = np.abs(probability - threshold) > 1e-4
    np.testing.assert_array_equal(labels[sure], (probability > threshold)[sure])
    np.testing.assert_allclose(percent[sure], 100 * np.where(labels, probability, 1 - probability)[sure], atol=0.51)


def test_where_nothing_was_looked_at_there_is_no_percent(made):
    has_data = np.ones((150, 190), bool)
    has_data[:70, :80] = False
    labels, percent, each = segmented(made(), ArrayImage(photo(), has_data))
    np.testing.assert_array_equal(labels == 0, ~has_data)
    np.testing.assert_array_equal(percent == NO_DATA, ~has_data)
    np.testing.assert_array_equal((each == NO_DATA).all(axis=0), ~has_data)


@pytest.mark.parametrize("overlap", [0, 0.25])
def test_how_sure_the_network_is_is_the_mean_percent_of_the_labels(made, overlap):
    has_data = np.ones((150, 190), bool)
    has_data[:70, :80] = False
    image = ArrayImage(photo(), has_data)
    rows = [rows for _, rows in segment(made(), image, VALUES, overlap) if rows is not None]
    sure = Sureness()
    for one in rows:
        sure.add(one.sure)
    percent = segmented(made(), image, overlap)[1]
    assert 100 * sure.mean == pytest.approx(percent[has_data].mean(), abs=3)
    assert 60 < sure.count < 130  # about 1 of 256 of the pixels that have data


def test_a_network_that_gives_only_classes_has_no_certainty(tmp_path):
    network = brightest_color().add("ArgMax", axis=1, keepdims=0).add("Cast", to=writer.FLOAT)
    path = write_model(tmp_path / "m.onnx", network, metadata=metadata(), output_shape=(1, "height", "width"))
    model = SegmentationModel(str(path), 1)
    rows = [r for _, r in segment(model, ArrayImage(photo()), VALUES, 0.25) if r is not None]
    assert all(one.sure.mean is None for one in rows)


def test_probabilities_are_known_by_their_sums():
    even = np.full((1, 4, 2, 2), 0.25, np.float32)
    assert are_probabilities(even) and are_probabilities(even.astype(np.float16))
    assert not are_probabilities(even + 0.01) and not are_probabilities(even - np.float32(0.5))


class Corner:
    """Mask of the pixels above a slanting line."""

    def read(self, column, row, width, height):
        rows, columns = np.mgrid[row : row + height, column : column + width]
        return rows + columns < 120


def test_a_mask_leaves_out_the_outside_and_changes_nothing_inside(made, monkeypatch):
    model, image = made(brightest_color(15)), ArrayImage(photo((150, 400)))
    labels, percent, _ = segmented(model, image)
    given = []
    scores = model.scores
    monkeypatch.setattr(model, "scores", lambda images: given.append(len(images)) or scores(images))
    found, found_percent, _ = segmented(model, MaskedImage(image, Corner()))
    inside = Corner().read(0, 0, 400, 150)
    np.testing.assert_array_equal(found, np.where(inside, labels, 0))
    np.testing.assert_array_equal(found_percent, np.where(inside, percent, NO_DATA))
    assert sum(given) < 3 * 9 / 2


def test_pixels_outside_a_mask_are_not_read():
    class Unread:
        shape_hw = 500, 500

        def read(self, *_):
            raise AssertionError("read")

    pixels, has_data = MaskedImage(Unread(), Corner()).read(300, 300, 64, 64)
    assert not pixels.any() and not has_data.any()


SHARED_VALUES = (3, 0, 7, 3)
"""Two channels of class 3, one without a class."""


@pytest.fixture
def seen():
    return percents(np.moveaxis(np.random.default_rng(3).dirichlet(np.ones(4), (60, 90)), 2, 0))


def added(seen, size_wh, bands):
    sums = ScoreShares(SHARED_VALUES, seen.shape[1:], size_wh)
    for first, last in zip(bands[:-1], bands[1:]):
        part = seen[:, first:last]
        sums.add(SegmentedRows(first, np.ones(part.shape[1:], np.uint8), percents_chw=part))
    return sums.found()


def test_shares_are_means_of_the_softmax_over_each_pixel_of_the_grid(seen):
    found = added(seen, (15, 12), [0, 60])
    assert found.values.tolist() == [3, 7]
    # Means of the probabilities of classes 3 and 7 over blocks of whole pixels.
    planes = np.stack([seen[0] / 100 + seen[3] / 100, seen[2] / 100], axis=2)
    wanted = planes.reshape(12, 5, 15, 6, 2).mean(axis=(1, 3))
    np.testing.assert_allclose(found.shares / 255, wanted, atol=0.6 / 255)


@pytest.mark.parametrize("size_wh", [(15, 12), (90, 60), (37, 23), (1, 1)])
def test_rows_in_any_bands_give_the_same(seen, size_wh):
    whole = added(seen, size_wh, [0, 60]).shares.astype(int)
    parts = added(seen, size_wh, [0, 1, 13, 14, 37, 60]).shares.astype(int)
    assert whole.shape == (size_wh[1], size_wh[0], 2)
    assert np.abs(whole - parts).max() <= 1


def test_pixels_without_data_are_unknown(seen):
    seen[:, :30] = NO_DATA
    sums = ScoreShares((1, 2, 3, 4), (60, 90), (1, 2))
    sums.add(SegmentedRows(0, np.ones((60, 90), np.uint8), percents_chw=seen))
    shares = sums.found().shares.astype(int).sum(axis=2)
    assert shares[0, 0] == 0 and abs(shares[1, 0] - 255) <= 3


def test_labels_without_percents_count_as_certain():
    labels = np.repeat([[1, 1, 2, 0]], 4, axis=0).astype(np.uint8)
    sums = ScoreShares((1, 2), (4, 4), (2, 2))
    sums.add(SegmentedRows(0, labels))
    assert sums.found().shares.tolist() == [[[255, 0], [0, 128]]] * 2


def test_a_picture_has_the_means_of_the_photos_pixels(monkeypatch):
    photo = np.random.default_rng(4).integers(0, 256, (60, 90, 3), np.uint8)
    monkeypatch.setattr(grid_means, "BAND_ROWS", 7)
    found = result_of(grid_means.picture_steps(ArrayImage(photo), (15, 12)))
    np.testing.assert_allclose(found, photo.reshape(12, 5, 15, 6, 3).mean(axis=(1, 3)), atol=0.51)
