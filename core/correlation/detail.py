"""Map correlation's second opinion: whether what the search did not look at agrees, too.

Told in docs/explanation/method.md#map-correlation.

The best of very many places agrees well by chance alone, because it was chosen for that: at the pixels of the first
look. What is finer than those took no part in the choice but for the last few steps. At a wrong place it agrees hardly
better than with the image moved aside there by a few pixels, which tells what chance gives for just this image on just
this ground; at the right one it stands out (the peak-to-sidelobe ratio of correlation filters, Bolme et al. 2010).
"""

from __future__ import annotations

import cv2
import numpy as np

from .class_pyramid import EvidenceLevel, MapPyramid
from .refine import ScoredPose, map_under


def detail_at(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose) -> float:
    """How far what is finer than the first look's pixels agrees better than with the image moved aside.

    Args:
        image: Its evidence, at the decision's pixels.
        pose: As refined at those pixels.

    Returns:
        In standard deviations of the correlation with the moved image; 0 where nothing is that fine.
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
    """Odd edge, pixels of the image, that a pixel of the first look has at least; 1 where it is one of them."""
    height, width = image.known.shape
    return 2 * int(np.sqrt(height * width) / coarse_edge / 2) + 1


def finer(planes: np.ndarray, window: int) -> np.ndarray:
    """(H, W, C) less the mean over ``window``² pixels around."""
    return planes - cv2.blur(planes, (window, window), borderType=cv2.BORDER_REFLECT).reshape(planes.shape)
