"""Cutting a database to an area."""

from __future__ import annotations

import numpy as np
import pytest

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.errors import DatabaseError
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.onboard.area import area_mask, clip_database

FRAME = MapFrame('PROJCS["a metric CRS"]', (600000.0, 2.0, 0.0, 5200000.0, 0.0, -2.0))
OVERVIEW_PIXEL = 8.0
RING = np.array([(600200, 5199900), (600500, 5199900), (600500, 5199600), (600200, 5199600), (600200, 5199900)])


@pytest.fixture(scope="module")
def database():
    """Return a database of 800 × 640 m with a square landmark every 20 m."""
    labels = np.zeros((320, 400), np.uint8)
    for row in range(2, 316, 10):
        for column in range(2, 396, 10):
            labels[row : row + 4, column : column + 4] = 1
    table = ClassTable((LandCoverClass(1, "building", "#ff0000", "reference"),))
    return build_from_labels(ArrayLabels(labels), FRAME, table, BuildSettings(120.0, 40.0, 28.0), "1.2.3")


def within(points_xy, margin):
    low, high = RING.min(axis=0) - margin, RING.max(axis=0) + margin
    return ((points_xy >= low) & (points_xy <= high)).all(axis=1)


def test_the_mask_is_the_area_to_a_pixel_of_the_overview(database):
    mask = area_mask([RING], database.parameters)
    assert mask.shape == database.overview.shape
    assert mask[14:49, 26:62].all()
    assert mask.sum() == mask[12:51, 24:64].sum()


def test_a_ring_within_another_is_a_hole(database):
    hole = RING.mean(axis=0) + (RING - RING.mean(axis=0)) / 3
    mask = area_mask([RING, hole], database.parameters)
    assert mask[15, 30] and not mask[31, 43]


def test_only_the_content_of_the_area_is_kept(database):
    part = clip_database(database, area_mask([RING], database.parameters))
    assert (
        within(part.references.positions, OVERVIEW_PIXEL).all() and within(part.windows.centers, OVERVIEW_PIXEL).all()
    )
    least, most = (within(database.references.positions, margin).sum() for margin in (-OVERVIEW_PIXEL, OVERVIEW_PIXEL))
    assert 0 < least <= len(part.references) <= most
    assert part.overview.shape == database.overview.shape
    assert not part.overview[:, : 200 // 8 - 1].any() and part.overview[20:40, 30:60].any()


def test_an_area_without_landmarks_is_refused(database):
    with pytest.raises(DatabaseError, match="area contains no landmark"):
        clip_database(database, np.zeros(database.overview.shape, bool))
