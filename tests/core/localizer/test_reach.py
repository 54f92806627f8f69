import numpy as np
import pytest

from semref.core.localization import Localization, Method, Place, Prior, Status
from semref.core.localizer.reach import Reach, jumps, search_within_reach


def fix(x, risk=1e-5, error=5.0):
    place = Place((float(x), 0.0), 0.0, 0.1)
    return Localization(Status.FIX, Method.AUTOMATIC, best=place, risk=risk, confidence=1 - risk, error_95_m=error)


NOTHING = Localization(Status.AMBIGUOUS, Method.AUTOMATIC, risk=0.6)


def asked(results, times, answers, speed=10.0, allowed=1e-4):
    """Return the reaches that were searched, by number, and the fixes that were found."""
    searched = []

    def search(n, reach):
        searched.append((n, reach))
        return answers.get(n)

    exact = [None if one is None else one + 0.5 for one in times]
    found = search_within_reach(results, exact, speed, allowed, search)
    return [(n, reach.position[0], reach.radius) for n, reach in searched], found


def test_an_image_is_searched_around_the_position_nearest_in_time():
    searched, found = asked([fix(0), NOTHING, fix(800)], [0, 60, 80], {1: fix(700)})
    assert (searched, found[1].position) == ([(1, 800.0, 205.0)], (700.0, 0.0))


def test_the_error_probability_is_that_of_both_positions():
    _, found = asked([fix(0, risk=2e-5), NOTHING], [0, 10], {1: fix(50, risk=3e-5)})
    assert (found[1].risk, 1 - found[1].confidence) == pytest.approx((5e-5, 5e-5))


def test_the_start_leaves_less_error_probability_for_the_search_and_is_not_used_if_none():
    reaches = []
    search_within_reach([fix(0, risk=4e-5), NOTHING], [0, 10], 10.0, 1e-4, lambda n, reach: reaches.append(reach))
    assert reaches[0].allowed_risk == pytest.approx(6e-5)
    assert asked([fix(0, risk=1e-4), NOTHING], [0, 10], {1: fix(50)}) == ([], {})


def test_a_new_position_narrows_the_search_of_the_next_image():
    searched, found = asked([fix(0), NOTHING, NOTHING], [0, 10, 20], {1: fix(80), 2: fix(160)})
    assert searched == [(1, 0.0, 105.0), (2, 80.0, 105.0)]
    assert found[2].risk == pytest.approx(3e-5)


def test_an_image_that_was_not_found_is_searched_again_only_on_clearly_less_ground():
    searched, _ = asked([fix(0), NOTHING, NOTHING], [0, 20, 21], {2: fix(160)})
    assert searched == [(1, 0.0, 205.0), (2, 0.0, 215.0), (1, 160.0, 15.0)]


def test_images_without_a_time_and_positions_without_a_probability_are_left_alone():
    no_risk = Localization(Status.FIX, Method.TOPOLOGY_VECTOR, best=Place((0.0, 0.0)), confidence=0.9)
    assert all(asked([fix(0), NOTHING], times, {1: fix(50)}) == ([], {}) for times in ([0, None], [None, 10]))
    assert asked([no_risk, NOTHING, None], [0, 10, 20], {1: fix(50)}) == ([], {})


def test_nothing_is_searched_from_a_jump():
    searched, _ = asked([fix(0), fix(90), fix(9000), NOTHING, fix(280)], [0, 10, 20, 21, 30], {})
    assert searched == [(3, 280.0, 95.0)]


def test_a_prior_is_only_made_smaller():
    reach = Reach((100.0, 0.0), 200.0, 1e-4, 0)
    narrowed = reach.narrow(Prior(heading_deg=10.0))
    assert (narrowed.position, narrowed.radius, narrowed.heading_deg) == ((100.0, 0.0), 200.0, 10.0)
    assert reach.narrow(Prior((0.0, 0.0), 300.0)).radius == 200.0
    # They would allow places outside the search area.
    assert {reach.narrow(Prior((0.0, 0.0), radius)) for radius in (150.0, 299.0)} == {None}


def flagged(times, xs, speed=10.0, errors=None, confidences=None) -> list:
    positions = np.column_stack([xs, np.zeros(len(xs))])
    errors = np.zeros(len(xs)) if errors is None else np.array(errors)
    confidences = np.ones(len(xs)) if confidences is None else np.array(confidences)
    return np.flatnonzero(jumps(np.array(times) + 0.5, positions, errors, confidences, speed)).tolist()


@pytest.mark.parametrize(
    ("times", "xs", "expected"),
    [
        ([], [], []),
        ([5], [0], []),
        ([0, 1, 2, 3], [0, 9, 18, 27], []),
        ([0, 1, 2, 3], [0, 9, 500, 27], [2]),
        ([0, 1, 2, 3, 4], [900, 9, 18, 27, 800], [0, 4]),
        ([0, 1, 2, 3, 4, 5], [0, 9, 500, 503, 36, 45], [2, 3]),
        ([0, 1, 2, 3, 4], [300, 500, 0, 5, 900], [0, 1, 4]),
    ],
    ids=["none", "one", "steady", "one jump", "first and last", "two beside each other", "most are wrong"],
)
def test_the_fewest_fixes_are_flagged(times, xs, expected):
    assert flagged(times, xs) == expected


def test_errors_of_both_fixes_are_allowed_for_and_fixes_of_the_same_moment_must_be_close():
    assert [flagged([0, 1, 2], [0, x, 20], errors=[3, 3, 3]) for x in (16, 17)] == [[], [1]]
    assert flagged([0, 0, 1], [0, 50, 5]) == [1]


def test_times_in_whole_seconds_may_be_off_by_one():
    assert not jumps(np.zeros(2), np.array([[0, 0], [9, 0]]), np.zeros(2), np.ones(2), 10.0).any()
    reaches = []
    search_within_reach([fix(0), NOTHING], [0, 10], 10.0, 1e-4, lambda n, reach: reaches.append(reach.radius))
    assert reaches == [115.0]


def test_a_long_flight_with_many_wrong_fixes_keeps_the_right_ones():
    rng = np.random.default_rng(4)
    times = np.arange(1000.0)
    xs = 8 * times + rng.normal(0, 0.5, 1000)
    wrong = rng.random(1000) < 0.2
    xs[wrong] = rng.uniform(-1e6, 1e6, wrong.sum())
    assert flagged(times, xs, errors=np.full(1000, 2.0)) == np.flatnonzero(wrong).tolist()
