import math
from dataclasses import replace

import pytest

from semref.core.evaluation.trial import Query, ellipse_ratio, judge
from semref.core.geometry.pose import Ellipse, PoseCovariance
from semref.core.localization import Localization, Method, Place, Status
from semref.core.simulation.views import View

QUERY = Query(View(1000.0, 5000.0, 1.0, 0.5, 320, 240))
"""Footprint of 160 m."""


def told(query=QUERY, away=(0.0, 0.0), right_within=None, **known):
    position = query.view.x + away[0], query.view.y + away[1]
    place = Place(position, known.pop("heading_deg", None), known.pop("pixel_size_m", None))
    known = {"status": Status.FIX, "method": Method.CONSTELLATION, "best": place, **known}
    return judge(query, Method.CONSTELLATION, Localization(**known), right_within)


def test_without_a_fix_nothing_is_right_and_no_error_known():
    trial = told(status=Status.NO_MATCH)
    assert (trial.is_right, trial.is_wrong, trial.is_fix, trial.status) == (False, False, False, "no_match")
    assert (trial.error, trial.heading_error_deg, trial.radius_ratio) == (None,) * 3


@pytest.mark.parametrize(("away", "right"), [(0, True), (3.1, True), (3.3, False), (500, False)])
def test_right_is_within_two_percent_of_the_ground_shown(away, right):
    trial = told(away=(0.0, away))
    assert (trial.is_right, trial.is_wrong, trial.error) == (right, not right, pytest.approx(away))


@pytest.mark.parametrize(("away", "right"), [(3.1, True), (3.3, False)])
def test_a_likely_position_is_neither_right_nor_wrong_and_counted_apart(away, right):
    trial = told(away=(0.0, away), status=Status.LIKELY, confidence=0.9)
    assert (trial.is_fix, trial.is_right, trial.is_wrong, trial.is_likely_right) == (False, False, False, right)
    assert trial.error == pytest.approx(away)
    assert not told(away=(0.0, away)).is_likely_right


def test_errors_of_heading_and_scale_are_measured_the_short_way_and_relative():
    trial = told(heading_deg=359.0, pixel_size_m=0.51)
    assert trial.heading_error_deg == pytest.approx(2) and trial.scale_error == pytest.approx(0.02)


@pytest.mark.parametrize(
    "query", [replace(QUERY, view=replace(QUERY.view, is_mirrored=True)), replace(QUERY, is_of_map=False)]
)
def test_an_image_off_the_map_is_never_right(query):
    trial = told(query)
    assert trial.is_wrong and not query.can_be_right and trial.error == 0


def test_an_error_is_given_in_units_of_the_stated_radius():
    assert told(away=(3.0, 4.0), error_95_m=10.0).radius_ratio == pytest.approx(0.5)
    assert told(away=(3.0, 4.0)).radius_ratio is None
    known = PoseCovariance(((1.0, 0.0), (0.0, 1.0)), 0.1, 0.01, Ellipse(4.0, 2.0, 90.0))
    assert told(away=(0.0, 1.0), error_95_m=10.0, covariance=known).radius_ratio == pytest.approx(0.5)


def test_an_error_on_the_ellipse_has_the_ratio_one_and_an_ellipse_without_extent_contains_only_zero():
    ellipse = Ellipse(4.0, 2.0, 90.0)
    assert ellipse_ratio(4.0, 0.0, ellipse) == pytest.approx(1)
    assert ellipse_ratio(0.0, 1.0, ellipse) == pytest.approx(0.5)
    ellipse = Ellipse(0.0, 0.0, 0.0)
    assert ellipse_ratio(0.0, 0.0, ellipse) == 0
    assert 1 < ellipse_ratio(0.1, 0.0, ellipse) < math.inf
