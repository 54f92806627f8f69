"""The simulated camera: a ``View`` of the map, and the part of a label map, photo or database that it shows.

A view is defined on the map, so that the same one can be cut from a label map of any pixel size, a database's overview
and a list of landmarks. ``noise`` adds errors; ``core/evaluation/trial.py`` judges a localization of it.

Example:
    >>> view = View(x=758_400.0, y=5_221_350.0, heading_deg=30.0, pixel_size=1.2, width_px=640, height_px=480)
    >>> labels_hw = cut(source, frame, view)                    # source, frame: a label map and its grid
    >>> centers_xy = image_coordinates(view, landmarks.positions)  # the same ground as points
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from ..geometry.frame import MapFrame
from ..labels.sources import LabelSource

PIXELS = MapFrame.at((0.0, 0.0), 1.0)
"""Frame of a plain pixel grid: x is the column, y minus the row."""

LENS_STEPS = 6
"""Iterations of the lens's inverse; each reduces the error to a twentieth at 3 %."""

STRIP_ROWS = 32
"""Rows of an image that are cut together."""


@dataclass(frozen=True)
class View:
    """View of a simulated camera.

    Attributes:
        x: Easting of the image's center, m.
        y: Northing of the image's center, m.
        heading_deg: Direction of the image's top, clockwise from grid north.
        pixel_size: Ground size of a pixel at the center, m.
        tilt_deg: Angle of the optical axis from the vertical.
        tilt_direction_deg: Direction of the tilt, clockwise from the image's top.
        field_of_view_deg: Across the image's width; only for tilted views.
        is_mirrored: Left and right are exchanged: such an image exists nowhere on the map.
        lens: Radial distortion: relative displacement of the ground in the image's corners, outwards.
    """

    x: float
    y: float
    heading_deg: float = 0.0
    pixel_size: float = 1.0
    width_px: int = 1280
    height_px: int = 1280
    tilt_deg: float = 0.0
    tilt_direction_deg: float = 0.0
    field_of_view_deg: float = 60.0
    is_mirrored: bool = False
    lens: float = 0.0

    @property
    def position(self) -> tuple[float, float]:
        """Map (x, y) of the image's center."""
        return self.x, self.y

    @property
    def footprint(self) -> float:
        """Ground across the image's width, m."""
        return self.width_px * self.pixel_size

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self.height_px, self.width_px

    def plain(self) -> View:
        """Return the view without mirroring."""
        return replace(self, is_mirrored=False) if self.is_mirrored else self


