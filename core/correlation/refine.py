"""Refine a pose in map correlation to the best agreement of image and map, finer than a pixel.

See docs/explanation/method.md#map-correlation.

Gauss–Newton on Σ (map(pose) − a·image − b)² over all channels. b makes both means, a both norms equal: with a as in
a linear regression, label errors would make a small, and the pose would move to where the map is more uniform. The
optimum is that of the zero-mean normalized cross-correlation (Evangelidis & Psarakis 2008). The mean of both gradients
(Malis 2004, "ESM") converges from farther away. Four parameters: place (2), heading, logarithm of the pixel size.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from ..geometry.small_matrices import eigen
from .class_pyramid import EvidenceLevel, MapPyramid
from .compare import LEAST_KNOWN, LEAST_KNOWN_MOVED, NOT_COMPARABLE, Comparison, compare
from .outlines import joined, map_edges

LARGEST_STEP = (1.5, 1.5, 0.06, 0.06)
"""Largest Gauss–Newton step: coarse pixels right and down, radians, ln pixel size. The linearization is not valid
beyond."""

CONVERGED = 0.02
"""Refinement ends after a step below this share of a coarse pixel. Set by hand, for the time."""

DAMPING = 1e-4
"""Added to the normal equations, as a share of their trace. Parameters with less effect are undetermined: for example
the place along a straight shore that crosses the image."""

LEAST_TRUSTED = 0.1
"""Least share of the slopes' information, in each direction, that is not taken for noise, so that a covariance stays
finite. With 0.2, the radius of single images is too small. Flights use a smaller share (``FlightSettings``)."""

SCALE = 3
"""Number of the parameter of the pixel size."""


@dataclass(frozen=True)
class ScoredPose:
    """Pose of an image, from the map's upper left corner.

    Attributes:
        x: Of its center, meters right.
        y: Of its center, meters down.
        heading_deg: Of its top, clockwise from up.
        score: Correlation, −1 to 1.
    """

    x: float
    y: float
    heading_deg: float
    pixel_size_m: float
    score: float = NOT_COMPARABLE


def axes(pose: ScoredPose) -> np.ndarray:
    """Return (2, 2): meters right and down for one image pixel right and down."""
    cos, sin = np.cos(np.radians(pose.heading_deg)), np.sin(np.radians(pose.heading_deg))
    return pose.pixel_size_m * np.array([[cos, -sin], [sin, cos]])


def map_under(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose) -> tuple[np.ndarray, np.ndarray]:
    """Return the map as the image would show it from ``pose``: evidence (h, w, C), labeled share (h, w), float32.

    For an image with edges, the last two channels are the directions of the map's outlines.
    """
    height, width = image.known.shape
    to_map = axes(pose) * np.array(image.pixel)
    reach = np.abs(to_map) @ np.array([width, height]) / 2
    pixel = pose.pixel_size_m * float(np.sqrt(image.pixel[0] * image.pixel[1]))
    spare = 2 * max(pixel, pyramid.frame.pixel_size)
    box = pose.x - reach[0] - spare, pose.y - reach[1] - spare, pose.x + reach[0] + spare, pose.y + reach[1] + spare
    level, left, top = pyramid.crop(pixel, box)
    to_level = to_map / level.pixel[0]
    center = np.array([pose.x - left, pose.y - top]) / level.pixel[0] - 0.5
    offset = center - to_level @ np.array([(width - 1) / 2, (height - 1) / 2])
    matrix = np.column_stack([to_level, offset])
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    evidence = cv2.warpAffine(level.evidence, matrix, (width, height), flags=flags).reshape(height, width, -1)
    known = cv2.warpAffine(level.known, matrix, (width, height), flags=flags)
    return joined(evidence, map_edges(evidence, known)) if image.has_edges else evidence, known


def refine(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, quiet: float, steps: int) -> ScoredPose:
    """Return the best pose of a few Gauss–Newton steps, with its score.

    Args:
        quiet: Energy per pixel that is added to the map's own in the score.
    """
    best, best_fit = pose, NOT_COMPARABLE
    for step in range(steps + 1):
        found = _compared(image, pyramid, pose, quiet)
        pose, fit = replace(pose, score=found.score), found.fit
        if step == 0 or fit > best_fit:
            best, best_fit = pose, fit
        if step == steps or fit <= 0 or fit < best_fit - 0.1:
            break
        move = _move(image, found)
        if (np.abs(move) < CONVERGED * parameter_units(image)).all():
            break
        pose = move_pose(pose, move)
    return best


def is_held_by_edge(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, quiet: float) -> bool:
    """Return whether a refined pose is or would move beyond the map's edge; then the right place is farther out.

    Args:
        quiet: As in ``refine``.
    """
    patch, known = map_under(image, pyramid, pose)
    found = compare(image, patch, known, quiet)
    if found.fit > 0:
        _, known = map_under(image, pyramid, move_pose(pose, _move(image, found)))
    return float(known.mean()) < LEAST_KNOWN_MOVED


def move_pose(pose: ScoredPose, move: np.ndarray) -> ScoredPose:
    """Return a pose after a step, without a score.

    Args:
        move: (4,) right and down in image pixels, radians clockwise, ln scale.
    """
    at = np.array([[pose.x, pose.y, pose.heading_deg, pose.pixel_size_m]])
    return ScoredPose(*moved(at, move[None])[0].tolist())


def moved(at: np.ndarray, moves: np.ndarray) -> np.ndarray:
    """Return (N, 4) rows of x, y, heading and pixel size after N steps, as in ``move_pose``."""
    cos, sin = np.cos(np.radians(at[:, 2])), np.sin(np.radians(at[:, 2]))
    turned = at[:, 3, None, None] * np.array([[cos, -sin], [sin, cos]]).transpose(2, 0, 1)
    shifted = at[:, :2] + (turned @ moves[:, :2, None])[..., 0]
    headings = (at[:, 2] + np.degrees(moves[:, 2])) % 360.0
    return np.column_stack([shifted, headings, at[:, 3] * np.exp(moves[:, 3].copy())])


def score_at(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, quiet: float) -> float:
    """Return the correlation −1…1 of image and map at an unchanged pose, or NOT_COMPARABLE."""
    return _compared(image, pyramid, pose, quiet, LEAST_KNOWN).score


def pose_covariance(
    image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, quiet: float, least_trusted: float = LEAST_TRUSTED
) -> np.ndarray:
    """Return the covariance of a pose from the residuals of its fit and from the slopes that image and map share.

    Args:
        least_trusted: As for ``inverse_without_noise``.

    Returns:
        (4, 4) of x in image pixels right, y down, heading in radians and ln pixel size; infinite if the image does not
        determine the whole pose.
    """
    fit = fit_at(image, pyramid, pose, quiet)
    if fit is None:
        return np.full((4, 4), np.inf)
    (found, slopes, normal), units = fit, parameter_units(image)
    residual = found.there - found.seen
    noise = found.slopes(slopes_of(image, residual)).reshape(4, -1)
    inverse = inverse_without_noise(normal, _normal(noise), least_trusted)
    height, width = image.known.shape
    pulls = clustered_covariance(slopes * residual.ravel(), (height, width), pyramid.settings.blocks)
    return inverse @ pulls @ inverse * np.outer(units, units)


def inverse_without_noise(normal: np.ndarray, noise: np.ndarray, least_trusted: float = LEAST_TRUSTED) -> np.ndarray:
    """Return the inverse of normal equations without the noise of their slopes.

    With slopes m of the map and i of the image, the sum of (m + i)(m + i)ᵀ would grow with label errors, as if these
    were information. Without (m − i)(m − i)ᵀ, products of m and i remain, and an error of one of them averages out.

    Args:
        normal: (P, P) products of the slopes of map and image together.
        noise: (P, P) products of the slopes of their residual.
        least_trusted: Least share of the information in each direction that is not taken for noise.
    """
    damped = normal + DAMPING * max(float(np.trace(normal)), 1e-30) * np.eye(len(normal))
    strengths, vectors = eigen(damped)
    half = (vectors / np.sqrt(strengths)).T
    shares, directions = eigen(half @ noise @ half.T)
    found = half.T @ directions
    return found / np.maximum(1 - shares, least_trusted) @ found.T


def parameter_units(image: EvidenceLevel) -> np.ndarray:
    """Return the change of each parameter that moves the image's edge by one coarse pixel."""
    height, width = image.known.shape
    return np.array([image.pixel[0], image.pixel[1], 2 / width, 2 / height])


