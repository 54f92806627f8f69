"""A photo of the landscape from above: what a camera in clear weather would see of it, not what an annotator drew.

Every field, roof and tree has its own color and grain; the sun shades roofs and tree crowns and throws shadows; the
ground between the drawn polygons (roads, tracks, margins) is there too. Only numpy and OpenCV; the same landscape gives
the same photo. Arrays are (rows, columns), colors linear red, green, blue in 0…1 unless said otherwise.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from . import shapes
from .classes import BARE_LAND, BUILDING, CULTIVATED, FOREST, GRASS, WATER
from .landscape import ZORDER, Feature, Landscape
from .pictures import WINDOW_PX, Picture

Frame = tuple[float, float, int, int]
"""West and north edge in map units, width and height in pixels."""

SEED_OFFSET = 200  # draws of the photo don't depend on those of the landscape
SUBPIXEL_BITS = 4  # of OpenCV's polygon corners

# sRGB 0…255 as one sees them in summer photos of Central Europe
CROPS = ((104, 118, 62), (150, 138, 82), (176, 158, 104), (74, 98, 48), (122, 96, 70), (92, 112, 58), (138, 112, 84))
MEADOWS = ((106, 124, 66), (120, 130, 74), (92, 112, 60), (132, 134, 84))
GARDEN = (98, 112, 66)
ROOFS = ((150, 84, 62), (134, 74, 58), (160, 98, 76), (112, 66, 54), (92, 88, 88), (74, 72, 76), (120, 114, 108))
FLAT_ROOFS = ((168, 168, 166), (146, 146, 150), (190, 188, 180), (128, 134, 142))
BARE = ((190, 174, 148), (172, 160, 140), (200, 186, 164), (160, 146, 124))
STILL_WATERS = ((42, 62, 58), (50, 70, 52), (34, 52, 58), (58, 74, 62))
RIVER = (58, 76, 64)
CONIFERS, LEAVES = (44, 62, 42), (72, 94, 48)
ASPHALT, VERGE = (124, 122, 120), (122, 120, 84)

HOUSE_HEIGHTS_M, HALL_HEIGHT_M, FOREST_HEIGHT_M = (4.5, 8.5), 7.0, 14.0
FLAT_FROM_M2 = 430.0
GARDEN_TREES, TREE_RADII_M = 0.0022, (1.6, 4.2)  # trees a m² near houses
MEADOW_TREE_SHARE = 0.13  # of that, elsewhere on grass
SATURATION = 0.84  # of colors through air and a cheap lens
SHADOW_LIGHT = np.array([0.34, 0.40, 0.50], np.float32)  # the sky alone, bluer than the sun


@dataclass(frozen=True)
class Sun:
    """Direction on the image from which the light comes (right, down), and its height above the horizon."""

    toward: tuple[float, float]
    elevation: float

    @property
    def slope(self) -> float:
        """Meters of height a meter of shadow."""
        return float(np.tan(self.elevation))


@dataclass(frozen=True)
class Scene:
    """What stands where.

    Attributes:
        owner: (H, W) int32 index of the uppermost feature, −1 for none.
        kind: (H, W) uint8 class value, 0 for none.
        road: (H, W) uint8, 1 on roads.
        pixel_m: Edge of a pixel, meters.
    """

    owner: np.ndarray
    kind: np.ndarray
    road: np.ndarray
    pixel_m: float


def render(landscape: Landscape, frame: Frame, pixel_m: float) -> np.ndarray:
    """The photo of the whole landscape.

    Args:
        landscape: What is seen.
        frame: West and north edge in map units, width and height in pixels, as the label map has them.
        pixel_m: Edge of a pixel, meters.

    Returns:
        (H, W, 3) uint8 RGB.
    """
    rng = np.random.default_rng([landscape.seed, SEED_OFFSET])
    azimuth = np.deg2rad(rng.uniform(120, 240))  # clockwise from north: a flight around noon
    sun = Sun((float(np.sin(azimuth)), float(-np.cos(azimuth))), float(np.deg2rad(rng.uniform(38, 58))))
    features = sorted((f for f in landscape.features if f.geometry is not None), key=lambda f: f.zorder)
    scene = draw_scene(features, landscape, frame, pixel_m)
    color = ground_color(rng, scene, features)
    relief = np.zeros(scene.owner.shape, np.float32)
    height = np.zeros(scene.owner.shape, np.float32)
    plant_forest(rng, scene, color, relief, height)
    plant_trees(rng, scene, color, relief, height)
    build_roofs(rng, scene, features, frame, color, relief, height)
    return developed(rng, color, shading(relief, sun, pixel_m), shadow(height, sun, pixel_m), pixel_m)


def draw_scene(features: Sequence[Feature], landscape: Landscape, frame: Frame, pixel_m: float) -> Scene:
    """Features burnt in their order; roads over water (bridges), under houses."""
    _, _, width, height = frame
    owner = np.full((height, width), -1, np.int32)
    for index, feature in enumerate(features):
        for ring_set in outlines(feature.geometry, frame, pixel_m):
            cv2.fillPoly(owner, ring_set, index, cv2.LINE_8, SUBPIXEL_BITS)
    kinds = np.array([f.class_value for f in features] + [0], np.uint8)  # −1 picks the last
    kind = kinds[owner]
    road = np.zeros((height, width), np.uint8)
    for ring_set in outlines(landscape.road_surface, frame, pixel_m):
        cv2.fillPoly(road, ring_set, 1, cv2.LINE_8, SUBPIXEL_BITS)
    road[kind == BUILDING] = 0
    kind[road > 0] = 0
    return Scene(owner, kind, road, pixel_m)


def outlines(geometry: BaseGeometry | None, frame: Frame, pixel_m: float) -> Iterator[list[np.ndarray]]:
    """For each polygon its rings, holes included, as OpenCV's corners: pixel centers, with SUBPIXEL_BITS."""
    west, north, _, _ = frame
    for polygon in shapes.polygons_of(geometry):
        rings = []
        for ring in (polygon.exterior, *polygon.interiors):
            corners = (shapes.corners_xy(ring) - (west, north)) / (pixel_m, -pixel_m) - 0.5
            rings.append(np.round(corners * 2**SUBPIXEL_BITS).astype(np.int32))
        yield rings


