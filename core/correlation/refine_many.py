"""Refine many poses of one image at once, in the search.

All poses are in one array: at the few pixels of a first look, calls would take longer than arithmetic. The Gauss–Newton
steps are those of ``refine``, but unknown ground counts as average ground, and linear regression scales the image. The
curve of the error probability was fitted with these steps. With those of ``refine``, chance would match better on small
maps.
"""

from __future__ import annotations

import cv2
import numpy as np

from .. import limits
from .class_pyramid import EvidenceLevel, MapPyramid, centered
from .compare import LEAST_KNOWN_MOVED, NOT_COMPARABLE
from .refine import (
    DAMPING,
    LARGEST_STEP,
    ScoredPose,
    map_under,
    moved,
    parameter_units,
    slopes_of,
)


def refine_many(
    image: EvidenceLevel, pyramid: MapPyramid, poses: list[ScoredPose], quiet: float, steps: int
) -> list[ScoredPose]:
    """Return the best pose of ``steps`` Gauss–Newton steps from each of N poses, with its score, in the given order.

    Args:
        image: Evidence at coarse pixels.
        quiet: Energy per pixel that is added to the map's own in the score.
    """
    if not poses:
        return []
    # Rows of x, y, heading in degrees and pixel size, as in a pose.
    at = np.array([(pose.x, pose.y, pose.heading_deg, pose.pixel_size_m) for pose in poses])
    best, best_scores = at.copy(), np.full(len(at), NOT_COMPARABLE)
    for step in range(steps + 1):
        patches, known = _maps_under(image, pyramid, at)
        scores, gains, there = _score(image.centered, patches, known, quiet)
        is_better = scores > best_scores
        best[is_better], best_scores[is_better] = at[is_better], scores[is_better]
        if step < steps:
            at = moved(at, _moves(image, there, np.maximum(gains, 0)))
    return [ScoredPose(*row) for row in np.column_stack([best, best_scores]).tolist()]


def _maps_under(image: EvidenceLevel, pyramid: MapPyramid, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the map as the image would show it from each pose: evidence (N, h, w, C), labeled share (N, h, w)."""
    height, width = image.known.shape
    patches = np.empty((len(at), *image.evidence.shape), np.float32)
    known = np.empty((len(at), height, width), np.float32)
    pixel = float(np.sqrt(image.pixel[0] * image.pixel[1]))
    levels = pyramid.levels_of(at[:, 3] * pixel)
    for number in np.unique(levels):
        chosen = np.flatnonzero(levels == number)
        level = pyramid.whole(int(number))
        if level is None or max(level.known.shape) > limits.WARPED_EDGE_PX:
            for n in chosen:
                patches[n], known[n] = map_under(image, pyramid, ScoredPose(*at[n]))
            continue
        for part in np.array_split(chosen, -(-len(chosen) * height // limits.WARPED_EDGE_PX)):
            columns, rows = _places(image, at[part], level.pixel[0])
            found = cv2.remap(level.evidence, columns, rows, cv2.INTER_LINEAR)
            patches[part] = found.reshape(len(part), height, width, -1)
            known[part] = cv2.remap(level.known, columns, rows, cv2.INTER_LINEAR).reshape(len(part), height, width)
    return patches, known


def _places(image: EvidenceLevel, at: np.ndarray, level_pixel_m: float) -> tuple[np.ndarray, np.ndarray]:
    """Return columns and rows, (n · h, w) float32, in a map's level for the image's pixels at n poses."""
    height, width = image.known.shape
    right = (np.arange(width) - (width - 1) / 2) * image.pixel[0]
    down = ((np.arange(height) - (height - 1) / 2) * image.pixel[1])[:, None]
    x, y, heading, size = (column[:, None, None] for column in at.T)
    cos, sin = size * np.cos(np.radians(heading)), size * np.sin(np.radians(heading))
    columns, rows = (x + cos * right) - sin * down, (y + sin * right) + cos * down
    for places in (columns, rows):
        places /= level_pixel_m
        places -= 0.5
    return columns.reshape(-1, width).astype(np.float32), rows.reshape(-1, width).astype(np.float32)


def _score(
    seen: np.ndarray, patches: np.ndarray, known: np.ndarray, quiet: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return (N,) scores, (N,) gains of the image in the map, and the map (N, h, w · C) without its means."""
    there = centered(patches)
    norm = max(float((seen**2).sum()), 1e-30)
    energy = np.einsum("nhk,nhk->n", there, there)
    product = np.einsum("nhk,hk->n", there, seen)
    scores = product / np.sqrt(norm * np.maximum(energy + quiet * known[0].size, 1e-6))
    usable = (known.mean(axis=(1, 2)) >= LEAST_KNOWN_MOVED) & (energy > 0)
    return np.where(usable, scores, NOT_COMPARABLE), product / norm, there


def _moves(image: EvidenceLevel, there: np.ndarray, gains: np.ndarray) -> np.ndarray:
    """Return (N, 4) Gauss–Newton steps: x, y in image pixels, radians, ln pixel size."""
    model = gains[:, None, None].astype(np.float32) * image.centered
    count = len(there)
    flat, residual = slopes_of(image, there + model).reshape(4, count, -1), (there - model).reshape(count, -1)
    normal = np.empty((count, 4, 4))
    for row in range(4):
        for column in range(row + 1):
            normal[:, row, column] = normal[:, column, row] = np.einsum("nk,nk->n", flat[row], flat[column])
    pull = np.stack([np.einsum("nk,nk->n", slope, residual) for slope in flat], axis=1)
    damped = DAMPING * np.maximum(np.trace(normal, axis1=1, axis2=2), 1e-30)
    steps = np.linalg.solve(normal + damped[:, None, None] * np.eye(4), pull[..., None].astype(float))[..., 0]
    limit = np.array(LARGEST_STEP) * np.array([*image.pixel, 1, 1])
    return np.clip(-steps * parameter_units(image), -limit, limit)
