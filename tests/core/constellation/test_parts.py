"""Images that show two places are recognized; images of one place are not, even with poor labels."""

import numpy as np
import pytest

from semref.core.constellation.parts import Agreement, empty_side, uneven_side
from semref.core.constellation.settings import CONSTELLATION

DIAGONAL = 1000.0


def seen(share_left, share_right, count=60, seed=0, cut=0.0):
    """Return landmarks with a share of agreement on either side of a vertical cut."""
    rng = np.random.default_rng(seed)
    points = rng.uniform(-350, 350, count) + 1j * rng.uniform(-350, 350, count)
    share = np.where(points.real > cut, share_right, share_left)
    return Agreement(points, rng.random(count) < share)


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("cut", [-120.0, 0.0, 120.0])
def test_the_side_that_shows_another_place_is_found(seed, cut):
    side = empty_side(
        seen(0.8, 0.03, seed=seed, cut=cut), seen(0.8, 0.03, 50, seed + 9, cut), DIAGONAL, CONSTELLATION.decision
    )
    assert side is not None
    assert side.direction.real > 0.8 and abs(side.begins_px - cut) < 120


@pytest.mark.parametrize("share", [0.95, 0.6, 0.3, 0.1])
def test_an_image_of_one_place_has_no_empty_side_however_poor_its_labels(share):
    for seed in range(20):
        assert (
            empty_side(
                seen(share, share, 80, seed), seen(share, share, 80, seed + 50), DIAGONAL, CONSTELLATION.decision
            )
            is None
        )


def test_new_houses_where_the_map_has_nothing_are_no_other_place():
    of_map = seen(0.8, 0.8, 50, 3)
    left = Agreement(of_map.points[of_map.points.real < 0], of_map.agree[of_map.points.real < 0])
    assert empty_side(seen(0.8, 0.0), left, DIAGONAL, CONSTELLATION.decision) is None


def test_few_landmarks_are_no_evidence_of_two_places():
    assert empty_side(seen(1.0, 0.0, 8), seen(1.0, 0.0, 8, 1), DIAGONAL, CONSTELLATION.decision) is None


@pytest.mark.parametrize("seed", range(5))
def test_a_side_with_few_agreeing_landmarks_is_found(seed):
    side = uneven_side(seen(0.6, 0.0, seed=seed), DIAGONAL, CONSTELLATION.decision)
    assert side is not None and side.direction.real > 0.7


@pytest.mark.parametrize("share", [0.2, 0.5, 0.9])
def test_chance_makes_few_images_uneven(share):
    sides = [uneven_side(seen(share, share, 60, seed), DIAGONAL, CONSTELLATION.decision) for seed in range(100)]
    assert sum(side is not None for side in sides) <= 2
