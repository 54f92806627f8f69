from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from semref.core.constellation.hypotheses import SeenLandmarks
from semref.core.constellation.index import AREA_BINS
from semref.core.constellation.matching import Nearest, center_noise, noise_factor
from semref.core.constellation.parts import Side
from semref.core.constellation.search import ROUGH_GATES
from semref.core.constellation.settings import CONSTELLATION
from semref.core.constellation.verification import (
    ASSUMED_OBJECTS,
    ASSUMED_OBJECTS_TILTED,
    Verifier,
    averaged_log_odds,
    expected_objects,
    match_ratios,
    rough_scores,
    telling_objects,
    verify,
    verify_tilted,
    weigh_all,
)
from semref.core.geometry.pose import Pose, fit_similarity, fit_tilted, huber, numbers_of

EDGE = 640
TILT = {"stretch": 0.008 - 0.004j, "slope": 1.5e-4 + 1e-4j}


def weigh(verifier, query, pose):
    """Return the evidence for one pose with the assumed noise."""
    return weigh_all(verifier, query, [pose], np.ones(1))[0]


def missing(evidence):
    return len(np.setdiff1d(evidence.expected, evidence.objects))


@pytest.fixture(scope="module")
def made(cut):
    return cut(900.0, 1100.0, 70.0, 1.1)


@pytest.fixture(scope="module")
def verifier(index):
    return Verifier(index, EDGE, EDGE, 9.0)


def test_the_true_pose_has_high_odds_and_matches_every_object_with_itself(verifier, made):
    evidence = weigh(verifier, made.query, made.pose)
    assert evidence.log_odds > 100
    assert missing(evidence) == 0
    np.testing.assert_array_equal(evidence.objects, made.objects[evidence.matched])
    assert len(evidence.matched) == len(made.objects)


def test_poses_verified_together_have_their_own_evidence(index, verifier, made):
    """True, near, far and impossible poses; some lose their matches rounds before the others."""
    rng = np.random.default_rng(11)
    query = noisy(made, index, made.pose)
    off = np.r_[0, 3 - 2j, rng.uniform(-400, 400, 20) + 1j * rng.uniform(-400, 400, 20), 1e5]
    turned = np.r_[1, 1.005 * np.exp(0.004j), rng.uniform(0.7, 1.4, 20) * np.exp(1j * rng.uniform(-3, 3, 20)), 1]
    poses = [Pose(complex(made.pose.center + a), complex(made.pose.turn * b)) for a, b in zip(off, turned)]
    together = verify(verifier, query, poses)
    assert len(together) == len(poses) and verify(verifier, query, []) == []
    for pose, found in zip(poses, together):
        (alone,) = verify(verifier, query, [pose])
        assert found.log_odds == pytest.approx(alone.log_odds, rel=1e-9, abs=1e-9)
        assert np.abs(found.pose.on_map(query.points) - alone.pose.on_map(query.points)).max() < 1e-6
        assert found.noise_factor == pytest.approx(alone.noise_factor, rel=1e-9)
        for name in ("matched", "objects", "expected", "possible"):
            np.testing.assert_array_equal(getattr(found, name), getattr(alone, name))
        np.testing.assert_allclose(found.deviations, alone.deviations, rtol=1e-9)
        assert missing(found) == missing(alone)
    assert together[0].log_odds > 100 > 0 > max(found.log_odds for found in together[2:])
    # Far poses moved or stayed; no pose moves to the place of another.
    assert together[-1].pose == poses[-1] and len({found.pose for found in together}) > 15


