"""Losses of regions by rasterizing: the same as OpenCV finds for each mask."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from semref.core.annotation.raster_losses import count_pieces, join_runs, lost_regions, merged_regions, runs_of_strip


def random_regions(seed: int):
    """Return (40, 60) region numbers 0 to 12 in blobs, and the class of each number."""
    random = np.random.default_rng(seed)
    noise = cv2.GaussianBlur(random.normal(size=(40, 60, 13)), (0, 0), 2.0)
    return noise.argmax(axis=2), np.array([-1, *random.integers(1, 3, 12)])


def runs_in_strips(regions_hw, rows=7):
    firsts = range(0, len(regions_hw), rows)
    return join_runs([runs_of_strip(regions_hw[first : first + rows], first) for first in firsts])


@pytest.mark.parametrize("seed", range(4))
def test_pieces_losses_and_merges_are_those_of_opencv(seed):
    regions, classes = random_regions(seed)
    runs = runs_in_strips(regions)
    pieces, lost = count_pieces(runs, 13), lost_regions(runs, 13, 30.0)
    for number in range(1, 13):
        mask = (regions == number).astype(np.uint8)
        assert pieces[number] == cv2.connectedComponents(mask, connectivity=8)[0] - 1
        contours = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]
        assert lost[number] == (max(map(cv2.contourArea, contours), default=0) < 30)
    expected = set()
    for one in range(1, 13):
        around = cv2.dilate((regions == one).astype(np.uint8), np.ones((3, 3), np.uint8))
        for other in np.unique(regions[around > 0]):
            if other > one and classes[one] == classes[other]:
                expected.add((one, int(other)))
    assert {tuple(pair) for pair in merged_regions(runs, classes).tolist()} == expected
