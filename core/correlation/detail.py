"""Check of map correlation: agreement in the detail that the search did not use.

See docs/explanation/method.md#map-correlation.

The best of very many places agrees well by chance at the pixels of the first look, because it was chosen for that.
Finer detail took no part in the choice except in the last steps. At a wrong place it agrees hardly better than with the
image shifted by a few pixels, which shows what chance gives for this image on this ground. At the right place it
exceeds that clearly (peak-to-sidelobe ratio of correlation filters, Bolme et al. 2010).
"""

from __future__ import annotations

import cv2
import numpy as np

from .class_pyramid import EvidenceLevel, MapPyramid
from .refine import ScoredPose, map_under


def detail_at(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose) -> float:
    """Return how far the detail below the first look's pixels agrees better than with the image shifted.

    Args:
        image: Its evidence, at the decision's pixels.
        pose: Refined at those pixels.

    Returns:
        Standard deviations of the correlation with the shifted image; 0 without such detail.
    """
    window = _window(image, pyramid.settings.coarse_edge)
    seen, there = finer(image.evidence, window), finer(map_under(image, pyramid, pose)[0], window)
    product = np.fft.rfft2(there, axes=(0, 1)) * np.conj(np.fft.rfft2(seen, axes=(0, 1)))
    correlation = np.fft.irfft2(product.sum(axis=2), s=seen.shape[:2])
    down, right = (np.minimum(np.arange(edge), edge - np.arange(edge)) for edge in seen.shape[:2])
    aside = correlation[np.maximum(down[:, None], right) >= window]
    spread = float(aside.std()) if aside.size else 0.0
    return float(correlation[0, 0]) / spread if spread > 0 and window > 1 else 0.0


def _window(image: EvidenceLevel, coarse_edge: int) -> int:
    """Return the odd edge, in pixels of the image, of at least a pixel of the first look; 1 if they are the same."""
    height, width = image.known.shape
    return 2 * int(np.sqrt(height * width) / coarse_edge / 2) + 1


def finer(planes: np.ndarray, window: int) -> np.ndarray:
    """Return (H, W, C) minus the mean over ``window``² pixels around."""
    return planes - cv2.blur(planes, (window, window), borderType=cv2.BORDER_REFLECT).reshape(planes.shape)
