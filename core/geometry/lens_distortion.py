"""Lens distortion: convert between the pixels of an image and those of a pinhole camera.

The model is Brown's, as in OpenCV and DJI's “dewarp data”. A ray that meets the plane at focal length 1 in (x, y),
x right, y down, r² = x² + y², appears at

    x · s + 2 p₁ x y + p₂ (r² + 2 x²),   y · s + p₁ (r² + 2 y²) + 2 p₂ x y,
    s = (1 + k₁ r² + k₂ r⁴ + k₃ r⁶) / (1 + k₄ r² + k₅ r⁴ + k₆ r⁶)

Lengths are in widths of the photo, so that they are valid for label images of any size.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

ROUNDS, EXACT = 50, 1e-7
"""Largest number of iterations of the inversion, and the remaining error, in widths, that ends it."""

SAMPLES = 33
"""Points along each edge of an image, for checking a lens and measuring its ground."""


@dataclass(frozen=True)
class LensDistortion:
    """Calibration of a lens.

    Attributes:
        focal_xy: Focal length along rows and along columns, widths of the photo.
        center_xy: Principal point, right and down from the photo's center, widths of the photo.
        radial: k₁, k₂, k₃, then k₄, k₅, k₆ or nothing.
        tangential: p₁, p₂.
    """

    focal_xy: tuple[float, float]
    center_xy: tuple[float, float]
    radial: tuple[float, ...]
    tangential: tuple[float, float] = (0.0, 0.0)

    def seen(self, rays_xy: np.ndarray) -> np.ndarray:
        """Return (…, 2) positions of rays at focal length 1, right and down from the photo's center in widths."""
        x, y = rays_xy[..., 0], rays_xy[..., 1]
        square = x**2 + y**2
        above, below = (*self.radial[:3],), (*self.radial[3:],)
        scale = _polynomial(above, square) / _polynomial(below, square)
        first, second = self.tangential
        bent_x = x * scale + 2 * first * x * y + second * (square + 2 * x**2)
        bent_y = y * scale + first * (square + 2 * y**2) + 2 * second * x * y
        (focal_x, focal_y), (center_x, center_y) = self.focal_xy, self.center_xy
        return np.stack([center_x + focal_x * bent_x, center_y + focal_y * bent_y], axis=-1)

    def rays(self, seen_xy: np.ndarray) -> np.ndarray:
        """Return (…, 2) rays at focal length 1 of positions right and down from the photo's center in widths.

        NaN where no ray near the undistorted one appears.
        """
        focal, center = np.array(self.focal_xy), np.array(self.center_xy)
        plain = (np.asarray(seen_xy, float) - center) / focal
        rays = plain.copy()
        for _ in range(ROUNDS):
            rest = (seen_xy - self.seen(rays)) / focal
            rays = rays + rest
            if np.fmax.reduce(np.abs(rest), axis=None, initial=0.0) < EXACT:
                break
        with np.errstate(invalid="ignore"):
            is_exact = np.abs(seen_xy - self.seen(rays)).max(axis=-1) < 100 * EXACT
        return np.where(is_exact[..., None], rays, np.nan)

    def shift(self, ratio: float) -> float:
        """Return the largest shift of a pixel of an image, widths; ``ratio``: its height to its width."""
        edge = border(ratio)
        rays = self.rays(edge)
        plain = rays * np.array(self.focal_xy) + np.array(self.center_xy)
        return float(np.abs(np.hypot(*(plain - edge).T)).max())

    def is_usable(self, ratio: float) -> bool:
        """Return whether every pixel of an image comes from one ray; ``ratio``: its height to its width."""
        if not (min(self.focal_xy) > 0 and np.isfinite([*self.focal_xy, *self.center_xy, *self.radial]).all()):
            return False
        with np.errstate(all="ignore"):
            rays = self.rays(border(ratio))
            if not np.isfinite(rays).all():
                return False
            # Along a ray from the center to every corner, the distance must grow.
            steps = np.linspace(0, 1, SAMPLES)[:, None, None] * rays
            lengths = np.hypot(*np.moveaxis(self.seen(steps) - np.array(self.center_xy), -1, 0))
        return bool((np.diff(lengths, axis=0) > 0).all())


def border(ratio: float) -> np.ndarray:
    """Return (n, 2) points around an image, right and down from its center in widths, corners included.

    Args:
        ratio: Height to width.
    """
    along = np.linspace(-0.5, 0.5, SAMPLES)
    edge = np.full(SAMPLES, 0.5)
    right = np.concatenate([along, edge, -along, -edge])
    down = np.concatenate([-edge, along, edge, -along]) * ratio
    return np.column_stack([right, down])


def _polynomial(factors: tuple[float, ...], square: np.ndarray) -> np.ndarray:
    """Return 1 + f₁ r² + f₂ r⁴ and so on."""
    found = np.zeros_like(square)
    for factor in reversed(factors):
        found = (found + factor) * square
    return 1 + found
