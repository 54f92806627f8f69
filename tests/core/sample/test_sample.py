"""The sample area: same seed, same landscape; pictures cut where truth.csv says; colors that decode to their class."""

from collections import Counter

import cv2
import numpy as np
import pytest
import shapely

from semref.core.sample import classes, landscape, photo, pictures

SEED = 1671


@pytest.fixture(scope="module")
def land():
    return landscape.make_landscape(SEED)


@pytest.fixture
def labels_hw():
    return np.random.default_rng(0).integers(0, 7, (200, 260), dtype=np.uint8)


def view(column, row, heading=0.0, scale=1.0):
    return pictures.Picture("v.png", "test", column, row, heading, scale)


@pytest.mark.parametrize(("heading", "quarter_turns"), [(0, 0), (90, 1), (180, 2), (270, 3)])
@pytest.mark.parametrize("size", [63, 64])
def test_quarter_turns_lose_no_pixel(labels_hw, heading, quarter_turns, size):
    window = labels_hw[40 : 40 + size, 70 : 70 + size]
    turned = pictures.cut(labels_hw, view(70 + size / 2, 40 + size / 2, heading), size)
    np.testing.assert_array_equal(turned, np.rot90(window, quarter_turns))


def test_heading_90_shows_the_east_at_the_top():
    labels = np.zeros((100, 100), np.uint8)
    labels[50, 70] = 9  # 20 pixels east of the center
    assert np.argwhere(pictures.cut(labels, view(50.5, 50.5, 90), 61) == 9).tolist() == [[10, 30]]


def test_scale_3_takes_the_middle_of_every_three_pixels(labels_hw):
    seen = pictures.cut(labels_hw, view(100, 100, scale=3.0), 20)
    np.testing.assert_array_equal(seen, labels_hw[71:130:3, 71:130:3])


def test_a_photo_of_three_bands_is_cut_like_a_label_map(labels_hw):
    photo = np.dstack([labels_hw] * 3)
    at = view(120.3, 99.8, 33.0, 1.2)
    np.testing.assert_array_equal(pictures.cut(photo, at, 64)[:, :, 1], pictures.cut(labels_hw, at, 64))


def test_a_view_beyond_the_map_is_refused(labels_hw):
    with pytest.raises(ValueError, match="beyond the map"):
        pictures.cut(labels_hw, view(20, 100), 64)


def test_planned_views_lie_on_the_map_and_have_different_names():
    labels = np.zeros((3000, 4000), np.uint8)
    views = pictures.plan_views(labels.shape, SEED)
    assert len({v.name for v in views}) == len(views) == 46
    assert all(pictures.cut(labels, v).shape == (640, 640) for v in views)


def test_views_on_windows_are_centered_on_the_window_of_their_name():
    for v in pictures.plan_views((3000, 4000), SEED):
        if v.window:
            column, row = (int(n) for n in v.window.split("_"))
            assert column % pictures.STRIDE_PX == row % pictures.STRIDE_PX == 0
            assert (v.column, v.row) == (column + 320, row + 320)
            assert v.name.endswith(f"_{v.window}.png")


def test_a_map_too_small_for_the_pictures_is_refused():
    with pytest.raises(ValueError, match="smaller pixel size"):
        pictures.plan_views((900, 2000), SEED)


def in_range(hsv, entry):
    """Whether an OpenCV HSV color lies in a class's range, where the hue may wrap."""
    low, high = np.array(entry.hsv_min), np.array(entry.hsv_max)
    hue = low[0] <= hsv[0] <= high[0] if low[0] <= high[0] else hsv[0] >= low[0] or hsv[0] <= high[0]
    return bool(hue and np.all(hsv[1:] >= low[1:]) and np.all(hsv[1:] <= high[1:]))


@pytest.mark.parametrize("shift", [-9, 0, 9])
def test_every_color_decodes_to_its_own_class_only(shift):
    for entry in classes.CLASSES:
        rgb = np.clip(np.array(entry.rgb) + shift, 0, 255).astype(np.uint8)
        hsv = cv2.cvtColor(rgb.reshape(1, 1, 3), cv2.COLOR_RGB2HSV)[0, 0]
        assert [c.value for c in classes.CLASSES if in_range(hsv, c)] == [entry.value]


