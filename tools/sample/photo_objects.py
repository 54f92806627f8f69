"""Draw the objects of a photo into color, relief and height of its scene: forests, single trees and roofs."""

from collections.abc import Sequence

import cv2
import numpy as np
from shapely.geometry import Polygon

from . import shapes
from .classes import BUILDING, FOREST, GRASS
from .landscape import Feature
from .photo_ground import LEAVES, Scene, linear, tinted

# sRGB 0…255 as one sees them in summer photos of Central Europe
ROOFS = ((150, 84, 62), (134, 74, 58), (160, 98, 76), (112, 66, 54), (92, 88, 88), (74, 72, 76), (120, 114, 108))
FLAT_ROOFS = ((168, 168, 166), (146, 146, 150), (190, 188, 180), (128, 134, 142))
CONIFERS = (44, 62, 42)

HOUSE_HEIGHTS_M, HALL_HEIGHT_M, FOREST_HEIGHT_M = (4.5, 8.5), 7.0, 14.0
FLAT_FROM_M2 = 430.0
GARDEN_TREES, TREE_RADII_M = 0.0022, (1.6, 4.2)  # trees a m² near houses
MEADOW_TREE_SHARE = 0.13  # of that, elsewhere on grass


def plant_forest(rng: np.random.Generator, scene: Scene) -> None:
    """Draw the crowns of the forest: groups of conifers and of broad-leaved trees, each tree a little different."""
    shape = scene.owner.shape
    forest = scene.kind == FOREST
    stand = shapes.noise(rng, shape, 170, 3)
    conifers = 1 / (1 + np.exp(-6 * (stand - rng.normal(0, 0.5))))
    crowns = blended(crown_relief(rng, shape, 3.4), crown_relief(rng, shape, 2.1), conifers)
    tone = shapes.noise(rng, shape, 6, 1)
    tree = linear(LEAVES) + conifers[..., None] * (linear(CONIFERS) - linear(LEAVES))
    gaps = np.clip(0.45 + 0.75 * crowns, 0.25, 1.15)
    tree = tree * (gaps * np.exp(0.13 * tone))[..., None]
    scene.color[forest] = tree[forest]
    edge = np.clip(cv2.distanceTransform(forest.astype(np.uint8), cv2.DIST_L2, 3) / 3, 0, 1)
    scene.relief[:] += np.where(forest, (1.9 + 1.2 * conifers) * crowns * edge, 0).astype(np.float32)
    scene.height[:] += np.where(forest, (FOREST_HEIGHT_M + 3 * stand) * np.clip(edge, 0.4, 1), 0).astype(np.float32)


def crown_relief(rng: np.random.Generator, shape_hw: tuple[int, ...], radius: float) -> np.ndarray:
    """(H, W) heights 0…1 of round crowns of about ``radius`` pixels: distance from a random scatter of trunks."""
    trunks = rng.uniform(size=shape_hw) < 0.30 / radius**2
    away = cv2.distanceTransform((~trunks).astype(np.uint8), cv2.DIST_L2, 5)
    return np.clip(1 - (away / (1.45 * radius)) ** 2, 0, 1).astype(np.float32)


