"""Agreement of a photo's edges with the outlines of the map's classes at one pose.

See docs/explanation/method.md#map-correlation. A network that knows other countries only labels many roofs wrongly, but
their edges are in the photo and on the map. Both become planes of directions: the angle of an edge is doubled, so that
it is the same from light to dark and from dark to light (Granlund 1978). Edges in all directions, as those of trees,
cancel.
"""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np

from .class_pyramid import EvidenceLevel, centered

EDGE_SIGMA = 1.0
"""Standard deviation of the smoothing before gradients, pixels. Set by hand."""

AROUND = 13
"""Edge of the square, pixels, whose mean gradient is the unit of a photo's gradients: a faint roof in the shade counts
like a bright one [photos]."""

NEAR, ASIDE, FARTHEST = 2, 6, 20
"""Largest shift that still is the same place, and smallest and largest shift of the comparison, pixels. A pose is off
by up to two pixels; with FARTHEST of 12, 16 or 24, fewer photos had positions [photos]."""

EDGE_ENERGY = 2.0
"""Energy of edges in units of that of class areas, where both determine a pose. With 1 to 4, errors are about the same;
without edges, twice as large [photos]."""


def photo_edges(image: EvidenceLevel) -> np.ndarray | None:
    """Return (2, h, w) float32 directions of a photo's edges; None for an image of labels."""
    if image.picture is None:
        return None
    directions, strength = _directions(image.picture.astype(np.float32))
    usual = cv2.blur(strength, (AROUND, AROUND))
    return directions * (strength / np.maximum(strength + usual, 1e-6) * _inside(image.known))


def map_edges(evidence: np.ndarray, known: np.ndarray) -> np.ndarray:
    """Return (2, h, w) float32 directions of the outlines of classes, by their contrast.

    Args:
        evidence: (h, w, C) of the map under the photo; the result does not depend on its axes.
        known: (h, w) labeled share.
    """
    directions, strength = _directions(evidence)
    return directions * (strength * _inside(known))


def with_edges(image: EvidenceLevel) -> EvidenceLevel:
    """Return a photo with its edges as two more channels, with which a pose becomes more accurate; labels unchanged."""
    edges = photo_edges(image)
    if edges is None:
        return image
    return replace(image, evidence=joined(image.evidence, edges), has_edges=True)


def joined(evidence: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """Return (h, w, C + 2) float32: evidence (h, w, C) and edges (2, h, w), which get ``EDGE_ENERGY``."""
    energy, of_edges = float((centered(evidence) ** 2).sum()), float((edges**2).sum())
    scale = np.float32(np.sqrt(EDGE_ENERGY * energy / max(of_edges, 1e-9)))
    return np.dstack([evidence, *(scale * edges)])


def agreement(photo: np.ndarray, there: np.ndarray) -> float:
    """Return the correlation of edges (2, h, w), in standard deviations of that with the photo shifted; 0 without any.

    The mean of the shifted ones is subtracted. The best of the shifts up to ``NEAR`` counts.
    """
    height, width = photo.shape[1:]
    size = tuple(cv2.getOptimalDFTSize(edge + FARTHEST) for edge in (height, width))
    product = np.fft.rfft2(photo, s=size) * np.conj(np.fft.rfft2(there, s=size))
    around = np.fft.irfft2(product.sum(axis=0), s=size)
    shifts = np.arange(-FARTHEST, FARTHEST + 1)
    around = around[shifts[:, None], shifts]
    apart = np.maximum(np.abs(shifts)[:, None], np.abs(shifts))
    aside = around[apart > ASIDE]
    spread = float(aside.std())
    return float(around[apart <= NEAR].max() - aside.mean()) / spread if spread > 0 else 0.0


def _inside(known: np.ndarray) -> np.ndarray:
    """Return (h, w) bool of pixels with labels all around: the end of an image or a map is no outline of a class."""
    return cv2.erode((known > 0.5).astype(np.uint8), np.ones((7, 7), np.uint8)) > 0


def _directions(planes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (2, h, w) unit vectors of the doubled angle of the gradient of (h, w, C) planes, and its (h, w) norm."""
    smooth = cv2.GaussianBlur(planes, (0, 0), EDGE_SIGMA).reshape(planes.shape)
    right, down = (cv2.Sobel(smooth, cv2.CV_32F, *step).reshape(planes.shape) for step in ((1, 0), (0, 1)))
    across, slanting = (right**2 - down**2).sum(axis=2), 2 * (right * down).sum(axis=2)
    energy = (right**2 + down**2).sum(axis=2)
    return np.stack([across, slanting]) / np.maximum(energy, 1e-9), np.sqrt(energy)
