"""``refine`` for many poses of one image at once.

The Gauss–Newton steps are the same, with all poses in one array: at the few pixels of a first look, calls would take
longer than arithmetic.
"""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np

from .. import limits
from .class_pyramid import EvidenceLevel, MapPyramid
from .refine import (
    DAMPING,
    LARGEST_STEP,
    LEAST_KNOWN_MOVED,
    NOT_COMPARABLE,
    ScoredPose,
    difference,
    map_under,
    move_pose,
    parameter_units,
)


def refine_many(
    image: EvidenceLevel, pyramid: MapPyramid, poses: list[ScoredPose], quiet: float, steps: int
) -> list[ScoredPose]:
    """Return the best pose of ``steps`` Gauss–Newton steps from each of N poses, with its score, in the given order.

    Args:
        image: Evidence at coarse pixels.
        poses: Start poses.
        quiet: Energy per pixel that is added to the map's own in the score.
        steps: Steps of each pose.
    """
    best = [replace(pose, score=NOT_COMPARABLE) for pose in poses]
    if not poses:
        return best
    seen = image.evidence - image.evidence.mean(axis=(0, 1))
    for step in range(steps + 1):
        patches, known = _maps_under(image, pyramid, poses)
        scores, gains, there = _score(seen, patches, known, quiet)
        poses = [replace(pose, score=float(score)) for pose, score in zip(poses, scores)]
        best = [pose if pose.score > kept.score else kept for pose, kept in zip(poses, best)]
        if step < steps:
            moves = _moves(image, seen, there, np.maximum(gains, 0))
            poses = [move_pose(pose, move) for pose, move in zip(poses, moves)]
    return best


def _maps_under(image: EvidenceLevel, pyramid: MapPyramid, poses: list[ScoredPose]) -> tuple[np.ndarray, np.ndarray]:
    """Return the map as the image would show it from each pose: evidence (N, h, w, C), labeled share (N, h, w)."""
    height, width = image.known.shape
    patches = np.empty((len(poses), *image.evidence.shape), np.float32)
    known = np.empty((len(poses), height, width), np.float32)
    pixel = float(np.sqrt(image.pixel[0] * image.pixel[1]))
    levels = np.array([pyramid.level_of(pose.pixel_size_m * pixel) for pose in poses])
    for number in np.unique(levels):
        chosen = np.flatnonzero(levels == number)
        level = pyramid.stored(int(number))
        if level is None or max(level.known.shape) > limits.WARPED_EDGE_PX:
            for n in chosen:
                patches[n], known[n] = map_under(image, pyramid, poses[n])
            continue
        for part in np.array_split(chosen, -(-len(chosen) * height // limits.WARPED_EDGE_PX)):
            columns, rows = _places(image, [poses[n] for n in part], level.pixel[0])
            found = cv2.remap(level.evidence, columns, rows, cv2.INTER_LINEAR)
            patches[part] = found.reshape(len(part), height, width, -1)
            known[part] = cv2.remap(level.known, columns, rows, cv2.INTER_LINEAR).reshape(len(part), height, width)
    return patches, known


def _places(image: EvidenceLevel, poses: list[ScoredPose], level_pixel_m: float) -> tuple[np.ndarray, np.ndarray]:
    """Return columns and rows, (n · h, w) float32, in a map's level for the image's pixels at n poses."""
    height, width = image.known.shape
    right = ((np.arange(width) - (width - 1) / 2) * image.pixel[0])[None, None, :]
    down = ((np.arange(height) - (height - 1) / 2) * image.pixel[1])[None, :, None]
    x, y, heading, size = np.array([(p.x, p.y, np.radians(p.heading_deg), p.pixel_size_m) for p in poses]).T
    cos, sin = (size * np.cos(heading))[:, None, None], (size * np.sin(heading))[:, None, None]
    columns = (x[:, None, None] + cos * right - sin * down) / level_pixel_m - 0.5
    rows = (y[:, None, None] + sin * right + cos * down) / level_pixel_m - 0.5
    return columns.reshape(-1, width).astype(np.float32), rows.reshape(-1, width).astype(np.float32)


def _score(
    seen: np.ndarray, patches: np.ndarray, known: np.ndarray, quiet: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return (N,) scores, (N,) gains of the image in the map, and the map (N, h, w, C) without its means."""
    there = patches - patches.mean(axis=(1, 2), keepdims=True)
    norm = max(float((seen**2).sum()), 1e-30)
    energy = np.einsum("nhwc,nhwc->n", there, there)
    product = np.einsum("nhwc,hwc->n", there, seen)
    scores = product / np.sqrt(norm * np.maximum(energy + quiet * known[0].size, 1e-30))
    usable = (known.mean(axis=(1, 2)) >= LEAST_KNOWN_MOVED) & (energy > 0)
    return np.where(usable, scores, NOT_COMPARABLE), product / norm, there


def _moves(image: EvidenceLevel, seen: np.ndarray, there: np.ndarray, gains: np.ndarray) -> np.ndarray:
    """Return (N, 4) Gauss–Newton steps: x, y in image pixels, radians, ln pixel size."""
    count, height, width, _ = there.shape
    model = gains[:, None, None, None].astype(np.float32) * seen
    both = (there + model) / 2
    by_column, by_row = difference(both, 2), difference(both, 1)
    x = ((np.arange(width, dtype=np.float32) - (width - 1) / 2) * image.pixel[0])[None, None, :, None]
    y = ((np.arange(height, dtype=np.float32) - (height - 1) / 2) * image.pixel[1])[None, :, None, None]
    by_x, by_y = by_column / image.pixel[0], by_row / image.pixel[1]
    slopes = [by_column, by_row, (by_y * x - by_x * y) * (2 / width), (by_x * x + by_y * y) * (2 / height)]
    flat = [slope.reshape(count, -1) for slope in slopes]
    residual = (there - model).reshape(count, -1)
    normal = np.empty((count, 4, 4))
    for row in range(4):
        for column in range(row + 1):
            normal[:, row, column] = normal[:, column, row] = np.einsum("nk,nk->n", flat[row], flat[column])
    pull = np.stack([np.einsum("nk,nk->n", slope, residual) for slope in flat], axis=1)
    damped = DAMPING * np.maximum(np.trace(normal, axis1=1, axis2=2), 1e-30)
    steps = np.linalg.solve(normal + damped[:, None, None] * np.eye(4), pull[..., None].astype(float))[..., 0]
    limit = np.array(LARGEST_STEP) * np.array([*image.pixel, 1, 1])
    return np.clip(-steps * parameter_units(image), -limit, limit)
