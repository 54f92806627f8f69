"""Ground takes what has room and refuses what has none."""

import numpy as np
import pytest
from shapely.geometry import box

from sample.scatter import Ground

BLOCKED = box(40, 0, 60, 100)


def square(at, half=3.0):
    return box(at[0] - half, at[1] - half, at[0] + half, at[1] + half)


@pytest.mark.parametrize(
    ("at", "clearance", "is_free"),
    [((20, 20), 1, True), ((50, 50), 1, False), ((36, 50), 0.5, True), ((36, 50), 2, False), ((-5, 50), 1, False)],
)
def test_ground_is_free_off_what_is_blocked_and_inside_the_map(at, clearance, is_free):
    assert Ground((100.0, 100.0), BLOCKED).is_free(square(at), clearance) == is_free


def test_what_was_added_is_no_longer_free():
    ground = Ground((100.0, 100.0), BLOCKED)
    ground.add(square((20, 20)))
    assert not ground.is_free(square((24, 20)), 1)
    assert ground.is_free(square((30, 20)), 1)


def test_placed_shapes_keep_their_distance_until_there_is_no_room():
    ground, rng = Ground((100.0, 100.0), BLOCKED), np.random.default_rng(5)
    placed = [shape for _ in range(60) for shape in ground.place(rng, lambda at: [square(at, 8)], 2)]
    assert 5 < len(placed) < 60
    assert all(a.distance(b) >= 2 for n, a in enumerate(placed) for b in placed[:n])
