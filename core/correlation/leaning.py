"""Effect of leaning roofs on a pose in map correlation.

See docs/explanation/method.md#position-error. A roof leans away from the image's center, as if its part of the image
were larger. A lean that all roofs share changes only the pixel size; that of few roofs also moves and turns the image,
and the fit does not show it.
"""

from __future__ import annotations

import numpy as np

from ..geometry.error_settings import ErrorSettings
from .class_pyramid import EvidenceLevel, MapPyramid
from .refine import SCALE, ScoredPose, block_sums, damped_inverse, fit_at, parameter_units


def leaning_covariance(
    image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, settings: ErrorSettings
) -> np.ndarray:
    """Return the (4, 4) covariance that leaning roofs add to a pose, in the units of ``pose_covariance``.

    Each block of the image is larger by a random share; neighboring blocks show the same roof or similar ones.

    Args:
        image: Evidence at the pixels of the decision.
        settings: Heights of roofs.
    """
    fit = fit_at(image, pyramid, pose, pyramid.quiet)
    if fit is None:
        return np.full((4, 4), np.inf)
    pull, inverse = fit[0], damped_inverse(fit[1])
    height, width = image.known.shape
    growing = block_sums(pull.slopes * pull.slopes[SCALE], (height, width), pyramid.settings.blocks)
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
