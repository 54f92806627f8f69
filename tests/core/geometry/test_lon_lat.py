from dataclasses import replace

import numpy as np
import pytest

from semref.core.geometry.lon_lat import fit_lon_lat

EXTENT = (600_000.0, 5_190_000.0, 620_000.0, 5_200_000.0)


def curved(points_xy):
    """Return a slightly curved transform, like map projections."""
    x, y = (points_xy - (610_000, 5_195_000)).T
    return 9 + x / 76_000 + x * y * 2e-13, 47 + y / 111_000 - x**2 * 1e-13


def test_longitudes_stay_in_their_range_across_the_antimeridian():
    def across(points_xy):
        return (179.95 + (points_xy[:, 0] - EXTENT[0]) / 200_000 + 180) % 360 - 180, points_xy[:, 1] / 111_000

    found = fit_lon_lat(across, EXTENT)
    longitudes, _ = found(np.array([EXTENT[:2], EXTENT[2:]]))
    assert found.error_m < 1e-4
    assert longitudes == pytest.approx([179.95, -179.95], abs=1e-6)


def mercator(points_xy):
    radius = 6378137.0
    return np.degrees(points_xy[:, 0] / radius), np.degrees(np.arctan(np.sinh(points_xy[:, 1] / radius)))


def test_longitude_and_latitude_are_within_the_stated_error():
    extent = (1_000_000.0, 5_900_000.0, 1_060_000.0, 6_000_000.0)
    found = fit_lon_lat(mercator, extent)
    points = np.random.default_rng(1).uniform(extent[:2], extent[2:], (1000, 2))
    lon, lat = found(points)
    true_lon, true_lat = mercator(points)
    error = np.hypot((lon - true_lon) * 111320 * np.cos(np.radians(true_lat)), (lat - true_lat) * 111320).max()
    assert found.error_m <= 0.01
    assert error <= 1.1 * found.error_m + 1e-6


def test_a_map_around_a_pole_and_a_failing_transform_get_no_polynomial():
    def polar(points_xy):
        x, y = points_xy.T
        return np.degrees(np.arctan2(x, -y)), 90 - np.hypot(x, y) / 111_000

    assert fit_lon_lat(polar, (-50_000, -50_000, 50_000, 50_000)) is None
    assert fit_lon_lat(lambda points: (points[:, 0] * np.nan, points[:, 1]), EXTENT) is None


def test_coefficients_that_lead_off_the_earth_are_seen():
    found = fit_lon_lat(curved, (0.0, 0.0, 1000.0, 1000.0))
    assert found.is_on_earth((0.0, 0.0, 1000.0, 1000.0))
    for name in ("latitude", "longitude"):
        for coefficient in (float("inf"), float("nan")):
            changed = replace(found, **{name: (coefficient, *getattr(found, name)[1:])})
            assert not changed.is_on_earth((0.0, 0.0, 1000.0, 1000.0))
    assert not replace(found, latitude=(91.0, *found.latitude[1:])).is_on_earth((0.0, 0.0, 1000.0, 1000.0))
