from types import SimpleNamespace

import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.flight.evidence import SeenImage
from semref.core.flight.measurement import measure_by_landmarks
from semref.core.flight.model import FlightImage, FlightPose, PoseSource
from semref.core.flight.pool import Pool, update
from semref.core.flight.reported_pose import report_pose, tail_probability
from semref.core.flight.settings import FLIGHT
from semref.core.flight.smoothing import Estimate
from semref.core.geometry.leveling import Attitude, leveling
from semref.core.geometry.pose import PoseCovariance
from semref.core.localization import LEAST_RISK, Localization, Method, Place, Prior, Status
from semref.core.localizer.record import record
from semref.core.sentences import Sentence


def test_a_hypothesis_near_the_images_own_place_gets_its_evidence_and_moves_there():
    own = np.array([100.0, 100.0, 0.10, np.log(3.0)])
    seen = SeenImage(None, 96.0, (0.0, 1.0), Prior(), own, own_odds=10.0)
    states = np.array([[115.0, 92.0, 0.05, np.log(3.1)], [400.0, 400.0, 0.05, np.log(3.1)]])
    pool = Pool(states, np.full((2, 3), (100.0, 0.01, 0.01)), np.zeros((2, FLIGHT.window)))
    found = update(pool, seen, None, 1.0, FLIGHT)
    assert found.evidence[0, -1] > 5 and found.evidence[1, -1] == 0
    assert (np.abs(found.states[0] - own) < (1.5, 1.5, 0.001, 0.001)).all()
    assert (found.variances[0] < pool.variances[0] / 5).all()
    np.testing.assert_array_equal(found.states[1], states[1])
    np.testing.assert_array_equal(found.variances[1], pool.variances[1])


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


LABELS = np.ones((200, 260), np.uint8)


def test_a_leveled_image_is_measured_with_what_the_photo_shows():
    views = []

    class Localizer:
        pyramid = SimpleNamespace(frame=SimpleNamespace(origin=(600000.0, 5200000.0)))

        def with_view(self, view):
            views.append(view)
            return self

        def localize_by_constellation(self, labels_hw, prior, biases):
            return None

    way = leveling(Attitude(20.0, 10.0), 225.0, LABELS.shape)
    state = np.array([100.0, 50.0, 0.3, np.log(0.5)])
    for one in (None, way):
        image = FlightImage("a", LABELS, leveling=one)
        assert measure_by_landmarks(image, Localizer(), state, np.diag([25.0, 25.0, 0.01, 0.01])) is None
    assert len(views) == 1 and np.array_equal(views[0], way.view)
    # The view is as wide and as high as the leveled image.
    height, width = way.shape_hw
    assert abs(np.ptp(way.view.real) - width) < 2 and abs(np.ptp(way.view.imag) - height) < 2
