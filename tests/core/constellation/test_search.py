"""The constellation's choices between poses: which are one place, which of them stays; on a made catalogue."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from semref.core.constellation import search, solver, verification
from semref.core.constellation.hypotheses import MINIMUM_OBJECTS, query_triangles
from semref.core.constellation.index import build_index
from semref.core.constellation.lookup import Lookup
from semref.core.constellation.settings import CONSTELLATION
from semref.core.constellation.verification import PoseEvidence
from semref.core.database.model import MapLandmarks
from semref.core.geometry.pose import Pose
from semref.core.landmarks.landmarks import Landmarks
from semref.core.localization import Prior

EDGE = 640
SEEN = (900.0, 1100.0, 70.0, 1.1)
"""East and north of the origin, heading and pixel size of a cut."""


def evidence_at(pose, log_odds=100.0, count=10, considered=12, noise_factor=1.0, deviation=1.0):
    matched, deviations = np.arange(count), np.full(count, deviation)
    return PoseEvidence(pose, log_odds, matched, matched, deviations, noise_factor, matched, np.arange(considered))


LEVEL = Pose(100 + 50j, 1 + 0j)
TILTED = Pose(100 + 50j, 1 + 0j, 0.001 + 0j)


@pytest.mark.parametrize(
    ("changes", "agrees"),
    [
        ({}, True),
        ({"log_odds": 20.0}, False),
        ({"noise_factor": CONSTELLATION.decision.tilted_noise}, False),
        ({"considered": 17}, False),
        ({"considered": 16}, True),
        ({"count": 0, "considered": 0}, False),
    ],
)
def test_a_level_camera_explains_an_image_of_high_odds_little_noise_and_most_objects(changes, agrees):
    assert search._agrees(evidence_at(LEVEL, **changes), CONSTELLATION.decision) == agrees


@pytest.mark.parametrize(
    ("changes", "gained", "is_level"),
    [
        ({"count": 41, "considered": 200}, 5.9, True),
        ({"count": 41, "considered": 200}, 6.1, False),
        ({"count": 40, "considered": 200}, 0.0, False),
        ({"count": 40, "considered": 60}, 0.0, True),
        ({"count": 41, "considered": 200, "noise_factor": 1.01}, 0.0, False),
        ({"count": 41, "considered": 200, "log_odds": 20.0}, 0.0, False),
    ],
)
def test_no_tilt_is_tried_where_many_matches_of_an_evident_place_gain_nothing_by_it(
    monkeypatch, changes, gained, is_level
):
    monkeypatch.setattr(search, "gained_by_tilt", lambda *_: gained)
    verifier = SimpleNamespace(index=SimpleNamespace(settings=CONSTELLATION))
    assert search._is_level(verifier, None, evidence_at(LEVEL, **changes)) == is_level


@pytest.mark.parametrize(
    ("log_odds", "count", "considered", "needs_no_other"),
    [
        (80.0, 41, 200, True),
        (74.0, 41, 200, False),
        (80.0, 40, 200, False),
        (80.0, 40, 60, True),
        (106.0, 41, 200, False),
        (106.0, 41, 60, True),
        (500.0, 41, 200, False),
        (500.0, 41, 60, True),
    ],
)
def test_a_tilted_pose_needs_no_other_trial_where_the_camera_is_level_or_it_explains_the_image(
    log_odds, count, considered, needs_no_other
):
    tilted, level = (evidence_at(pose, odds, count, considered) for pose, odds in ((TILTED, log_odds), (LEVEL, 100.0)))
    assert search._is_as_good(tilted, level, CONSTELLATION.decision) == needs_no_other
    assert not search._is_as_good(evidence_at(TILTED, 15.0), evidence_at(LEVEL, 16.0), CONSTELLATION.decision)


def test_poses_are_at_one_place_within_their_noise(cut):
    query = cut(*SEEN).query

    def is_one_place(one, other):
        return search.Found(query, CONSTELLATION.decision, [other]).knows(one)

    for deviation, reach in ((1.0, 5.0), (0.1, 2.0)):
        one = evidence_at(LEVEL, deviation=deviation)
        for step, same in ((reach - 0.1, True), (reach + 0.1, False)):
            other = evidence_at(Pose(LEVEL.center + step, LEVEL.turn), deviation=deviation)
            assert is_one_place(one, other) == same
            assert is_one_place(other, one) == same
    beside = evidence_at(Pose(TILTED.center + 30, TILTED.turn, TILTED.stretch))
    assert is_one_place(evidence_at(LEVEL), beside)


def test_of_poses_at_one_place_the_best_stays_and_a_tilted_one_must_be_clearly_better(cut):
    query = cut(*SEEN).query
    far = evidence_at(Pose(LEVEL.center + 500, LEVEL.turn), 40.0)
    level, better = evidence_at(LEVEL, 100.0), evidence_at(LEVEL, 101.0)
    found = search.Found(query, CONSTELLATION.decision)
    for one, left in ((level, [level]), (far, [level, far]), (better, [far, better]), (level, [far, better])):
        found.add(one)
        assert [id(pose) for pose in found.poses] == [id(pose) for pose in left]
    assert [id(pose) for pose in found.best_first] == [id(better), id(far)]
    hardly, clearly = (evidence_at(TILTED, 101.0 + CONSTELLATION.decision.tilted_margin + more) for more in (0, 0.1))
    found.add(hardly)
    assert found.poses[-1] is better
    found.add(clearly)
    assert found.poses[-1] is clearly and len(found.poses) == 2


@pytest.fixture(scope="module")
def built_twice(catalogue):
    """An index of the catalogue and, 900 m east, most of its middle once more, with other ground around it."""
    rng = np.random.default_rng(6)
    away = catalogue.positions - catalogue.positions.mean(axis=0)
    again = (np.abs(away).max(axis=1) < 450) & (rng.uniform(size=len(away)) < 0.8)
    moved = catalogue.positions[again] + STEP + rng.normal(0, 1.5, (again.sum(), 2))
    others = catalogue.positions[~again] + STEP + rng.normal(0, 60, ((~again).sum(), 2))
    positions = np.concatenate([catalogue.positions, moved, others])
    classes = np.concatenate([catalogue.classes, catalogue.classes[again], catalogue.classes[~again]])
    areas = np.concatenate([catalogue.areas_m2, catalogue.areas_m2[again], catalogue.areas_m2[~again]])
    return build_index(MapLandmarks(positions, classes, areas, np.zeros(len(positions), bool)), 1.0)


STEP = (900.0, 40.0)


def at_the_copy(built_twice, index, cut):
    """An image of the catalogue's middle, how it lies, and the evidence for the copy of its place."""
    made = cut(1000.0, 1000.0, 30.0, 1.0)
    here = made.pose.center + index.origin - built_twice.origin
    verifier = verification.Verifier(built_twice, EDGE, EDGE, 60.0)
    telling = made.query.select(verification.telling_objects(made.query, CONSTELLATION.limits.largest_objects))
    (copy,) = verification.verify(verifier, telling, [Pose(here + complex(*STEP), made.pose.turn)])
    return made.query, verifier, here, copy


