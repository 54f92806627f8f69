"""Similarity transforms between an image and the map, as complex numbers: fit, heading, scale, uncertainty.

An image point is u = (column − W/2) + i (H/2 − row): pixels from the image's center, y up. A pose (center, turn) puts
it at center + turn · u on the map; center is the position of the image's center, |turn| the pixel size,
and the image's top points to turn · i.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

CONFIDENCE_TAIL = 0.05
"""The 95 % ellipse leaves out this much."""

HUBER_IN_NOISE = 1.345
"""A match farther off than this many σ pulls no harder than one that is just so far off: Huber's own value. On the
northern half of Liechtenstein merged and split objects cost less with it: median error 0.29 m, 0.33 m with 2.0."""

STRETCH_DEVIATION = 0.01
SLOPE_DEVIATION = 0.08
"""How tilted cameras are expected to be: 10° and a field of view of 60° make a stretch of 0.008 and, over half the
image's diagonal, a slope of 0.14."""


@dataclass(frozen=True)
class Ellipse:
    """95 % ellipse of a position.

    Attributes:
        semi_major: Longer semi-axis, map units.
        semi_minor: Shorter semi-axis, map units.
        orientation_deg: Direction of the longer one, clockwise from grid north, 0 to 180.
    """

    semi_major: float
    semi_minor: float
    orientation_deg: float


@dataclass(frozen=True)
class PoseCovariance:
    """How exactly a pose is known.

    Attributes:
        position: ((xx, xy), (xy, yy)) of the position along the map's axes, map units².
        heading_deviation_deg: Standard deviation of the heading.
        pixel_size_deviation: Standard deviation of the pixel size, map units.
        ellipse_95: Holds the position in 95 % of fixes; None where deviations are the fit's own, which no trials
            confirm, as those of map correlation.
    """

    position: tuple[tuple[float, float], tuple[float, float]]
    heading_deviation_deg: float
    pixel_size_deviation: float
    ellipse_95: Ellipse | None = None


@dataclass(frozen=True)
class Pose:
    """Where an image lies: u goes to center + turn · (u + stretch · ū) / (1 + Re(slope* · u)).

    With stretch and slope its 8 numbers make a homography: any view of level ground by a tilted camera.

    Attributes:
        center: Map position x + i y of the image's center.
        turn: Heading and pixel size there.
        stretch: 0 for a camera that looks straight down.
        slope: Per pixel; 0 for a camera that looks straight down.
    """

    center: complex
    turn: complex
    stretch: complex = 0j
    slope: complex = 0j

    @property
    def is_level(self) -> bool:
        """Whether the camera looks straight down."""
        return self.stretch == 0 and self.slope == 0

    def on_map(self, image: np.ndarray) -> np.ndarray:
        """(n,) complex map points of (n,) complex image points."""
        if self.is_level:
            return self.center + self.turn * image
        return self.center + self.turn * (image + self.stretch * image.conj()) / self.depth(image)

    def in_image(self, on_map: np.ndarray) -> np.ndarray:
        """The inverse of ``on_map``."""
        z = (on_map - self.center) / self.turn
        if self.is_level:
            return z
        a, p = self.stretch, self.slope
        xx, xy = 1 + a.real - z.real * p.real, a.imag - z.real * p.imag
        yx, yy = a.imag - z.imag * p.real, 1 - a.real - z.imag * p.imag
        determinant = xx * yy - xy * yx
        determinant = np.where(np.abs(determinant) < 1e-9, 1e-9, determinant)
        return ((yy * z.real - xy * z.imag) + 1j * (xx * z.imag - yx * z.real)) / determinant

    def depth(self, image: np.ndarray) -> np.ndarray:
        """(n,) how near the ground is, against the image's center; 1 everywhere for a level camera."""
        return np.maximum(1 + (self.slope.conjugate() * image).real, 0.2)

    def pixel_sizes(self, image: np.ndarray) -> np.ndarray:
        """(n,) size of a pixel on the ground at image points: the root of the area it covers."""
        return abs(self.turn) * self.depth(image) ** -1.5


def image_points(points_xy: np.ndarray, width_px: float, height_px: float) -> np.ndarray:
    """(n,) complex image points of pixel coordinates (n, 2) (column, row)."""
    points = np.asarray(points_xy, np.float64).reshape(-1, 2)
    return (points[:, 0] - width_px / 2) + 1j * (height_px / 2 - points[:, 1])


def heading_of(turn: complex) -> float:
    """Degrees clockwise from grid north of the image's top, 0 ≤ heading < 360."""
    top = turn * 1j
    return float(np.degrees(np.arctan2(top.real, top.imag)) % 360)


