"""First search on a made map, with images of known place."""

import numpy as np
import pytest

from semref.core.correlation.search import SearchSpace, search

HEADINGS = np.arange(0.0, 360.0, 30.0)


@pytest.mark.parametrize("x, y, heading, size", [(600, 500, 0, 1.0), (850, 640, 120, 1.0), (700, 600, 300, 1.2)])
def test_the_true_place_turn_and_scale_have_the_highest_score(patch_pyramid, image_at, x, y, heading, size):
    space = SearchSpace(HEADINGS, np.array([0.8, 1.0, 1.2]), (0.0, 0.0, 1440.0, 1200.0))
    best = search(image_at(x, y, heading, size, 32), patch_pyramid, space)[0]
    assert np.hypot(best[1] - x, best[2] - y) < 16 * size
    assert (best[3], best[4]) == (heading, size)
    assert best[0] > 0.6


def test_peaks_are_sorted_by_score_and_inside_the_box(patch_pyramid, image_at):
    box = (700.0, 500.0, 1000.0, 800.0)
    found = search(image_at(850, 640, 120, 1.0, 32), patch_pyramid, SearchSpace(HEADINGS, np.array([1.0]), box))
    assert len(found) > 3 and (np.diff(found[:, 0]) <= 0).all()
    pixel = 500 / 32
    assert (found[:, 1:3] >= (700, 500)).all() and (found[:, 1:3] <= (1000 + pixel, 800 + pixel)).all()


def test_nothing_is_found_beside_the_map(patch_pyramid, image_at):
    space = SearchSpace(HEADINGS, np.array([1.0]), (9000.0, 9000.0, 9400.0, 9400.0))
    assert search(image_at(850, 640, 120, 1.0, 32), patch_pyramid, space).shape == (0, 5)
