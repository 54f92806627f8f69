"""Images of two places, and of places with a change on one side: a reason, or a fix that names the part."""

import dataclasses

import numpy as np
import pytest
from made_town import NOISE, ORIGIN, PRIOR, SIZE, Ground, error, seen_from, solve, town

from semref.core.constellation.index import build_index
from semref.core.constellation.solver import localize
from semref.core.database.model import MapLandmarks
from semref.core.landmarks.landmarks import Landmarks
from semref.core.localization import Status

TWO_PLACES = "the image may show two places"


@pytest.fixture(scope="module")
def ground():
    return Ground(town(7))


def joined(*parts):
    names = [field.name for field in dataclasses.fields(Landmarks)]
    return Landmarks(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))


def of_two(left, right, cut=SIZE / 2):
    """Return landmarks of one image left of the cut and of the other image right of it."""
    return joined(left.select(left.centers_xy[:, 0] < cut), right.select(right.centers_xy[:, 0] >= cut))


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
