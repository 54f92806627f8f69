import numpy as np
import pytest

from semref.core.correlation.class_pyramid import MapPyramid, evidence_level
from semref.core.correlation.exactness import leaning_covariance
from semref.core.correlation.refine import ScoredPose, refine
from semref.core.geometry.error_settings import ErrorSettings
from semref.core.geometry.frame import MapFrame

FOUR = [(-80, -90), (-90, 60), (50, -80), (90, 70)]
MANY = [(x, y) for x in range(-120, 121, 60) for y in range(-120, 121, 60)]
"""Centers of buildings of 40 m, meters right and down of the image's center."""

EDGE, MIDDLE, LEAN = 300, 300, 0.03
TRUE = ScoredPose(MIDDLE, MIDDLE, 0.0, 1.0)
SETTINGS = ErrorSettings(roof_height=LEAN * EDGE * np.sqrt(2) / 2)


def ground(buildings, leans, edge):
    """Return (edge, edge) labels, pixels of 1 m, with buildings moved away from the middle by a share each."""
    labels = np.ones((edge, edge), np.uint8)
    for (x, y), lean in zip(buildings, leans):
        left, top = (round(edge / 2 + part * (1 + lean) - 20) for part in (x, y))
        labels[top : top + 40, left : left + 40] = 2
    return labels


def stated_and_measured(buildings, share_all=False):
    """Return (4,) standard deviations of a pose as stated, and of the poses of 40 images with random leans."""
    rng = np.random.default_rng(4)
    pyramid = MapPyramid(ground(buildings, np.zeros(len(buildings)), 2 * MIDDLE), MapFrame.at((0.0, 0.0), 1.0))
    poses, stated = [], []
    for _ in range(40):
        leans = LEAN * (np.full(len(buildings), rng.normal()) if share_all else rng.normal(size=len(buildings)))
        image = evidence_level(ground(buildings, leans, EDGE), pyramid.space, (64, 64))
        pose = refine(image, pyramid, TRUE, pyramid.quiet, 8)
        turned = np.radians((pose.heading_deg + 180) % 360 - 180)
        poses.append([pose.x - MIDDLE, pose.y - MIDDLE, turned, np.log(pose.pixel_size_m)])
        stated.append(np.diag(leaning_covariance(image, pyramid, pose, SETTINGS)))
    return np.sqrt(np.mean(stated, axis=0)), np.std(poses, axis=0)


@pytest.mark.parametrize("buildings", [FOUR, MANY], ids=["four", "many"])
def test_roofs_of_different_heights_move_and_turn_the_pose_as_stated(buildings):
    stated, measured = stated_and_measured(buildings)
    np.testing.assert_array_less(0.6, stated[:3] / measured[:3])
    np.testing.assert_array_less(stated[:3] / measured[:3], 1.7)


def test_roofs_of_equal_height_change_only_the_pixel_size():
    stated, measured = stated_and_measured(FOUR, share_all=True)
    assert (measured[:2] < 0.3).all() and measured[3] > 0.5 * LEAN
    assert stated[3] > 0.9 * measured[3]


def test_the_lower_the_camera_the_more_roofs_lean():
    assert ErrorSettings(roof_height=6.0).leaning(400.0) == pytest.approx(0.03)
    assert ErrorSettings(roof_height=6.0).leaning(2000.0) == pytest.approx(0.006)
