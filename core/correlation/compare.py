"""Compare an image with a map at given poses, where both have labels.

See docs/explanation/method.md#map-correlation. Beyond the map's edge nothing is compared: otherwise the edge would
attract the image, because unknown ground counts as average ground.
"""

from __future__ import annotations

from dataclasses import dataclass

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
    """An image and the map at one or more poses, without the mean of each channel.

    Attributes:
        scores: (…) correlations −1…1, or NOT_COMPARABLE.
        seen: (…, h, w · C) evidence of the image, scaled to the norm of the map's; 0 if they don't agree. With another
            scale, places where the map is more uniform would attract poor labels.
        there: (…, h, w · C) of the map.
        weights: (…, h, w · C) of slopes, 0 at unknown ground; None for the whole image.
    """

    scores: np.ndarray
    seen: np.ndarray
    there: np.ndarray
    weights: np.ndarray | None

    def slopes(self, slopes: np.ndarray) -> np.ndarray:
        """Return the slopes (P, …, h, w · C) without those of unknown ground."""
        return slopes if self.weights is None else slopes * self.weights


def compare(
    image: EvidenceLevel,
    patches: np.ndarray,
    known: np.ndarray,
    quiet: float,
    least_known: float | None = None,
) -> Comparison:
    """Compare an image with the map under it.

    Args:
        image: Its evidence.
        patches: (…, h, w, C) evidence of the map at each pose.
        known: (…, h, w) labeled shares of the map.
        quiet: Energy per pixel that is added to the map's own in the score.
        least_known: Least labeled share; that of refinement if None.
    """
    seen, there, weights = image.centered, patches, None
    if min(float(known.min()), image.least_known) < LEAST_WHOLE:
        both = known * image.known
        seen = centered(image.evidence * known[..., None], both)
        there = centered(patches * image.known[..., None], both)
        weights = np.repeat(_without_rim(both), patches.shape[-1], axis=-1)
    else:
        there = centered(patches)
    norm, energy = (np.einsum("...hk,...hk->...", one, one) for one in (seen, there))
    product = np.einsum("...hk,...hk->...", seen, there)
    # The whole image is the measure: a small part of it agrees easily.
    scale = np.sqrt(np.maximum(image.energy * (energy + quiet * image.known.size), 1e-30))
    least_known = LEAST_KNOWN_MOVED if least_known is None else least_known
    is_usable = (known.mean(axis=(-2, -1)) >= least_known) & (energy > 0) & (norm > 0)
    scores = np.where(is_usable, product / scale, NOT_COMPARABLE)
    gains = np.where(scores > 0, np.sqrt(energy / np.maximum(norm, 1e-30)), 0.0).astype(np.float32)
    return Comparison(scores, gains[..., None, None] * seen, there, weights)


def _without_rim(shares: np.ndarray) -> np.ndarray:
    """Return (…, h, w) the smallest share of each pixel and its four neighbors, which its slopes use."""
    found = shares.copy()
    for axis in (-2, -1):
        here, around = np.moveaxis(found, axis, 0), np.moveaxis(shares, axis, 0)
        np.minimum(here[1:], around[:-1], out=here[1:])
        np.minimum(here[:-1], around[1:], out=here[:-1])
    return found
