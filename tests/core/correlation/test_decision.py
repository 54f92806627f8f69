"""The verdict on known peaks and covariances."""

import numpy as np
import pytest

from semref.core.correlation.decision import (
    decide,
    exact_enough,
    fisher_z,
    over_mirror,
    over_runner_up,
    position_error_95,
    risk_of_peaks,
    smaller_lead,
)
from semref.core.correlation.settings import CORRELATION
from semref.core.localization import CorrelationPeaks, Status


@pytest.mark.parametrize(
    "score, runner_up, mirror, status, code",
    [
        (0.7, 0.3, 0.3, Status.FIX, None),
        (0.1, 0.0, 0.0, Status.NO_MATCH, "localization.agreement_too_low"),
        (0.7, 0.3, 0.65, Status.NO_MATCH, "localization.mirror_agrees"),
        (0.7, 0.65, 0.3, Status.AMBIGUOUS, "localization.two_places_agree"),
    ],
)
def test_a_fix_needs_a_score_and_a_lead_over_both_opponents(score, runner_up, mirror, status, code):
    found, reason = decide(CorrelationPeaks(score, runner_up, mirror))
    assert (found, reason and reason.code) == (status, code)


def test_a_larger_risk_that_is_allowed_makes_a_fix_of_a_smaller_lead():
    peaks = CorrelationPeaks(0.45, 0.3, 0.3)
    risk = risk_of_peaks(peaks)
    assert 1e-9 < risk < 0.5
    assert decide(peaks, 1.01 * risk)[0] == Status.FIX != decide(peaks, 0.99 * risk)[0]


def test_the_risk_falls_with_the_lead_over_the_stronger_opponent():
    peaks = [CorrelationPeaks(0.7, 0.1, mirror) for mirror in (0.69, 0.6, 0.3)]
    risks = [risk_of_peaks(one) for one in peaks]
    assert risks == sorted(risks, reverse=True) and risks[0] > 0.9 and risks[-1] < 1e-4
    assert smaller_lead(peaks[2]) == pytest.approx(np.arctanh(0.7) - np.arctanh(0.3))


def test_the_error_radius_grows_with_the_covariance():
    radii = [position_error_95(factor * np.diag([4.0, 1.0]), 0.7, 4.0) for factor in (1, 4, 16)]
    assert radii[1] / radii[0] == pytest.approx(2, rel=0.02) and radii[2] / radii[1] == pytest.approx(2, rel=0.02)


def test_the_error_radius_grows_as_image_and_map_agree_less():
    spread = np.diag([4.0, 1.0])
    radii = [position_error_95(spread, score, 4.0) for score in (0.9, 0.8, 0.6, 0.4)]
    assert radii == sorted(radii) and radii[0] > 1 and radii[-1] > 5 * radii[1]
    assert position_error_95(np.zeros((2, 2)), 0.9, 4.0) == pytest.approx(0.6)
    assert position_error_95(np.full((2, 2), np.inf), 0.9, 4.0) == np.inf


def test_a_fix_has_to_be_exact_for_the_ground_its_image_shows():
    assert exact_enough(CORRELATION.largest_error * 800, 800.0) == ("fix", None)
    status, reason = exact_enough(21.26, 800.0)
    assert status == "ambiguous" and "within 21.3 m" in str(reason) and "needs 20 m" in str(reason)
    assert "in all directions" in str(exact_enough(float("inf"), 800.0)[1])


def test_leads_are_differences_of_fishers_z_which_has_bounds():
    peaks = CorrelationPeaks(0.6, 0.2, -0.4)
    assert over_runner_up(peaks) == pytest.approx(np.arctanh(0.6) - np.arctanh(0.2))
    assert over_mirror(peaks) == pytest.approx(np.arctanh(0.6))
    assert smaller_lead(peaks) == over_runner_up(peaks)
    assert fisher_z(1.0) == fisher_z(0.999) == pytest.approx(np.arctanh(0.999)) and fisher_z(-0.3) == 0


def test_the_risk_is_a_logistic_curve_of_the_lead_and_of_the_agreement():
    offset, slope, own = CORRELATION.confidence_curve
    for risk in (0.01, 0.3):
        lead = (np.log(1 / risk - 1) - offset - own * np.arctanh(0.6)) / slope
        peaks = CorrelationPeaks(0.6, np.tanh(np.arctanh(0.6) - lead), -1.0)
        assert risk_of_peaks(peaks) == pytest.approx(risk)
        assert decide(peaks, risk * 1.001)[0] == Status.FIX and decide(peaks, risk * 0.999)[0] != Status.FIX


@pytest.mark.parametrize(("score", "noise"), [(0.5, 3.0), (0.95, CORRELATION.least_noise), (0.05, 99.0), (0.1, 99.0)])
def test_the_error_radius_is_that_of_the_larger_axis_by_the_noise_and_of_the_pixels(score, noise):
    turn = np.array([[0.6, -0.8], [0.8, 0.6]])
    spread = turn @ np.diag([4.0, 1.0]) @ turn.T
    expected = np.hypot(CORRELATION.error_factor * noise * 2, CORRELATION.error_floor_px * 4.0)
    assert position_error_95(spread, score, 4.0) == pytest.approx(expected)


def test_where_both_opponents_are_as_near_it_is_chance():
    assert decide(CorrelationPeaks(0.7, 0.65, 0.65))[0] == Status.NO_MATCH