def test_evidence_of_several_poses_is_averaged_for_each(index):
    rng = np.random.default_rng(5)
    ratios = np.exp(rng.normal(0, 3, (4, 30)))
    matched = ratios > 1
    matched[2] = False
    missing = np.array([0, 3, 7, 30])
    together = averaged_log_odds(ratios, matched, missing, np.array([3, 5, 3, 5]), CONSTELLATION.noise)
    for number, makers in enumerate((3, 5, 3, 5)):
        terms = []
        for share in CONSTELLATION.noise.distractors:
            gained = np.log(share + (1 - share) * ratios[number])
            mean = max(gained[matched[number]].mean(), 0) if matched[number].any() else 0
            for seen in CONSTELLATION.noise.visibility:
                terms.append(gained.sum() - makers * mean + missing[number] * np.log(1 - seen))
        assert together[number] == pytest.approx(np.logaddexp.reduce(terms) - np.log(len(terms)))
    # An object whose ratio is 1 changes nothing.
    more = np.column_stack([ratios, np.ones(4)]), np.column_stack([matched, np.zeros(4, bool)])
    again = averaged_log_odds(*more, missing, 3, CONSTELLATION.noise)
    np.testing.assert_allclose(again[[0, 2]], together[[0, 2]], rtol=1e-12)


def test_objects_of_the_map_that_the_image_lacks_are_counted_and_lower_the_odds(verifier, made):
    all_but_ten = made.query.select(np.arange(len(made.objects))[10:])
    everything, fewer = (weigh(verifier, query, made.pose) for query in (made.query, all_but_ten))
    assert 5 <= missing(fewer) <= 10
    assert fewer.log_odds < everything.log_odds


def test_a_match_speaks_for_a_pose_by_its_distance_its_size_and_how_rare_both_are():
    """The likelihood ratio of docs/explanation/method.md, worked out for each object of a catalogue of three."""
    settings = CONSTELLATION
    sizes = np.log([100.0, 400.0, 50.0])
    by_class = np.linspace(0.01, 0.5, 2 * len(AREA_BINS)).reshape(2, -1)
    densities = np.array([1e-3, 2e-4, 5e-3])
    index = SimpleNamespace(settings=settings, log_areas=sizes, densities=densities, area_densities=by_class)
    query = SeenLandmarks(
        np.zeros(5, complex), np.array([0, 1, 1, 0, 0]), np.log([80.0, 30.0, 9.0, 25.0, 60.0]), None, 900.0
    )
    objects, distances = np.array([0, 1, 2, -1, 0]), np.array([1.0, 3.0, 0.0, np.inf, 60.0])
    deviations = np.array([1.0, 2.0, 0.7, 1.0, 10.0])
    found = match_ratios(index, query, Nearest(distances, objects, deviations), np.log(2.0))

    def normal(x, deviation):
        return np.exp(-0.5 * (x / deviation) ** 2) / np.sqrt(2 * np.pi) / deviation

    for k in (0, 1, 2):
        area = query.log_areas[k] + np.log(4.0)
        off = area - sizes[objects[k]]
        size = (1 - settings.noise.area_outliers) * normal(off, settings.noise.area_deviation)
        size += settings.noise.area_outliers * normal(off, settings.noise.area_outlier_deviation)
        usual = by_class[query.ranks[k], np.flatnonzero(area >= AREA_BINS)[-1]]
        place = normal(distances[k], deviations[k]) * normal(0, deviations[k]) / densities[objects[k]]
        assert found[k] == pytest.approx(place * size / usual)
    # Without a match, or with one beyond the gate.
    assert found[3] == found[4] == 0


def test_rough_fits_draw_near_poses_to_the_truth_and_leave_far_ones(index, made):
    query = made.query.select(telling_objects(made.query, CONSTELLATION.limits.rough_objects))
    gates = [gate * query.diagonal for gate in ROUGH_GATES]
    offsets = np.array([0, 3 - 2j, 400 + 300j])
    grown = np.array([1, 1.005 * np.exp(0.004j), 1])
    centers, turns, scores = rough_scores(index, query, made.pose.center + offsets, made.pose.turn * grown, gates)
    assert np.abs(centers[:2] - made.pose.center).max() < 0.01
    assert np.abs(turns[:2] / made.pose.turn - 1).max() < 1e-4
    assert scores[0] == pytest.approx(scores[1], rel=1e-3) and scores[0] > 100 > 0 > scores[2]


