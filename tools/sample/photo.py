"""A photo of the landscape from above: what a camera in clear weather would see of it, not what an annotator drew.

Every field, roof and tree has its own color and grain; the sun shades roofs and tree crowns and throws shadows; the
ground between the drawn polygons (roads, tracks, margins) is there too. Only numpy and OpenCV; the same landscape gives
the same photo. Arrays are (rows, columns), colors linear red, green, blue in 0…1 unless said otherwise.
"""

import cv2
import numpy as np
import numpy.typing as npt

from . import shapes
from .landscape import Landscape
from .photo_ground import draw_scene, linear, paint_ground
from .photo_objects import build_roofs, plant_forest, plant_trees
from .pictures import WINDOW_PX, Picture

SEED_OFFSET = 200  # draws of the photo don't depend on those of the landscape
SATURATION = 0.84  # of colors through air and a cheap lens
SHADOW_LIGHT = np.array([0.34, 0.40, 0.50], np.float32)  # the sky alone, bluer than the sun


def render(landscape: Landscape) -> np.ndarray:
    """Return the photo of the whole landscape, (H, W, 3) uint8 RGB, on the grid of its label map."""
    rng = np.random.default_rng([landscape.seed, SEED_OFFSET])
    azimuth = np.deg2rad(rng.uniform(120, 240))  # clockwise from north: a flight around noon
    toward, elevation = (float(np.sin(azimuth)), float(-np.cos(azimuth))), float(np.deg2rad(rng.uniform(38, 58)))
    features = sorted((f for f in landscape.features if f.geometry is not None), key=lambda f: f.zorder)
    scene = draw_scene(features, landscape)
    paint_ground(rng, scene, features)
    plant_forest(rng, scene)
    plant_trees(rng, scene)
    build_roofs(rng, scene, features, landscape.frame)
    light, shade = shading(scene.relief, toward, elevation), shadow(scene.height, toward, elevation)
    return developed(rng, scene.color, light, shade)


def shading(relief: np.ndarray, toward: tuple[float, float], elevation: float) -> np.ndarray:
    """Return the (H, W) light of slopes, 1 on level ground: Lambert's cosine law.

    Args:
        relief: (H, W) heights, meters.
        toward: Direction to the sun on the image (right, down).
        elevation: Height of the sun above the horizon, radians.
    """
    down, right = (cv2.Sobel(relief, cv2.CV_32F, *axes, ksize=3, scale=1 / 8) for axes in ((0, 1), (1, 0)))
    level = np.sin(elevation)
    cosine = level - np.cos(elevation) * (right * toward[0] + down * toward[1])
    return np.clip(cosine / np.sqrt(1 + right**2 + down**2) / level, 0.0, 1.7)


def shadow(height: np.ndarray, toward: tuple[float, float], elevation: float) -> np.ndarray:
    """(H, W) 0…1: how much of the sun each pixel misses behind what is higher towards the sun."""
    slope = float(np.tan(elevation))  # meters of height a meter of shadow
    reach = int(np.ceil(float(height.max()) / slope))
    horizon = np.full(height.shape, -1e3, np.float32)
    for step in range(1, reach + 1):
        move = np.array([[1, 0, -step * toward[0]], [0, 1, -step * toward[1]]], np.float32)
        moved = cv2.warpAffine(height, move, height.shape[::-1], flags=cv2.INTER_LINEAR)
        np.maximum(horizon, moved - np.float32(step * slope), out=horizon)
    return cv2.GaussianBlur(np.clip((horizon - height) / 0.8, 0, 1), (0, 0), 0.6)


def developed(rng: np.random.Generator, color: np.ndarray, light: np.ndarray, shade: np.ndarray) -> np.ndarray:
    """Light on color, seen through air and lens, as (H, W, 3) uint8 sRGB."""
    sky = np.float32(0.30)
    direct = (light * (1 - shade))[..., None]
    seen = color * (sky * SHADOW_LIGHT / SHADOW_LIGHT.mean() + (1 - sky) * direct)
    drift = shapes.noise(rng, color.shape[:2], 900, 2)  # thin clouds, mosaic of several flights
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


def turned(
    photo: np.ndarray, center: npt.ArrayLike, heading_deg: float, scale: float, size_px: tuple[int, int]
) -> np.ndarray:
    """Return a crop (height, width, 3) of a photo by linear interpolation.

    Args:
        photo: (H, W, 3) uint8.
        center: (column, row) of the crop's center.
        heading_deg: Direction of the crop's top, clockwise from that of the photo.
        scale: Pixels of the photo per pixel of the crop.
        size_px: (width, height) of the crop.
    """
    turn = np.deg2rad(heading_deg)
    matrix = scale * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    # Pixel corners have whole-number coordinates; in OpenCV, pixel centers have.
    offset = np.asarray(center) - 0.5 - matrix @ ((np.array(size_px) - 1) / 2)
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    return cv2.warpAffine(photo, np.column_stack([matrix, offset]), size_px, flags=flags)


def shoot(photo: np.ndarray, view: Picture, seed: int, size_px: int = WINDOW_PX) -> np.ndarray:
    """What a camera over the view's place would store, (size, size, 3) uint8: its own exposure, blur, vignette, noise.

    The place is the same as that of `pictures.cut`. The same seed and view give the same picture.
    """
    rng = np.random.default_rng([seed, SEED_OFFSET, int(view.column * 100), int(view.row * 100)])
    # A coarser pixel gathers the light of several; the margin is for the lens.
    softened = cv2.GaussianBlur(photo, (0, 0), 0.45 * view.scale) if view.scale > 1 else photo
    seen = turned(softened, (view.column, view.row), view.heading_deg, view.scale, (size_px, size_px))
    seen = cv2.GaussianBlur(seen.astype(np.float32) / 255, (0, 0), rng.uniform(0.3, 0.9))
    across = (np.arange(size_px, dtype=np.float32) + 0.5) / size_px - 0.5
    vignette = 1 - rng.uniform(0, 0.35) * (across[:, None] ** 2 + across[None, :] ** 2)
    exposure = np.exp(rng.normal(0, 0.12) + rng.normal(0, 0.025, 3)).astype(np.float32)
    contrast = np.exp(rng.normal(0, 0.10))
    seen = (seen * vignette[..., None] * exposure - 0.45) * np.float32(contrast) + 0.45
    return as_bytes(seen + rng.normal(0, rng.uniform(0.005, 0.02), seen.shape).astype(np.float32))
