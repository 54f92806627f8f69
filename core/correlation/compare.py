"""Compare an image with a map at one pose.

See docs/explanation/method.md#map-correlation. Only ground where both have labels is used to refine the pose. If
unknown ground counted as average ground, as it does in the score, the map's edge would attract the image.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from .class_pyramid import EvidenceLevel, centered

LEAST_KNOWN = 0.5
"""Least labeled share of the map under a place in the search."""

LEAST_KNOWN_MOVED = 0.4
"""Least labeled share during refinement: smaller, so that the limit does not stop places at the map's edge."""

LEAST_WHOLE = 0.95
"""Least labeled share of every pixel at which the whole image is compared; shares of 8 bits are rounded."""

NOT_COMPARABLE = -1.0
"""Score if the map has too few labels under the image, or if either is uniform."""


@dataclass(frozen=True)
class Comparison:
    """An image and the map at a pose, without the mean of each channel.

    Attributes:
        score: Correlation −1…1 by which places are ranked, or NOT_COMPARABLE. Unknown ground counts as average ground,
            so that a place half beyond the map's edge does not match easily.
        fit: Correlation where both have labels, times the root of their share of the image, or NOT_COMPARABLE. It is
            highest at the most accurate pose; without the share, little common ground would fit best.
        seen: (h, w · C) evidence of the image, scaled to the norm of the map's. With the factor of a linear regression,
            places where the map is more uniform would attract poor labels.
        there: (h, w · C) of the map.
        weights: (h, w · C) of slopes, 0 at unknown ground; None for the whole image.
    """

    score: float
    fit: float
    seen: np.ndarray
    there: np.ndarray
    weights: np.ndarray | None = None

    def slopes(self, slopes: np.ndarray) -> np.ndarray:
        """Return the slopes (P, h, w · C) without those of unknown ground."""
        return slopes if self.weights is None else slopes * self.weights


def compare(
    image: EvidenceLevel, patch: np.ndarray, known: np.ndarray, quiet: float, least_known: float | None = None
) -> Comparison:
    """Compare an image with the map under it.

    Args:
        image: Its evidence.
        patch: (h, w, C) evidence of the map.
        known: (h, w) labeled share of the map.
        quiet: Energy per pixel that is added to the map's own in the score.
        least_known: Least labeled share of the map; that of refinement if None.
    """
    seen, there, weights, share = image.centered, centered(patch), None, 1.0
    norm, energy, product = _products(seen, there)
    least_known = LEAST_KNOWN_MOVED if least_known is None else least_known
    if known.mean() < least_known or norm <= 0 or energy <= 0:
        return Comparison(NOT_COMPARABLE, NOT_COMPARABLE, seen, there)
    score = product / float(np.sqrt(norm * (energy + quiet * known.size)))
    if min(float(known.min()), image.least_known) < LEAST_WHOLE:
        both = known * image.known
        seen = centered(image.evidence * known[..., None], both)
        there = centered(patch * image.known[..., None], both)
        # Slopes use the pixels around.
        weights = np.repeat(cv2.erode(both, np.ones((3, 3), np.uint8)), patch.shape[2], axis=1)
        norm, energy, product = _products(seen, there)
        share = float(both.mean())
    if norm <= 0 or energy <= 0:
        return Comparison(score, NOT_COMPARABLE, seen, there)
    fit = product * float(np.sqrt(share / (norm * energy)))
    return Comparison(score, fit, np.float32(np.sqrt(energy / norm)) * seen, there, weights)


def _products(seen: np.ndarray, there: np.ndarray) -> tuple[float, float, float]:
    """Return the sums of squares of the image and of the map, and of their product."""
    return float((seen**2).sum()), float((there**2).sum()), float((seen * there).sum())
