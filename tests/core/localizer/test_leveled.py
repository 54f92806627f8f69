import numpy as np
import pytest

from semref.core.geometry.leveling import Attitude, leveling
from semref.core.labels.class_shares import ClassShares, SeenLabels
from semref.core.localization import Localization, Matches, Method, Place, Prior, Status
from semref.core.localizer.search import Search
from semref.core.pipeline import localize_with

LABELS = np.ones((200, 260), np.uint8)
FOCAL = 225.0
MIDDLE = (600100.0, 5200050.0)
"""Position that the made localizer returns for the middle of the level image."""


class Made:
    """Localizer that remembers its input and returns a given result."""

    def __init__(self, found):
        self.found = found

    landmark_classes = ()

    def with_view(self, view):
        return self

    def localize(self, labels_hw, method, prior, with_matches, shares, biases, earlier=None):
        self.shape, self.prior, self.shares = labels_hw.shape, prior, shares
        return self.found


def fix(heading, pixel_size, **more):
    best = Place(MIDDLE, heading_deg=heading, pixel_size_m=pixel_size)
    return Localization(Status.FIX, Method.CONSTELLATION, best=best, **more)


def leveled(made, attitude, prior=None, shares=None):
    """Return the localization of a leveled image, and how it was leveled."""
    way = leveling(attitude, FOCAL, LABELS.shape)
    seen = SeenLabels(LABELS, shares)
    return localize_with(made, Search(Method.CONSTELLATION), seen, prior or Prior(), way).localization, way


def test_of_a_level_camera_the_middle_is_the_place_and_the_nadir():
    made = Made(fix(90.0, 0.5))
    found, _ = leveled(made, Attitude(0, 0))
    assert made.shape == LABELS.shape
    assert found.position == found.nadir == pytest.approx(MIDDLE, abs=1e-6)
    # The image's top points east: its upper left corner is half its height east and half its width north.
    np.testing.assert_allclose(found.footprint[0], (MIDDLE[0] + 50, MIDDLE[1] + 65), rtol=0, atol=1e-6)


def test_a_camera_pitched_up_is_south_of_the_ground_at_its_center():
    found, way = leveled(Made(fix(0.0, 2.0)), Attitude(0, 20))
    # A view to the top reaches farther beyond its center than before it, so the center is south of the middle.
    assert found.position == pytest.approx((MIDDLE[0], MIDDLE[1] - 2.0 * way.middle.imag), abs=1e-6)
    assert way.middle.imag > 10
    # The ground size at the center is kept: the camera is f · cos 20°^1.5 pixels high, and tan 20° times that away.
    away = 2.0 * FOCAL * np.cos(np.radians(20)) ** 1.5 * np.tan(np.radians(20))
    assert found.position[1] - found.nadir[1] == pytest.approx(away)
    assert found.nadir[0] == pytest.approx(MIDDLE[0], abs=1e-6)


def test_the_search_area_allows_for_the_offset_of_the_center():
    made, prior = Made(fix(0.0, 2.0)), Prior(position=MIDDLE, radius=100.0, pixel_size_range=(1.0, 3.0))
    _, way = leveled(made, Attitude(0, 20), prior)
    assert made.prior.radius == pytest.approx(100 + 3 * abs(way.middle))


def test_matches_are_those_of_the_image_as_it_is():
    way = leveling(Attitude(5, 20), FOCAL, LABELS.shape)
    pixels = np.array([[20.0, 30.0], [130.0, 100.0]])
    x, y, w = way.homography @ np.column_stack([pixels, np.ones(2)]).T
    matches = Matches(np.arange(2), np.column_stack([x / w, y / w]), np.zeros((2, 2)), np.zeros(2))
    found, _ = leveled(Made(fix(0.0, 2.0, matches=matches)), Attitude(5, 20))
    np.testing.assert_allclose(found.matches.pixels_xy, pixels)


def test_without_a_fix_there_is_no_place():
    none = Localization(Status.NO_MATCH, Method.CONSTELLATION)
    assert leveled(Made(none), Attitude(0, 20))[0] == none


def test_shares_are_leveled_with_the_labels():
    made = Made(fix(0.0, 2.0))
    shares = ClassShares(np.array([4], np.uint8), np.full((50, 65, 1), 200, np.uint8))
    leveled(made, Attitude(0, 20), shares=shares)
    assert made.shares.values.tolist() == [4]
    height, width = made.shares.shares.shape[:2]
    pixels = np.array(LABELS.shape) / (50, 65)
    assert np.abs(np.array(made.shape) / pixels - (height, width)).max() <= 0.5
    # Pixels that are not seen are unknown; the others have their share.
    middle = made.shares.shares[height // 2, width // 2]
    assert made.shares.shares.min() == 0 and middle == 200
