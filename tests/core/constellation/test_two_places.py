import dataclasses

import numpy as np
import pytest
from made_town import NOISE, ORIGIN, PRIOR, SIZE, Ground, error, seen_from, solve, town

from semref.core.constellation.index import build_index
from semref.core.constellation.parts import Agreement, empty_side, uneven_side
from semref.core.constellation.settings import CONSTELLATION
from semref.core.constellation.solver import localize
from semref.core.database.model import MapLandmarks
from semref.core.landmarks.landmarks import Landmarks
from semref.core.localization import Status

TWO_PLACES = "the image may show two places"
DIAGONAL = 1000.0


@pytest.fixture(scope="module")
def ground():
    return Ground(town(7))


def of_two(left, right, cut=SIZE / 2):
    """Return landmarks of one image left of the cut and of the other image right of it."""
    parts = left.select(left.centers_xy[:, 0] < cut), right.select(right.centers_xy[:, 0] >= cut)
    names = [field.name for field in dataclasses.fields(Landmarks)]
    return Landmarks(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))


def test_an_image_of_two_places_is_recognized(ground):
    left, right = (ground.see(seen_from(*center, 20.0)) for center in ((1400, 1600), (900, 900)))
    found = solve(ground, of_two(left, right))
    assert found.status == Status.AMBIGUOUS and TWO_PLACES in str(found.reason)
    assert found.confidence is None and len(found.alternatives) == 1 and not found.is_doubted


@pytest.fixture(scope="module")
def half_mapped(ground):
    """Return the town without its part east of x = 1,400; another place with landmarks is at 900, 900."""
    all_of_them, known = ground.references, ground.references.positions[:, 0] < ORIGIN[0] + 1400
    columns = (all_of_them.positions, all_of_them.classes, all_of_them.areas_m2, all_of_them.touches_edge)
    return build_index(MapLandmarks(*(column[known] for column in columns)), 1.0)


@pytest.mark.parametrize("seed", range(3))
def test_a_second_place_is_found_by_few_landmarks_where_the_map_has_nothing_at_the_first(ground, half_mapped, seed):
    right = ground.see(seen_from(900, 900), dataclasses.replace(NOISE, missed=0.7), seed)
    found = localize(of_two(ground.see(seen_from(1400, 1600)), right), (SIZE, SIZE), half_mapped, PRIOR)
    assert found.status == Status.AMBIGUOUS and TWO_PLACES in str(found.reason)
    first, second = (np.subtract(place.position, ORIGIN) for place in found.alternatives)
    assert np.hypot(*(first - (1400, -1600))) < 5 and np.hypot(*(second - (900, -900))) < 5


def test_a_fix_names_the_part_of_the_image_that_disagrees(ground, half_mapped):
    view = seen_from(1400, 1600)
    found = localize(ground.see(view), (SIZE, SIZE), half_mapped, PRIOR)
    assert found.status == Status.FIX and error(found, view) < 1
    assert str(found.reason).startswith("In the right part of the image only 0 of ")


@pytest.mark.parametrize("seed", range(4))
def test_a_fix_of_one_place_has_no_warning_even_with_poor_labels(ground, seed):
    found = solve(ground, ground.see(seen_from(1400, 1600, 40.0 * seed), NOISE, seed))
    assert (found.status, found.reason) == (Status.FIX, None)


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
        one, other = (seen(share, share, 80, number) for number in (seed, seed + 50))
        assert empty_side(one, other, DIAGONAL, CONSTELLATION.decision) is None


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
