import csv
import json

import cv2
import numpy as np
import pytest

from semref.core.errors import TrainingError
from semref.training import augment, class_bias, metrics, tiles

IGNORED = tiles.IGNORED


def blocks(size=96, edge=12):
    """Return labels 0 to 3 in blocks, and an image with a red and green value for each label."""
    values = np.random.default_rng(2).integers(0, 4, (size // edge, size // edge))
    labels = np.kron(values, np.ones((edge, edge))).astype(np.uint8)
    image = np.dstack([labels % 2, labels // 2, np.zeros_like(labels)]).astype(np.float32)
    return image, labels


@pytest.mark.parametrize("seed", range(12))
def test_the_labels_of_a_piece_stay_on_their_pixels_whatever_its_turn_and_scale(seed):
    image, labels = blocks()
    piece, marks = augment.random_piece(np.random.default_rng(seed), image, labels, 64)
    assert piece.shape == (64, 64, 3) and marks.shape == (64, 64)
    shown = np.rint(piece[..., 0]).astype(int) + 2 * np.rint(piece[..., 1]).astype(int)
    # On edges of blocks the image is blended; inside they must agree.
    blended = np.abs(piece - np.rint(piece)).max(axis=2) > 0.01
    counted = (cv2.dilate(blended.astype(np.uint8), np.ones((3, 3))) == 0) & (marks != IGNORED)
    assert counted.mean() > 0.15
    np.testing.assert_array_equal(marks[counted], shown[counted])


def test_beyond_the_tile_labels_are_ignored():
    image, labels = blocks(48)
    _, marks = augment.random_piece(np.random.default_rng(0), image, labels, 96, scales=(1.0, 1.001))
    assert 0.2 < (marks == IGNORED).mean() < 0.9


def test_the_same_seed_gives_the_same_light():
    image, _ = blocks()
    first, second = (augment.random_light(np.random.default_rng(7), image) for _ in range(2))
    np.testing.assert_array_equal(first, second)
    assert first.dtype == np.float32 and 0 <= first.min() <= first.max() <= 1


def test_light_varies_by_its_strength_and_not_at_all_at_zero(monkeypatch):
    monkeypatch.setattr(augment, "BLUR", 0)
    monkeypatch.setattr(augment, "NOISE", 0)
    image = np.random.default_rng(3).uniform(0.3, 0.7, (32, 32, 3)).astype(np.float32)
    seeds = range(20)
    spreads = [
        np.std([augment.random_light(np.random.default_rng(seed), image, strength).mean() for seed in seeds])
        for strength in (0, 0.5, 1.0, 1.5)
    ]
    assert spreads[0] < 1e-6 and spreads == sorted(spreads)
    np.testing.assert_allclose(augment.random_light(np.random.default_rng(1), image, 0.0), image, atol=1e-6)


@pytest.mark.parametrize(
    ("learn_unlabeled", "expected"), [(False, [IGNORED, 1, 2, IGNORED]), (True, [0, 1, 2, IGNORED])]
)
def test_class_values_become_channels_and_unknown_ones_are_ignored(tmp_path, learn_unlabeled, expected):
    cv2.imwrite(str(tmp_path / "image.png"), np.full((1, 4, 3), (10, 20, 255), np.uint8))
    cv2.imwrite(str(tmp_path / "labels.png"), np.array([[0, 7, 40, 9]], np.uint8))
    pairs = [tiles.TilePair(tmp_path / "image.png", tmp_path / "labels.png", (1, 2, 3), None)]
    image, channels = tiles.TileReader(pairs, [0, 7, 40], learn_unlabeled)(0)
    assert channels[0].tolist() == expected
    np.testing.assert_allclose(image[0, 0], [1, 20 / 255, 10 / 255])


def test_grey_tiles_are_red_green_and_blue_alike(tmp_path):
    cv2.imwrite(str(tmp_path / "grey.png"), np.arange(12, dtype=np.uint8).reshape(3, 4))
    seen = tiles.read_image(tiles.TilePair(tmp_path / "grey.png", tmp_path, (1, 1, 1), None))
    np.testing.assert_array_equal(seen, np.dstack([np.arange(12).reshape(3, 4)] * 3))


def write_folder(folder, names=("building", "water"), tile_count=1, mean=0.5, deviation=0.1):
    for kind in ("images", "labels"):
        (folder / "train" / kind).mkdir(parents=True)
    for number in range(tile_count):
        cv2.imwrite(str(folder / "train" / "images" / f"{number}_0.png"), np.zeros((8, 8, 3), np.uint8))
    with (folder / "classes.csv").open("w", newline="") as file:
        rows = [[value, name, "#000000", "reference"] for value, name in enumerate(names, 1)]
        csv.writer(file).writerows([["value", "name", "color", "role"], *rows])
    statistics = {"band_mean": [mean] * 3, "band_std": [deviation] * 3, "class_pixels": {"train": {}}}
    manifest = {"statistics": statistics, "network_bands": [1, 2, 3], "stretch": None}
    (folder / "manifest.json").write_text(json.dumps(manifest))
    return folder


def test_statistics_of_several_folders_are_those_of_all_their_tiles(tmp_path):
    folders = tiles.open_folders(
        [write_folder(tmp_path / "a", tile_count=1, mean=0.2), write_folder(tmp_path / "b", tile_count=3, mean=0.6)]
    )
    mean, deviation = tiles.band_statistics(folders)
    np.testing.assert_allclose(mean, 0.5)
    np.testing.assert_allclose(deviation, np.sqrt(0.01 + (0.3**2 + 3 * 0.1**2) / 4))
    one_color = tiles.open_folders([write_folder(tmp_path / "c", tile_count=3, mean=0.1, deviation=0.0)])
    assert (tiles.band_statistics(one_color)[1] > 0).all()


def test_folders_with_different_classes_or_without_tiles_are_refused(tmp_path):
    paths = [write_folder(tmp_path / "a"), write_folder(tmp_path / "b", names=("building", "forest"))]
    with pytest.raises(TrainingError, match="have different classes"):
        tiles.open_folders(paths)
    with pytest.raises(TrainingError, match="has no exported training tiles"):
        tiles.open_folder(tmp_path)
    with pytest.raises(TrainingError, match="has no tiles for training"):
        tiles.open_folder(write_folder(tmp_path / "empty", tile_count=0))


def test_rare_classes_count_more_but_not_without_limit():
    weights = metrics.class_weights(np.array([0, 100, 400, 10_000, 1]))
    assert weights[0] == 0
    assert weights[1] / weights[2] == pytest.approx(2)
    assert weights.max() == weights[4] == metrics.RAREST_WEIGHT


def test_intersection_over_union_counts_ignored_pixels_nowhere():
    labels = np.array([0, 0, 1, 1, IGNORED, 1], np.uint8)
    predicted = np.array([0, 1, 1, 1, 0, 0])
    confusion = metrics.confusion_matrix(labels, predicted, 3)
    np.testing.assert_array_equal(confusion, [[1, 1, 0], [1, 2, 0], [0, 0, 0]])
    iou = metrics.intersection_over_union(confusion)
    np.testing.assert_allclose(iou[:2], [1 / 3, 1 / 2])
    assert np.isnan(iou[2])


def test_shifts_of_a_network_are_separated_from_shifts_of_the_ground():
    rng = np.random.default_rng(8)
    tiles_hw = []
    for _ in range(4):
        labels = np.zeros((256, 256), np.uint8)
        for row, column in np.mgrid[10:220:32, 10:220:32].reshape(2, -1).T:
            height, width = rng.integers(9, 16, 2)
            labels[row : row + height, column : column + width] = 1
        # The shift of the ground: shown 2 px north of its place.
        tiles_hw.append((np.roll(labels, -2, axis=0)[..., None].astype(np.float32), labels))

    class Reader:
        def __len__(self):
            return len(tiles_hw)

        def __call__(self, index):
            return tiles_hw[index]

    def answer(image):
        return np.roll(image[..., 0].astype(np.uint8), 1, axis=1)

    (row,) = class_bias.measure_class_biases(answer, Reader(), 2)
    bias = row.bias(0.5)
    assert (bias.east, bias.north, bias.right, bias.down) == pytest.approx((0.0, 1.0, 0.5, 0.0), abs=0.02)
    assert bias.spread < 0.1


@pytest.mark.parametrize(("count", "most", "expected"), [(0, 4, []), (3, 4, [0, 1, 2]), (9, 3, [0, 4, 8])])
def test_some_of_many_tiles_are_evenly_apart(count, most, expected):
    assert tiles.spread(count, most) == expected
    pairs = [tiles.TilePair(f"{n}.png", "labels", (1, 2, 3), None) for n in range(count)]
    reader = tiles.TileReader(pairs, [0, 1], learn_unlabeled=True)
    assert [pair.image for pair in reader.spread(most).pairs] == [f"{n}.png" for n in expected]
    assert len(reader) == count


def test_tiles_that_overlap_count_once():
    pairs = [tiles.TilePair(tiles.Path(f"{c}_{r}.png"), "labels", (1, 2, 3), None) for c in (0, 4, 8) for r in (0, 4)]
    assert [pair.image.stem for pair in tiles.without_overlap(pairs, 8)] == ["0_0", "8_0"]


def test_ground_where_only_one_class_was_drawn_allows_all_the_others_but_not_what_is_unlabeled():
    first, second, full = (tiles.Path(name) for name in ("a", "b", "c"))
    allowed, labels = metrics.partial_labels(4, {first: [1], second: [1], full: [1, 2, 3]})
    assert labels == {first: 4, second: 4, full: IGNORED}
    np.testing.assert_array_equal(allowed, [*np.eye(4), [0, 0, 1, 1]])
    decided = metrics.decided_channels(allowed)
    np.testing.assert_array_equal(decided[4], [True, True, False, False])
    assert decided[:4].all()


def test_a_pixel_of_a_set_counts_only_against_the_classes_it_excludes():
    allowed, _ = metrics.partial_labels(4, {tiles.Path("a"): [1]})
    labels, predicted = np.array([1, 1, 2, 4, 4, 4], np.uint8), np.array([1, 2, 2, 1, 2, 3])
    confusion = metrics.confusion_matrix(labels, predicted, 4, 1)
    iou = metrics.intersection_over_union(confusion, allowed)
    np.testing.assert_allclose(iou[1:3], [1 / 3, 1 / 2])
    assert np.isnan(iou[3])


def test_unlabeled_ground_follows_the_setting_of_its_folder(tmp_path):
    cv2.imwrite(str(tmp_path / "image.png"), np.zeros((1, 3, 3), np.uint8))
    cv2.imwrite(str(tmp_path / "labels.png"), np.array([[0, 7, 9]], np.uint8))
    pairs = [tiles.TilePair(tmp_path / "image.png", tmp_path / "labels.png", (1, 2, 3), None, one) for one in (None, 2)]
    reader = tiles.TileReader(pairs, [0, 7], False)
    assert [reader(n)[1][0].tolist() for n in (0, 1)] == [[IGNORED, 1, IGNORED], [2, 1, IGNORED]]


class Tiles:
    """Tiles with scores as their image, and labels drawn from the softmax at a temperature."""

    def __init__(self, true_temperature, count=3, edge=96):
        rng = np.random.default_rng(5)
        self.scores = rng.normal(0, 4, (count, 3, edge, edge))
        odds = np.exp(self.scores / true_temperature)
        limits = np.cumsum(odds / odds.sum(axis=1, keepdims=True), axis=1)
        self.labels = (rng.random((count, 1, edge, edge)) > limits).sum(axis=1).astype(np.uint8)

    def __len__(self):
        return len(self.scores)

    def __call__(self, index):
        return index, self.labels[index]


@pytest.mark.parametrize("true_temperature", [0.7, 1.0, 2.5])
def test_the_temperature_that_made_the_labels_is_found(true_temperature):
    tiles = Tiles(true_temperature)
    found = metrics.fit_temperature(lambda index: tiles.scores[index], tiles)
    assert found == pytest.approx(true_temperature, rel=0.1)


def test_a_network_without_labels_to_test_it_counts_as_too_certain():
    tiles = Tiles(1.0, 1)
    tiles.labels[:] = 255
    assert metrics.fit_temperature(lambda index: tiles.scores[index], tiles) == metrics.UNTESTED > 1
