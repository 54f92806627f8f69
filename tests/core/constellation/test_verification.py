"""Evidence for poses of a cut of a made catalogue; noise of known size."""

import numpy as np
import pytest

from semref.core.constellation.settings import CONSTELLATION
from semref.core.constellation.verification import Verifier, biweight, noise_factor, verify, weigh
from semref.core.geometry.pose import Pose, fit_similarity

EDGE = 640


@pytest.fixture(scope="module")
def made(cut):
    return cut(900.0, 1100.0, 70.0, 1.1)


@pytest.fixture(scope="module")
def verifier(index):
    return Verifier(index, EDGE, EDGE, 9.0)


def test_the_true_pose_has_high_odds_and_matches_every_object_with_itself(verifier, made):
    evidence = weigh(verifier, made.query, made.pose, 1.0)
    assert evidence.log_odds > 100
    assert evidence.missing == 0
    np.testing.assert_array_equal(evidence.objects, made.objects[evidence.matched])
    assert len(evidence.matched) == len(made.objects)


@pytest.mark.parametrize("off, turn", [(150 + 40j, 1), (-90 - 200j, 1), (0, -1), (0, 1j), (0, 1.3)])
def test_any_other_pose_has_negative_log_odds(verifier, made, off, turn):
    pose = Pose(made.pose.center + off, made.pose.turn * turn)
    assert weigh(verifier, made.query, pose, 1.0).log_odds < 0


def test_a_pose_a_little_off_is_moved_to_the_true_one(verifier, made):
    near = Pose(made.pose.center + 1.5 - 1j, made.pose.turn * np.exp(0.003j))
    found = verify(verifier, made.query, near).pose
    assert abs(found.center - made.pose.center) < 0.01
    assert abs(found.turn / made.pose.turn - 1) < 1e-4


def test_objects_of_the_map_that_the_image_lacks_are_counted_and_lower_the_odds(verifier, made):
    all_but_ten = made.query.select(np.arange(len(made.objects))[10:])
    everything, fewer = (weigh(verifier, query, made.pose, 1.0) for query in (made.query, all_but_ten))
    assert 5 <= fewer.missing <= 10
    assert fewer.log_odds < everything.log_odds


def test_a_match_weighs_less_the_nearer_it_is_to_the_gate():
    assert biweight(np.array([0.0, 2.0, 4.0, 9.0]), np.full(4, 4.0)).tolist() == [1.0, 0.5625, 0.0, 0.0]


@pytest.mark.parametrize("count", [5, 12, 200])
def test_noise_is_measured_without_bias_from_few_matches_or_many(count):
    rng = np.random.default_rng(count)
    factors = []
    for _ in range(300):
        image = rng.uniform(-600, 600, count) + 1j * rng.uniform(-600, 600, count)
        on_map = image + rng.normal(size=count) + 1j * rng.normal(size=count)
        center, turn = fit_similarity(image, on_map, np.ones(count))
        factors.append(noise_factor(np.abs(center + turn * image - on_map), 4, CONSTELLATION) ** 2)
    assert np.mean(factors) == pytest.approx(1, abs=0.08)


def test_a_few_exact_matches_do_not_make_the_noise_vanish():
    assert noise_factor(np.zeros(4), 4, CONSTELLATION) > 0.7 > noise_factor(np.zeros(40), 4, CONSTELLATION)