def test_hsv_ranges_of_classes_do_not_overlap():
    def hues(entry):
        low, high = entry.hsv_min[0], entry.hsv_max[0]
        return set(range(low, high + 1)) if low <= high else set(range(low, 181)) | set(range(high + 1))

    counted = Counter(hue for entry in classes.CLASSES for hue in hues(entry))
    assert max(counted.values()) == 1


def test_black_is_in_no_class():
    assert not any(in_range(np.zeros(3), entry) for entry in classes.CLASSES)


def test_the_same_seed_gives_the_same_landscape(land):
    again = landscape.make_landscape(SEED)
    assert [(f.class_value, f.zorder, f.geometry and f.geometry.wkb) for f in again.features] == [
        (f.class_value, f.zorder, f.geometry and f.geometry.wkb) for f in land.features
    ]


def test_the_landscape_fills_its_extent_and_nothing_leaves_it(land):
    bounds = np.array([f.geometry.bounds for f in land.features if f.geometry is not None])
    assert (*bounds[:, :2].min(axis=0), *bounds[:, 2:].max(axis=0)) == land.extent


def test_oddities_are_few_and_present(land):
    drawn = [f.geometry for f in land.features if f.geometry is not None]
    assert len(land.features) - len(drawn) == 1
    assert sum(not g.is_valid for g in drawn) == landscape.BOW_TIES
    assert 4 <= sum(g.geom_type == "MultiPolygon" for g in drawn) <= 80


def test_no_house_stands_in_water(land):
    water = [f.geometry for f in land.features if f.class_value == classes.WATER]
    houses = [f.geometry for f in land.features if f.class_value == classes.BUILDING]
    assert 1000 <= len(houses) <= 1600
    tree = shapely.STRtree(water)
    assert tree.query(houses, predicate="intersects").size == 0


def test_nearly_every_window_holds_ten_landmarks(land):
    x0, y0, x1, y1 = land.extent
    points = np.array(
        [
            f.geometry.representative_point().coords[0]
            for f in land.features
            if f.class_value in (classes.BUILDING, classes.BARE_LAND, classes.WATER)
        ]
    )
    counts = [
        np.all((points >= (x, y)) & (points <= (x + 640, y + 640)), axis=1).sum()
        for x in np.arange(x0, x1 - 639, 160)
        for y in np.arange(y0, y1 - 639, 160)
    ]
    assert np.mean(np.array(counts) >= 10) > 0.98


def small_landscape():
    """One house of 20 × 10 m on a field, a forest in the north-west and a pond, as a landscape of 120 × 100 m."""
    box = shapely.box
    drawn = [(5, 10, box(0, 0, 120, 100)), (4, 30, box(0, 60, 60, 100)), (3, 50, box(80, 60, 110, 90))]
    drawn.append((1, 60, box(50, 20, 70, 30)))
    features = tuple(landscape.Feature(*row) for row in drawn)
    return landscape.Landscape(features, shapely.Polygon(), (0.0, 0.0, 120.0, 100.0), 25832, 5)


@pytest.fixture(scope="module")
def small_photo():
    return photo.render(small_landscape(), (0.0, 100.0, 120, 100), 1.0)


def test_a_photo_is_the_same_every_time_and_has_the_size_of_the_map(small_photo):
    assert small_photo.shape == (100, 120, 3)
    assert small_photo.dtype == np.uint8
    np.testing.assert_array_equal(photo.render(small_landscape(), (0.0, 100.0, 120, 100), 1.0), small_photo)


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
    view = pictures.Picture("p.jpg", "photo", 60.0, 50.0, 90.0, 1.0)
    shot = photo.shoot(small_photo, view, 5, 64).astype(float).mean(axis=2)
    cut = pictures.cut(small_photo, view, 64).astype(float).mean(axis=2)
    assert np.corrcoef(cv2.GaussianBlur(cut, (0, 0), 1).ravel(), shot.ravel())[0, 1] > 0.9


def test_more_photos_begin_with_the_same_ones():
    few, many = (pictures.plan_photos((3000, 4000), SEED, count) for count in (12, 200))
    assert many[:12] == few
    assert len({view.name for view in many}) == 200