def test_before_a_place_is_a_fix_ground_around_that_looks_the_same_is_tried(built_twice, index, cut):
    query, verifier, here, copy = at_the_copy(built_twice, index, cut)
    assert copy.log_odds > 100 and len(copy.matched) > 20
    best, other = search.with_copies(verifier, query, [copy], None)[:2]
    assert abs(best.pose.center - here) < 0.5 and other is copy
    assert best.log_odds > copy.log_odds + 20


def test_ground_that_a_prior_excludes_is_not_tried(built_twice, index, cut):
    query, verifier, here, copy = at_the_copy(built_twice, index, cut)
    there = copy.pose.center + built_twice.origin
    prior = Prior(position=(there.real, there.imag), radius=300.0)
    assert search.with_copies(verifier, query, [copy], prior) == [copy]


def test_ground_that_lies_nowhere_else_has_no_copies(index, cut):
    made = cut(1000.0, 1000.0, 30.0, 1.0)
    verifier = verification.Verifier(index, EDGE, EDGE, 60.0)
    (evidence,) = verification.verify(verifier, made.query, [made.pose])
    assert len(evidence.matched) > 20
    assert search.copies(verifier, made.query, evidence) == []


def looked_up(index, query, step=1):
    return Lookup(index, query, query_triangles(query, CONSTELLATION).every(step), None)


