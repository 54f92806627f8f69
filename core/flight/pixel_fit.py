"""Fit the mapping between two pictures to matched places: a similarity, or a homography for tilted images.

The covariance follows from the residuals. Lenses, relief and boundaries cause errors that neighbors share, so residuals
are also summed by blocks.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import cv2
import numpy as np

Mapping = Callable[[np.ndarray], np.ndarray]
"""(N, 2) points of the second picture → (N, 2) of the first, both from the picture's center, right and down."""

Model = Callable[[np.ndarray, np.ndarray], np.ndarray]
"""(K,) parameters and (N, 2) points → (N, 2) points. From (K, M, 1) parameters of M mappings → (M, N, 2)."""

TILT_LENGTH_PX = 320.0
"""Distance from the center to which the tilt parameters refer, so that all parameters have a similar size."""

LEAST_FOR_TILT = 24
TILT_GAIN = 8.0
"""A homography needs at least ``LEAST_FOR_TILT`` places, and its four extra parameters must reduce the mean square by
this factor of what remains."""

STARTS_WITHIN_PX = 4.0
ROUNDS = 8
BLOCK_PX = 96.0
LEAST_SPREAD_PX = 0.1

SPREAD_FACTOR = 1.0
FLOOR = (0.15, 0.15, 0.0005, 0.0005)
"""Least standard deviations of a link: working pixels right and down, radians, log scale."""


