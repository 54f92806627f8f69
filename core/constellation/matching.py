"""Match landmarks of an image with the nearest ones of their class on the map, within the noise of a pose."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..geometry.pose import Pose
from .hypotheses import SeenLandmarks
from .index import ConstellationIndex
from .neighbors import SteppedMatcher
from .settings import NoiseModel

NOISE_FACTORS = (0.5, 3.0)
"""Smallest and largest ratio of an image's measured noise to the assumed one."""

ASSUMED_MATCHES = 4
"""Number of matches with exactly the assumed noise that are added to the measured ones: twice the parameters of a pose,
so that a few residuals can't reduce the noise to nothing. Set by hand."""

MEDIAN_OF_RAYLEIGH = 1.1774
"""Median length of a residual with a standard deviation of 1 in both coordinates."""


@dataclass(frozen=True)
class Nearest:
    """Nearest landmarks of the map to those of an image, of the same class; … means the poses.

    Attributes:
        distances: (…, n) map units, inf without one.
        objects: (…, n) int64, −1 without one.
        deviations: (…, n) σ of each distance, map units.
    """

    distances: np.ndarray
    objects: np.ndarray
    deviations: np.ndarray

    def __getitem__(self, poses: np.ndarray) -> Nearest:
        return Nearest(self.distances[poses], self.objects[poses], self.deviations[poses])


def center_noise(log_areas_px: np.ndarray, pixel_size: np.ndarray | float, noise: NoiseModel) -> np.ndarray:
    """Return the assumed σ of centers, map units.

    Args:
        log_areas_px: (…, n) ln of areas in px².
        pixel_size: Map units, broadcastable.
    """
    return pixel_size * np.hypot(noise.center_noise_px, noise.center_noise_in_sizes * np.exp(log_areas_px / 2))


class PoseMatcher:
    """Matches an image's landmarks at S poses that move step by step, with the assumed deviations."""

    def __init__(self, index: ConstellationIndex, query: SeenLandmarks, count: int) -> None:
        """Match nothing yet."""
        self._query, self._noise = query, index.settings.noise
        self._matcher = SteppedMatcher(index.matcher, query.ranks, count)

    def match(
        self, poses: Pose, factors: np.ndarray, beyond: float = 0.0, which: np.ndarray | None = None
    ) -> tuple[Nearest, np.ndarray]:
        """Return the nearest landmarks, exact for distances up to the ends of matches, and these ends (S, n).

        Args:
            poses: Stack of S poses.
            factors: (S, 1) ratio of the noise to the assumed one.
            beyond: Largest residual beyond the noise, pixels.
            which: (S,) numbers of the poses among all of the matcher; None for all.
        """
        sizes = poses.pixel_size
        deviations = center_noise(self._query.log_areas, sizes, self._noise)
        ends = beyond * sizes + self._noise.gate_in_noise * factors * deviations
        reach = ends.max(axis=1, keepdims=True)
        distances, objects = self._matcher.match(poses.on_map(self._query.points), reach, which)
        return Nearest(distances.astype(np.float64), objects, deviations), ends


def matched_within(nearest: Nearest, ends: np.ndarray) -> np.ndarray:
    """Return (S, n) bool: matches within ``ends`` (S, n); each landmark of the map matches its nearest only.

    A nearest one that is too far still blocks the others.
    """
    # Landmarks beyond every end neither match nor block others, so most need no sorting.
    near = nearest.distances <= ends.max(axis=1, keepdims=True)
    rows, columns = np.nonzero(near & (nearest.objects >= 0))
    distances, objects = nearest.distances[rows, columns], nearest.objects[rows, columns]
    pairs = rows * (int(objects.max(initial=0)) + 1) + objects
    order = np.lexsort((distances, pairs))
    rows, columns, pairs = rows[order], columns[order], pairs[order]
    first = np.ones(len(order), bool)
    first[1:] = pairs[1:] != pairs[:-1]
    best = np.zeros(nearest.objects.shape, bool)
    best[rows[first], columns[first]] = True
    return best & (nearest.distances <= ends)


def biweight(distances: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Return Tukey's biweight: (…) weights, 1 at distance 0, decreasing smoothly to 0 at the end."""
    return np.maximum(1 - (distances / ends) ** 2, 0) ** 2


def noise_factor(residuals: np.ndarray, fitted: int) -> np.ndarray:
    """Return (…) σ of matches over the assumed one.

    Uses the median, because some matches are wrong. Fitting a pose reduces the residuals: the squares of n true ones
    are smaller by 2 n / (2 n − fitted). Few residuals are uncertain, so the assumption also counts.

    Args:
        residuals: (…, n) lengths over the assumed σ; inf for missing ones, at least one finite in each row.
        fitted: Number of parameters of the pose.
    """
    count = np.isfinite(residuals).sum(axis=-1)
    ordered = np.sort(residuals, axis=-1)
    first = np.arange(count.size).reshape(count.shape) * residuals.shape[-1]
    low, high = (ordered.take(first + place) for place in ((count - 1) // 2, count // 2))
    measured = ((low + high) / 2 / MEDIAN_OF_RAYLEIGH) ** 2 * 2 * count / np.maximum(2 * count - fitted, 1)
    assumed = ASSUMED_MATCHES
    return np.clip(np.sqrt((count * measured + assumed) / (count + assumed)), *NOISE_FACTORS)


def median(values: np.ndarray) -> float:
    """Return the median of a few values, (n,) with n ≥ 1, ten times as fast as NumPy's, with the same result."""
    ordered = np.sort(values)
    return float(ordered[(len(ordered) - 1) // 2] + ordered[len(ordered) // 2]) / 2