def test_the_first_search_takes_triangles_from_all_over_the_image(cut, index):
    everything = looked_up(index, cut(*SEEN).query)
    first, *others = search.rounds(everything)
    assert all(reach.lookup is everything for reach in others)
    assert (first.cap, *(reach.cap for reach in others)) == CONSTELLATION.limits.maximum_hits
    triangles, some = everything.triangles, first.lookup.triangles
    step = -(-len(triangles) // CONSTELLATION.limits.first_triangles)
    assert step > 1 and len(some) <= CONSTELLATION.limits.first_triangles
    np.testing.assert_array_equal(some.members, triangles.members[::step])
    few = looked_up(index, cut(*SEEN).query, len(triangles) // 100)
    assert len(search.rounds(few)[0].lookup.triangles) == len(few.triangles)


def test_of_a_larger_map_more_poses_are_tried_where_the_first_searches_brought_nothing(cut, index):
    query = cut(*SEEN).query
    assert {reach.seeds for reach in search.rounds(looked_up(index, query))} == {CONSTELLATION.limits.seeds}
    large = replace(CONSTELLATION, limits=replace(CONSTELLATION.limits, landmarks_of_few_seeds=len(index) // 9))
    seeds = [reach.seeds for reach in search.rounds(looked_up(replace(index, settings=large), query))]
    assert seeds[:2] == [CONSTELLATION.limits.seeds] * 2
    assert seeds[2:] == [pytest.approx(3 * CONSTELLATION.limits.seeds, rel=0.02)] * 2


def test_too_few_objects_are_told_with_how_many_more_the_catalogue_needs(index):
    needed = solver.objects_needed(index)
    assert 4 < needed < 12
    empty = MapLandmarks(np.empty((0, 2)), np.empty(0, np.uint8), np.empty(0), np.empty(0, bool))
    assert solver.objects_needed(build_index(empty, 1.0)) == MINIMUM_OBJECTS
    centers = np.random.default_rng(0).uniform(50, 600, (3, 2))
    objects = Landmarks(centers, np.ones(3, np.uint8), np.full(3, 200.0), np.zeros((3, 4), np.int64), np.zeros(3, bool))
    found = solver.localize(objects, (EDGE, EDGE), index, Prior(pixel_size_range=(0.4, 2.5)))
    shown, more = (dict(found.reason.values)[name] for name in ("shown", "needed"))
    assert dict(shown.values)["count"] == 3 and dict(more.values)["count"] == needed - 3


def as_landmarks(index, made):
    """The objects of a cut as extraction gives them."""
    query = made.query
    centers = np.column_stack([EDGE / 2 + query.points.real, EDGE / 2 - query.points.imag])
    areas = (np.exp(query.log_areas / 2) - 1) ** 2
    bounds = np.zeros((len(areas), 4), np.int64)
    return Landmarks(centers, index.class_values[query.ranks], areas, bounds, ~query.whole)


def test_a_cut_of_the_catalogue_is_found_with_each_object_matched_to_itself(index, cut):
    made = cut(*SEEN)
    found = solver.localize(as_landmarks(index, made), (EDGE, EDGE), index, Prior(pixel_size_range=(0.4, 2.5)))
    true = made.pose.center + index.origin
    assert found.is_fix and found.position == pytest.approx((true.real, true.imag), abs=1e-3)
    assert (found.heading_deg, found.pixel_size_m) == (
        pytest.approx(SEEN[2], abs=1e-3),
        pytest.approx(SEEN[3], rel=1e-5),
    )
    assert found.references == len(made.objects) == found.best.inliers
    np.testing.assert_array_equal(found.matches.on_map, made.objects)
    assert found.matches.residuals.max() < 1e-3 and 0 < found.error_95_m < 1
    assert found.confidence > 0.99 and found.mirror_log_odds < 10 and not found.search_capped
