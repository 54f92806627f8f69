import numpy as np
import pytest

from semref.training import temperature


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
    found = temperature.fit_temperature(lambda index: tiles.scores[index], tiles)
    assert found == pytest.approx(true_temperature, rel=0.1)


def test_pixels_without_a_label_have_no_effect():
    tiles = Tiles(1.0, 1)
    tiles.labels[:] = 255
    assert temperature.fit_temperature(lambda index: tiles.scores[index], tiles) is None
