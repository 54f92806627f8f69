"""Agreement in what is finer than the pixels of the search, on images whose place is known."""

import numpy as np
import pytest

from semref.core.correlation.detail import detail_at, details_at, finer
from semref.core.correlation.refine import ScoredPose

TRUE = ScoredPose(703.4, 598.1, 41.0, 1.03)


@pytest.fixture(scope="module")
def image(image_at):
    return image_at(TRUE.x, TRUE.y, TRUE.heading_deg, TRUE.pixel_size_m)


def test_detail_stands_out_at_the_true_place_alone(patch_pyramid, image):
    aside = [(150, -80, 0), (-200, 40, 0), (0, 0, 90), (0, 0, 180), (90, 170, 20)]
    poses = [TRUE, *(ScoredPose(TRUE.x + x, TRUE.y + y, 41.0 + turn, 1.03) for x, y, turn in aside)]
    here, *elsewhere = details_at(image, patch_pyramid, poses)
    assert here > 12 and max(elsewhere) < 5


def test_detail_is_in_standard_deviations_whatever_the_strength_of_the_image(patch_pyramid, image):
    stronger = type(image)(3 * image.evidence + 1, image.known, image.pixel)
    known = detail_at(image, patch_pyramid, TRUE)
    assert detail_at(stronger, patch_pyramid, TRUE) == pytest.approx(known, rel=1e-4)


def test_what_is_finer_is_what_differs_from_the_neighborhood():
    planes = np.zeros((20, 20, 2), np.float32)
    planes[10, 10, 0], planes[..., 1] = 25, 7
    found = finer(planes, 5)
    assert found[10, 10, 0] == pytest.approx(24) and found[9, 10, 0] == pytest.approx(-1) and found[0, 0, 0] == 0
    np.testing.assert_allclose(found[..., 1], 0, atol=1e-5)