def turn_of(heading_deg: float, pixel_size: float) -> complex:
    """The inverse of ``heading_of`` with a pixel size."""
    return complex(pixel_size * np.exp(-1j * np.radians(heading_deg)))


def fit_similarity(image: np.ndarray, on_map: np.ndarray, weights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Weighted least squares along the last axis: (…,) complex centers and turns from (…, n) complex points.

    Rows whose weighted image points coincide give a turn of 0.
    """
    total = np.maximum(weights.sum(axis=-1), 1e-300)
    image_mean = (weights * image).sum(axis=-1) / total
    map_mean = (weights * on_map).sum(axis=-1) / total
    away = image - image_mean[..., None]
    spread = (weights * (away.real**2 + away.imag**2)).sum(axis=-1)
    turn = (weights * away.conj() * (on_map - map_mean[..., None])).sum(axis=-1) / np.maximum(spread, 1e-300)
    return map_mean - turn * image_mean, turn


def fit_tilted(image: np.ndarray, on_map: np.ndarray, deviations: np.ndarray, pose: Pose, diagonal: float) -> Pose:
    """The pose of a possibly tilted camera by linear least squares, with a prior that tilt is moderate.

    Args:
        image: (n,) complex image points.
        on_map: (n,) complex map points.
        deviations: (n,) σ per axis, map units.
        pose: A first one.
        diagonal: Of the image, pixels.
    """
    columns, right = _tilted_system(image, on_map, deviations, pose, diagonal)
    solution = np.linalg.lstsq(columns, right, rcond=None)[0]
    center, turn, stretched, slope = (complex(*solution[k : k + 2]) for k in (0, 2, 4, 6))
    # The equations have the center above the depth, a pose has it beside: center = center · depth / depth, and what
    # depth adds, center · Re(slope* · u), is part of the turn and of the stretch.
    turn, stretched = turn - center * slope.conjugate() / 2, stretched - center * slope / 2
    scale = diagonal / 2
    return Pose(pose.center + pose.turn * scale * center, pose.turn * turn, stretched / turn, slope / scale)


def _tilted_system(
    image: np.ndarray, on_map: np.ndarray, deviations: np.ndarray, pose: Pose, diagonal: float
) -> tuple[np.ndarray, np.ndarray]:
    """Real equations for what goes to (center + turn · u + stretched · ū) / (1 + Re(slope* · u)), relative to ``pose``.

    Returns:
        (2 n + 4, 8) columns and (2 n + 4,) right side, of size 1; the last four are the prior.
    """
    scale = diagonal / 2
    u = image / scale
    z = (on_map - pose.center) / pose.turn / scale
    ones = np.ones(len(u))
    complex_columns = [ones, 1j * ones, u, 1j * u, u.conj(), 1j * u.conj(), -z * u.real, -z * u.imag]
    weights = abs(pose.turn) * scale / deviations
    block = np.column_stack(complex_columns) * weights[:, None]
    prior = np.zeros((4, 8))
    prior[(0, 1), (4, 5)] = 1 / STRETCH_DEVIATION
    prior[(2, 3), (6, 7)] = 1 / SLOPE_DEVIATION
    right = z * weights
    return np.concatenate([block.real, block.imag, prior]), np.concatenate([right.real, right.imag, np.zeros(4)])


def tilted_covariance(
    image: np.ndarray, on_map: np.ndarray, deviations: np.ndarray, pose: Pose, diagonal: float
) -> PoseCovariance:
    """``level_covariance`` for ``fit_tilted``, by linear propagation of the noise measured from the residuals."""
    residuals = (pose.on_map(image) - on_map) / deviations * abs(pose.turn) / pose.turn
    share = huber(np.abs(residuals), np.ones(len(image)))
    columns, _ = _tilted_system(image, on_map, deviations / np.sqrt(share), pose, diagonal)
    freedom = max(2 * len(image) - 8, 2)
    influence = np.linalg.pinv(columns)[:, : 2 * len(image)]
    leverage = (influence.T * columns[: 2 * len(image)]).sum(axis=1)
    pulls = np.concatenate([residuals.real, residuals.imag]) * np.tile(np.sqrt(share), 2)
    variances = (pulls / np.maximum(1 - leverage, 0.1)) ** 2
    pooled = (pulls**2 * np.tile(share, 2)).sum() / freedom / np.tile(share, 2)
    variances = blended(variances, pooled, len(image), 8) / slope_of_pulls(share) ** 2
    covariance = (influence * variances) @ influence.T
    # Positions are in units of half the diagonal, in the frame of the image.
    scale = abs(pose.turn) * diagonal / 2
    values, axes = np.linalg.eigh(covariance[:2, :2])
    minor, major = scale * np.sqrt(2 * fisher_quantile(freedom) * np.maximum(values, 0))
    direction = complex(*axes[:, 1]) * pose.turn
    turn = float(np.sqrt(np.trace(covariance[2:4, 2:4]) / 2))
    ellipse = Ellipse(float(major), float(minor), float((90 - np.degrees(np.angle(direction))) % 180))
    unit = pose.turn / abs(pose.turn)
    to_map = scale * np.array([[unit.real, -unit.imag], [unit.imag, unit.real]])
    position = as_pairs(to_map @ covariance[:2, :2] @ to_map.T)
    return PoseCovariance(position, float(np.degrees(turn)), turn * abs(pose.turn), ellipse)


def level_covariance(image: np.ndarray, residuals: np.ndarray, deviations: np.ndarray, turn: complex) -> PoseCovariance:
    """The covariance of a level pose fitted to matches.

    A sandwich estimate for Huber's weights: what each match pulls, by its residual, over how much the pull of all
    changes with the pose. The noise is measured from the residuals, which know it better than the assumption does.
    A match of leverage h has drawn the pose towards itself; without it its residual would be 1 / (1 − h) times
    as large (at most 10 are believed), so that is taken: the jackknife, HC3 of MacKinnon and White (1985).
    n points and 4 numbers fitted leave 2 n − 4 degrees of freedom, and the ellipse's size follows Fisher's F with 2
    and those. It is a circle, as noise that is alike in all directions makes it.

    Args:
        image: (n,) complex image points.
        residuals: (n,) complex, on the map.
        deviations: (n,) σ per axis, map units.
        turn: Of the pose.
    """
    share = huber(np.abs(residuals), deviations)
    weights = share / deviations**2
    total = weights.sum()
    mean = (weights * image).sum() / total
    away = image - mean
    spread = (weights * np.abs(away) ** 2).sum()
    freedom = max(2 * len(image) - 4, 1)
    on_turn = weights * away.conj() / spread
    on_center = weights / total - mean * on_turn
    leverage = weights / total + weights * np.abs(away) ** 2 / spread
    variances = np.abs(residuals) ** 2 / 2 / np.maximum(1 - leverage, 0.1) ** 2
    pooled = (share * weights * np.abs(residuals) ** 2).sum() / freedom / weights / share
    variances = blended(variances, pooled, len(image), 4) / slope_of_pulls(share) ** 2
    variance = (np.abs(on_center) ** 2 * variances).sum()
    radius = float(np.sqrt(2 * fisher_quantile(freedom) * variance))
    deviation = float(np.sqrt((np.abs(on_turn) ** 2 * variances).sum()))
    ellipse, position = Ellipse(radius, radius, 0.0), as_pairs(variance * np.eye(2))
    return PoseCovariance(position, float(np.degrees(deviation / abs(turn))), deviation, ellipse)


def as_pairs(covariance: np.ndarray) -> tuple[tuple[float, float], tuple[float, float]]:
    """A (2, 2) covariance as ``PoseCovariance`` keeps it: results can be compared."""
    (xx, xy), (yx, yy) = covariance.tolist()
    return (xx, xy), (yx, yy)


def huber(distances: np.ndarray, deviations: np.ndarray) -> np.ndarray:
    """(n,) weights: 1 up to HUBER_IN_NOISE σ, then falling so that the pull stays the same."""
    return HUBER_IN_NOISE / np.maximum(distances / deviations, HUBER_IN_NOISE)


def blended(variances: np.ndarray, pooled: np.ndarray, count: int, fitted: int) -> np.ndarray:
    """Each match's own variance and that of all, which counts as much as 2 · fitted of them."""
    own = max(count - fitted, 0)
    return (variances * own + pooled * 2 * fitted) / (own + 2 * fitted)


def slope_of_pulls(share: np.ndarray) -> float:
    """How much the pulls change with the pose, against their weights.

    Where a pull is at its limit it changes half as much, because it still turns there.

    Args:
        share: (n,) of ``huber``.
    """
    return float(1 - 0.5 * share[share < 1].sum() / share.sum())


def fisher_quantile(freedom: int) -> float:
    """Of Fisher's F with 2 and so many degrees of freedom, at 1 − CONFIDENCE_TAIL; closed form."""
    return freedom / 2 * (CONFIDENCE_TAIL ** (-2 / freedom) - 1)
