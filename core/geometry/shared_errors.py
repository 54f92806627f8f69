"""Covariance of a pose with shared errors: generalized least squares on the landmarks that agree.

See docs/explanation/method.md#position-error.

A map displaces neighboring landmarks alike, a network shifts all landmarks of a class, lens distortion and tilt deform
the whole image: such errors do not average out. Each is a random effect with a variance. Variances that residuals can
show (noise of single landmarks, displacement of the map, lens and tilt) are integrated out with their restricted
likelihood; the others are stated values.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .error_settings import SharedErrors
from .pose import SLOPE_DEVIATION, STRETCH_DEVIATION, Pose, PoseCovariance, as_pairs
from .radius import CIRCLE_95, circle_radius, ellipse_of

FITTED = 4
"""Numbers of a level pose: center and turn, two each."""

MEDIAN_OF_RAYLEIGH = 1.1774
"""Median length of a residual with a standard deviation of 1 in both coordinates."""

LEAST_NOISE = 0.1
"""Smaller residuals, as a share of the assumed noise, are chance or come from a map matched with itself."""

OUTLIER_IN_NOISE = 2.5
"""Residuals of more σ pull no harder; Gaussian ones are rarely so long (4 in 100)."""

ErrorPart = tuple[str, float]
"""A cause, and the 95 % radius of this cause, map units."""

LANDMARKS, AREAS, MAP, VIEW, CLASSES, PIXELS = "landmarks", "areas", "map", "view", "classes", "pixels"

_FIRST_CLASS = 9
"""Number of effects before those of the classes: the pose's four, the lens, stretch and slope of a tilt, two each."""


@dataclass(frozen=True)
class MatchedPoints:
    """The n landmarks of an image that agree with landmarks of the map.

    Attributes:
        image: (n,) complex image points.
        on_map: (n,) complex map points.
        deviations: (n,) assumed independent σ per axis, map units.
        classes: (n,) class values.
        diagonal: Of the image, pixels.
    """

    image: np.ndarray
    on_map: np.ndarray
    deviations: np.ndarray
    classes: np.ndarray
    diagonal: float

    def thinned(self, most: int) -> MatchedPoints:
        """Return at most ``most`` of them, evenly chosen: the time grows with the cube of their number."""
        if len(self.image) <= most:
            return self
        kept = np.linspace(0, len(self.image) - 1, most).round().astype(np.int64)
        return MatchedPoints(
            self.image[kept], self.on_map[kept], self.deviations[kept], self.classes[kept], self.diagonal
        )


def refined_pose(matched: MatchedPoints, pose: Pose, errors: SharedErrors) -> tuple[Pose, PoseCovariance]:
    """Return the pose with shared errors considered, and its covariance.

    Args:
        matched: At least three landmarks.
        pose: A fit to them.

    Returns:
        The pose as the mean over all possible variances; its covariance with the stated variances added.
    """
    system = _System(matched.thinned(errors.settings.most_landmarks), pose, errors)
    variances = system.variances(errors.map_accuracy)
    weights, solutions, covariances = system.solved(variances)
    mean = weights @ solutions
    apart = solutions - mean
    covariance = np.tensordot(weights, covariances, 1) + np.einsum("k,ki,kj->ij", weights, apart, apart)
    scale = abs(pose.turn) * matched.diagonal / 2
    moved = Pose(
        pose.center + pose.turn * matched.diagonal / 2 * complex(mean[0], mean[1]),
        pose.turn * (1 + complex(mean[2], mean[3])),
        pose.stretch,
        pose.slope,
    )
    phase = phase_deviation(moved.turn, errors.map_pixel_size, matched.diagonal)
    full = _on_map(covariance, pose.turn / abs(pose.turn), scale)
    full[:2, :2] += phase**2 * np.eye(2)
    full[3, 3] += errors.settings.leaning(2 * scale) ** 2
    parts = system.parts(weights, variances, float(np.trace(full[:2, :2]) / 2), phase)
    return moved, covariance_of(full, abs(moved.turn), parts)


