"""The ground of a photo: the class of each pixel, and the color of everything flat, from rows in fields to asphalt."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt
from shapely.geometry.base import BaseGeometry

from . import shapes
from .classes import BARE_LAND, BUILDING, CULTIVATED, FOREST, GRASS, WATER
from .landscape import ZORDER, Feature, Landscape

SUBPIXEL_BITS = 4  # of OpenCV's polygon corners

# sRGB 0…255 as one sees them in summer photos of Central Europe
CROPS = ((104, 118, 62), (150, 138, 82), (176, 158, 104), (74, 98, 48), (122, 96, 70), (92, 112, 58), (138, 112, 84))
MEADOWS = ((106, 124, 66), (120, 130, 74), (92, 112, 60), (132, 134, 84))
GARDEN = (98, 112, 66)
BARE = ((190, 174, 148), (172, 160, 140), (200, 186, 164), (160, 146, 124))
STILL_WATERS = ((42, 62, 58), (50, 70, 52), (34, 52, 58), (58, 74, 62))
RIVER = (58, 76, 64)
ASPHALT, VERGE = (124, 122, 120), (122, 120, 84)
UNDER_ROOFS = (150, 84, 62)  # until a roof is drawn
LEAVES = (72, 94, 48)


@dataclass(frozen=True)
class Scene:
    """Feature, class and road of each pixel, and what is painted on it.

    Attributes:
        owner: (H, W) int32 index of the uppermost feature, −1 without a feature.
        kind: (H, W) uint8 class value, 0 without a class.
        road: (H, W) uint8, 1 on roads.
        color: (H, W, 3) linear red, green, blue.
        relief: (H, W) height of surfaces that the sun shades, meters.
        height: (H, W) height of what throws a shadow, meters.
    """

    owner: np.ndarray
    kind: np.ndarray
    road: np.ndarray
    color: np.ndarray
    relief: np.ndarray
    height: np.ndarray


def draw_scene(features: Sequence[Feature], landscape: Landscape) -> Scene:
    """Features burnt in their order; roads over water (bridges), under houses."""
    west, north, width, height = landscape.frame
    owner = np.full((height, width), -1, np.int32)
    for index, feature in enumerate(features):
        for ring_set in outlines(feature.geometry, west, north):
            cv2.fillPoly(owner, ring_set, index, cv2.LINE_8, SUBPIXEL_BITS)
    kinds = np.array([f.class_value for f in features] + [0], np.uint8)  # −1 picks the last
    kind = kinds[owner]
    road = np.zeros((height, width), np.uint8)
    for ring_set in outlines(landscape.road_surface, west, north):
        cv2.fillPoly(road, ring_set, 1, cv2.LINE_8, SUBPIXEL_BITS)
    road[kind == BUILDING] = 0
    kind[road > 0] = 0
    flat = np.zeros((2, height, width), np.float32)
    return Scene(owner, kind, road, np.zeros((height, width, 3), np.float32), *flat)


def outlines(geometry: BaseGeometry | None, west: float, north: float) -> Iterator[list[np.ndarray]]:
    """For each polygon its rings, holes included, as OpenCV's corners: pixel centers, with SUBPIXEL_BITS."""
    for polygon in shapes.polygons_of(geometry):
        rings = []
        for ring in (polygon.exterior, *polygon.interiors):
            corners = (shapes.corners_xy(ring) - (west, north)) * (1, -1) - 0.5
            rings.append(np.round(corners * 2**SUBPIXEL_BITS).astype(np.int32))
        yield rings


def linear(rgb: npt.ArrayLike) -> np.ndarray:
    """Linear light of sRGB 0…255."""
    return (np.asarray(rgb, np.float32) / 255) ** np.float32(2.2)


def tinted(rng: np.random.Generator, rgb: npt.ArrayLike, strength: float) -> np.ndarray:
    """A color of the same kind: a little lighter or darker, warmer or cooler; linear."""
    return linear(rgb) * np.exp(rng.normal(0, strength) + rng.normal(0, 0.35 * strength, 3)).astype(np.float32)


def paint_ground(rng: np.random.Generator, scene: Scene, features: Sequence[Feature]) -> None:
    """Paint everything flat: fields with rows and tramlines, grass, water, gravel, roads."""
    shape, color = scene.owner.shape, scene.color
    base = np.array([feature_color(rng, f) for f in features] + [linear(VERGE)], np.float32)
    color[:] = base[scene.owner]
    fine = shapes.noise(rng, shape, 3, 2)
    middle = shapes.noise(rng, shape, 24, 4)
    coarse = shapes.noise(rng, shape, 260, 3)
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
    shore(scene)
    pave(rng, scene, fine, middle)


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
    return tinted(rng, {GRASS: GARDEN, FOREST: LEAVES, BUILDING: UNDER_ROOFS}[feature.class_value], 0.06)


def rows_of(rng: np.random.Generator, scene: Scene, features: Sequence[Feature]) -> np.ndarray:
    """(H, W) change of light by drilled rows and tramlines, along the longer side of each field."""
    angle, period, strength, lane = (np.zeros(len(features) + 1, np.float32) for _ in range(4))
    for index, feature in enumerate(features):
        if feature.class_value == CULTIVATED:
            east, north = shapes.longest_side(feature.geometry)
            angle[index] = np.arctan2(-north, east)  # image rows run down
            period[index], strength[index] = rng.uniform(2.8, 5.5), rng.uniform(0, 0.05)
            lane[index] = rng.choice([0, 15, 18, 21, 24, 27])
    y, x = np.indices(scene.owner.shape, np.float32)
    across = y * np.cos(angle)[scene.owner] - x * np.sin(angle)[scene.owner]
    change = strength[scene.owner] * np.sin(2 * np.pi * across / np.maximum(period[scene.owner], 1))
    lanes = lane[scene.owner]
    away = np.abs(np.mod(across, np.maximum(lanes, 1)) - lanes / 2)  # from the middle between two tramlines
    wheel = np.exp(-(((lanes / 2 - away) - 1.0) ** 2) / 0.6)
    return change + np.where(lanes > 0, 0.16 * wheel, 0).astype(np.float32)


def shore(scene: Scene) -> None:
    """Water is lighter and browner where it is shallow, and its edge is dark with reeds."""
    water = (scene.kind == WATER).astype(np.uint8)
    depth = cv2.distanceTransform(water, cv2.DIST_L2, 3)
    shallow = np.exp(-depth / 4.0) * water
    scene.color[:] += shallow[..., None] * (linear((92, 96, 70)) - scene.color) * 0.4
    bank = cv2.GaussianBlur(water.astype(np.float32), (0, 0), 1.6)
    edge = bank * (1 - water) * np.isin(scene.kind, (GRASS, CULTIVATED, 0)) * (scene.road == 0)
    scene.color[:] *= (1 - 0.75 * edge)[..., None]


def pave(rng: np.random.Generator, scene: Scene, fine: np.ndarray, middle: np.ndarray) -> None:
    """Asphalt, more or less worn, with paler edges; away from roads what no class covers stays verge and track."""
    inside = cv2.distanceTransform(scene.road, cv2.DIST_L2, 3)
    worn = np.exp(0.10 * middle + 0.04 * fine + 0.16 * np.exp(-inside / 0.9))
    asphalt = tinted(rng, ASPHALT, 0.10) * worn[..., None]
    road = scene.road > 0
    scene.color[road] = asphalt[road]
