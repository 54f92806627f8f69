"""Effect of lens distortion and camera tilt on a place that was found by areas without them.

See docs/explanation/method.md#position-error. Both displace the content of an image increasingly outwards, so that the
best level pose is beside the true one. A Gauss–Newton system like that of ``refine_many``, with five more unknowns,
measures them in the whole image: common ground alone can leave them undetermined. Their prior is the mixture of
cameras that landmarks use, too (``ErrorSettings.views``).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from ..geometry.error_settings import SharedErrors
from ..geometry.pose import SLOPE_DEVIATION, STRETCH_DEVIATION
from ..geometry.small_matrices import eigen, inverse_of
from .class_pyramid import EvidenceLevel, MapPyramid
from .compare import LEAST_KNOWN_MOVED, NOT_COMPARABLE
from .refine import (
    DAMPING,
    ScoredPose,
    axes,
    clustered_covariance,
    gradients,
    inverse_without_noise,
)

POSE, COUNT = 4, 9
"""Parameters of a level pose (right, down, heading, ln pixel size; the unit of the first two is half a diagonal), and
parameters with the effects."""

STEPS = 3
"""Gauss–Newton steps; two determine a tilt of 10° to a twentieth."""

WORSE = 0.02
"""A step that lowers the score by more is rejected."""

LEAST = 1e-6
"""Least standard deviation of a measured parameter: even a map compared with itself is not more accurate."""

SAMPLES = 7
"""Places along an edge of an image that show the effect of a displaced map."""

_UNITS = np.array([1.0, STRETCH_DEVIATION, STRETCH_DEVIATION, SLOPE_DEVIATION, SLOPE_DEVIATION])
"""Units of lens, stretch and slope of a tilt, two numbers each, for the standard deviations of views."""


@dataclass(frozen=True)
class ViewEffect:
    """Error of a level pose.

    Attributes:
        shift: (4,) mean, in image pixels right and down, heading in radians and ln pixel size.
        covariance: (4, 4) that the possible cameras add to that of the pose.
    """

    shift: np.ndarray
    covariance: np.ndarray

    def correct(self, pose: ScoredPose) -> ScoredPose:
        """Return the pose without the mean effect."""
        x, y = axes(pose) @ self.shift[:2]
        heading = (pose.heading_deg + float(np.degrees(self.shift[2]))) % 360.0
        size = pose.pixel_size_m * float(np.exp(self.shift[3]))
        return replace(pose, x=pose.x + x, y=pose.y + y, heading_deg=heading, pixel_size_m=size)


def view_effect(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, errors: SharedErrors) -> ViewEffect | None:
    """Return the error of a level pose from the lens and tilt that the image shows.

    Args:
        image: Its evidence at the decision's pixels.
        pose: The best level pose.
        errors: Of the map, with the possible cameras (``ErrorSettings.views``); the first camera has no effect.

    Returns:
        None if the image does not determine the whole pose.
    """
    system, views = _System(image, pyramid, pose), errors.settings.views
    of_map = system.of_map(errors)
    known = np.zeros(COUNT)
    deviations = np.array([_deviations(view) for view in views])
    loosest = np.zeros((COUNT, COUNT))
    loosest[range(POSE, COUNT), range(POSE, COUNT)] = deviations.max(axis=0) ** -2.0
    best, measured = NOT_COMPARABLE, None
    for _ in range(STEPS):
        found = system.fit(known, of_map)
        if found is None or found.score < best - WORSE:
            break
        best = max(best, found.score)
        measured = found
        information = inverse_of(found.covariance)
        known = inverse_of(information + loosest) @ (information @ found.mean)
    if measured is None:
        return None
    shift, spread = _mixture(measured, deviations, np.array([view[2] for view in views]))
    units = np.array([system.half, system.half, 1.0, 1.0])
    return ViewEffect(shift * units, spread * np.outer(units, units))


def _deviations(view: tuple[float, float, float]) -> np.ndarray:
    lens, tilt, _ = view
    return np.array([lens, *[tilt] * 4]) * _UNITS


def _mixture(measured: _SystemFit, deviations: np.ndarray, shares: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return shift (4,) of the pose and its added covariance (4, 4), against a camera without effect.

    Args:
        measured: Pose and effects.
        deviations: (K, 5) of the effects, for each possible camera; the first one has no effect.
        shares: (K,) of the cameras.
    """
    own, seen, to_pose = measured.covariance[POSE:, POSE:], measured.mean[POSE:], measured.to_pose
    shifts: list[np.ndarray] = []
    spreads: list[np.ndarray] = []
    likely: list[float] = []
    for deviation, share in zip(deviations, shares):
        both = inverse_of(own + np.diag(deviation**2))
        # Posterior of the measured effects and their covariance; the pose follows them.
        left = deviation**2 * (both @ seen)
        spread = np.diag(deviation**2) - np.diag(deviation**2) @ both @ np.diag(deviation**2)
        moved = measured.mean[:POSE] + to_pose @ (left - seen)
        shifts.append(moved if shifts else np.zeros(POSE))
        spreads.append(to_pose @ spread @ to_pose.T)
        likely.append(float(np.log(share) + 0.5 * (np.linalg.slogdet(both)[1] - seen @ both @ seen)))
    weights: np.ndarray = np.exp(np.array(likely) - max(likely))
    weights /= weights.sum()
    shift = weights @ np.array(shifts)
    apart = np.array(shifts) - shift
    return shift, np.tensordot(weights, np.array(spreads), 1) + np.einsum("k,ki,kj->ij", weights, apart, apart)