def inverted(matrices: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return inverses (…, p, p) of symmetric positive definite matrices (…, p, p), and ln of their determinants (…).

    Eliminates in all of them at once, without pivoting. LAPACK would run once per matrix and, on busy processors, wait
    longer for its threads than such small matrices take.
    """
    rest = np.array(matrices, dtype=np.float64)
    logarithms = np.zeros(rest.shape[:-2])
    for k in range(rest.shape[-1]):
        pivot = rest[..., k, k].copy()
        logarithms += np.log(pivot)
        row = rest[..., k, :] / pivot[..., None]
        column = rest[..., :, k].copy()
        rest -= column[..., :, None] * row[..., None, :]
        rest[..., k, :] = row
        rest[..., :, k] = -column / pivot[..., None]
        rest[..., k, k] = 1 / pivot
    return rest, logarithms


def eliminated(matrices: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return symmetric matrices (…, p, p) without their last unknowns, and ln of the products of the pivots (…).

    Args:
        matrices: Normal equations; bordering rows and columns may be among the first ones.
        count: Number of unknowns to eliminate, last ones first.

    Returns:
        (…, p − count, p − count), the Schur complements.
    """
    rest, logarithms = matrices, np.zeros(matrices.shape[:-2])
    for _ in range(count):
        # A copy: for non-contiguous numbers the last bit of NumPy's logarithm depends on the address of the result.
        pivot, column = rest[..., -1, -1].copy(), rest[..., :-1, -1]
        logarithms += np.log(pivot)
        rest = rest[..., :-1, :-1] - column[..., :, None] * (column / pivot[..., None])[..., None, :]
    return rest, logarithms


def bordered(precisions: np.ndarray, means: np.ndarray) -> np.ndarray:
    """Return (…, p + 1, p + 1) normal equations of the prior, bordered by its means (p,).

    ``precisions``: (…, p).
    """
    weighed = precisions * means
    matrices = np.zeros((*precisions.shape[:-1], len(means) + 1, len(means) + 1))
    matrices[..., 0, 0] = (weighed * means).sum(axis=-1)
    matrices[..., 0, 1:] = matrices[..., 1:, 0] = weighed
    places = np.arange(1, len(means) + 1)
    matrices[..., places, places] = precisions
    return matrices


def covariance_of(full: np.ndarray, pixel_size: float, parts: tuple[ErrorPart, ...]) -> PoseCovariance:
    """Return the uncertainty of a pose from its covariance.

    Args:
        full: (4, 4) of map x and y, heading in radians, ln pixel size.
        pixel_size: Map units.
        parts: Error budget of the 95 % radius.
    """
    position = full[:2, :2]
    rows = tuple(tuple(row) for row in full.tolist())
    return PoseCovariance(
        as_pairs(position),
        float(np.degrees(np.sqrt(full[2, 2]))),
        float(np.sqrt(full[3, 3]) * pixel_size),
        ellipse_of(position),
        circle_radius(position),
        rows,
        parts,
    )


def phase_deviation(turn: complex, map_pixel_size: float, size_px: float) -> float:
    """Return σ per axis, map units, of the common shift of an image because both it and the map consist of pixels.

    If rows of the image are parallel to rows of the map and pixels are equally large, every boundary is rounded alike.
    Otherwise the phase drifts over the image, and the shifts average out.

    Args:
        map_pixel_size: Of the label map, map units; 0 for a map without pixels.
    """
    if map_pixel_size <= 0:
        return 0.0
    step = turn / map_pixel_size
    whole = complex(round(step.real), round(step.imag)) or 1.0 + 0j
    drift = abs(step - whole) * size_px / 2
    return float(np.sqrt(1 / 12) * max(abs(turn), map_pixel_size) / np.hypot(1, np.pi * drift))


class _System:
    """The linear system of a fit, in units of half the diagonal, in the image's frame."""

    def __init__(self, matched: MatchedPoints, pose: Pose, errors: SharedErrors) -> None:
        self._settings = settings = errors.settings
        self._is_level = pose.is_level
        self._half = half = matched.diagonal / 2
        self._scale = scale = abs(pose.turn) * half
        image = matched.image / half
        seen = (matched.image + pose.stretch * matched.image.conj()) / pose.depth(matched.image) / half
        off = (matched.on_map - pose.center) / pose.turn / half - seen
        own = matched.deviations / scale
        # Scale the noise to the residuals; only residuals that are large for it count as outliers.
        own = own * max(float(np.median(np.abs(off) / own)) / MEDIAN_OF_RAYLEIGH, LEAST_NOISE)
        own = own * np.sqrt(np.maximum(np.abs(off) / own / OUTLIER_IN_NOISE, 1))
        columns, self._stated, self._spreads = self._effects(matched, image, pose, errors)
        away = np.abs(matched.on_map[:, None] - matched.on_map)
        shared = sum(share * np.exp(-away / length) for length, share in settings.map_kernels)
        self._strengths, directions = np.linalg.eigh(shared / own[:, None] / own)
        self._strengths = np.maximum(self._strengths, 0)
        # In these directions every covariance of the family is diagonal. The observations border the effects.
        seen_first = np.column_stack([off, columns]) / own[:, None]
        turned = (directions.T @ seen_first.view(np.float64)).view(np.complex128)
        products = turned.real[:, :, None] * turned.real[:, None] + turned.imag[:, :, None] * turned.imag[:, None]
        self._products = products.reshape(len(own), -1)

    def _effects(
        self, matched: MatchedPoints, image: np.ndarray, pose: Pose, errors: SharedErrors
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return (n, p) complex columns of all effects, their stated means (p,), spreads (p − 9,) of class effects."""
        ones = np.ones(len(image))
        columns = [ones, 1j * ones, image, 1j * image, image * np.abs(image) ** 2]
        columns += [image.conj(), 1j * image.conj(), -image * image.real, -image * image.imag]
        tilt = pose.stretch, pose.slope * self._half
        stated = [0.0] * 5 + [-part for value in tilt for part in (value.real, value.imag)]
        spreads = []
        for value in np.unique(matched.classes).tolist():
            bias = errors.bias_of(value)
            belongs = (matched.classes == value).astype(np.float64)
            columns += [belongs, 1j * belongs]
            # A landmark that a network shows too far east is west of it on the map.
            effect = -bias.in_image(pose.turn) / self._scale
            stated += [effect.real, effect.imag]
            spreads += [errors.spread_of(bias, abs(pose.turn)) / self._scale] * 2
        unstated = np.isin(matched.classes, errors.unstated(np.unique(matched.classes).tolist())).astype(np.float64)
        if errors.class_spread and unstated.any():
            # Effects of one network: shadows and its own properties shift all its classes alike.
            columns += [unstated, 1j * unstated]
            stated += [0.0, 0.0]
            spreads += [errors.common_spread / self._scale] * 2
        return np.column_stack(columns), np.array(stated), np.array(spreads)

    def variances(self, map_accuracy: float) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Return factors (A,) of own noise, map deviations (A,), ln prior (A,), and views (B, 3): lens, tilt, share."""
        settings = self._settings
        own, shared = (axis.ravel() for axis in np.meshgrid(settings.own_factors, settings.map_factors, indexing="ij"))
        # The map's deviation: nearly even in its logarithm up to the stated one, because most neighborhoods hardly
        # change between two dates; above it, half Cauchy. The landmarks' own: log normal.
        prior = 0.25 * np.log(shared) - 0.625 * np.log1p(shared**2) - 0.5 * (np.log(own) / settings.own_spread) ** 2
        if not self._is_level:
            # Landmarks were matched because they agree with this pose, so they show less of the map's displacement.
            prior += settings.tilted_exponent * np.log(shared)
        return own, shared * map_accuracy / self._scale, prior, np.array(settings.views)

    def solved(self, variances: tuple) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return weights (K,), poses (K, 4) and covariances (K, 4, 4) for all possible variances."""
        own, shared, prior, views = variances
        inverse = 1 / (own[:, None] ** 2 + shared[:, None] ** 2 * self._strengths)
        precisions = self._precisions(views)
        # The system of the classes' effects is independent of the camera.
        classes = np.where(np.arange(precisions.shape[1]) < _FIRST_CLASS, 0, precisions[0])
        rest, of_classes = eliminated(self._normal(inverse) + bordered(classes, self._stated), len(self._spreads))
        of_view = bordered(precisions[:, :_FIRST_CLASS], self._stated[:_FIRST_CLASS])
        rest, of_views = eliminated(rest[:, None] + of_view, _FIRST_CLASS - FITTED)
        covariances, logarithms = inverted(rest[..., 1:, 1:])
        solutions = (covariances @ rest[..., 1:, :1])[..., 0]
        squares = rest[..., 0, 0] - (rest[..., 1:, 0] * solutions).sum(axis=-1)
        of_prior = np.log(precisions[:, FITTED:].copy()).sum(axis=1)
        likely = of_prior - logarithms - of_views - of_classes[:, None] - squares
        likely = 0.5 * likely + np.log(inverse).sum(axis=1)[:, None] + prior[:, None] + np.log(views[:, -1].copy())
        weights = np.exp(likely - likely.max()).ravel()
        return weights / weights.sum(), solutions.reshape(-1, FITTED), covariances.reshape(-1, FITTED, FITTED)

    def _normal(self, inverse: np.ndarray) -> np.ndarray:
        """Return (A, p + 1, p + 1) normal equations for inverse variances (A, n), bordered by the observations."""
        count = len(self._stated) + 1
        return (inverse @ self._products).reshape(-1, count, count)

    def _precisions(self, views: np.ndarray) -> np.ndarray:
        """Return (B, p) precisions of the effects, 0 for those of the pose itself."""
        found = np.zeros((len(views), len(self._stated)))
        units = np.array([1.0, *[STRETCH_DEVIATION] * 2, *[SLOPE_DEVIATION] * 2])
        deviations = np.column_stack([views[:, 0], *[views[:, 1]] * 4]) * units
        found[:, FITTED:_FIRST_CLASS] = deviations**-2.0
        found[:, _FIRST_CLASS:] = self._spreads**-2.0
        return found

    def parts(self, weights: np.ndarray, variances: tuple, variance: float, phase: float) -> tuple[ErrorPart, ...]:
        """Return the error budget of the position, the largest part first.

        Causes are added one after the other at the mean of the possible variances: single landmarks, then the map, the
        view, the classes.

        Args:
            weights: (K,) of ``solved``.
            variances: The variances that ``weights`` belong to.
            variance: Of the position along an axis, map units².
            phase: Standard deviation from the pixels.
        """
        own, shared, _, views = variances
        by_own = weights.reshape(len(own), len(views))
        on_own, on_view = by_own.sum(axis=1), by_own.sum(axis=0)
        own_mean, map_mean = np.sqrt(on_own @ own**2), np.sqrt(on_own @ shared**2)
        view = np.sqrt(on_view @ views**2)[None]
        nothing = np.full((1, len(self._stated) - FITTED), 1e9)
        precisions = self._precisions(view)[:, FITTED:]
        tilted, all_of_it = nothing.copy(), precisions
        tilted[:, : _FIRST_CLASS - FITTED] = precisions[:, : _FIRST_CLASS - FITTED]
        steps = [(0.0, nothing), (map_mean, nothing), (map_mean, tilted), (map_mean, all_of_it)]
        reached = [self._variance(own_mean, deviation, known[0]) for deviation, known in steps]
        shares = np.maximum(np.diff([0.0, *reached]), 0)
        shares *= max(variance - phase**2, 0) / max(shares.sum(), 1e-300)
        found = zip((LANDMARKS, MAP, VIEW, CLASSES, PIXELS), np.sqrt([*shares, phase**2]).tolist())
        return tuple(sorted(((name, CIRCLE_95 * part) for name, part in found), key=lambda part: -part[1]))

    def _variance(self, own: float, shared: float, precisions: np.ndarray) -> float:
        """Return the variance of the position along an axis, with precisions (p − 4,) of the effects."""
        count = len(self._stated)
        inverse = 1 / (own**2 + shared**2 * self._strengths)
        normal = self._normal(inverse[None])[0, 1:, 1:]
        normal[range(FITTED, count), range(FITTED, count)] += precisions
        return float(np.trace(np.linalg.inv(normal)[:2, :2]) / 2)


def _on_map(covariance: np.ndarray, unit: complex, scale: float) -> np.ndarray:
    """Return the (4, 4) covariance of map x, y, heading in radians and ln pixel size, from one in the image's frame."""
    to_map = np.zeros((4, 4))
    to_map[:2, :2] = scale * np.array([[unit.real, -unit.imag], [unit.imag, unit.real]])
    # The heading grows clockwise, ``turn`` counter-clockwise.
    to_map[2, 3], to_map[3, 2] = -1.0, 1.0
    return to_map @ covariance @ to_map.T
