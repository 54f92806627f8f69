"""What can be recognized of an image in another one: its corners, described, and its picture of even contrast.

Told in docs/explanation/method.md#relative-motion. An image is looked at in a smaller version whose longer edge has
``WORKING_EDGE`` pixels at most: a link is exact to a part of a pixel of that, which is more than a flight needs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import cv2
import numpy as np

from ..errors import ImageError
from ..geometry.leveling import Leveling

WORKING_EDGE = 800
"""Pixels of the longer edge that an image is brought to, at most."""

CORNERS = 2000
"""Corners that are described of an image, at most."""

CORNER_CONTRAST = 12
"""Gray levels of 255 by which a corner differs from what lies around it, in the picture of even contrast."""

EVENED_OVER_PX = 12.0
"""Standard deviation of the Gaussian that brightness and contrast are evened out over."""

LEAST_CONTRAST = 6.0
"""Gray levels: ground that differs by less stays flat, so that noise is not taken for texture."""

EVEN_CONTRAST = 40.0
"""Gray levels that one standard deviation becomes."""

LEAST_EDGE = 64
"""Working pixels: smaller images have no corners that could be described."""

LABEL_BLUR_PX = 1.5
"""Boundaries of label images are softened by so much: those of two images differ by a pixel or two."""

REACH_PX = 40.0
"""Distances from the next boundary are told up to this one."""

_LEVEL_RATIO = 1.2
"""Between levels of ORB's pyramid, its default."""

_GOLDEN = 0.6180339887498949


@dataclass(frozen=True)
class Features:
    """An image as others are compared with it.

    Attributes:
        picture_hw: (h, w) uint8, evened out, of the working size.
        points: (N, 2) corners from the image's center, right and down, working pixels.
        descriptors: (N, 32) uint8 of ORB.
        is_known_hw: (h, w) bool: where the image shows something; None everywhere.
        scale: Pixels of the image that a working pixel has.
    """

    picture_hw: np.ndarray = field(repr=False)
    points: np.ndarray = field(repr=False)
    descriptors: np.ndarray = field(repr=False)
    is_known_hw: np.ndarray | None = field(repr=False)
    scale: float


def photo_features(photo: np.ndarray, has_data_hw: np.ndarray | None = None, width: int | None = None) -> Features:
    """Features of a photo.

    Args:
        photo: (H, W, 3) red, green and blue or (H, W) gray, uint8.
        has_data_hw: (H, W) bool: where it has data; None everywhere.
        width: Pixels across of the image in whose pixels links are told, of the same view; the photo's own if None.

    Raises:
        ImageError: It is no photo of 8 bits.
    """
    if photo.dtype != np.uint8 or photo.ndim not in (2, 3) or not photo.size or photo.shape[2:] not in ((), (3,)):
        raise ImageError(
            "This is no photo or label image of 8 bits: its pixels are {shape} of {kind}.",
            shape=photo.shape,
            kind=photo.dtype,
        )
    gray = cv2.cvtColor(photo, cv2.COLOR_RGB2GRAY) if photo.ndim == 3 else photo
    return _features(gray.astype(np.uint8, copy=False), has_data_hw, width)


def features_of(
    level_hw: np.ndarray, photo: tuple[np.ndarray, np.ndarray | None] | None, way: Leveling | None
) -> Features:
    """Features of a flight's image: of its photo where there is one, else of its labels.

    Args:
        level_hw: (H', W') uint8 labels, leveled.
        photo: (H, W, 3) pixels and (H, W) bool where there is data (None everywhere), as taken; None without a photo.
        way: How the image is leveled; None as it is.
    """
    if photo is None:
        return label_features(level_hw)
    pixels_hw3, has_data_hw = photo
    if way is not None:
        seen_hw = np.ones(pixels_hw3.shape[:2], np.uint8) if has_data_hw is None else has_data_hw.astype(np.uint8)
        pixels_hw3, has_data_hw = way.level(pixels_hw3), way.level(seen_hw) > 0
    return photo_features(pixels_hw3, has_data_hw, level_hw.shape[1])


