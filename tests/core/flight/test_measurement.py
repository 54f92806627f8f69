"""Measurements of one image of a flight at an expected place."""

from types import SimpleNamespace

import numpy as np

from semref.core.flight.measurement import measure_by_landmarks
from semref.core.flight.model import FlightImage
from semref.core.geometry.leveling import Attitude, leveling

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