@dataclass(frozen=True)
class _SystemFit:
    """Fit of pose and effects, in units of ``_System``.

    Attributes:
        score: Correlation at the assumed values.
        mean: (9,).
        covariance: (9, 9).
        to_pose: (4, 5) change of the pose with the effects.
    """

    score: float
    mean: np.ndarray
    covariance: np.ndarray
    to_pose: np.ndarray


class _System:
    """The fit of an image to the map around a pose, with lens and tilt as unknowns."""

    def __init__(self, image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose) -> None:
        self._image, self._pyramid, self._pose = image, pyramid, pose
        height, width = image.known.shape
        self.half = float(np.hypot(height * image.pixel[1], width * image.pixel[0])) / 2
        x = (np.arange(width) - (width - 1) / 2) * image.pixel[0] / self.half
        y = (np.arange(height) - (height - 1) / 2) * image.pixel[1] / self.half
        # Complex numbers with the imaginary part down, like image pixels.
        self._points = u = x[None, :] + 1j * y[:, None]
        ones = np.ones_like(u)
        tilt = [u.conj(), 1j * u.conj(), -u * u.real, -u * u.imag]
        self._moves = np.stack([ones, 1j * ones, 1j * u, u, u * np.abs(u) ** 2, *tilt])
        self._seen = image.evidence - image.evidence.mean(axis=(0, 1))

    def of_map(self, errors: SharedErrors) -> np.ndarray:
        """Return the (9, 9) covariance of the apparent effects of a displaced map with correlated neighbors."""
        height, width = self._points.shape
        rows, columns = (np.linspace(0, edge - 1, SAMPLES).round().astype(int) for edge in (height, width))
        sampled = np.ix_(rows, columns)
        points = self._points[sampled].ravel()
        moves = self._moves[(slice(None), *sampled)].reshape(COUNT, -1)
        half_m = self.half * self._pose.pixel_size_m
        away = np.abs(points[:, None] - points) * half_m
        shared = sum(share * np.exp(-away / length) for length, share in errors.settings.map_kernels)
        fitted = np.linalg.pinv(np.vstack([moves.real.T, moves.imag.T]))
        across, down = fitted[:, : len(points)], fitted[:, len(points) :]
        return (errors.map_accuracy / half_m) ** 2 * (across @ shared @ across.T + down @ shared @ down.T)

    def fit(self, assumed: np.ndarray, of_map: np.ndarray) -> _SystemFit | None:
        """Return the fit at assumed pose and effects (9,); None if the image does not determine all of them."""
        patch, share = self._patch(assumed)
        there = patch - patch.mean(axis=(0, 1))
        norm, energy = float((self._seen**2).sum()), float((there**2).sum())
        if share.mean() < LEAST_KNOWN_MOVED or norm <= 0 or energy <= 0:
            return None
        product = float((self._seen * there).sum())
        gain = product / norm
        if gain <= 0:
            return None
        residual = there - gain * self._seen
        slopes, noise = self._slopes(there + gain * self._seen), self._slopes(residual)
        units = 1 / np.sqrt(np.maximum((slopes.astype(np.float64) ** 2).sum(axis=1), 1e-30))
        both = np.outer(units, units)
        normal, of_noise = (cv2.mulTransposed(one, False, dtype=cv2.CV_64F) * both for one in (slopes, noise))
        if eigen(normal)[0][-1] <= DAMPING:
            return None
        inverse, trusted = inverse_of(normal) * both, inverse_without_noise(normal, of_noise) * both
        descent = np.einsum("ik,k->i", slopes, residual.ravel()).astype(np.float64)
        height, width = share.shape
        pulls = clustered_covariance(slopes * residual.ravel(), (height, width), self._pyramid.settings.blocks)
        covariance = trusted @ pulls @ trusted + of_map + LEAST**2 * np.eye(COUNT)
        score = product / np.sqrt(norm * (energy + self._pyramid.quiet * share.size))
        of_pose = inverse_of(normal[:POSE, :POSE]) * units[:POSE, None]
        to_pose = -of_pose @ (normal[:POSE, POSE:] / units[POSE:])
        return _SystemFit(score, assumed - inverse @ descent, covariance, to_pose)

    def _slopes(self, planes: np.ndarray) -> np.ndarray:
        """Return (9, h·w·C) float32 slopes of the fit by pose and effects, from the (h, w, C) sum of map and image."""
        height, width, channels = planes.shape
        gradient_x, gradient_y = gradients(planes.reshape(height, -1), channels).reshape(2, *planes.shape) / 2
        by_x = gradient_x * (self.half / self._image.pixel[0])
        by_y = gradient_y * (self.half / self._image.pixel[1])
        moves = self._moves[..., None]
        return (by_x * moves.real + by_y * moves.imag).reshape(COUNT, -1).astype(np.float32)

    def _patch(self, known: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the map as the image would show it: evidence (h, w, C) and labeled share (h, w), float32."""
        pose, image = self._pose, self._image
        seen = (self._points + np.einsum("k,kij->ij", known, self._moves)) * self.half
        to_map = axes(pose)
        x = to_map[0, 0] * seen.real + to_map[0, 1] * seen.imag
        y = to_map[1, 0] * seen.real + to_map[1, 1] * seen.imag
        pixel = pose.pixel_size_m * float(np.sqrt(image.pixel[0] * image.pixel[1]))
        spare = 2 * max(pixel, self._pyramid.frame.pixel_size)
        low, high = (pose.x + x.min() - spare, pose.y + y.min() - spare), (pose.x + x.max(), pose.y + y.max())
        level, left, top = self._pyramid.crop(pixel, (*low, high[0] + spare, high[1] + spare))
        columns = ((pose.x + x - left) / level.pixel[0] - 0.5).astype(np.float32)
        rows = ((pose.y + y - top) / level.pixel[0] - 0.5).astype(np.float32)
        evidence = cv2.remap(level.evidence, columns, rows, cv2.INTER_LINEAR).reshape(*columns.shape, -1)
        return evidence, cv2.remap(level.known, columns, rows, cv2.INTER_LINEAR)
