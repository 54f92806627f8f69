import math
from dataclasses import replace

import numpy as np
import pytest
from made_labels import scattered_objects
from onboard_area import TABLE

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.errors import ParameterError
from semref.core.evaluation.evaluation import (
    MOST_IN_A_CELL,
    NOISE_LEVELS,
    ROTATION,
    ROTATIONS_DEG,
    SCALES,
    SCALING,
    SHARED,
    Evaluation,
    TrialRanges,
)
from semref.core.evaluation.rates import Rate
from semref.core.evaluation.summary import summarize
from semref.core.geometry.frame import MapFrame
from semref.core.labels.sources import ArrayLabels
from semref.core.localization import Localization, Method, Place, Status
from semref.core.simulation.noise import LabelNoise

WEST, NORTH = 1000.0, 9000.0
CLEAN = {"missed": (0, 0), "invented": (0, 0), "misnamed": (0, 0), "ragged": (0, 0)}
LABELS = scattered_objects(600, 700, 308, seed=3)
BOTH = [Method.AUTOMATIC, Method.TOPOLOGY_VECTOR]


@pytest.fixture(scope="module")
def database():
    frame = MapFrame.at((WEST, NORTH), 1.0)
    settings = BuildSettings(160.0, 40.0, 30.0, (1.0,), 10)
    return replace(build_from_labels(ArrayLabels(LABELS), frame, TABLE, settings, "0"), overview=None)


@pytest.fixture
def evaluate(database):
    """`evaluate(labels=LABELS, pixel=1.0, seed=1, **ranges)` returns an Evaluation."""

    def make(labels=LABELS, pixel=1.0, seed=1, right_within=None, minimum=3, **ranges):
        ranges = TrialRanges(**ranges)
        return Evaluation(
            database, ArrayLabels(labels), MapFrame.at((WEST, NORTH), pixel), ranges, seed, minimum, right_within
        )

    return make


def test_values_fill_their_ranges(evaluate):
    ranges = {"scale": (0.5, 2.0), "rotation": (10.0, 20.0), "offset": (0.1, 0.4), "missed": (10, 30), "ragged": (1, 3)}
    queries = list(evaluate(**ranges).trials(300, 0))
    values = {
        "scale": [q.scale for q in queries],
        "rotation": [q.view.heading_deg for q in queries],
        "offset": [q.offset for q in queries],
        "missed": [100 * q.noise.missed for q in queries],
        "ragged": [q.noise.jitter for q in queries],
    }
    for name, found in values.items():
        low, high = ranges[name]
        assert low <= min(found) < low + 0.1 * (high - low) and high - 0.1 * (high - low) < max(found) <= high, name


def test_the_offset_is_the_distance_from_the_nearest_window_in_strides(evaluate, database):
    for query in evaluate(offset=(0.2, 0.5)).trials(50, 0):
        away = np.abs(database.windows.centers - query.view.position).max(axis=1).min() / database.parameters.stride
        assert away == pytest.approx(query.offset, abs=1e-9)


def test_an_image_shows_the_map_at_its_position(evaluate):
    (query,) = evaluate(**CLEAN, offset=(0, 0), scale=(1, 1), rotation=(0, 0)).trials(1, 0)
    column, row = query.view.position[0] - WEST, NORTH - query.view.position[1]
    seen = LABELS[int(row) - 80 : int(row) + 80, int(column) - 80 : int(column) + 80]
    np.testing.assert_array_equal(evaluate().image(query), seen)


def test_a_map_with_finer_pixels_gives_the_same_images(evaluate):
    fine = evaluate(np.kron(LABELS, np.ones((2, 2), np.uint8)), 0.5, **CLEAN)
    for query, same in zip(evaluate(**CLEAN).trials(3, 0), fine.trials(3, 0)):
        assert query.view.position == same.view.position
        assert (evaluate(**CLEAN).image(query) == fine.image(same)).mean() > 0.999


def test_a_seed_repeats_queries_and_images_and_another_one_does_not(evaluate):
    first, again, other = (list(evaluate(seed=seed).trials(4, 2)) for seed in (5, 5, 6))
    assert first == again and not {q.view for q in first} & {q.view for q in other}
    for query in first:
        np.testing.assert_array_equal(evaluate(seed=5).image(query), evaluate(seed=5).image(query))


def test_the_grid_of_noise_has_every_pair_of_levels_at_the_same_places(evaluate):
    queries = list(evaluate().noise_grid(2))
    pairs = {(round(100 * q.noise.missed), round(100 * q.noise.spurious)) for q in queries}
    assert len(queries) == 32 and pairs == {(m, i) for m in NOISE_LEVELS for i in NOISE_LEVELS}
    assert len({q.view.position for q in queries}) == 2


def test_the_tables_scale_and_turn_whole_windows_without_noise(evaluate, database):
    queries = list(evaluate().tables())
    assert [q.scale for q in queries if q.kind == SCALING][:10] == pytest.approx(SCALES)
    assert [q.view.heading_deg for q in queries if q.kind == ROTATION][:12] == pytest.approx(ROTATIONS_DEG)
    assert len(queries) == 3 * 22
    for query in queries:
        assert query.noise == LabelNoise() and query.offset == 0
        number = [database.windows.name(n) for n in range(len(database.windows))].index(query.window)
        assert query.view.position == tuple(database.windows.centers[number])


def test_trials_are_only_near_windows_with_enough_landmarks(evaluate, database):
    enough = int(np.median(database.windows.counts))
    assert all(query.landmarks >= enough for query in evaluate(minimum=enough).trials(60, 0))
    told = evaluate(minimum=enough).tried_windows
    assert (told.successes, told.trials) == (int((database.windows.counts >= enough).sum()), len(database.windows))
    part = evaluate(LABELS[:300])
    assert all(query.view.position[1] >= NORTH - 300 + 80 - 20 - 1 for query in part.trials(60, 0))


