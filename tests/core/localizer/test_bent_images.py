from dataclasses import replace

import cv2
import numpy as np
import pytest
from made_labels import scattered_objects
from onboard_area import FRAME, TABLE

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.geometry.lens_distortion import LensDistortion
from semref.core.geometry.leveling import Attitude, leveling
from semref.core.geometry.pose import turn_of
from semref.core.labels.class_shares import SeenLabels
from semref.core.labels.sources import ArrayLabels
from semref.core.localization import Method, Prior, Status
from semref.core.localizer.localizer import Localizer
from semref.core.localizer.search import Search
from semref.core.pipeline import localize_with

SHAPE = 450, 600
LENS = LensDistortion((0.75, 0.75), (0.0, 0.0), (-0.27, 0.11, -0.03))
"""As strong as that of a Phantom 4: corners are 9 % too near the center."""
HEADING = 25.0
MAP = scattered_objects(1400, 1600, 1100, seed=12)


@pytest.fixture(scope="module")
def localizer():
    settings = BuildSettings(400.0, 200.0, minimum_area=20.0)
    return Localizer(replace(build_from_labels(ArrayLabels(MAP), FRAME, TABLE, settings, "0"), overview=None))


def seen_at(x: float, y: float) -> np.ndarray:
    """Return the labels that a level camera with LENS sees above map (x, y)."""
    way = leveling(Attitude(0, 0), LENS.focal_xy[0] * SHAPE[1], SHAPE, LENS)
    rows, columns = np.mgrid[0 : SHAPE[0], 0 : SHAPE[1]]
    straight = way.bent.straight(np.column_stack([columns.ravel(), rows.ravel()]) + 0.5)
    right, up = straight[:, 0] - SHAPE[1] / 2, SHAPE[0] / 2 - straight[:, 1]
    place = complex(x, y) + turn_of(HEADING, 1.0) * (right + 1j * up)
    pixels = FRAME.to_pixels(np.column_stack([place.real, place.imag])).reshape(*SHAPE, 2).astype(np.float32) - 0.5
    return cv2.remap(MAP, pixels.astype(np.float32), None, cv2.INTER_NEAREST)


@pytest.mark.slow
@pytest.mark.parametrize("where", [(0.5, 0.5), (0.4, 0.6)])
def test_a_stated_lens_makes_position_and_radius_more_accurate(localizer, where):
    x = 600000.0 + where[0] * MAP.shape[1]
    y = 5200000.0 - where[1] * MAP.shape[0]
    labels = seen_at(x, y)
    prior = Prior(pixel_size_range=(0.8, 1.25))
    bent = localizer.localize(labels, Method.CONSTELLATION, prior)
    way = leveling(Attitude(0, 0), LENS.focal_xy[0] * SHAPE[1], SHAPE, LENS)
    straight = localize_with(localizer, Search(Method.CONSTELLATION), SeenLabels(labels), prior, way).localization
    assert straight.status == Status.FIX

    def error(found):
        return np.hypot(found.position[0] - x, found.position[1] - y)

    assert error(straight) < 0.5
    assert straight.pixel_size_m == pytest.approx(1.0, rel=0.005)
    assert abs(straight.heading_deg - HEADING) < 0.2
    # Without the lens there is no position, or a larger error and another scale.
    if bent.status == Status.FIX:
        assert error(bent) > 2 * error(straight) and abs(bent.pixel_size_m - 1) > 0.02
        assert bent.error_95_m > straight.error_95_m
