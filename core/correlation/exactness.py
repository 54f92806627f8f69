"""Accuracy of a place in map correlation: the covariance of its own fit and of the errors that the whole image shares.

See docs/explanation/method.md#position-error.
"""

from __future__ import annotations

import numpy as np

from ..geometry.error_settings import ClassBias, ErrorSettings, SharedErrors
from ..geometry.pose import PoseCovariance, as_pairs
from ..geometry.radius import CIRCLE_95
from ..geometry.shared_errors import AREAS, CLASSES, MAP, VIEW, covariance_of
from .class_pyramid import EvidenceLevel, MapPyramid
from .refine import SCALE, ScoredPose, axes, block_sums, damped_inverse, fit_at, parameter_units
from .settings import CORRELATION
from .view_effects import ViewEffect

SAMPLES = 5
"""Places along an edge of an image; their distances determine how much of a map's displacement the image shares."""


def covariance_on_map(pose: ScoredPose, covariance: np.ndarray) -> np.ndarray:
    """Return (4, 4) of map x and y, heading in radians, ln pixel size; infinite values stay infinite.

    Args:
        covariance: (4, 4) of ``pose_covariance``, in image pixels, radians and ln pixel size.
    """
    to_map = np.eye(4)
    # y of the map goes up, that of image pixels down.
    to_map[:2, :2] = np.array([[1.0], [-1.0]]) * axes(pose)
    return to_map @ covariance @ to_map.T


def full_pose_covariance(  # noqa: PLR0913 - a fit, what it was made on, and what it does not show
    pose: ScoredPose,
    covariance: np.ndarray,
    edge_m: float,
    overview_pixel_m: float,
    errors: SharedErrors,
    effect: ViewEffect | None = None,
) -> PoseCovariance:
    """Return the covariance of a pose with all its sources of error.

    Args:
        covariance: (4, 4) of ``pose_covariance``, with that of leaning roofs.
        edge_m: Of the ground that the image shows.
        effect: Possible effect of lens and tilt, if it was estimated.
    """
    if not np.isfinite(covariance).all():
        return PoseCovariance(as_pairs(np.full((2, 2), np.inf)), np.inf, np.inf)
    own = covariance_on_map(pose, covariance)
    own[:2, :2] += (CORRELATION.error_floor_px * overview_pixel_m / CIRCLE_95) ** 2 * np.eye(2)
    shared = errors.map_accuracy**2 * shared_over(errors.settings.map_kernels, edge_m)
    own += shared
    known = [errors.bias_of(bias.value) for bias in (*errors.class_biases, ClassBias(0))]
    # Areas do not show which class moved the place: stated class offsets are not subtracted.
    common = errors.common_spread if errors.unstated([one.value for one in known]) else 0.0
    bias = common**2 + max(errors.spread_of(one, pose.pixel_size_m) ** 2 + one.length**2 / 2 for one in known)
    parts = [
        (AREAS, float(np.sqrt(np.trace((own - shared)[:2, :2]) / 2))),
        (MAP, float(np.sqrt(shared[0, 0]))),
        (CLASSES, float(np.sqrt(bias))),
    ]
    if effect is not None:
        view = covariance_on_map(pose, effect.covariance)
        parts.append((VIEW, float(np.sqrt(np.trace(view[:2, :2]) / 2))))
        own += view
    own[:2, :2] += bias * np.eye(2)
    budget = tuple(sorted(((name, CIRCLE_95 * part) for name, part in parts), key=lambda part: -part[1]))
    return covariance_of(own, pose.pixel_size_m, budget)


def shared_over(kernels: tuple[tuple[float, float], ...], edge_m: float) -> np.ndarray:
    """Return (4, 4): effect on a pose of a map displacement with variance 1 m², which does not average out.

    The order is map x and y in meters, heading in radians, ln pixel size.
    """
    places = np.arange(SAMPLES) / (SAMPLES - 1) * edge_m - edge_m / 2
    x, y = (axis.ravel() for axis in np.meshgrid(places, places))
    away = np.hypot(x[:, None] - x, y[:, None] - y)
    together = sum(share * np.exp(-away / length) for length, share in kernels)
    # Displacements along both axes are independent: turn and scale are their moments about the center.
    turning = np.stack([x, y]) / (x**2 + y**2).sum()
    turned = float(sum(moment @ together @ moment for moment in turning))
    return np.diag([float(together.mean())] * 2 + [turned] * 2)


def leaning_covariance(
    image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, settings: ErrorSettings
) -> np.ndarray:
    """Return the (4, 4) covariance that leaning roofs add to a pose, in the units of ``pose_covariance``.

    A roof leans away from the image's center, as if its part of the image were larger. A lean that all roofs share
    changes only the pixel size; that of few roofs also moves and turns the image, and the fit does not show it. Each
    block of the image is larger by a random share; neighboring blocks show the same roof or similar ones.

    Args:
        image: Evidence at the pixels of the decision.
    """
    fit = fit_at(image, pyramid, pose, pyramid.quiet)
    if fit is None:
        return np.full((4, 4), np.inf)
    _, slopes, normal = fit
    inverse = damped_inverse(normal)
    height, width = image.known.shape
    growing = block_sums(slopes * slopes[SCALE], (height, width), pyramid.settings.blocks)
    down, across = growing.shape[1:]
    edges_m = np.array([width * image.pixel[0], height * image.pixel[1]]) * pose.pixel_size_m
    row, column = (axis.ravel() for axis in np.indices((down, across)))
    x, y = (column + 0.5) / across * edges_m[0], (row + 0.5) / down * edges_m[1]
    alike = np.exp(-np.hypot(x[:, None] - x, y[:, None] - y) / settings.roof_length)
    units = parameter_units(image)
    moves = inverse @ growing.reshape(4, -1) * (units / units[SCALE])[:, None]
    lean = settings.leaning(float(np.hypot(*edges_m)))
    found = lean**2 * moves @ alike @ moves.T
    found[SCALE, SCALE] += lean**2
    return found
