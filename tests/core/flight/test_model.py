"""Poses of a flight."""

import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.flight.model import FlightImage, FlightPose, PoseSource
from semref.core.geometry.pose import PoseCovariance
from semref.core.localization import Localization, Method, Place, Status
from semref.core.localizer.record import record
from semref.core.sentences import Sentence

LOST = Sentence("No place on the map has triangles of landmarks like the image's.")


def test_a_pose_has_the_columns_of_an_image():
    own = Localization(Status.FIX, Method.CONSTELLATION, 12, best=Place((0.0, 0.0), 0.0, 1.0))
    place, known = Place((30.0, 0.0), 90.0, 0.5), PoseCovariance(((1.0, 0.0), (0.0, 1.0)), 1.0, 0.01, radius_95=2.45)
    pose = FlightPose(Status.FIX, None, place, known, 0.01, PoseSource.FLIGHT, 1, True, own, (100, 80))
    result = pose.localization()
    assert result.position == (30.0, 0.0)
    assert (result.confidence, result.error_95_m) == (pytest.approx(0.99), 2.45)
    assert result.footprint.mean(axis=0) == pytest.approx((30.0, 0.0))
    assert result.references == 12


def test_an_own_fix_that_the_flight_does_not_take_is_no_fix():
    own = Localization(Status.FIX, Method.CONSTELLATION, 12, best=Place((0.0, 0.0), 0.0, 1.0), confidence=1.0)
    result = FlightPose(Status.NO_MATCH, LOST, own=own).localization()
    assert not result.is_fix and result.confidence is None and result.reason == LOST


def test_a_predicted_place_is_no_position_of_its_image():
    own = Localization(Status.FIX, Method.CONSTELLATION, 12, best=Place((0.0, 0.0), 0.0, 1.0), confidence=1.0, risk=0.0)
    place, known = Place((30.0, 0.0), 90.0, 0.5), PoseCovariance(((1.0, 0.0), (0.0, 1.0)), 1.0, 0.01, radius_95=2.45)
    result = FlightPose(Status.AMBIGUOUS, LOST, place, known, source=PoseSource.PREDICTED, own=own).localization()
    assert (result.position, result.footprint, result.confidence, result.risk) == (None, None, None, None)
    assert (result.best, result.error_95_m) == (place, 2.45)
    assert record(result)["x"] is None and record(result)["error_95"] is None


@pytest.mark.parametrize("status", [Status.FIX, Status.LIKELY])
def test_an_image_that_the_flight_does_not_place_has_no_footprint(status):
    own = Localization(status, Method.CONSTELLATION, best=Place((0.0, 0.0), 0.0, 1.0), footprint=np.zeros((4, 2)))
    result = FlightPose(Status.NO_MATCH, LOST, own=own).localization()
    assert (result.status, result.position, result.footprint) == (Status.NO_MATCH, None, None)


def test_an_image_without_pixels_is_refused():
    with pytest.raises(ParameterError, match=r"a\.png"):
        FlightImage("a.png", np.zeros((0, 3), np.uint8))
