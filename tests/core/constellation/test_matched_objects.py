"""Objects of an image and of the map that are the same: random houses seen from a known place."""

import numpy as np
import pytest

from semref.core.constellation.matched_objects import matched_objects
from semref.core.database.model import MapLandmarks
from semref.core.geometry.footprint import image_corners, is_parallelogram, on_ground
from semref.core.geometry.leveling import Attitude, leveling
from semref.core.landmarks.landmarks import Landmarks

SHAPE_HW = (480, 640)
ORIGIN = np.array([400_000.0, 5_400_000.0])
PIXEL_M = 0.5


def houses(count=900, seed=3):
    """References at random places of 600 × 600 m, in two classes."""
    rng = np.random.default_rng(seed)
    areas = rng.uniform(60, 300, count)
    positions = ORIGIN + rng.uniform(0, 600, (count, 2))
    return MapLandmarks(positions, rng.choice([1, 2], count).astype(np.uint8), areas, np.zeros(count, bool))


def photo(references, footprint, pixel_m=PIXEL_M):
    """(objects of the image, (n,) which of the map they are): all that lie in the image, in another order."""
    height, width = SHAPE_HW
    back = inverse(references, footprint)
    inside = np.flatnonzero(((back > 5) & (back < (width - 5, height - 5))).all(axis=1))[::-1]
    count = len(inside)
    pixels = back[inside]
    areas = references.areas_m2[inside] / pixel_m**2
    return Landmarks(
        pixels, references.classes[inside], areas, np.zeros((count, 4), np.int64), np.zeros(count, bool)
    ), inside


def inverse(references, footprint):
    """Pixel coordinates of the map's objects, by OpenCV's homography."""
    import cv2

    height, width = SHAPE_HW
    pixels = np.array([(0, 0), (width, 0), (width, height), (0, height)], np.float32)
    matrix = cv2.getPerspectiveTransform((footprint - ORIGIN).astype(np.float32), pixels)
    places = np.column_stack([references.positions - ORIGIN, np.ones(len(references))]) @ matrix.T
    return places[:, :2] / places[:, 2:]


def level_footprint(heading=35.0):
    return image_corners(tuple(ORIGIN + 300), heading, PIXEL_M, SHAPE_HW[1], SHAPE_HW[0])


def tilted_footprint(heading=35.0):
    """Of a camera that leans by 20° and 8°, its center where the level one's is."""
    way = leveling(Attitude(8.0, 20.0), 600.0, SHAPE_HW)
    ground = way.corners * PIXEL_M * np.exp(-1j * np.radians(heading))
    return ORIGIN + 300 + np.column_stack([ground.real, ground.imag])


def pairs(objects, footprint, references, heading=35.0):
    return matched_objects(objects, SHAPE_HW, footprint, heading, PIXEL_M, references, 1.0)


def test_an_image_without_objects_matches_nothing():
    references = houses()
    objects, _ = photo(references, level_footprint())
    assert pairs(objects.select(np.zeros(len(objects), bool)), level_footprint(), references).shape == (0, 2)


@pytest.mark.parametrize("footprint", [level_footprint(), tilted_footprint()], ids=["level", "tilted"])
def test_every_object_is_matched_with_itself(footprint):
    references = houses()
    objects, truth = photo(references, footprint)
    found = pairs(objects, footprint, references)
    assert len(objects) > 100
    assert len(found) > 0.95 * min(len(objects), 250)
    assert np.array_equal(truth[found[:, 0]], found[:, 1])


def test_objects_that_the_map_lacks_and_those_of_another_class_are_left_out():
    references = houses()
    objects, truth = photo(references, level_footprint())
    classes = objects.classes.copy()
    classes[:10] = 3 - classes[:10]
    moved = objects.centers_xy.copy()
    moved[10:20] += 12
    spoilt = Landmarks(moved, classes, objects.areas_px, objects.bounds, objects.touches_edge)
    found = pairs(spoilt, level_footprint(), references)
    right = truth[found[:, 0]] == found[:, 1]
    assert not np.isin(found[right, 0], np.arange(20)).any()
    assert right[found[:, 0] >= 20].all()
    assert (found[:, 0] >= 20).sum() > 0.9 * (min(len(objects), 250) - 20)


def test_at_a_wrong_place_nothing_is_matched():
    references = houses()
    objects, _ = photo(references, level_footprint())
    assert len(pairs(objects, level_footprint() + (73, -41), references)) == 0


def test_of_a_level_image_the_middle_lies_in_the_middle():
    height, width = SHAPE_HW
    assert on_ground(np.array([(width / 2, height / 2)]), level_footprint(), SHAPE_HW)[0] == pytest.approx(ORIGIN + 300)
    assert is_parallelogram(level_footprint()) and not is_parallelogram(tilted_footprint())


@pytest.mark.parametrize("footprint", [level_footprint(), tilted_footprint()], ids=["level", "tilted"])
def test_the_ground_of_a_pixel_is_that_of_opencvs_homography(footprint):
    import cv2

    height, width = SHAPE_HW
    pixels = np.array([(0, 0), (width, 0), (width, height), (0, height)], np.float32)
    matrix = cv2.getPerspectiveTransform(pixels, (footprint - ORIGIN).astype(np.float32))
    points = np.random.default_rng(1).uniform(0, (width, height), (50, 2))
    expected = np.column_stack([points, np.ones(50)]) @ matrix.T
    expected = ORIGIN + expected[:, :2] / expected[:, 2:]
    assert on_ground(points, footprint, SHAPE_HW) == pytest.approx(expected, abs=0.01)
