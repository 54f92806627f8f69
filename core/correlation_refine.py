"""Map correlation's second look: a pose moved to where image and map agree best, finer than a pixel (DESIGN §3).

Gauss–Newton on Σ (map(pose) − a·image − b)² over all channels, a and b free: the same optimum as the zero-mean
normalised cross-correlation (Evangelidis & Psarakis 2008), with the mean of both gradients (Malis 2004, "ESM") for a
wider pull. Four parameters: place (2), heading, logarithm of the pixel size.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Tuple

import cv2
import numpy as np

from .class_pyramid import EvidenceLevel, MapPyramid
from .correlation_search import LEAST_KNOWN

LARGEST_STEP = np.array([1.5, 1.5, 0.06, 0.06])
"""Bound of one Gauss–Newton step: coarse pixels, radians, logarithm; beyond it the linearisation holds no more."""

BLOCKS = 10
"""Blocks along each edge of the image that are taken to err independently (covariance)."""


@dataclass(frozen=True)
class Pose:
    """Where an image lies: its centre in metres right (x) and down (y) of the map's corner, heading of its top in
    degrees clockwise from up, ground sampling distance in metres; score −1…1.
    """

    x: float
    y: float
    heading_deg: float
    pixel_size_m: float
    score: float = -1.0


def axes(pose: Pose) -> np.ndarray:
    """(2, 2): metres right and down a step of one image pixel right and down makes."""
    cos, sin = np.cos(np.radians(pose.heading_deg)), np.sin(np.radians(pose.heading_deg))
    return pose.pixel_size_m * np.array([[cos, -sin], [sin, cos]])


def map_under(image: EvidenceLevel, pyramid: MapPyramid, pose: Pose) -> Tuple[np.ndarray, np.ndarray]:
    """The map as the image would see it from ``pose``: evidence (h, w, C) and labelled share (h, w), float32."""
    height, width = image.known.shape
    to_map = axes(pose) * np.array(image.pixel)
    reach = np.abs(to_map) @ np.array([width, height]) / 2
    pixel = pose.pixel_size_m * float(np.sqrt(image.pixel[0] * image.pixel[1]))
    spare = 2 * max(pixel, pyramid.frame[2])
    box = pose.x - reach[0] - spare, pose.y - reach[1] - spare, pose.x + reach[0] + spare, pose.y + reach[1] + spare
    level, left, top = pyramid.crop(pixel, box)
    to_level = to_map / level.pixel[0]
    center = np.array([pose.x - left, pose.y - top]) / level.pixel[0] - 0.5
    offset = center - to_level @ np.array([(width - 1) / 2, (height - 1) / 2])
    matrix = np.column_stack([to_level, offset])
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    evidence = cv2.warpAffine(level.evidence, matrix, (width, height), flags=flags).reshape(height, width, -1)
    return evidence, cv2.warpAffine(level.known, matrix, (width, height), flags=flags)


def refine(image: EvidenceLevel, pyramid: MapPyramid, pose: Pose, quiet: float, steps: int) -> Tuple[Pose, np.ndarray]:
    """The best pose of ``steps`` Gauss–Newton steps from ``pose``, with its score, and its (4, 4) covariance.

    ``quiet``: energy a pixel added to the map's own in the score. Covariance of (x in image pixels right, y down,
    heading in radians, ln pixel size); to be calibrated.
    """
    best, covariance = pose, np.full((4, 4), np.inf)
    for step in range(steps + 1):
        patch, known = map_under(image, pyramid, pose)
        score, move, spread = _gauss_newton(image, patch, known, quiet)
        pose = Pose(pose.x, pose.y, pose.heading_deg, pose.pixel_size_m, score)
        if step == 0 or score > best.score:
            best, covariance = pose, spread
        if step == steps or move is None or score < best.score - 0.1:
            break
        shift = axes(pose) @ move[:2]
        pose = Pose(
            pose.x + shift[0],
            pose.y + shift[1],
            (pose.heading_deg + float(np.degrees(move[2]))) % 360.0,
            pose.pixel_size_m * float(np.exp(move[3])),
        )
    return best, covariance


def _gauss_newton(image: EvidenceLevel, patch: np.ndarray, known: np.ndarray, quiet: float):
    """Score, next move (x, y in image pixels, radians, ln scale) or None, covariance (4, 4)."""
    nowhere = np.full((4, 4), np.inf)
    if known.mean() < LEAST_KNOWN:
        return -1.0, None, nowhere
    seen = image.evidence - image.evidence.mean(axis=(0, 1))
    there = patch - patch.mean(axis=(0, 1))
    norm, energy = float((seen**2).sum()), float((there**2).sum())
    if norm <= 0 or energy <= 0:
        return -1.0, None, nowhere
    product = float((seen * there).sum())
    score = product / np.sqrt(norm * (energy + quiet * known.size))
    gain = product / norm
    if gain <= 0:
        return score, None, nowhere
    gradient_x = _difference(there + gain * seen, 1) / (2 * image.pixel[0])
    gradient_y = _difference(there + gain * seen, 0) / (2 * image.pixel[1])
    height, width = known.shape
    x = ((np.arange(width, dtype=np.float32) - (width - 1) / 2) * image.pixel[0])[None, :, None]
    y = ((np.arange(height, dtype=np.float32) - (height - 1) / 2) * image.pixel[1])[:, None, None]
    slopes = np.stack(
        [gradient_x, gradient_y, gradient_y * x - gradient_x * y, gradient_x * x + gradient_y * y]
    ).reshape(4, -1)
    residual = (there - gain * seen).ravel()
    # Parameters differ by orders of magnitude: solve in units of one coarse pixel at the image's edge.
    units = np.array([image.pixel[0], image.pixel[1], 2 / width, 2 / height])
    slopes = slopes.astype(np.float64) * units[:, None]
    # einsum: BLAS would start threads for this and let them spin.
    normal = np.einsum("ik,jk->ij", slopes, slopes)
    trace = float(np.trace(normal))
    if trace <= 0:
        return score, None, nowhere
    # OpenCV's: LAPACK would start threads for a 4 × 4 matrix.
    inverse = cv2.invert(normal + 1e-4 * trace * np.eye(4), flags=cv2.DECOMP_CHOLESKY)[1]
    limit = LARGEST_STEP * np.array([*image.pixel, 1, 1])
    move = np.clip(-(inverse @ np.einsum("ik,k->i", slopes, residual)) * units, -limit, limit)
    covariance = inverse @ _clustered(slopes * residual, patch.shape) @ inverse * np.outer(units, units)
    return score, move, covariance


def _clustered(pulls: np.ndarray, shape) -> np.ndarray:
    """(4, 4) covariance of the sum of all pixels' pulls (4, h·w·C), whose neighbours err together.

    Pulls are summed in BLOCKS × BLOCKS blocks of the image, which are taken as independent (cluster-robust "sandwich"
    covariance, Liang & Zeger 1986): a patch of a wrong class counts as one error, not as a thousand.
    """
    height, width, _ = shape
    rows, columns = (np.linspace(0, edge, min(BLOCKS, edge), endpoint=False).astype(int) for edge in (height, width))
    sums = pulls.reshape(4, *shape).sum(axis=3)
    sums = np.add.reduceat(np.add.reduceat(sums, rows, axis=1), columns, axis=2).reshape(4, -1)
    sums = sums - sums.mean(axis=1, keepdims=True)
    return np.einsum("ik,jk->ij", sums, sums)


def _difference(planes: np.ndarray, axis: int) -> np.ndarray:
    """Central differences along an axis, 0 at the two ends (where the image stops, its slope is unknown)."""
    slope = np.zeros_like(planes)
    inner = [slice(None)] * planes.ndim
    after, before = list(inner), list(inner)
    inner[axis], after[axis], before[axis] = slice(1, -1), slice(2, None), slice(None, -2)
    slope[tuple(inner)] = (planes[tuple(after)] - planes[tuple(before)]) / 2
    return slope
