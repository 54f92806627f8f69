"""What is known of an image beforehand: what the user said, else what its camera states."""

import pytest

from semref.core.geometry.camera import Camera, Lens, above_ground
from semref.core.geometry.leveling import Attitude
from semref.core.localization import Method, Prior
from semref.core.localizer.search import Search

SHAPE_HW = 40, 60
LENS = Lens("field_of_view", 60.0)


class Localizer:
    """Windows of 100 m."""

    def pixel_sizes(self, shape_hw, scales):
        return tuple(scale * 100 / min(shape_hw) for scale in scales)


def test_scales_become_pixel_sizes_of_the_shorter_edge():
    search = Search(Method.CONSTELLATION, Prior((1.0, 2.0), 30.0), (0.5, 2.0))
    prior = search.prior_of(Localizer(), Camera(), SHAPE_HW)
    assert prior == Prior((1.0, 2.0), 30.0, pixel_size_range=(1.25, 5.0))


@pytest.mark.parametrize(("known", "heading"), [(Prior(), 70.0), (Prior(heading_deg=10.0), 10.0)])
def test_the_heading_of_the_camera_counts_where_the_user_said_nothing(known, heading):
    prior = Search(Method.CONSTELLATION, known).prior_of(Localizer(), Camera(heading_deg=70.0), SHAPE_HW)
    assert prior.heading_deg == heading


def test_height_and_lens_tell_the_pixel_size_unless_scales_are_given():
    camera = Camera(lens=LENS, height=above_ground(100.0))
    own = Search(Method.CONSTELLATION).prior_of(Localizer(), camera, SHAPE_HW).pixel_size_range
    assert own == camera.pixel_sizes(SHAPE_HW) and own is not None
    given = Search(Method.CONSTELLATION, scales=(0.5, 2.0)).prior_of(Localizer(), camera, SHAPE_HW)
    assert given.pixel_size_range == (1.25, 5.0)


def test_an_image_to_be_leveled_has_the_pixel_sizes_of_its_own_shape():
    tilted = Camera(Attitude(10.0, 5.0), LENS)
    assert Search(Method.CONSTELLATION).prior_of(Localizer(), tilted, SHAPE_HW).pixel_size_range is not None
    assert Search(Method.CONSTELLATION).prior_of(Localizer(), Camera(), SHAPE_HW).pixel_size_range is None
