"""Curves, blobs and noise that landscapes are drawn with. Lengths in meters, angles in radians from +x to +y."""

from __future__ import annotations

import cv2
import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry


def smoothed(points_xy: np.ndarray, rounds: int, closed: bool = False) -> np.ndarray:
    """Cut the corners of a line, (n, 2) → (m, 2), `rounds` times (Chaikin)."""
    for _ in range(rounds):
        following = np.roll(points_xy, -1, axis=0) if closed else points_xy[1:]
        current = points_xy if closed else points_xy[:-1]
        cut = np.stack([0.75 * current + 0.25 * following, 0.25 * current + 0.75 * following], axis=1).reshape(-1, 2)
        points_xy = cut if closed else np.vstack([points_xy[:1], cut, points_xy[-1:]])
    return points_xy


def meander(
    rng: np.random.Generator, start_xy: npt.ArrayLike, end_xy: npt.ArrayLike, wavelength: float, swing: float
) -> np.ndarray:
    """A river's line, (n, 2), from start to end: direction swings like a sine along the way (Langbein & Leopold 1966).

    `swing` is the largest deviation from the valley's direction; 1.9 would close the loops.
    """
    start, end = np.asarray(start_xy, float), np.asarray(end_xy, float)
    step = wavelength / 60
    count = int(1.4 * np.hypot(*(end - start)) / step)
    along = np.arange(count) * step
    drift = np.interp(along, np.linspace(0, along[-1], 9), rng.uniform(-1.2, 1.2, 9))
    strength = np.interp(along, np.linspace(0, along[-1], 7), rng.uniform(0.45, 1.0, 7))
    small = 0.3 * np.sin(2 * np.pi * along / (0.37 * wavelength) + rng.uniform(0, 6))
    direction = swing * strength * (np.sin(2 * np.pi * along / wavelength + drift * 2) + small)
    path = np.cumsum(np.column_stack([np.cos(direction), np.sin(direction)]), axis=0)
    path -= path[0]
    turn = complex(*(end - start)) / complex(*path[-1])  # similarity that brings the last point to `end`
    moved = (path[:, 0] + 1j * path[:, 1]) * turn
    return np.column_stack([moved.real, moved.imag]) + start


def wobbly_line(rng: np.random.Generator, start_xy: npt.ArrayLike, end_xy: npt.ArrayLike, bend: float) -> LineString:
    """A road from start to end that strays sideways by about `bend` × its length."""
    start, end = np.asarray(start_xy, float), np.asarray(end_xy, float)
    length = np.hypot(*(end - start))
    t = np.linspace(0, 1, max(3, int(length / 90) + 2))
    waves = sum(rng.normal(0, bend / k) * np.sin(np.pi * k * t) for k in (1, 2, 3))
    normal = np.array([-(end - start)[1], (end - start)[0]])
    return LineString(smoothed(start + t[:, None] * (end - start) + waves[:, None] * normal, 2))


def blob(
    rng: np.random.Generator,
    center_xy: npt.ArrayLike,
    radius: float,
    roughness: float,
    stretch: float = 1.0,
    heading: float = 0.0,
) -> Polygon:
    """An irregular round patch of mean radius `radius`, `stretch` times longer along `heading` than across."""
    count = int(np.clip(radius * 1.5, 20, 90))
    theta = np.linspace(0, 2 * np.pi, count, endpoint=False)
    waves = sum(rng.normal(0, roughness / k**0.8) * np.cos(k * theta + rng.uniform(0, 6.3)) for k in range(2, 8))
    r = radius * np.clip(1 + waves, 0.35, 1.8)
    x, y = r * np.cos(theta) * np.sqrt(stretch), r * np.sin(theta) / np.sqrt(stretch)
    points = rotated(np.column_stack([x, y]), heading) + np.asarray(center_xy)
    return Polygon(smoothed(points, 1, closed=True))


def rotated(points_xy: np.ndarray, angle: float) -> np.ndarray:
    """Points (n, 2) turned about the origin."""
    c, s = np.cos(angle), np.sin(angle)
    return points_xy @ np.array([[c, s], [-s, c]])


def rectangle(center_xy: npt.ArrayLike, heading: float, length: float, width: float) -> Polygon:
    """Return a rectangle with its `length` along `heading`."""
    half = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * [length / 2, width / 2]
    return Polygon(rotated(half, heading) + np.asarray(center_xy))


def noise(
    rng: np.random.Generator, shape_hw: tuple[int, ...], cell: float, octaves: int, rough: float = 0.58
) -> np.ndarray:
    """Smooth noise, float32 (h, w), mean 0, deviation 1.

    `cell`: pixels between knots of the coarsest octave; each finer octave is `rough` times as strong.
    """
    height, width = shape_hw
    total = np.zeros(shape_hw, np.float32)
    for octave in range(octaves):
        size = cell / 2**octave
        knots = rng.normal(size=(int(height / size) + 3, int(width / size) + 3)).astype(np.float32)
        total += cv2.resize(knots, (width, height), interpolation=cv2.INTER_CUBIC) * rough**octave
    return (total - total.mean()) / total.std()


def corners_xy(shape: BaseGeometry) -> np.ndarray:
    """(n, 2) vertices of a line, a ring, or a polygon without holes; no height, which old versions of GEOS make up."""
    return shapely.get_coordinates(shape)


def point_xy(point: BaseGeometry) -> np.ndarray:
    """(2,) place of a point."""
    return shapely.get_coordinates(point)[0]


def longest_side(polygon: Polygon) -> np.ndarray:
    """(2,) longest side of the smallest rectangle around a polygon."""
    edges = np.diff(corners_xy(polygon.minimum_rotated_rectangle), axis=0)
    return edges[np.argmax(np.hypot(*edges.T))]


def polygons_of(geometry: BaseGeometry | None, min_area: float = 0.0) -> list[Polygon]:
    """The polygons in any geometry, in its order, without those smaller than `min_area` m²."""
    if geometry is None or geometry.is_empty:
        return []
    parts = getattr(geometry, "geoms", [geometry])
    return [
        p
        for part in parts
        for p in ([part] if part.geom_type == "Polygon" else polygons_of(part))
        if part.geom_type != "Polygon" or part.area >= min_area
    ]


def mask_polygons(mask_hw: np.ndarray, pixel: float, min_area: float) -> list[Polygon]:
    """Return outlines with holes of a mask. Its first row is the southernmost; pixel edge in meters."""
    padded = np.pad(mask_hw.astype(np.uint8), 2, mode="edge")  # so that outlines pass the map's edge
    padded = np.pad(padded, 1)
    contours, tree = cv2.findContours(padded, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    rings = [smoothed((c[::2, 0].astype(float) - 2.5) * pixel, 2, closed=True) for c in contours]
    found = []
    for index, ring in enumerate(rings):
        if tree[0][index][3] >= 0 or len(ring) < 16:
            continue
        holes = [rings[k] for k in range(len(rings)) if tree[0][k][3] == index and len(rings[k]) >= 16]
        found += polygons_of(Polygon(ring, holes).buffer(0), min_area)
    return found
