"""Longitude and latitude of map coordinates by polynomials, for computers without PROJ."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Callable

import numpy as np

LOWEST_DEGREE, HIGHEST_DEGREE = 2, 9
"""Degrees tried: 9 has 55 terms; the UTM coordinates of a map of 50 km need 5."""

WANTED_ERROR_M = 0.01
"""The lowest degree with at most this error is used: a tenth of the error of the best fixes."""

LARGEST_ERROR_M = 1.0
"""A polynomial with a larger error is not stored: the map is too large, or contains a pole."""

_CHECKED = 41
"""Points along each axis where the error is measured; they differ from the fitted ones."""

_EQUATOR_M, _MERIDIAN_M = 111_319.5, 110_574.3
"""Meters a degree of longitude and smallest meters a degree of latitude, at the equator of WGS 84."""

_SEMI_MAJOR_M, _SQUARED_ECCENTRICITY = 6_378_137.0, 0.00669437999014
"""Of the ellipsoid of WGS 84."""

_STEP = 1.0
"""Step for measuring the axes, map units."""

Transform = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


@dataclass(frozen=True)
class LonLatPolynomial:
    """Longitude and latitude (degrees, EPSG:4326) as a function of map coordinates (x, y).

    With u = (x − center_x) / half_width and v = (y − center_y) / half_height, both are sums of c · uⁱ · vʲ over all
    i + j ≤ degree in the order (0, 0), (0, 1), … (0, degree), (1, 0), … (degree, 0).

    Attributes:
        center: (x, y).
        half_size: (half_width, half_height), map units.
        longitude: The coefficients c of the longitude.
        latitude: The coefficients c of the latitude.
        error_m: The largest distance from the true transform on a grid of places over the map.
    """

    degree: int
    center: tuple[float, float]
    half_size: tuple[float, float]
    longitude: tuple[float, ...]
    latitude: tuple[float, ...]
    error_m: float

    def __call__(self, points_xy: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return longitudes (N,) in [−180, 180) and latitudes (N,) of (N, 2) map coordinates."""
        terms = _terms(points_xy, self.degree, self.center, self.half_size)
        longitudes = (terms @ np.array(self.longitude) + 180) % 360 - 180
        return longitudes, terms @ np.array(self.latitude)

    def is_on_earth(self, extent: tuple[float, float, float, float]) -> bool:
        """Return whether all of a map has a finite longitude and a latitude of −90 to 90.

        Args:
            extent: (x_min, y_min, x_max, y_max) of the map.
        """
        x_min, y_min, x_max, y_max = extent
        xs, ys = np.meshgrid(np.linspace(x_min, x_max, _CHECKED), np.linspace(y_min, y_max, _CHECKED))
        with np.errstate(all="ignore"):
            longitudes, latitudes = self(np.column_stack([xs.ravel(), ys.ravel()]))
            return bool(np.isfinite(longitudes).all() and (np.abs(latitudes) <= 90).all())


