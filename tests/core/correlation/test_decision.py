import numpy as np
import pytest

from semref.core.correlation.decision import (
    LEAST_CHANCE,
    decide,
    decide_accuracy,
    fisher_z,
    lead,
    position_error_95,
    risk_of_peaks,
    surprises,
)
from semref.core.correlation.settings import CORRELATION
from semref.core.geometry.radius import CIRCLE_95
from semref.core.localization import CorrelationPeaks, Status


@pytest.mark.parametrize(
    "peaks, status, said",
    [
        (CorrelationPeaks(0.7, 0.3, 0.3, 30.0, 2.0), Status.FIX, None),
        (CorrelationPeaks(0.1, 0.0, 0.0), Status.NO_MATCH, "not significantly better than chance"),
        (CorrelationPeaks(0.7, 0.3, 0.65), Status.NO_MATCH, "not significantly better than for the mirrored image"),
        (CorrelationPeaks(0.7, 0.69, 0.3, 30.0, 29.0), Status.AMBIGUOUS, "Two places match almost equally well"),
        (CorrelationPeaks(0.41, 0.4, 0.38), Status.NO_MATCH, "not significantly better than chance"),
    ],
)
def test_a_fix_needs_a_score_and_a_lead_over_both_opponents(peaks, status, said):
    found, reason = decide(peaks)
    assert found == status and (reason is None if said is None else said in str(reason))


def test_the_risk_falls_with_the_lead_over_the_stronger_opponent_and_with_the_detail():
    peaks = [CorrelationPeaks(0.7, 0.1, mirror, detail) for mirror, detail in ((0.69, 0), (0.6, 0), (0.3, 0), (0.3, 9))]
    risks = [risk_of_peaks(one) for one in peaks]
    assert risks == sorted(risks, reverse=True) and risks[0] > 0.9 and risks[-1] < 1e-4
    assert lead(peaks[2]) == pytest.approx(np.arctanh(0.7) / np.arctanh(0.3) - 1)
    assert lead(CorrelationPeaks(0.7, 0.0, 0.0)) == pytest.approx(np.arctanh(0.7) / LEAST_CHANCE - 1)


def test_outlines_are_evidence_for_a_place_and_against_it_where_they_are_as_usual():
    labels, usual, seen, alike = (
        risk_of_peaks(CorrelationPeaks(0.5, 0.3, 0.3, 4.0, 0.0, *outlines))
        for outlines in ((), (0.0, 0.0), (8.0, 0.0), (8.0, 8.0))
    )
    assert seen < labels / 50 and labels < usual < 3 * labels and alike > 2 * seen


def test_another_place_that_is_as_good_makes_the_best_one_a_guess():
    assert 0.5 <= risk_of_peaks(CorrelationPeaks(0.7, 0.7, 0.1, 60.0, 60.0)) < 0.7


def test_detail_surprises_where_it_is_unlike_all_others():
    usual, spread, weight = CORRELATION.usual_detail
    assert surprises([usual], [usual] * 9, CORRELATION.usual_detail)[0] == pytest.approx(0)
    others = list(np.random.default_rng(3).normal(usual, spread, 14))
    found = [surprises([usual + units * spread], others, CORRELATION.usual_detail)[0] for units in (-6, 2, 4, 8, 16)]
    assert found == sorted(found) and found[0] < 0 < found[1] < 5 and found[3] > 8
    wild = [usual + 5 * (one - usual) for one in others]
    assert surprises([usual + 8 * spread], wild, CORRELATION.usual_detail)[0] < 4 < found[3]


def test_a_surprise_is_what_students_density_falls_short_of_its_highest():
    others = [-1.0, 1.0, -1.0, 1.0, 0.0]
    # Mean 0, spread 1 with 4 degrees of freedom: t = x / √(1 + 1/5), density ∝ (1 + t² / 4)^(−5/2).
    assert surprises([3.0], others, (0.0, 0.0, 0.0))[0] == pytest.approx(2.5 * np.log(1 + 9 / 1.2 / 4))


def test_two_places_with_the_same_detail_are_no_surprise():
    alone, *_ = surprises([20.0, 1.0, 1.2], [1.0] * 8, CORRELATION.usual_detail)
    twice = surprises([20.0, 20.0, 1.2], [1.0] * 8, CORRELATION.usual_detail)
    assert alone > 25 and max(twice) < alone / 3


def test_the_error_radius_has_the_floor_of_the_overviews_pixels_and_can_be_infinite():
    assert position_error_95(np.zeros((2, 2)), 4.0) == pytest.approx(0.6)
    assert position_error_95(np.full((2, 2), np.inf), 4.0) == np.inf


def test_a_fix_has_to_be_exact_for_the_ground_its_image_shows():
    assert decide_accuracy(CORRELATION.largest_error * 800, 800.0) == ("fix", None)
    status, reason = decide_accuracy(21.26, 800.0)
    assert status == "ambiguous" and "is 21.3 m" in str(reason) and "at most 20 m" in str(reason)
    assert "in all directions" in str(decide_accuracy(float("inf"), 800.0)[1])
    status, reason = decide_accuracy(1.0, 800.0, is_held=True)
    assert status == "ambiguous" and "outside the map" in str(reason)


def test_fishers_z_has_bounds():
    assert fisher_z(1.0) == fisher_z(0.999) == pytest.approx(np.arctanh(0.999)) and fisher_z(-0.3) == 0


def test_the_risk_is_a_logistic_curve_of_the_lead_and_of_the_detail():
    offset, by_lead, by_detail, by_both = CORRELATION.confidence_curve
    for risk, detail in ((0.01, 0.0), (0.3, 2.0)):
        share = (np.log(1 / risk - 1) - offset - by_detail * detail) / (by_lead + by_both * detail)
        peaks = CorrelationPeaks(np.tanh((1 + share) * np.arctanh(0.2)), 0.0, 0.2, detail, -100.0)
        assert risk_of_peaks(peaks) == pytest.approx(risk, rel=1e-3)
        assert decide(peaks, risk * 1.01)[0] == Status.FIX and decide(peaks, risk * 0.99)[0] != Status.FIX


def test_much_detail_counts_only_together_with_a_lead():
    leading, equal = ([risk_of_peaks(CorrelationPeaks(0.7, 0.2, mirror, d)) for d in (4, 9)] for mirror in (0.5, 0.7))
    assert equal[0] == equal[1]
    assert leading[1] < leading[0] / 5


def test_the_error_radius_is_that_of_the_larger_axis_and_of_the_pixels():
    turn = np.array([[0.6, -0.8], [0.8, 0.6]])
    expected = np.hypot(CIRCLE_95 * 2, CORRELATION.error_floor_px * 4.0)
    assert position_error_95(turn @ np.diag([4.0, 1.0]) @ turn.T, 4.0) == pytest.approx(expected)
