import cv2
import numpy as np
import pytest
import shapely

from sample import landscape, photo, pictures
from semref.core.simulation.views import PIXELS, cut, lies_on

SEED = 1671


def test_more_photos_begin_with_the_same_ones():
    few, many = (pictures.plan_photos((3000, 4000), SEED, count) for count in (12, 200))
    assert many[:12] == few
    assert len({view.name for view in many}) == 200
    assert all(lies_on(PIXELS.of_shape((3000, 4000)), view.view(640)) for view in many)


def test_the_photos_of_a_flight_overlap_and_their_tops_point_where_it_goes():
    views = pictures.plan_flight((3000, 4000))
    assert all(lies_on(PIXELS.of_shape((3000, 4000)), view.view(640)) for view in views)
    steps = np.diff([(view.column, view.row) for view in views], axis=0)
    assert (np.hypot(*steps.T) < 0.6 * 640).all()
    headings = np.degrees(np.arctan2(steps[:, 0], -steps[:, 1])) % 360
    between = [(a.heading_deg + b.heading_deg) / 2 for a, b in zip(views, views[1:])]
    np.testing.assert_allclose(headings, between, atol=8)


def small_landscape():
    """Return a landscape of 120 × 100 m: a house of 20 × 10 m on a field, a forest in the north-west and a pond."""
    box = shapely.box
    drawn = [(5, 10, box(0, 0, 120, 100)), (4, 30, box(0, 60, 60, 100)), (3, 50, box(80, 60, 110, 90))]
    drawn.append((1, 60, box(50, 20, 70, 30)))
    features = tuple(landscape.Feature(*row) for row in drawn)
    return landscape.Landscape(features, shapely.Polygon(), (0.0, 0.0, 120.0, 100.0), 25832, 5)


@pytest.fixture(scope="module")
def small_photo():
    return photo.render(small_landscape())


def test_a_photo_is_the_same_every_time_and_has_the_size_of_the_map(small_photo):
    assert small_photo.shape == (100, 120, 3)
    assert small_photo.dtype == np.uint8
    np.testing.assert_array_equal(photo.render(small_landscape()), small_photo)


def test_a_photo_shows_house_forest_and_water_where_they_are_drawn(small_photo):
    photo = small_photo.astype(float)
    house, forest, pond = photo[71:79, 52:68], photo[5:35, 5:55], photo[13:37, 84:106]
    field = photo[85:97, 5:110].mean(axis=(0, 1))
    assert pond.mean() < 0.8 * field.mean()
    assert forest.mean(axis=2).std() > 2 * pond.mean(axis=2).std()
    assert np.abs(house.mean(axis=(0, 1)) - field).max() > 20


def test_houses_throw_their_shadow_to_the_north(small_photo):
    photo = small_photo.mean(axis=2)
    assert photo[68:70, 54:66].mean() < 0.85 * photo[83:86, 54:66].mean()


def test_a_shot_shows_the_place_of_its_view(small_photo):
    view = pictures.Picture("p.jpg", 60.0, 50.0, 90.0, 1.0)
    shot = photo.shoot(small_photo, view, 5, 64).astype(float).mean(axis=2)
    there = cut(small_photo, PIXELS, view.view(64)).astype(float).mean(axis=2)
    assert np.corrcoef(cv2.GaussianBlur(there, (0, 0), 1).ravel(), shot.ravel())[0, 1] > 0.9