def linear(rgb: npt.ArrayLike) -> np.ndarray:
    """Linear light of sRGB 0…255."""
    return (np.asarray(rgb, np.float32) / 255) ** np.float32(2.2)


def tinted(rng: np.random.Generator, rgb: npt.ArrayLike, strength: float) -> np.ndarray:
    """A color of the same kind: a little lighter or darker, warmer or cooler; linear."""
    return linear(rgb) * np.exp(rng.normal(0, strength) + rng.normal(0, 0.35 * strength, 3)).astype(np.float32)


def ground_color(rng: np.random.Generator, scene: Scene, features: Sequence[Feature]) -> np.ndarray:
    """(H, W, 3) color of everything that lies flat: fields with rows and tramlines, grass, water, gravel, roads."""
    shape, px = scene.owner.shape, scene.pixel_m
    base = np.array([feature_color(rng, f) for f in features] + [linear(VERGE)], np.float32)
    color = base[scene.owner]
    fine = shapes.noise(rng, shape, 3 / px, 2)
    middle = shapes.noise(rng, shape, 24 / px, 4)
    coarse = shapes.noise(rng, shape, 260 / px, 3)
    grain = {0: (0.06, 0.07), BARE_LAND: (0.09, 0.12), WATER: (0.015, 0.03), CULTIVATED: (0.045, 0.07)}
    grain |= {GRASS: (0.06, 0.12), FOREST: (0.05, 0.10), BUILDING: (0.03, 0.02)}
    weights = np.zeros((256, 2), np.float32)
    for value, pair in grain.items():
        weights[value] = pair
    light = weights[scene.kind, 0] * fine + weights[scene.kind, 1] * middle
    light += np.where(scene.kind == WATER, 0.02, 0.05).astype(np.float32) * coarse
    light += np.where(scene.kind == CULTIVATED, rows_of(rng, scene, features), 0)
    color *= np.exp(light)[..., None]
    # Dry patches are yellower, damp ones greener.
    green = np.isin(scene.kind, (GRASS, CULTIVATED))
    color[..., 0] *= np.where(green, np.exp(0.07 * middle + 0.04 * coarse), 1)
    shore(scene, color)
    pave(rng, scene, color, fine, middle)
    return color