def _compared(
    image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, quiet: float, least_known: float | None = None
) -> Comparison:
    return compare(image, *map_under(image, pyramid, pose), quiet, least_known)


def slopes_of(image: EvidenceLevel, both: np.ndarray) -> np.ndarray:
    """Return (4, …, h, w · C) slopes of the fit, by the parameters in ``parameter_units``.

    Args:
        both: (…, h, w · C) sum of map and image.
    """
    (height, width), channels = image.known.shape, image.evidence.shape[2]
    slopes = np.empty((4, *both.shape), np.float32)
    gradient_x, gradient_y, by_turn, by_scale = slopes
    # Slopes by one coarse pixel, and by the turn and scale that move the middle of the edge by one.
    np.divide(gradients(both, channels), 2, out=slopes[:2])
    x = np.repeat((np.arange(width, dtype=np.float32) - (width - 1) / 2) * image.pixel[0], channels)
    y = ((np.arange(height, dtype=np.float32) - (height - 1) / 2) * image.pixel[1])[:, None]
    by_x, by_y = gradient_x / image.pixel[0], gradient_y / image.pixel[1]
    np.subtract(by_y * x, by_x * y, out=by_turn)
    np.add(by_x * x, by_y * y, out=by_scale)
    by_turn *= 2 / width
    by_scale *= 2 / height
    return slopes


