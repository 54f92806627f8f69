from dataclasses import replace

import numpy as np
import pytest

from semref.core.constellation import clusters
from semref.core.constellation.clusters import Poses, cluster, poses_in_cells
from semref.core.constellation.decision import Opponents, may_be_a_fix, risk_against, risk_of_best, verdict
from semref.core.constellation.settings import CONSTELLATION
from semref.core.localization import LEAST_RISK, RISK, Status

SURE = Opponents(200.0, -20.0, 0.0, 10_000, False)


def risk(**changed):
    return risk_of_best(replace(SURE, **changed), CONSTELLATION.decision)


def test_the_risk_falls_with_the_log_odds_and_never_vanishes():
    risks = [risk(log_odds=value) for value in (-10.0, 0.0, 5.0, 12.0, 25.0, 40.0, 80.0)]
    assert risks == sorted(risks, reverse=True) and len(set(risks)) == len(risks)
    assert risks[0] > 0.9 and risks[-1] < 1e-8
    assert risk(log_odds=1e6) == LEAST_RISK


@pytest.mark.parametrize("opponent", ["runner_up", "mirror"])
def test_the_risk_grows_with_either_opponent(opponent):
    risks = [risk(**{opponent: value}) for value in (0.0, 50.0, 120.0, 199.0)]
    assert risks == sorted(risks) and risks[-1] > 0.5


def test_a_larger_map_and_a_capped_search_ask_for_more():
    usual = risk(log_odds=30.0)
    assert risk(log_odds=30.0, landmarks=1_000_000) > 5 * usual
    assert risk(log_odds=30.0, landmarks=100) == usual
    assert risk(log_odds=30.0, is_capped=True) > 10 * usual


@pytest.mark.parametrize(
    ("changed", "rivals", "status", "said"),
    [
        ({}, 0, Status.FIX, None),
        ({"log_odds": 8.0}, 0, Status.NO_MATCH, "The best candidate position (log odds 8.0) has an error probability"),
        ({"runner_up": 199.0}, 1, Status.AMBIGUOUS, "1 other position fits almost as well as the best one."),
        ({"mirror": 199.0}, 0, Status.NO_MATCH, "The mirrored image matches almost as well"),
        ({"mirror": 199.0, "runner_up": 199.0}, 1, Status.NO_MATCH, "The mirrored image matches almost as well"),
    ],
)
def test_the_reason_states_what_is_missing(changed, rivals, status, said):
    found, reason = verdict(replace(SURE, **changed), rivals, RISK, CONSTELLATION.decision)
    assert found == status and (reason is None if said is None else str(reason).startswith(said))


def test_the_risk_that_is_allowed_decides_and_only_a_rival_above_even_odds_adds_to_it():
    doubtful = replace(SURE, log_odds=20.0)
    told = risk_of_best(doubtful, CONSTELLATION.decision)
    assert verdict(doubtful, 0, 1.01 * told, CONSTELLATION.decision)[0] == Status.FIX
    assert verdict(doubtful, 0, 0.99 * told, CONSTELLATION.decision)[0] == Status.NO_MATCH
    assert may_be_a_fix(replace(doubtful, mirror=19.0), 1.01 * told, CONSTELLATION.decision)
    assert risk_against(doubtful, 19.0, CONSTELLATION.decision) > 100 * told
    alone, worse, little = (risk_against(doubtful, rival, CONSTELLATION.decision) for rival in (0.0, -5.0, 0.5))
    assert alone == worse < little


def made_poses(rng, count, spread):
    """Return poses spread evenly over a number of positions, a few sizes and headings."""
    places = rng.integers(-spread, spread, (4, count)).astype(np.int32)
    places[2:] //= max(spread // 3, 1)
    centers, turns = rng.normal(size=(2, count)) + 1j * rng.normal(size=(2, count))
    return Poses(centers, turns, np.arange(count) + 0j, places)


@pytest.mark.parametrize("spread", [3, 30, 300, 3_000_000])
def test_of_very_many_poses_the_fullest_cells_are_the_same_as_when_all_are_sorted(monkeypatch, spread):
    """Cases: few full cells; many cells, some full; so many cells that few contain two poses."""
    poses = made_poses(np.random.default_rng(4), 30_000, spread)
    counted = cluster([poses], False, 40)
    monkeypatch.setattr(clusters, "_SORTED_AT_ONCE", 10**9)
    everything = cluster([poses], False, 40)
    assert len(counted.votes) >= 40
    for name in ("centers", "turns", "focuses", "votes"):
        np.testing.assert_array_equal(getattr(counted, name), getattr(everything, name))


def test_the_fullest_cells_are_found_though_others_share_their_groups(monkeypatch):
    """Two full cells among single poses; there are so few groups that all are large."""
    rng = np.random.default_rng(8)
    poses = made_poses(rng, 30_000, 3_000_000)
    poses.places[:, :500] = np.array([[40], [80], [2], [5]])
    poses.places[:, 500:900] = np.array([[-40], [80], [2], [5]])
    mixed = poses.select(rng.permutation(30_000))
    for bits in (8, 12, 21):
        monkeypatch.setattr(clusters, "_GROUP_BITS", bits)
        assert cluster([mixed], False, 2).votes.tolist() == [500, 400]


def test_clusters_of_portions_are_those_of_all_poses_together():
    poses = made_poses(np.random.default_rng(5), 30_000, 60)
    parts = [poses.select(part) for part in np.split(np.arange(30_000), [0, 100, 20_000])]
    for portions in (parts, [*parts[:2], poses.select(np.arange(0)), *parts[2:]]):
        one, other = cluster(portions, True, 40), cluster([poses], True, 40)
        for name in ("centers", "turns", "focuses", "votes"):
            np.testing.assert_array_equal(getattr(one, name), getattr(other, name))
        assert one.capped
    assert len(cluster([], False, 40).votes) == 0


def test_poses_of_one_cell_are_one_cluster_at_their_mean(monkeypatch):
    centers, turns = np.array([10 + 10j, 12 + 14j, 900 + 0j]), np.array([1 + 0j, 1.002 + 0j, 1 + 0j])
    focuses = np.array([0j, 30 + 0j, 7j])
    monkeypatch.setattr(clusters, "CELL_OF_IMAGE", 0.1)
    seeds = cluster([poses_in_cells(centers, turns, focuses, 900.0)], False, 1)
    assert seeds.votes.tolist() == [2] and not seeds.capped
    assert (seeds.centers[0], seeds.turns[0], seeds.focuses[0]) == pytest.approx((11 + 12j, 1.001, 15))