def feature_color(rng: np.random.Generator, feature: Feature) -> np.ndarray:
    """The base color of one feature, linear; roofs get theirs later."""
    if feature.class_value == CULTIVATED:
        return tinted(rng, CROPS[rng.integers(len(CROPS))], 0.12)
    if feature.class_value == GRASS and feature.zorder == ZORDER["parcel"]:
        return tinted(rng, MEADOWS[rng.integers(len(MEADOWS))], 0.10)
    if feature.class_value == WATER:
        running = feature.geometry.length**2 > 120 * feature.geometry.area
        return tinted(rng, RIVER if running else STILL_WATERS[rng.integers(len(STILL_WATERS))], 0.12)
    if feature.class_value == BARE_LAND:
        return tinted(rng, BARE[rng.integers(len(BARE))], 0.10)
    return tinted(rng, {GRASS: GARDEN, FOREST: LEAVES, BUILDING: ROOFS[0]}[feature.class_value], 0.06)


def rows_of(rng: np.random.Generator, scene: Scene, features: Sequence[Feature]) -> np.ndarray:
    """(H, W) change of light by drilled rows and tramlines, along the longer side of each field."""
    px, count = scene.pixel_m, len(features)
    angle, period, strength, lane = (np.zeros(count + 1, np.float32) for _ in range(4))
    for index, feature in enumerate(features):
        if feature.class_value == CULTIVATED:
            box = feature.geometry.minimum_rotated_rectangle
            edges = np.diff(shapes.corners_xy(box.exterior), axis=0)
            longest = edges[np.argmax(np.hypot(*edges.T))]
            angle[index] = np.arctan2(-longest[1], longest[0])  # image rows run down
            period[index], strength[index] = rng.uniform(2.8, 5.5), rng.uniform(0, 0.05)
            lane[index] = rng.choice([0, 15, 18, 21, 24, 27])
    y, x = np.indices(scene.owner.shape, np.float32) * np.float32(px)
    across = y * np.cos(angle)[scene.owner] - x * np.sin(angle)[scene.owner]
    change = strength[scene.owner] * np.sin(2 * np.pi * across / np.maximum(period[scene.owner], 1))
    lanes = lane[scene.owner]
    away = np.abs(np.mod(across, np.maximum(lanes, 1)) - lanes / 2)  # from the middle between two tramlines
    wheel = np.exp(-(((lanes / 2 - away) - 1.0) ** 2) / 0.6)
    return change + np.where(lanes > 0, 0.16 * wheel, 0).astype(np.float32)


def shore(scene: Scene, color: np.ndarray) -> None:
    """Water is lighter and browner where it is shallow, and its edge is dark with reeds."""
    water = (scene.kind == WATER).astype(np.uint8)
    depth = cv2.distanceTransform(water, cv2.DIST_L2, 3) * np.float32(scene.pixel_m)
    shallow = np.exp(-depth / 4.0) * water
    color += shallow[..., None] * (linear((92, 96, 70)) - color) * 0.4
    bank = cv2.GaussianBlur(water.astype(np.float32), (0, 0), 1.6 / scene.pixel_m)
    edge = bank * (1 - water) * np.isin(scene.kind, (GRASS, CULTIVATED, 0)) * (scene.road == 0)
    color *= (1 - 0.75 * edge)[..., None]


