"""Images of a distorting lens have more accurate positions if the calibration is known."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.geometry.frame import MapFrame
from semref.core.geometry.lens_distortion import LensDistortion
from semref.core.geometry.leveling import Attitude, leveling
from semref.core.geometry.pose import turn_of
from semref.core.labels.class_shares import SeenLabels
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.localization import Method, Prior, Status
from semref.core.localizer.localizer import Localizer
from semref.core.localizer.search import Search
from semref.core.pipeline import localize_with

TABLE = ClassTable(
    (
        LandCoverClass(1, "ground", "#999999"),
        LandCoverClass(2, "building", "#ff0000", "reference"),
        LandCoverClass(5, "water", "#0000ff", "reference"),
    )
)
PIXEL_M = 1.0
FRAME = MapFrame("a metric CRS", (600000.0, PIXEL_M, 0.0, 5200000.0, 0.0, -PIXEL_M))
SHAPE = 450, 600
LENS = LensDistortion((0.75, 0.75), (0.0, 0.0), (-0.27, 0.11, -0.03))
"""As strong as that of a Phantom 4: corners are 9 % too near the center."""
HEADING = 25.0


def ground(height=1400, width=1600) -> np.ndarray:
    """Return randomly placed rectangles of two classes."""
    random, labels = np.random.default_rng(12), np.ones((height, width), np.uint8)
    for _ in range(900):
        row, column = random.integers(0, height - 30), random.integers(0, width - 30)
        tall, wide = random.integers(7, 22, 2)
        if (labels[row - 4 : row + tall + 4, column - 4 : column + wide + 4] == 1).all():
            labels[row : row + tall, column : column + wide] = random.choice((2, 5))
    return labels


MAP = ground()


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
    place = complex(x, y) + turn_of(HEADING, PIXEL_M) * (right + 1j * up)
    pixels = FRAME.to_pixels(np.column_stack([place.real, place.imag])).reshape(*SHAPE, 2).astype(np.float32) - 0.5
    return cv2.remap(MAP, pixels.astype(np.float32), None, cv2.INTER_NEAREST)


@pytest.mark.slow
@pytest.mark.parametrize("where", [(0.5, 0.5), (0.4, 0.6)])
def test_a_stated_lens_makes_position_and_radius_more_accurate(localizer, where):
    x = 600000.0 + where[0] * MAP.shape[1] * PIXEL_M
    y = 5200000.0 - where[1] * MAP.shape[0] * PIXEL_M
    labels = seen_at(x, y)
    prior = Prior(pixel_size_range=(0.8, 1.25))
    bent = localizer.localize(labels, Method.CONSTELLATION, prior)
    way = leveling(Attitude(0, 0), LENS.focal_xy[0] * SHAPE[1], SHAPE, LENS)
    straight = localize_with(localizer, Search(Method.CONSTELLATION), SeenLabels(labels), prior, way).localization
    assert straight.status == Status.FIX

    def error(found):
        return np.hypot(found.position[0] - x, found.position[1] - y)

    assert error(straight) < 0.5
    assert straight.pixel_size_m == pytest.approx(PIXEL_M, rel=0.005)
    assert abs(straight.heading_deg - HEADING) < 0.2
    # Without the lens there is no position, or a larger error and another scale.
    if bent.status == Status.FIX:
        assert error(bent) > 2 * error(straight) and abs(bent.pixel_size_m / PIXEL_M - 1) > 0.02
        assert bent.error_95_m > straight.error_95_m
