"""The constellation's decision from log odds."""

from dataclasses import replace

import pytest

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


def test_the_risk_that_is_allowed_decides():
    doubtful = replace(SURE, log_odds=20.0)
    told = risk_of_best(doubtful, CONSTELLATION.decision)
    assert verdict(doubtful, 0, 1.01 * told, CONSTELLATION.decision)[0] == Status.FIX
    assert verdict(doubtful, 0, 0.99 * told, CONSTELLATION.decision)[0] == Status.NO_MATCH
    assert may_be_a_fix(replace(doubtful, mirror=19.0), 1.01 * told, CONSTELLATION.decision)
    assert risk_against(doubtful, 19.0, CONSTELLATION.decision) > 100 * told


def test_a_rival_below_even_odds_takes_nothing_off_and_one_above_does():
    doubtful = replace(SURE, log_odds=20.0)
    alone, worse, little = (risk_against(doubtful, rival, CONSTELLATION.decision) for rival in (0.0, -5.0, 0.5))
    assert alone == worse < little