def pave(rng: np.random.Generator, scene: Scene, color: np.ndarray, fine: np.ndarray, middle: np.ndarray) -> None:
    """Asphalt, more or less worn, with paler edges; away from roads what no class covers stays verge and track."""
    inside = cv2.distanceTransform(scene.road, cv2.DIST_L2, 3) * np.float32(scene.pixel_m)
    worn = np.exp(0.10 * middle + 0.04 * fine + 0.16 * np.exp(-inside / 0.9))
    asphalt = tinted(rng, ASPHALT, 0.10) * worn[..., None]
    road = scene.road > 0
    color[road] = asphalt[road]


def plant_forest(
    rng: np.random.Generator, scene: Scene, color: np.ndarray, relief: np.ndarray, height: np.ndarray
) -> None:
    """Crowns on the forest: stands of conifers and of broad-leaved trees, each tree a little different."""
    shape, px = scene.owner.shape, scene.pixel_m
    forest = scene.kind == FOREST
    stand = shapes.noise(rng, shape, 170 / px, 3)
    conifers = 1 / (1 + np.exp(-6 * (stand - rng.normal(0, 0.5))))
    crowns = blended(crown_relief(rng, shape, 3.4 / px), crown_relief(rng, shape, 2.1 / px), conifers)
    tone = shapes.noise(rng, shape, 6 / px, 1)
    tree = linear(LEAVES) + conifers[..., None] * (linear(CONIFERS) - linear(LEAVES))
    gaps = np.clip(0.45 + 0.75 * crowns, 0.25, 1.15)
    tree = tree * (gaps * np.exp(0.13 * tone))[..., None]
    color[forest] = tree[forest]
    edge = np.clip(cv2.distanceTransform(forest.astype(np.uint8), cv2.DIST_L2, 3) * px / 3, 0, 1)
    relief += np.where(forest, (1.9 + 1.2 * conifers) * crowns * edge, 0).astype(np.float32)
    height += np.where(forest, (FOREST_HEIGHT_M + 3 * stand) * np.clip(edge, 0.4, 1), 0).astype(np.float32)


def crown_relief(rng: np.random.Generator, shape_hw: tuple[int, ...], radius: float) -> np.ndarray:
    """(H, W) heights 0…1 of round crowns of about ``radius`` pixels: distance from a random scatter of trunks."""
    trunks = rng.uniform(size=shape_hw) < 0.30 / radius**2
    away = cv2.distanceTransform((~trunks).astype(np.uint8), cv2.DIST_L2, 5)
    return np.clip(1 - (away / (1.45 * radius)) ** 2, 0, 1).astype(np.float32)


