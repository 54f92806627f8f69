"""What an image is simulated under: sizes as asked for, directions and signs by chance."""

import numpy as np
import pytest

from semref.core.simulation.conditions import ASSUMED, Conditions
from semref.core.simulation.noise import LabelNoise
from semref.core.simulation.views import View

VIEW = View(10.0, 20.0, 30.0, 1.0, 640, 640)


def test_sizes_are_as_asked_for_and_directions_differ():
    rng = np.random.default_rng(1)
    conditions = Conditions(LabelNoise(missed=0.2), class_shift=2.0, lens=0.01, tilt_deg=3.0)
    drawn = [conditions.drawn(VIEW, rng, (1, 4)) for _ in range(40)]
    assert {abs(view.lens) for view, _ in drawn} == {0.01} and {np.sign(view.lens) for view, _ in drawn} == {-1, 1}
    assert {view.tilt_deg for view, _ in drawn} == {3.0}
    directions = [view.tilt_direction_deg for view, _ in drawn]
    assert min(directions) < 60 and max(directions) > 300
    for _, noise in drawn:
        assert noise.missed == 0.2 and [value for value, *_ in noise.class_shifts] == [1, 4]
        assert [np.hypot(right, down) for _, right, down in noise.class_shifts] == pytest.approx([2.0, 2.0])
    assert np.std([noise.class_shifts[0][1] for _, noise in drawn]) > 1


def test_what_is_assumed_spoils_everything_a_little():
    noise = ASSUMED.noise
    assert min(noise.background, noise.displaced, noise.leaning, ASSUMED.class_shift, ASSUMED.lens) > 0
    assert 0 < ASSUMED.tilt_deg <= 5