def test_chosen_objects_are_the_largest_whole_ones_in_order():
    areas = np.log([10.0, 90.0, 50.0, 70.0, 80.0, 60.0])
    ranks, whole = np.array([0, 1, 0, -1, 1, 0]), np.array([1, 1, 1, 1, 0, 1], bool)
    query = SeenLandmarks(np.arange(6) + 0j, ranks, areas, whole, 100.0)
    assert telling_objects(query, 2).tolist() == [1, 5]
    assert telling_objects(query, 99).tolist() == [0, 1, 2, 5]


def test_expected_are_whole_objects_well_inside_that_are_large_enough(index, verifier, made):
    found = expected_objects(verifier, made.query, numbers_of([made.pose]))[0]
    seen = made.pose.in_image(index.points)
    edges = np.exp(index.log_areas / 2) / 1.1
    inside = (np.abs(seen.real) < EDGE / 2 - edges) & (np.abs(seen.imag) < EDGE / 2 - edges)
    assert sorted(found) == np.flatnonzero(inside).tolist()
    # For an image with too many objects, no expected object is smaller than the smallest used one.
    smallest = float(np.median(made.query.log_areas))
    larger = made.query.select(np.flatnonzero(made.query.log_areas >= smallest))
    limits = replace(CONSTELLATION.limits, largest_objects=len(larger.points))
    fewer = Verifier(replace(index, settings=replace(CONSTELLATION, limits=limits)), EDGE, EDGE, 9.0)
    limit = larger.log_areas.min() + 2 * np.log(1.1) + CONSTELLATION.noise.area_deviation
    expected = np.flatnonzero(inside & (index.log_areas > limit))
    assert sorted(expected_objects(fewer, larger, numbers_of([made.pose]))[0]) == expected.tolist()
    assert 0 < len(expected) < inside.sum()
    # For one side, only objects of that side.
    side = Side(1j, 50.0)
    there = expected_objects(replace(verifier, side=side), made.query, numbers_of([made.pose]))[0]
    assert sorted(there) == np.flatnonzero(inside & (seen.imag > 50.0)).tolist()
    assert 0 < len(there) < inside.sum()
    # Of a leveled image, a trapezoid, only objects that the photo shows whole: not those of the corners.
    half = EDGE / 2
    view = np.array([-half + half * 1j, half + half * 1j, half / 4 - half * 1j, -half / 4 - half * 1j])
    there = expected_objects(replace(verifier, view=view), made.query, numbers_of([made.pose]))[0]
    slant = np.hypot(2, 0.75)
    shown = (2 * np.abs(seen.real) - 0.75 * seen.imag - 1.25 * half) / slant < -edges
    assert sorted(there) == np.flatnonzero(inside & shown).tolist()
    assert 0 < len(there) < inside.sum()


def test_a_tilted_camera_is_verified_from_a_level_pose(index, verifier, made):
    tilted = Pose(made.pose.center, made.pose.turn, 0.008 - 0.004j, 1.5e-4 + 1e-4j)
    seen = tilted.in_image(index.points)
    objects = np.flatnonzero((np.abs(seen.real) < EDGE / 2) & (np.abs(seen.imag) < EDGE / 2))
    log_areas = index.log_areas[objects] - 2 * np.log(tilted.pixel_sizes(seen[objects]))
    whole = np.ones(len(objects), bool)
    query = SeenLandmarks(seen[objects], index.ranks[objects], log_areas, whole, made.query.diagonal)
    level, found = verify(verifier, query, [made.pose])[0], verify_tilted(verifier, query, [made.pose], [0j])[0]
    assert found.log_odds > level.log_odds + 50 and len(found.matched) == len(objects)
    np.testing.assert_array_equal(found.objects, objects[found.matched])
    assert np.abs(found.pose.on_map(query.points) - index.points[objects]).max() < 0.5
    assert abs(found.pose.slope - tilted.slope) < 2e-5
    (lost,) = verify_tilted(verifier, query, [Pose(made.pose.center + 900, made.pose.turn)], [0j])
    assert lost.log_odds < 0