def gradients(planes: np.ndarray, channels: int) -> np.ndarray:
    """Return (2, …, h, w · C) float32 central differences to the right and down; 0 at the ends, where they are unknown.

    Args:
        planes: (…, h, w · C).
        channels: C.
    """
    found = np.zeros((2, *planes.shape), np.float32)
    np.subtract(planes[..., 2 * channels :], planes[..., : -2 * channels], out=found[0][..., channels:-channels])
    np.subtract(planes[..., 2:, :], planes[..., :-2, :], out=found[1][..., 1:-1, :])
    found /= 2
    return found


def fit_at(
    image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, quiet: float
) -> tuple[Comparison, np.ndarray, np.ndarray] | None:
    """Return a pose's comparison, (4, h·w·C) slopes and (4, 4) normal equations; None if the pose is undetermined."""
    found = _compared(image, pyramid, pose, quiet)
    if found.fit <= 0:
        return None
    slopes = _slopes(image, found)
    normal = _normal(slopes)
    strengths, _ = eigen(normal)
    return None if strengths[-1] <= DAMPING * strengths.sum() else (found, slopes, normal)


def _slopes(image: EvidenceLevel, found: Comparison) -> np.ndarray:
    """Return (4, h·w·C) slopes of a pose with a positive fit."""
    return found.slopes(slopes_of(image, found.there + found.seen)).reshape(4, -1)


def _normal(slopes: np.ndarray) -> np.ndarray:
    """Return (4, 4) products of slopes (4, N): the normal equations."""
    # OpenCV's product and inverse: BLAS and LAPACK would start threads that keep spinning.
    return cv2.mulTransposed(slopes, False, dtype=cv2.CV_64F)


def damped_inverse(normal: np.ndarray) -> np.ndarray:
    """Return the (4, 4) inverse of normal equations, slightly damped."""
    damped = DAMPING * max(float(np.trace(normal)), 1e-30)
    return cv2.invert(normal + damped * np.eye(4), flags=cv2.DECOMP_CHOLESKY)[1]


def _move(image: EvidenceLevel, found: Comparison) -> np.ndarray:
    """Return the (4,) Gauss–Newton step: x, y in image pixels, radians, ln scale."""
    slopes = _slopes(image, found)
    descent = np.einsum("ik,k->i", slopes, (found.there - found.seen).ravel()).astype(np.float64)
    limit = np.array(LARGEST_STEP) * np.array([*image.pixel, 1, 1])
    return np.clip(-(damped_inverse(_normal(slopes)) @ descent) * parameter_units(image), -limit, limit)


def clustered_covariance(pulls: np.ndarray, shape_hw: tuple[int, int], blocks: int) -> np.ndarray:
    """Return the (P, P) covariance of the sum of all pixels' gradients (P, h·w·C) with correlated neighbors.

    Gradients are summed in blocks × blocks parts of the image, which count as independent (cluster-robust "sandwich"
    covariance, Liang & Zeger 1986): a patch of a wrong class is one error, not a thousand.
    """
    sums = block_sums(pulls, shape_hw, blocks).reshape(len(pulls), -1)
    sums = sums - sums.mean(axis=1, keepdims=True)
    return np.einsum("ik,jk->ij", sums, sums)


def block_sums(values: np.ndarray, shape_hw: tuple[int, int], blocks: int) -> np.ndarray:
    """Return (P, at most blocks, at most blocks) sums of (P, h·w·C) values in blocks × blocks parts of the image."""
    height, width = shape_hw
    rows, columns = (np.linspace(0, edge, min(blocks, edge), endpoint=False).astype(int) for edge in (height, width))
    sums = values.reshape(len(values), height, width, -1).sum(axis=3)
    return np.add.reduceat(np.add.reduceat(sums, rows, axis=1), columns, axis=2)