def fit_lon_lat(transform: Transform, extent: tuple[float, float, float, float]) -> LonLatPolynomial | None:
    """Return the polynomial of the lowest degree within WANTED_ERROR_M of ``transform``, or the best one.

    Args:
        transform: (N, 2) map coordinates → longitudes (N,) and latitudes (N,), NaN where undefined.
        extent: (x_min, y_min, x_max, y_max) of the map.

    Returns:
        None if no polynomial is within LARGEST_ERROR_M.
    """
    center = (extent[0] + extent[2]) / 2, (extent[1] + extent[3]) / 2
    half_size = (extent[2] - extent[0]) / 2, (extent[3] - extent[1]) / 2
    # Chebyshev nodes are densest at the edges, where polynomials oscillate.
    nodes = np.cos((np.arange(2 * HIGHEST_DEGREE) + 0.5) * np.pi / (2 * HIGHEST_DEGREE))
    fitted, checked = _grid(nodes, center, half_size), _grid(np.linspace(-1, 1, _CHECKED), center, half_size)
    true_lon, true_lat = transform(fitted)
    check_lon, check_lat = transform(checked)
    if not np.isfinite([*true_lon, *true_lat, *check_lon, *check_lat]).all():
        return None
    # Without the jump at the antimeridian.
    true_lon = true_lon[0] + (true_lon - true_lon[0] + 180) % 360 - 180
    best: LonLatPolynomial | None = None
    for degree in range(LOWEST_DEGREE, HIGHEST_DEGREE + 1):
        terms = _terms(fitted, degree, center, half_size)
        lon, lat = (np.linalg.lstsq(terms, values, rcond=None)[0] for values in (true_lon, true_lat))
        found = LonLatPolynomial(degree, center, half_size, tuple(lon.tolist()), tuple(lat.tolist()), 0.0)
        error = float(_distances_m(*found(checked), check_lon, check_lat).max())
        if best is None or error < best.error_m:
            best = LonLatPolynomial(degree, center, half_size, found.longitude, found.latitude, error)
        if error <= WANTED_ERROR_M:
            break
    return best if best is not None and best.error_m <= LARGEST_ERROR_M else None


def meters_from(origin: tuple[float, float], place: tuple[float, float]) -> tuple[float, float]:
    """Return (north, east) in meters of a position from an origin, by the ellipsoid's curvatures halfway between.

    Args:
        origin: (latitude, longitude), degrees.
        place: (latitude, longitude), degrees.
    """
    middle = math.radians((origin[0] + place[0]) / 2)
    root = 1 - _SQUARED_ECCENTRICITY * math.sin(middle) ** 2
    meridian, across = _SEMI_MAJOR_M * (1 - _SQUARED_ECCENTRICITY) / root**1.5, _SEMI_MAJOR_M / math.sqrt(root)
    around = (place[1] - origin[1] + 180) % 360 - 180
    return meridian * math.radians(place[0] - origin[0]), across * math.cos(middle) * math.radians(around)


def local_axes(lon_lat: LonLatPolynomial, position: tuple[float, float]) -> np.ndarray:
    """Return (2, 2): east and north, in meters, of a step of one map unit along the map's x, and along its y."""
    x, y = position
    ends = np.array([(x - _STEP, y), (x + _STEP, y), (x, y - _STEP), (x, y + _STEP)])
    longitudes, latitudes = (values.tolist() for values in lon_lat(ends))
    steps = (meters_from((latitudes[n], longitudes[n]), (latitudes[n + 1], longitudes[n + 1])) for n in (0, 2))
    return np.array([(east, north) for north, east in steps]) / (2 * _STEP)


def term_count(degree: int) -> int:
    """Return the number of coefficients of a polynomial of two variables."""
    return (degree + 1) * (degree + 2) // 2


def _terms(points_xy: np.ndarray, degree: int, center: Sequence[float], half_size: Sequence[float]) -> np.ndarray:
    """Return (N, term_count) values of uⁱ · vʲ."""
    u, v = ((np.asarray(points_xy, np.float64).reshape(-1, 2) - center) / half_size).T
    return np.column_stack([u**i * v**j for i in range(degree + 1) for j in range(degree + 1 - i)])


def _grid(along: np.ndarray, center: Sequence[float], half_size: Sequence[float]) -> np.ndarray:
    xs, ys = np.meshgrid(center[0] + half_size[0] * along, center[1] + half_size[1] * along)
    return np.column_stack([xs.ravel(), ys.ravel()])


def _distances_m(lon: np.ndarray, lat: np.ndarray, other_lon: np.ndarray, other_lat: np.ndarray) -> np.ndarray:
    """Return upper bounds of distances between nearby positions, at most one percent too large near the poles."""
    east = ((lon - other_lon + 180) % 360 - 180) * np.cos(np.radians(other_lat)) * _EQUATOR_M * 1.004
    return np.hypot(east, (lat - other_lat) * _MERIDIAN_M * 1.011)
