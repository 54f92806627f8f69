"""Poses in the records of a flight."""

import numpy as np
import pytest

from semref.core.flight.model import PoseSource
from semref.core.flight.reported_pose import report_pose, tail_probability
from semref.core.flight.smoothing import Estimate
from semref.core.localization import LEAST_RISK


def reported(flown, localizer, sigma_m, risk=1e-6):
    state = np.array([420.0, -700.0, 1.0, np.log(3.0), 0.0, 0.0, 0.0, 0.0])
    known = np.diag([sigma_m**2, sigma_m**2, 1e-4, 1e-4, 1.0, 1.0, 1e-4, 1e-4])
    return report_pose(flown.images[2], localizer, Estimate(state, known), risk, 1)


def test_the_risk_of_a_pose_is_that_of_its_track_or_its_own(flown, localizer):
    exact, loose = reported(flown, localizer, 0.05), reported(flown, localizer, 12.0)
    assert exact.risk == pytest.approx(1e-6, rel=0.5) and loose.risk > 0.05
    assert reported(flown, localizer, 0.05, risk=0.0).risk >= LEAST_RISK
    assert loose.is_fix and loose.track == 1


def test_a_pose_that_may_be_beside_its_image_is_only_predicted(flown, localizer):
    lost = reported(flown, localizer, 120.0)
    assert not lost.is_fix and lost.source is PoseSource.PREDICTED and lost.track == 0
    assert lost.error_95_m == pytest.approx(294, abs=1) and lost.localization().position is None
    assert "95 % radius of this image (294 m) is too large for its footprint width (288 m)" in str(lost.reason)


def test_the_chance_of_a_wrong_place_has_the_tails_of_measurements():
    known = np.diag([4.0, 1.0, 1.0, 1.0])
    assert tail_probability(known, 0.0) == 1.0
    assert tail_probability(known, 20.0) == pytest.approx((1 + 100 / 4) ** -2)
    drawn = np.random.default_rng(1).standard_t(4, (200_000, 2))
    assert (np.abs(drawn[:, 0]) > 6).mean() < tail_probability(np.eye(4), 6.0) < 0.02