def blended(first: np.ndarray, second: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Between two (H, W) arrays: the share of the second, 0…1."""
    return (first + (second - first) * share).astype(np.float32)


def plant_trees(rng: np.random.Generator, scene: Scene) -> None:
    """Single trees in gardens and meadows: too small for the forest class, but there."""
    rows, columns = np.nonzero((scene.kind == GRASS) & (rng.uniform(size=scene.kind.shape) < GARDEN_TREES))
    near_house = cv2.blur((scene.kind == BUILDING).astype(np.float32), (2 * 22 + 1,) * 2) > 0.02
    kept = near_house[rows, columns] | (rng.uniform(size=len(rows)) < MEADOW_TREE_SHARE)
    for row, column in zip(rows[kept], columns[kept]):
        plant_tree(rng, scene, (row, column), rng.uniform(*TREE_RADII_M))


def plant_tree(rng: np.random.Generator, scene: Scene, at_rc: tuple[int, int], radius_m: float) -> None:
    """One crown on grass around a pixel (row, column)."""
    color, relief, height = scene.color, scene.relief, scene.height
    reach = int(radius_m + 1)
    rows = slice(max(at_rc[0] - reach, 0), at_rc[0] + reach + 1)
    columns = slice(max(at_rc[1] - reach, 0), at_rc[1] + reach + 1)
    y, x = np.ogrid[rows.start : min(rows.stop, color.shape[0]), columns.start : min(columns.stop, color.shape[1])]
    crown = np.clip(1 - ((y - at_rc[0]) ** 2 + (x - at_rc[1]) ** 2) / radius_m**2, 0, 1).astype(np.float32)
    crown *= scene.kind[rows, columns] == GRASS
    cover = np.clip(3 * crown, 0, 1)[..., None]
    color[rows, columns] += cover * (tinted(rng, LEAVES, 0.15) * 0.85 - color[rows, columns])
    relief[rows, columns] = np.maximum(relief[rows, columns], 0.8 * radius_m * crown)
    height[rows, columns] = np.maximum(height[rows, columns], 1.6 * radius_m * np.clip(2 * crown, 0, 1))


def build_roofs(
    rng: np.random.Generator, scene: Scene, features: Sequence[Feature], frame: tuple[float, float, int, int]
) -> None:
    """Roofs: gables with a ridge along the longer side, halls flat; each with its color, courses and wear."""
    grain = shapes.noise(rng, scene.owner.shape, 2.5, 2)
    west, north, width, rows_count = frame
    for index, feature in enumerate(features):
        if feature.class_value != BUILDING:
            continue
        for polygon in shapes.polygons_of(feature.geometry):
            x0, y0, x1, y1 = polygon.bounds
            left, top = max(int(x0 - west) - 1, 0), max(int(north - y1) - 1, 0)
            right, bottom = min(int(x1 - west) + 2, width), min(int(north - y0) + 2, rows_count)
            part = np.s_[top:bottom, left:right]
            mine = scene.owner[part] == index
            y, x = np.mgrid[top:bottom, left:right]
            color, eaves, relief, streaks = make_roof(rng, polygon, west + x + 0.5, north - y - 0.5)
            scene.color[part][mine] = (color * np.exp(0.06 * grain[part] + streaks)[..., None])[mine]
            scene.relief[part][mine] = relief[mine]
            scene.height[part][mine] = (eaves + relief)[mine]


def make_roof(rng: np.random.Generator, polygon: Polygon, x: np.ndarray, y: np.ndarray) -> tuple:
    """The roof of one building at map coordinates x, y (h, w).

    Returns:
        (3,) linear color; height of the eaves, m; (h, w) height above them, m; (h, w) change of light by courses and
        skylights.
    """
    corners = shapes.corners_xy(polygon.minimum_rotated_rectangle)[:4]
    edges = np.diff(corners, axis=0)
    longest = edges[np.argmax(np.hypot(*edges[:2].T))]
    ridge = longest / np.hypot(*longest)
    center = corners.mean(axis=0)
    along = (x - center[0]) * ridge[0] + (y - center[1]) * ridge[1]
    across = np.abs((x - center[0]) * -ridge[1] + (y - center[1]) * ridge[0])
    courses = 0.03 * np.sin(2 * np.pi * along / rng.uniform(2.2, 4.0))
    if polygon.area > FLAT_FROM_M2 or rng.uniform() < 0.08:
        color = tinted(rng, FLAT_ROOFS[rng.integers(len(FLAT_ROOFS))], 0.12)
        skylights = np.where((np.mod(along, 9) < 1.6) & (across < 0.3 * np.sqrt(polygon.area)), 0.25, 0)
        return color, HALL_HEIGHT_M, np.zeros_like(x, np.float32), courses + skylights * rng.integers(0, 2)
    half = across.max()
    pitch = rng.uniform(0.45, 0.95)
    relief = (pitch * np.clip(half - across, 0, None)).astype(np.float32)
    color = tinted(rng, ROOFS[rng.choice(len(ROOFS), p=(0.22, 0.2, 0.14, 0.14, 0.12, 0.1, 0.08))], 0.10)
    return color, rng.uniform(*HOUSE_HEIGHTS_M) - 1.5, relief, courses