def map_coordinates(view: View, columns: np.ndarray, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the map position of image points: the ground truth of a view.

    Args:
        view: Of any tilt, mirrored or not.
        columns: Pixel coordinates, of any shape.
        rows: Of the same shape.

    Returns:
        Map x and y, each of that shape.
    """
    east, south = _offsets(view, columns, rows, view.pixel_size)
    return view.x + east, view.y - south


def cut(source: LabelSource | np.ndarray, frame: MapFrame, view: View) -> np.ndarray:
    """Return the part of a raster that a view shows, by nearest neighbor.

    Args:
        source: A label map that is read in pieces, or a raster in memory, (H, W) or (H, W, bands).

    Returns:
        (height_px, width_px[, bands]) of the raster's type; 0 beyond the raster.
    """
    center = frame.to_pixels(np.array(view.position))
    places = np.empty((2, view.height_px, view.width_px), np.int64)
    columns, rows = np.arange(view.width_px) + 0.5, np.arange(view.height_px)[:, None] + 0.5
    # Strip by strip, because what a strip takes stays in the processor's cache.
    for first in range(0, view.height_px, STRIP_ROWS):
        strip = slice(first, first + STRIP_ROWS)
        offsets = _offsets(view, columns, rows[strip], view.pixel_size / frame.pixel_size)
        for place, at, offset in zip(places, center, offsets):
            # Rounding keeps quarter turns exact: cos 90° ≈ 6e-17 could push a sample over a pixel's edge.
            place[strip] = np.floor(np.round(at + offset, 6))
    return _sample(source, *places)


def lies_on(frame: MapFrame, view: View) -> bool:
    """Return whether the whole image shows ground of a frame with a shape."""
    # Level or tilted, the outermost samples are those of the corners.
    columns, rows = np.array([0.5, view.width_px - 0.5] * 2), np.repeat([0.5, view.height_px - 0.5], 2)
    points = np.floor(np.round(frame.to_pixels(np.column_stack(map_coordinates(view, columns, rows))), 6))
    return bool((points >= 0).all() and (points < frame.shape_hw[::-1]).all())


def image_coordinates(view: View, positions: np.ndarray) -> np.ndarray:
    """Return the image position of map points.

    Args:
        view: Level or tilted, with any lens.
        positions: (n, 2) map x, y.

    Returns:
        (n, 2) pixel coordinates (column, row), also outside the image.
    """
    east, north = (positions - view.position).T
    turn = math.radians(view.heading_deg)
    right = (east * math.cos(turn) - north * math.sin(turn)) / view.pixel_size
    up = (east * math.sin(turn) + north * math.cos(turn)) / view.pixel_size
    if view.tilt_deg:
        right, up = _in_the_image(view, right, up)
    if view.is_mirrored:
        right = -right
    if view.lens:
        straight_right, straight_up = right, up
        for _ in range(LENS_STEPS):
            larger = _larger(view, right, up)
            right, up = straight_right / larger, straight_up / larger
    return np.column_stack([view.width_px / 2 + right, view.height_px / 2 - up])


def _offsets(view: View, columns: np.ndarray, rows: np.ndarray, scale: float) -> tuple[np.ndarray, np.ndarray]:
    """Return offsets to the east and south of the image's center, in units of ``scale`` per image pixel."""
    right, up = columns - view.width_px / 2, view.height_px / 2 - rows
    if view.is_mirrored:
        right = -right
    if view.lens:
        larger = _larger(view, right, up)
        right, up = right * larger, up * larger
    if view.tilt_deg:
        right, up = _on_the_ground(view, right, up)
    turn = np.radians(view.heading_deg)
    cosine, sine = np.cos(turn), np.sin(turn)
    return scale * (cosine * right + sine * up), scale * (sine * right - cosine * up)


def _larger(view: View, right: np.ndarray, up: np.ndarray) -> np.ndarray:
    """Return how many times farther from the center points on the ground are (Brown's first radial term)."""
    return 1 + view.lens * (right**2 + up**2) / ((view.width_px**2 + view.height_px**2) / 4)


def _tilt(view: View) -> tuple[float, float, float]:
    """Return tilt and direction in radians, and the focal length in pixels."""
    focal = view.width_px / 2 / np.tan(np.radians(view.field_of_view_deg) / 2)
    return float(np.radians(view.tilt_deg)), float(np.radians(view.tilt_direction_deg)), float(focal)


def _on_the_ground(view: View, right: np.ndarray, up: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return offsets on level ground, in pixels of the vertical view, of image offsets of a tilted camera."""
    tilt, direction, focal = _tilt(view)
    along = np.sin(direction) * right + np.cos(direction) * up
    across = np.cos(direction) * right - np.sin(direction) * up
    depth = np.cos(tilt) - along / focal * np.sin(tilt)
    # The camera is lower the more it is tilted, so that a pixel at the center covers as much ground as a level one's.
    lower = np.cos(tilt) ** 1.5
    along, across = lower * along / (np.cos(tilt) * depth), lower * across / depth
    return (
        np.sin(direction) * along + np.cos(direction) * across,
        np.cos(direction) * along - np.sin(direction) * across,
    )


def _in_the_image(view: View, right: np.ndarray, up: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the inverse of ``_on_the_ground``; points at or behind the horizon are far outside."""
    tilt, direction, focal = _tilt(view)
    lower = np.cos(tilt) ** 1.5
    along = (np.sin(direction) * right + np.cos(direction) * up) / lower
    across = (np.cos(direction) * right - np.sin(direction) * up) / lower
    stretched = np.maximum(1 + along * np.cos(tilt) * np.sin(tilt) / focal, 1e-3)
    along = along * np.cos(tilt) ** 2 / stretched
    across = across * (np.cos(tilt) - along / focal * np.sin(tilt))
    return (
        np.sin(direction) * along + np.cos(direction) * across,
        np.cos(direction) * along - np.sin(direction) * across,
    )


def _sample(source: LabelSource | np.ndarray, columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Return (h, w[, bands]) pixels of a raster at integer places (h, w), 0 beyond it. Reads only the needed part."""
    height, width = source.shape[:2] if isinstance(source, np.ndarray) else source.shape_hw
    left, top = max(int(columns.min()), 0), max(int(rows.min()), 0)
    right, bottom = min(int(columns.max()) + 1, width), min(int(rows.max()) + 1, height)
    if right <= left or bottom <= top:
        if isinstance(source, np.ndarray):
            return np.zeros((*columns.shape, *source.shape[2:]), source.dtype)
        return np.zeros(columns.shape, np.uint8)
    if isinstance(source, np.ndarray):
        piece = source[top:bottom, left:right]
    else:
        piece = source.read(left, top, right - left, bottom - top)
    if columns.min() >= left and columns.max() < right and rows.min() >= top and rows.max() < bottom:
        return piece[rows - top, columns - left]
    seen = (columns >= left) & (columns < right) & (rows >= top) & (rows < bottom)
    pixels = piece[np.where(seen, rows - top, 0), np.where(seen, columns - left, 0)]
    pixels[~seen] = 0
    return np.ascontiguousarray(pixels)