def blended(first: np.ndarray, second: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Between two (H, W) arrays: the share of the second, 0…1."""
    return (first + (second - first) * share).astype(np.float32)


def plant_trees(
    rng: np.random.Generator, scene: Scene, color: np.ndarray, relief: np.ndarray, height: np.ndarray
) -> None:
    """Single trees in gardens and meadows: too small for the forest class, but there."""
    px = scene.pixel_m
    rows, columns = np.nonzero((scene.kind == GRASS) & (rng.uniform(size=scene.kind.shape) < GARDEN_TREES * px**2))
    near_house = cv2.blur((scene.kind == BUILDING).astype(np.float32), (2 * int(22 / px) + 1,) * 2) > 0.02
    kept = near_house[rows, columns] | (rng.uniform(size=len(rows)) < MEADOW_TREE_SHARE)
    for row, column in zip(rows[kept], columns[kept]):
        plant_tree(rng, scene, (row, column), rng.uniform(*TREE_RADII_M), color, relief, height)


def plant_tree(  # noqa: PLR0913 - it draws into three layers
    rng: np.random.Generator,
    scene: Scene,
    at_rc: tuple[int, int],
    radius_m: float,
    color: np.ndarray,
    relief: np.ndarray,
    height: np.ndarray,
) -> None:
    """One crown on grass around a pixel (row, column), drawn into color, relief and height."""
    radius = radius_m / scene.pixel_m
    reach = int(radius + 1)
    rows = slice(max(at_rc[0] - reach, 0), at_rc[0] + reach + 1)
    columns = slice(max(at_rc[1] - reach, 0), at_rc[1] + reach + 1)
    y, x = np.ogrid[rows.start : min(rows.stop, color.shape[0]), columns.start : min(columns.stop, color.shape[1])]
    crown = np.clip(1 - ((y - at_rc[0]) ** 2 + (x - at_rc[1]) ** 2) / radius**2, 0, 1).astype(np.float32)
    crown *= scene.kind[rows, columns] == GRASS
    cover = np.clip(3 * crown, 0, 1)[..., None]
    color[rows, columns] += cover * (tinted(rng, LEAVES, 0.15) * 0.85 - color[rows, columns])
    relief[rows, columns] = np.maximum(relief[rows, columns], 0.8 * radius_m * crown)
    height[rows, columns] = np.maximum(height[rows, columns], 1.6 * radius_m * np.clip(2 * crown, 0, 1))


def build_roofs(  # noqa: PLR0913 - it draws into three layers
    rng: np.random.Generator,
    scene: Scene,
    features: Sequence[Feature],
    frame: Frame,
    color: np.ndarray,
    relief: np.ndarray,
    height: np.ndarray,
) -> None:
    """Roofs: gables with a ridge along the longer side, halls flat; each with its color, courses and wear."""
    px = scene.pixel_m
    grain = shapes.noise(rng, scene.owner.shape, 2.5 / px, 2)
    west, north, width, rows_count = frame
    for index, feature in enumerate(features):
        if feature.class_value != BUILDING:
            continue
        for polygon in shapes.polygons_of(feature.geometry):
            x0, y0, x1, y1 = polygon.bounds
            left, top = max(int((x0 - west) / px) - 1, 0), max(int((north - y1) / px) - 1, 0)
            right, bottom = min(int((x1 - west) / px) + 2, width), min(int((north - y0) / px) + 2, rows_count)
            part = np.s_[top:bottom, left:right]
            mine = scene.owner[part] == index
            y, x = np.mgrid[top:bottom, left:right]
            roof = make_roof(rng, polygon, west + (x + 0.5) * px, north - (y + 0.5) * px)
            color[part][mine] = (roof.color * np.exp(0.06 * grain[part] + roof.streaks)[..., None])[mine]
            relief[part][mine] = roof.relief[mine]
            height[part][mine] = (roof.eaves + roof.relief)[mine]


@dataclass(frozen=True)
class Roof:
    """What the roof of one building looks like.

    Attributes:
        color: (3,) linear red, green, blue.
        eaves: Height of the eaves, meters.
        relief: (h, w) height above the eaves, meters.
        streaks: (h, w) change of light by courses and skylights.
    """

    color: np.ndarray
    eaves: float
    relief: np.ndarray
    streaks: np.ndarray


def make_roof(rng: np.random.Generator, polygon: Polygon, x: np.ndarray, y: np.ndarray) -> Roof:
    """The roof of one building at map coordinates x, y (h, w)."""
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
        return Roof(color, HALL_HEIGHT_M, np.zeros_like(x, np.float32), courses + skylights * rng.integers(0, 2))
    half = across.max()
    pitch = rng.uniform(0.45, 0.95)
    relief = (pitch * np.clip(half - across, 0, None)).astype(np.float32)
    color = tinted(rng, ROOFS[rng.choice(len(ROOFS), p=(0.22, 0.2, 0.14, 0.14, 0.12, 0.1, 0.08))], 0.10)
    return Roof(color, rng.uniform(*HOUSE_HEIGHTS_M) - 1.5, relief, courses)


def shading(relief: np.ndarray, sun: Sun, pixel_m: float) -> np.ndarray:
    """(H, W) light of slopes, 1 on level ground: Lambert's cosine law."""
    down, right = (cv2.Sobel(relief, cv2.CV_32F, *axes, ksize=3, scale=1 / (8 * pixel_m)) for axes in ((0, 1), (1, 0)))
    level = np.sin(sun.elevation)
    cosine = level - np.cos(sun.elevation) * (right * sun.toward[0] + down * sun.toward[1])
    return np.clip(cosine / np.sqrt(1 + right**2 + down**2) / level, 0.0, 1.7)


def shadow(height: np.ndarray, sun: Sun, pixel_m: float) -> np.ndarray:
    """(H, W) 0…1: how much of the sun each pixel misses behind what is higher towards the sun."""
    reach = int(np.ceil(float(height.max()) / sun.slope / pixel_m))
    horizon = np.full(height.shape, -1e3, np.float32)
    for step in range(1, reach + 1):
        move = np.array([[1, 0, -step * sun.toward[0]], [0, 1, -step * sun.toward[1]]], np.float32)
        moved = cv2.warpAffine(height, move, height.shape[::-1], flags=cv2.INTER_LINEAR)
        np.maximum(horizon, moved - np.float32(step * pixel_m * sun.slope), out=horizon)
    return cv2.GaussianBlur(np.clip((horizon - height) / 0.8, 0, 1), (0, 0), 0.6)


def developed(
    rng: np.random.Generator, color: np.ndarray, light: np.ndarray, shade: np.ndarray, pixel_m: float
) -> np.ndarray:
    """Light on color, seen through air and lens, as (H, W, 3) uint8 sRGB."""
    sky = np.float32(0.30)
    direct = (light * (1 - shade))[..., None]
    seen = color * (sky * SHADOW_LIGHT / SHADOW_LIGHT.mean() + (1 - sky) * direct)
    drift = shapes.noise(rng, color.shape[:2], 900 / pixel_m, 2)  # thin clouds, mosaic of several flights
    seen *= np.exp(0.05 * drift + rng.normal(0, 0.08))[..., None]
    seen = cv2.GaussianBlur(seen, (0, 0), 0.55)
    haze = linear((150, 165, 185)) * np.float32(rng.uniform(0.02, 0.07))
    balance = np.exp(rng.normal(0, 0.04, 3)).astype(np.float32)
    picture = np.clip((seen * balance + haze) * np.float32(1.15), 0, 1) ** np.float32(1 / 2.2)
    grey = picture.mean(axis=2, keepdims=True)
    return as_bytes(grey + np.float32(SATURATION) * (picture - grey))


def as_bytes(picture: np.ndarray) -> np.ndarray:
    """0…1 as 0…255, uint8."""
    return (np.clip(picture, 0, 1) * 255 + 0.5).astype(np.uint8)


def shoot(photo: np.ndarray, view: Picture, seed: int, size_px: int = WINDOW_PX) -> np.ndarray:
    """What a camera over the view's place would store, (size, size, 3) uint8: its own exposure, blur, vignette, noise.

    The place is the same as that of `pictures.cut`. The same seed and view give the same picture.
    """
    rng = np.random.default_rng([seed, SEED_OFFSET, int(view.column * 100), int(view.row * 100)])
    turn = np.deg2rad(view.heading_deg)
    matrix = view.scale * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    offset = np.array([view.column, view.row]) - 0.5 - matrix @ np.full(2, (size_px - 1) / 2)
    # A coarser pixel gathers the light of several; the margin is for the lens.
    softened = cv2.GaussianBlur(photo, (0, 0), 0.45 * view.scale) if view.scale > 1 else photo
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    seen = cv2.warpAffine(softened, np.column_stack([matrix, offset]), (size_px, size_px), flags=flags)
    seen = cv2.GaussianBlur(seen.astype(np.float32) / 255, (0, 0), rng.uniform(0.3, 0.9))
    across = (np.arange(size_px, dtype=np.float32) + 0.5) / size_px - 0.5
    vignette = 1 - rng.uniform(0, 0.35) * (across[:, None] ** 2 + across[None, :] ** 2)
    exposure = np.exp(rng.normal(0, 0.12) + rng.normal(0, 0.025, 3)).astype(np.float32)
    contrast = np.exp(rng.normal(0, 0.10))
    seen = (seen * vignette[..., None] * exposure - 0.45) * np.float32(contrast) + 0.45
    return as_bytes(seen + rng.normal(0, rng.uniform(0.005, 0.02), seen.shape).astype(np.float32))