def test_a_map_of_elsewhere_is_refused(evaluate, database):
    with pytest.raises(ParameterError, match="No window"):
        Evaluation(database, ArrayLabels(LABELS), MapFrame.at((0.0, 0.0), 1.0), TrialRanges(), 1)


@pytest.mark.parametrize(
    ("name", "limits"), [("missed", (0, 101)), ("scale", (0, 1)), ("offset", (0.3, 0.2)), ("ragged", (math.nan, 1))]
)
def test_impossible_ranges_are_refused_by_name(name, limits):
    with pytest.raises(ParameterError, match=name):
        TrialRanges(**{name: limits})


class Told:
    """Localizer that returns the results it was made with."""

    def __init__(self, result):
        self.result = result

    def localize(self, labels_hw, method, biases):
        return self.result


def told(evaluation, query, **known):
    """Return a fix at a position, with the heading and pixel size of ``known``."""
    place = {name: known.pop(name) for name in ("position", "heading_deg", "pixel_size_m") if name in known}
    known = {"status": Status.FIX, "method": Method.CONSTELLATION, "best": Place(**place) if place else None, **known}
    evaluation.localizer = Told(Localization(**known))
    return evaluation.run(query, [Method.CONSTELLATION])[0]


def test_the_topology_vector_is_right_with_the_nearest_window(evaluate, database):
    evaluation = evaluate(offset=(0.4, 0.4))
    (query,) = evaluation.trials(1, 0)
    order = np.argsort(np.hypot(*(database.windows.centers - query.view.position).T))
    for rank, right in ((0, True), (1, False)):
        index = int(order[rank])
        position = tuple(database.windows.centers[index])
        known = {"method": Method.TOPOLOGY_VECTOR, "window_index": index, "window": database.windows.name(index)}
        assert told(evaluation, query, position=position, **known).is_right is right


@pytest.mark.slow
def test_methods_on_a_made_map_behave_as_they_must(evaluate):
    on_windows = evaluate(**CLEAN, offset=(0, 0), scale=(1, 1), rotation=(0, 0))
    both = [Method.TOPOLOGY_VECTOR, Method.CONSTELLATION]
    trials = [t for query in on_windows.trials(6, 0) for t in on_windows.run(query, both)]
    assert [t.method for t in trials] == both * 6 and all(t.is_right for t in trials)
    between = evaluate(**CLEAN, offset=(0.4, 0.5))
    trials = [t for query in between.trials(6, 6) for t in between.run(query, both)]
    assert summarize(trials, Method.CONSTELLATION).right.share > summarize(trials, Method.TOPOLOGY_VECTOR).right.share
    assert summarize(trials, Method.CONSTELLATION).false_accepts == Rate(0, 6)


def test_what_landmarks_share_is_drawn_from_its_ranges(evaluate):
    ranges = dict.fromkeys(SHARED, (1.0, 2.0))
    queries = list(evaluate(**ranges).trials(60, 0))
    found = {
        "background": [100 * q.noise.background for q in queries],
        "displaced": [q.noise.displaced for q in queries],
        "shifted": [np.hypot(*q.noise.class_shifts[0][1:]) for q in queries],
        "leaning": [100 * q.noise.leaning for q in queries],
        "lens": [100 * abs(q.view.lens) for q in queries],
        "tilt": [q.view.tilt_deg for q in queries],
    }
    assert set(found) == set(SHARED)
    for name, values in found.items():
        assert 1 <= min(values) < 1.2 and 1.8 < max(values) <= 2, name
    assert [q.shifted for q in queries] == pytest.approx(found["shifted"])


def test_shared_errors_leave_images_where_they_were(evaluate):
    plain, shared = (list(evaluate(**ranges).trials(5, 2)) for ranges in ({}, {"displaced": (1.0, 1.0)}))
    assert [q.view.position for q in plain] == [q.view.position for q in shared]
    assert [q.noise.missed for q in plain] == [q.noise.missed for q in shared]


class Planner:
    def trials(self, count, mirrored):
        return [("map", n) for n in range(count)] + [("mirrored", n) for n in range(mirrored)]

    def noise_grid(self, count):
        return [("noise", n) for n in range(count)]

    def moves(self, count):
        return [("offset", n) for n in range(count)]

    def tables(self):
        return [("scaling", 0)]


@pytest.mark.parametrize(("count", "share", "mirrored"), [(200, 0.25, 50), (1, 0.9, 0), (3, 0.9, 2), (10, 0.0, 0)])
def test_so_many_are_mirrored_but_one_at_least_is_of_the_map(count, share, mirrored):
    jobs = Evaluation.plan(Planner(), BOTH, count, share, False)
    kinds = [query[0] for query, _ in jobs]
    assert kinds.count("mirrored") == mirrored and len(kinds) == count
    assert all(methods == BOTH for _, methods in jobs)


@pytest.mark.parametrize(("count", "a_cell"), [(1, 2), (160, 10), (100_000, MOST_IN_A_CELL)])
def test_a_report_has_more_images_and_its_grid_of_noise_the_first_method(count, a_cell):
    jobs = Evaluation.plan(Planner(), BOTH, count, 0.25, True)[count:]
    assert [query[0] for query, _ in jobs] == ["noise"] * a_cell + ["offset"] * a_cell + ["scaling"]
    assert all(methods == (BOTH[:1] if query[0] == "noise" else BOTH) for query, methods in jobs)
