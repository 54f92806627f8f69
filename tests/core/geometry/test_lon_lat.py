"""Longitude and latitude without PROJ: a polynomial that says how far off it is."""

from __future__ import annotations

import numpy as np
import pytest

from semref.core.geometry.lon_lat import fit_lon_lat, term_count

EXTENT = (600_000.0, 5_190_000.0, 620_000.0, 5_200_000.0)


def curved(points_xy):
    """Not quite a plane, as maps are."""
    x, y = (points_xy - (610_000, 5_195_000)).T
    return 9 + x / 76_000 + x * y * 2e-13, 47 + y / 111_000 - x**2 * 1e-13


def test_a_smooth_transform_is_met_within_what_is_said():
    found = fit_lon_lat(curved, EXTENT)
    points = np.random.default_rng(2).uniform(EXTENT[:2], EXTENT[2:], (500, 2))
    for mine, true in zip(found(points), curved(points)):
        assert np.abs(mine - true).max() * 111_320 <= found.error_m + 1e-6
    assert found.error_m < 0.1
    assert len(found.longitude) == term_count(found.degree)


def test_longitudes_stay_in_their_range_across_the_antimeridian():
    def across(points_xy):
        return (179.95 + (points_xy[:, 0] - EXTENT[0]) / 200_000 + 180) % 360 - 180, points_xy[:, 1] / 111_000

    longitudes, _ = fit_lon_lat(across, EXTENT)(np.array([EXTENT[:2], EXTENT[2:]]))
    assert longitudes == pytest.approx([179.95, -179.95], abs=1e-6)


def test_a_transform_without_an_answer_gives_none():
    assert fit_lon_lat(lambda points: (points[:, 0] * np.nan, points[:, 1]), EXTENT) is None