def label_features(labels_hw: np.ndarray, width: int | None = None) -> Features:
    """Features of a label image, by its boundaries.

    Args:
        labels_hw: (H, W) uint8, 0 = unknown.
        width: As of ``photo_features``.

    Raises:
        ImageError: It is no label image.
    """
    if labels_hw.dtype != np.uint8 or labels_hw.ndim != 2 or not labels_hw.size:
        raise ImageError(
            "This is no photo or label image of 8 bits: its pixels are {shape} of {kind}.",
            shape=labels_hw.shape,
            kind=labels_hw.dtype,
        )
    shades = (25 + 205 * (np.arange(256) * _GOLDEN % 1)).astype(np.uint8)
    is_boundary = np.zeros(labels_hw.shape, bool)
    is_boundary[:, 1:] |= labels_hw[:, 1:] != labels_hw[:, :-1]
    is_boundary[1:] |= labels_hw[1:] != labels_hw[:-1]
    distances = cv2.distanceTransform((~is_boundary).astype(np.uint8), cv2.DIST_L2, 5)
    reach = REACH_PX * max(1.0, max(labels_hw.shape) / WORKING_EDGE)
    near = 1 - np.minimum(distances, reach) / reach
    drawn = cv2.GaussianBlur((0.5 * shades[labels_hw] + 127 * near).astype(np.uint8), (0, 0), LABEL_BLUR_PX)
    is_known = labels_hw > 0
    return _features(drawn, None if is_known.all() else is_known, width)


def _features(gray_hw: np.ndarray, is_known_hw: np.ndarray | None, width: int | None) -> Features:
    height, own_width = gray_hw.shape
    factor = max(1.0, max(height, own_width) / WORKING_EDGE)
    size = max(1, round(own_width / factor)), max(1, round(height / factor))
    if factor > 1:
        gray_hw = cv2.resize(gray_hw, size, interpolation=cv2.INTER_AREA)
        if is_known_hw is not None:
            is_known_hw = cv2.resize(is_known_hw.astype(np.uint8), size, interpolation=cv2.INTER_NEAREST) > 0
    picture = even_contrast(gray_hw)
    points, descriptors = _corners(picture, is_known_hw)
    return Features(picture, points, descriptors, is_known_hw, (width or own_width) / size[0])


def _corners(picture_hw: np.ndarray, is_known_hw: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
    """(N, 2) from the center and (N, 32) uint8: corners where the picture shows something, and how they look."""
    found: Sequence[cv2.KeyPoint] = ()
    descriptors = None
    if min(picture_hw.shape) >= LEAST_EDGE:
        mask = None if is_known_hw is None else is_known_hw.astype(np.uint8)
        detector = cv2.ORB.create(CORNERS, scaleFactor=_LEVEL_RATIO, fastThreshold=CORNER_CONTRAST)
        found, descriptors = detector.detectAndCompute(picture_hw, mask)
    if descriptors is None:
        return np.zeros((0, 2)), np.zeros((0, 32), np.uint8)
    points = np.array([corner.pt for corner in found], np.float64).reshape(-1, 2)
    levels = _LEVEL_RATIO ** np.array([corner.octave for corner in found], np.float64)
    # Of a coarser level ORB tells where the pixel's first corner lies, not its center.
    return points + 0.5 * (levels - 1)[:, None] - (np.array(picture_hw.shape[::-1]) - 1) / 2, descriptors


def even_contrast(gray_hw: np.ndarray) -> np.ndarray:
    """(H, W) uint8 of even brightness and contrast: what exposure, vignetting and haze change is gone.

    Args:
        gray_hw: (H, W) uint8.
    """
    gray = gray_hw.astype(np.float32)
    around = cv2.GaussianBlur(gray, (0, 0), EVENED_OVER_PX)
    detail = gray - around
    spread = cv2.sqrt(cv2.GaussianBlur(detail * detail, (0, 0), EVENED_OVER_PX))
    return np.clip(127.5 + EVEN_CONTRAST * detail / (spread + LEAST_CONTRAST), 0, 255).astype(np.uint8)