def noisy(cut_of, index, pose, seed=4, share=1.3):
    """Return objects of a cut with a known noise of the centers, a share of the assumed noise."""
    rng = np.random.default_rng(seed)
    objects = cut_of.objects
    noise = share * center_noise(cut_of.query.log_areas, 1.0, CONSTELLATION.noise)
    off = noise * (rng.normal(size=len(objects)) + 1j * rng.normal(size=len(objects)))
    points = pose.in_image(index.points[objects]) + off
    log_areas = index.log_areas[objects] - 2 * np.log(pose.pixel_sizes(points))
    return SeenLandmarks(points, index.ranks[objects], log_areas, np.ones(len(objects), bool), cut_of.query.diagonal)


def test_tilted_poses_verified_together_have_the_evidence_of_each_alone(index, verifier, made):
    query = noisy(made, index, replace(made.pose, **TILT))
    poses = [Pose(made.pose.center + step, made.pose.turn) for step in (0, 1.5 - 1j, 900, 25j)]

    def verified(some):
        return verify_tilted(verifier, query, some, [0j] * len(some))

    for together, pose in zip(verified(poses), poses):
        (alone,) = verified([pose])
        assert together.log_odds == pytest.approx(alone.log_odds, rel=1e-9)
        assert together.pose.center == pytest.approx(alone.pose.center, rel=1e-9)
        for name in ("matched", "objects", "expected", "possible"):
            np.testing.assert_array_equal(getattr(together, name), getattr(alone, name))


@pytest.mark.parametrize(("tilt", "numbers"), [({}, 4), (TILT, 8)], ids=["level", "tilted"])
def test_a_verified_pose_is_the_fit_of_its_matches_by_hubers_weights(index, verifier, made, tilt, numbers):
    query = noisy(made, index, replace(made.pose, **tilt))
    found = (verify_tilted(verifier, query, [made.pose], [0j]) if tilt else verify(verifier, query, [made.pose]))[0]
    assert len(found.matched) == len(made.objects)
    image, on_map = query.points[found.matched], index.points[found.objects]
    assumed = center_noise(query.log_areas[found.matched], abs(found.pose.turn), CONSTELLATION.noise)
    distances = np.abs(found.pose.on_map(image) - on_map)
    assert found.noise_factor == pytest.approx(noise_factor(distances / assumed, numbers), rel=1e-4)
    pose = found.pose
    for _ in range(30):
        weights = huber(np.abs(pose.on_map(image) - on_map), found.noise_factor * assumed) / assumed**2
        if tilt:
            pose = fit_tilted(image, on_map, weights**-0.5, pose, query.diagonal)
        else:
            pose = Pose(*(complex(part) for part in fit_similarity(image, on_map, weights)))
    assert np.abs(pose.on_map(image) - found.pose.on_map(image)).max() < 0.02


def test_log_odds_are_those_of_all_objects_that_could_be_on_the_map(index, verifier, made):
    seen = made.query.select(np.arange(len(made.objects))[6:])
    count, noise = len(seen.points), CONSTELLATION.noise
    for tilt, makers in ((0j, ASSUMED_OBJECTS), (1e-9 + 0j, ASSUMED_OBJECTS_TILTED)):
        evidence = weigh(verifier, seen, replace(made.pose, slope=tilt))
        assert len(evidence.matched) == count == evidence.considered and missing(evidence) > 0
        deviations = center_noise(seen.log_areas, 1.1, noise)
        nearest = Nearest(np.zeros(count), made.objects[6:], deviations)
        ratios = match_ratios(index, seen, nearest, np.full(count, np.log(1.1)))
        expected = averaged_log_odds(ratios, np.ones(count, bool), missing(evidence), makers, noise)
        assert evidence.log_odds == pytest.approx(expected, rel=1e-4)
