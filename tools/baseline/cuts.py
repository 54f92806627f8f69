"""Label images cut from label maps, the same ones every time: anywhere, turned, scaled, tilted, with spoiled labels.

Only numpy and OpenCV are used, so that a change of the plugin never changes the images.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

FIELD_OF_VIEW_DEG = 60.0
SMOOTH_PX = 4.0
"""How far along an edge its moves are alike."""


@dataclass(frozen=True)
class Noise:
    """Shares of the landmarks that are missed, invented and misnamed; edges are moved by ragged pixels."""

    missed: float = 0.0
    invented: float = 0.0
    misnamed: float = 0.0
    ragged: float = 0.0


LIGHT, HEAVY = Noise(0.2, 0.2, 0.05, 1.0), Noise(0.4, 0.4, 0.1, 2.0)


@dataclass(frozen=True)
class View:
    """Place of an image on the map, and the noise of its labels.

    column, row: center; pixel: map pixels per image pixel; tilt: roll and pitch in degrees; bare: share of the image
    without labels.
    """

    name: str
    column: float
    row: float
    heading_deg: float
    pixel: float
    size: int
    noise: Noise
    tilt: tuple[float, float] = (0.0, 0.0)
    bare: float = 0.0
    mirrored: bool = False


def plan(
    counts: dict[str, int], map_hw: Sequence[int], window_px: float, stride_px: float, size: int, seed: int
) -> list[View]:
    """Views of each kind; a view depends on its kind, its number and the seed only."""
    views = []
    for kind, count in counts.items():
        for number in range(count):
            rng = np.random.default_rng([seed, *kind.encode(), number])
            views.append(_view(kind, number, map_hw, window_px, stride_px, size, rng))
    return views


def _view(kind, number, map_hw, window_px, stride_px, size, rng) -> View:
    scale = float(rng.uniform(0.5, 2.0) if kind == "wide" else rng.uniform(0.8, 1.25))
    pixel = window_px / size * scale
    # The corners of a turned square may be outside the map.
    margin = min(0.6 * size * pixel, min(map_hw) / 2)
    column, row = (float(rng.uniform(margin, length - margin)) for length in (map_hw[1], map_hw[0]))
    noise = {"clean": Noise(), "window": Noise(), "spoiled": HEAVY, "poor": HEAVY}.get(kind, LIGHT)
    view = View(f"{kind}_{number:02d}", column, row, float(rng.uniform(0, 360)), pixel, size, noise)
    if kind == "window":
        steps = (int(rng.integers(0, (length - window_px) // stride_px + 1)) for length in (map_hw[1], map_hw[0]))
        column, row = (step * stride_px + window_px / 2 for step in steps)
        return replace(view, column=column, row=row, heading_deg=0.0, pixel=window_px / size)
    if kind == "tilted":
        return replace(view, tilt=(float(rng.uniform(-12, 12)), float(rng.uniform(5, 25))))
    if kind == "poor":
        return replace(view, bare=(1.0, 0.7, 0.85, 0.93)[number % 4])
    return replace(view, mirrored=kind == "mirrored")


def cut(labels_hw: np.ndarray, view: View, references: Sequence[int]) -> np.ndarray:
    """(size, size) the view's labels, spoiled as it says."""
    columns, rows = _ground(view)
    inside = (columns >= 0) & (columns < labels_hw.shape[1]) & (rows >= 0) & (rows < labels_hw.shape[0])
    image = np.zeros(columns.shape, np.uint8)
    image[inside] = labels_hw[rows[inside].astype(np.int64), columns[inside].astype(np.int64)]
    rng = np.random.default_rng([*view.name.encode(), int(view.column * 1000)])
    image = _spoiled(image, view.noise, references, rng)
    image[:, : round(view.bare * view.size)] = 0
    return np.ascontiguousarray(image[:, ::-1]) if view.mirrored else image


def _ground(view: View) -> tuple[np.ndarray, np.ndarray]:
    """(H, W) column and row on the map of each pixel's centre."""
    steps = np.arange(view.size) + 0.5 - view.size / 2
    right, top = np.meshgrid(steps, -steps)
    if view.tilt != (0.0, 0.0):
        right, top = _level(right, top, view.tilt, view.size / 2 / np.tan(np.radians(FIELD_OF_VIEW_DEG / 2)))
    sine, cosine = np.sin(np.radians(view.heading_deg)), np.cos(np.radians(view.heading_deg))
    columns = view.column + view.pixel * (right * cosine + top * sine)
    return columns, view.row + view.pixel * (right * sine - top * cosine)


def _level(right, top, tilt, focal) -> tuple[np.ndarray, np.ndarray]:
    """Where a tilted camera's rays meet the ground, from where its axis does; signs: docs/reference/file_formats.md."""
    roll, pitch = np.radians(tilt)
    down = np.array([-np.sin(roll) * np.cos(pitch), -np.sin(pitch), np.cos(roll) * np.cos(pitch)])
    ahead = np.array([0.0, 1.0, 0.0]) - down[1] * down
    ahead /= np.linalg.norm(ahead)
    aside = np.array([1.0, 0.0, 0.0]) - down[0] * down - ahead[0] * ahead
    aside /= np.linalg.norm(aside)
    rays = np.stack([right, top, np.full_like(right, focal)])
    x, y = (focal * np.tensordot(axis, rays, 1) / np.tensordot(down, rays, 1) for axis in (aside, ahead))
    return x - focal * aside[2] / down[2], y - focal * ahead[2] / down[2]


def _spoiled(image: np.ndarray, noise: Noise, references: Sequence[int], rng: np.random.Generator) -> np.ndarray:
    if noise == Noise():
        return image
    background = image[~np.isin(image, references)]
    fill = int(np.bincount(background).argmax()) if background.size else 0
    spoiled = image.copy()
    for value in references:
        count, regions = cv2.connectedComponents((image == value).astype(np.uint8))
        draws = rng.random(count)
        others = [other for other in references if other != value] or [value]
        becomes = np.where(draws < noise.missed, fill, value)
        renamed = (draws >= noise.missed) & (draws < noise.missed + noise.misnamed)
        becomes[renamed] = rng.choice(others, int(renamed.sum()))
        spoiled[regions > 0] = becomes[regions[regions > 0]]
        for _ in range(rng.binomial(count - 1, noise.invented)):
            center = tuple(int(place) for place in rng.integers(0, image.shape[0], 2))
            edges = tuple(float(edge) for edge in rng.uniform(6, 25, 2))
            corners = cv2.boxPoints((center, edges, float(rng.uniform(0, 90))))
            cv2.fillPoly(spoiled, [corners.astype(np.int32)], int(value))
    return _ragged(spoiled, noise.ragged, rng)


def _ragged(image: np.ndarray, sigma: float, rng: np.random.Generator) -> np.ndarray:
    """Edges moved to and fro by sigma pixels, smoothly along them."""
    if not sigma:
        return image
    # Blurred noise has a standard deviation of 1 / (2 √π · SMOOTH_PX).
    scale = sigma * 2 * np.sqrt(np.pi) * SMOOTH_PX
    moves = [scale * cv2.GaussianBlur(rng.standard_normal(image.shape), (0, 0), SMOOTH_PX) for _ in range(2)]
    rows, columns = np.indices(image.shape)
    rows, columns = (
        np.clip(np.rint(places + move), 0, length - 1).astype(np.int64)
        for places, move, length in zip((rows, columns), moves, image.shape)
    )
    return image[rows, columns]
