"""Which objects of the map an image's match at a pose: the nearest of their class, within what noise explains."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry.pose import Pose
from .hypotheses import SeenLandmarks
from .index import ConstellationIndex
from .settings import NoiseModel

NOISE_FACTORS = (0.5, 3.0)
"""How much less and more noise than assumed an image may have; measured from its own residuals."""

ASSUMED_MATCHES = 4
"""So many matches with just the assumed noise count with the measured ones: as many numbers as a pose has twice over,
so that a handful of residuals can't make the noise vanish. Set by hand."""

MEDIAN_OF_RAYLEIGH = 1.1774
"""Median length of a residual whose two coordinates have a standard deviation of 1."""


@dataclass(frozen=True)
class Nearest:
    """Nearest objects of the map to those of an image, of the same class; … stands for as many poses as there are.

    Attributes:
        distances: (…, n) map units, inf where there is none.
        objects: (…, n) int64, −1 where there is none.
        deviations: (…, n) σ of each distance, map units.
    """

    distances: np.ndarray
    objects: np.ndarray
    deviations: np.ndarray

    def __getitem__(self, poses: np.ndarray) -> Nearest:
        return Nearest(self.distances[poses], self.objects[poses], self.deviations[poses])


def center_noise(log_areas_px: np.ndarray, pixel_size: np.ndarray | float, noise: NoiseModel) -> np.ndarray:
    """Assumed σ of centers, map units.

    Args:
        log_areas_px: (…, n) ln of areas in px².
        pixel_size: Map units, broadcastable.
    """
    return pixel_size * np.hypot(noise.center_noise_px, noise.center_noise_in_sizes * np.exp(log_areas_px / 2))


def places_on_map(query: SeenLandmarks, poses: Sequence[Pose]) -> np.ndarray:
    """Return (S, n) complex: where each of S poses puts the image's objects."""
    return np.array([pose.on_map(query.points) for pose in poses])


def nearest_objects(index: ConstellationIndex, query: SeenLandmarks, poses: Sequence[Pose]) -> Nearest:
    """Return what is nearest to the image's objects at each of S poses, (S, n) each, with the assumed deviations."""
    distances, objects = index.matcher.match(places_on_map(query, poses), query.ranks)
    sizes = np.array([abs(pose.turn) for pose in poses])
    noise = center_noise(query.log_areas, sizes[:, None], index.settings.noise)
    return Nearest(distances.astype(np.float64), objects, noise)


def matched_within(nearest: Nearest, ends: np.ndarray) -> np.ndarray:
    """Return (S, n) bool: matches that end within ``ends`` (S, n); of objects that share one of the map only the nearest.

    That it is too far itself lets no other have it.
    """
    # One farther than every end is none, and keeps none from its match: most need no sorting.
    near = nearest.distances <= ends.max(axis=1, keepdims=True)
    rows, columns = np.nonzero(near & (nearest.objects >= 0))
    distances, objects = nearest.distances[rows, columns], nearest.objects[rows, columns]
    order = np.lexsort((distances, objects, rows))
    rows, columns, objects = rows[order], columns[order], objects[order]
    first = np.ones(len(order), bool)
    first[1:] = (objects[1:] != objects[:-1]) | (rows[1:] != rows[:-1])
    best = np.zeros(nearest.objects.shape, bool)
    best[rows[first], columns[first]] = True
    return best & (nearest.distances <= ends)


def biweight(distances: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Tukey's biweight: (…) weights, 1 at distance 0, falling smoothly to 0 at the end."""
    return np.maximum(1 - (distances / ends) ** 2, 0) ** 2


def noise_factor(residuals: np.ndarray, fitted: int) -> np.ndarray:
    """Return (…) σ of matches over the assumed one.

    From the median, because some matches are wrong. A pose takes its numbers out of the residuals: the squares of n
    true ones are smaller by 2 n / (2 n − fitted). Few residuals tell little, so the assumption counts as well.

    Args:
        residuals: (…, n) lengths over the assumed σ; inf where there is none, but one at least in each row.
        fitted: Numbers of the pose.
    """
    count = np.isfinite(residuals).sum(axis=-1)
    ordered = np.sort(residuals, axis=-1)
    low, high = (
        np.take_along_axis(ordered, place[..., None], axis=-1)[..., 0] for place in ((count - 1) // 2, count // 2)
    )
    measured = ((low + high) / 2 / MEDIAN_OF_RAYLEIGH) ** 2 * 2 * count / np.maximum(2 * count - fitted, 1)
    assumed = ASSUMED_MATCHES
    return np.clip(np.sqrt((count * measured + assumed) / (count + assumed)), *NOISE_FACTORS)


def median(values: np.ndarray) -> float:
    """Median of a few values, (n,) with n ≥ 1; NumPy's takes ten times as long to come to the same."""
    ordered = np.sort(values)
    return float(ordered[(len(ordered) - 1) // 2] + ordered[len(ordered) // 2]) / 2