def similarity(parameters: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return (N, 2) points after rotation and scaling (x + iy times the first two parameters) and shift."""
    right, down, dx, dy = parameters
    x, y = points.T
    return np.stack([right * x - down * y + dx, down * x + right * y + dy], axis=-1)


def homography(parameters: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return (N, 2) points in perspective: two linear forms with constants, divided by the depth."""
    a, b, dx, c, d, dy, right, down = parameters
    x, y = points.T
    depth = 1 + (right * x + down * y) / TILT_LENGTH_PX
    return np.stack([a * x + b * y + dx, c * x + d * y + dy], axis=-1) / depth[..., None]


@dataclass(frozen=True)
class Fitted:
    """A mapping fitted to places.

    Attributes:
        model: ``similarity`` or ``homography``.
        parameters: (K,) of it.
        covariance: (K, K) of the parameters.
        is_used: (N,) bool: places that agree with it.
    """

    model: Model
    parameters: np.ndarray
    covariance: np.ndarray
    is_used: np.ndarray

    @property
    def mapping(self) -> Mapping:
        """The model with the fitted parameters."""
        return partial(self.model, self.parameters)

    def pose(self) -> tuple[np.ndarray, np.ndarray]:
        """Return (4,) right, down, turn and log scale about the second picture's center, and their covariance."""
        steps = _derivatives(lambda parameters: pose_of(partial(self.model, parameters)), self.parameters)
        known = steps @ self.covariance @ steps.T
        return pose_of(self.mapping), SPREAD_FACTOR**2 * known + np.diag(np.square(FLOOR))


def pose_of(mapping: Mapping) -> np.ndarray:
    """Return (4,): place of the second picture's center, and turn and log scale there (nearest similarity).

    A mapping of M parameters at once gives (M, 4).
    """
    points = mapping(np.array([[0.0, 0], [-1, 0], [1, 0], [0, -1], [0, 1]]))
    center, west, east, north, south = np.moveaxis(points, -2, 0)
    across, along = (east - west) / 2, (south - north) / 2
    right, down = (across[..., 0] + along[..., 1]) / 2, (across[..., 1] - along[..., 0]) / 2
    turn, log_scale = np.arctan2(down, right), np.log(np.maximum(np.hypot(right, down), 1e-9))
    return np.concatenate([center, np.stack([turn, log_scale], axis=-1)], axis=-1)


def fit_mapping(second: np.ndarray, first: np.ndarray, within: float) -> Fitted | None:
    """Return the mapping that most places agree with; None if no similarity agrees with four of them.

    Args:
        second: (N, 2) places in the second picture.
        first: (N, 2) the same places in the first one.
        within: Largest residual of a place that agrees, pixels.
    """
    matrix, is_near = cv2.estimateAffinePartial2D(
        second, first, method=cv2.RANSAC, ransacReprojThreshold=STARTS_WITHIN_PX, maxIters=500, confidence=0.999
    )
    if matrix is None or int(is_near.sum()) < 4:
        return None
    start = np.array([matrix[0, 0], matrix[1, 0], matrix[0, 2], matrix[1, 2]])
    found, is_used = _robust(similarity, start, second, first, within)
    model: Model = similarity
    if len(second) >= LEAST_FOR_TILT:
        right, down, dx, dy = found
        level = np.array([right, -down, dx, down, right, dy, 0.0, 0.0])
        tilted, is_used_tilted = _robust(homography, level, second, first, within)
        chosen = is_used | is_used_tilted
        rests = [
            np.minimum(np.square(first - mapped).sum(axis=1), within**2)[chosen].sum()
            for mapped in (similarity(found, second), homography(tilted, second))
        ]
        if _is_tilted(rests[0], rests[1], int(chosen.sum())):
            model, found, is_used = homography, tilted, is_used_tilted
    if 2 * int(is_used.sum()) <= len(found):
        return None
    return Fitted(model, found, _covariance(model, found, second[is_used], first[is_used]), is_used)


def _is_tilted(level: float, tilted: float, count: int) -> bool:
    """Return whether the four tilt parameters reduce the sum of squares more than noise would."""
    left = max(tilted / max(2 * count - 8, 1), LEAST_SPREAD_PX**2)
    return (level - tilted) / 4 > TILT_GAIN * left


def _robust(
    model: Model, start: np.ndarray, second: np.ndarray, first: np.ndarray, within: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return (K,) parameters from weighted least squares (far places weigh less), and the places that agree."""
    found = start
    for _ in range(ROUNDS):
        rest = first - model(found, second)
        off = np.hypot(*rest.T)
        spread = max(
            1.4826 * float(np.median(off[off < 2 * STARTS_WITHIN_PX])) if (off < 8).any() else 1.0, LEAST_SPREAD_PX
        )
        weights = np.sqrt(1 / (1 + np.square(off / (2 * spread)))) * (off < 3 * max(within, spread))
        steps = _derivatives(lambda parameters: model(parameters, second), found)
        twice = np.repeat(weights, 2)
        change, *_ = np.linalg.lstsq(steps * twice[:, None], rest.ravel() * twice, rcond=None)
        found = found + change
        if np.abs(change).max() < 1e-6:
            break
    return found, np.hypot(*(first - model(found, second)).T) < within


def _derivatives(function: Callable[[np.ndarray], np.ndarray], at: np.ndarray) -> np.ndarray:
    """Return (M, K) derivatives of all values of a function of (K,) parameters, by central differences.

    Args:
        function: From (K, K, 1) parameters, one set of them in each column.
        at: (K,) parameters.
    """
    step = 1e-5
    moves = step * np.eye(len(at))
    ahead, behind = (function((at + move).T[..., None]) for move in (moves, -moves))
    return np.ascontiguousarray(((ahead - behind) / (2 * step)).reshape(len(at), -1).T)


def _covariance(model: Model, found: np.ndarray, second: np.ndarray, first: np.ndarray) -> np.ndarray:
    """Return (K, K) of the parameters: from single residuals, enlarged by the ratio that sums over blocks show."""
    rest = (first - model(found, second)).ravel()
    steps = _derivatives(lambda parameters: model(parameters, second), found)
    freedom = max(len(rest) - len(found), 1)
    inverse = np.linalg.pinv(steps.T @ steps)
    single = inverse * max(float(rest @ rest) / freedom, LEAST_SPREAD_PX**2)
    blocks = np.unique(np.floor(first / BLOCK_PX).astype(np.int64), axis=0, return_inverse=True)[1].ravel()
    count = int(blocks.max()) + 1
    if count <= len(found) // 2:
        return single
    sums = np.zeros((count, len(found)))
    np.add.at(sums, np.repeat(blocks, 2), steps * rest[:, None])
    together = inverse @ (sums.T @ sums) @ inverse * (count / (count - 1))
    larger = float(np.trace(np.linalg.pinv(single) @ together)) / len(found)
    return single * max(larger, 1.0)
