"""The ground of a photo: features burnt in their order, roads over them, colors of the same kind."""

import numpy as np
import shapely

from sample import landscape
from sample.photo_ground import draw_scene, linear, tinted

FRAME = (0.0, 40.0, 60, 40)


def scene_of(*drawn, road=None):
    features = [landscape.Feature(*row) for row in drawn]
    land = landscape.Landscape(tuple(features), road or shapely.Polygon(), (0.0, 0.0, 60.0, 40.0), 25832, 5)
    return draw_scene(features, land, FRAME, 1.0)


def test_the_uppermost_feature_owns_a_pixel_and_holes_show_what_lies_below():
    ring = shapely.Polygon(shapely.box(10, 10, 30, 30).exterior, [shapely.box(16, 16, 24, 24).exterior])
    scene = scene_of((5, 10, shapely.box(0, 0, 60, 40)), (3, 50, ring))
    assert (scene.kind[20, 12], scene.kind[20, 20], scene.kind[20, 40]) == (3, 5, 5)
    assert (scene.owner[20, 12], scene.owner[20, 20]) == (1, 0)


def test_a_road_covers_the_ground_but_no_house():
    scene = scene_of(
        (5, 10, shapely.box(0, 0, 60, 40)), (1, 60, shapely.box(20, 15, 30, 25)), road=shapely.box(0, 18, 60, 22)
    )
    assert (scene.road[20, 5], scene.kind[20, 5]) == (1, 0)
    assert (scene.road[20, 25], scene.kind[20, 25]) == (0, 1)


def test_a_tinted_color_is_of_the_same_kind():
    colors = np.array([tinted(np.random.default_rng(seed), (100, 120, 60), 0.1) for seed in range(200)])
    np.testing.assert_allclose(np.exp(np.log(colors).mean(axis=0)), linear((100, 120, 60)), rtol=0.03)
