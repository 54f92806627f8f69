"""Features that identify an image in another one: described corners and a picture of even contrast.

See docs/explanation/method.md#relative-motion. Images are reduced to a longer edge of at most ``WORKING_EDGE`` pixels.
A link is accurate to a fraction of such a pixel, more than a flight needs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import cv2
import numpy as np

from ..errors import ImageError
from ..geometry.leveling import Leveling

WORKING_EDGE = 800
"""Longest edge of the reduced image, pixels."""

CORNERS = 2000
"""Most corners of an image."""

CORNER_CONTRAST = 12
"""Least difference of a corner from its surroundings, in gray levels of 255, in the picture of even contrast."""

EVENED_OVER_PX = 12.0
"""Standard deviation of the Gaussian that evens out brightness and contrast."""

LEAST_CONTRAST = 6.0
"""Gray levels. Ground with less contrast stays flat, so that noise does not become texture."""

EVEN_CONTRAST = 40.0
"""Gray levels of one standard deviation in the picture of even contrast."""

LEAST_EDGE = 64
"""Smallest edge of a picture for corners, working pixels."""

LABEL_BLUR_PX = 1.5
"""Blur of label images: their boundaries differ by a pixel or two between two images."""

REACH_PX = 40.0
"""Largest distance from the next boundary in a drawn label image."""

_LEVEL_RATIO = 1.2
"""Ratio of neighboring levels of ORB's pyramid, its default."""

_GOLDEN = 0.6180339887498949


@dataclass(frozen=True)
class Features:
    """An image prepared for comparison with others.

    Attributes:
        picture_hw: (h, w) uint8, of even contrast, in working size.
        points: (N, 2) corners from the image's center, right and down, working pixels.
        descriptors: (N, 32) uint8 of ORB.
        is_known_hw: (h, w) bool: pixels with data; None if all have data.
        scale: Pixels of the image in a working pixel.
    """

    picture_hw: np.ndarray = field(repr=False)
    points: np.ndarray = field(repr=False)
    descriptors: np.ndarray = field(repr=False)
    is_known_hw: np.ndarray | None = field(repr=False)
    scale: float

    @cached_property
    def sums(self) -> tuple[np.ndarray, np.ndarray]:
        """(h + 1, w + 1) integral images of the picture around its middle gray, and of its square."""
        picture = self.picture_hw.astype(np.float32) - 127.5
        return cv2.integral(picture, sdepth=cv2.CV_64F), cv2.integral(picture * picture, sdepth=cv2.CV_64F)


def photo_features(photo: np.ndarray, has_data_hw: np.ndarray | None = None, width: int | None = None) -> Features:
    """Return the features of a photo.

    Args:
        photo: (H, W, 3) red, green and blue or (H, W) gray, uint8.
        has_data_hw: (H, W) bool: pixels with data; None for all.
        width: Width, in pixels, of the image that defines the pixels of links; None for the photo itself.

    Raises:
        ImageError: The array is not a photo of 8 bits.
    """
    _require_8_bits(photo, photo.ndim in (2, 3) and photo.shape[2:] in ((), (3,)))
    gray = cv2.cvtColor(photo, cv2.COLOR_RGB2GRAY) if photo.ndim == 3 else photo
    return _features(gray.astype(np.uint8, copy=False), has_data_hw, width)


def features_of(
    level_hw: np.ndarray, photo: tuple[np.ndarray, np.ndarray | None] | None, way: Leveling | None
) -> Features:
    """Return the features of a flight's image: of its photo if there is one, otherwise of its labels.

    Args:
        level_hw: (H', W') uint8 labels, leveled.
        photo: (H, W, 3) pixels as taken, and (H, W) bool of pixels with data (None for all); None without a photo.
        way: Leveling of the image; None without leveling.
    """
    if photo is None:
        return label_features(level_hw)
    pixels_hw3, has_data_hw = photo
    if way is not None:
        seen_hw = np.ones(pixels_hw3.shape[:2], np.uint8) if has_data_hw is None else has_data_hw.astype(np.uint8)
        pixels_hw3, has_data_hw = way.level(pixels_hw3), way.level(seen_hw) > 0
    return photo_features(pixels_hw3, has_data_hw, level_hw.shape[1])


def label_features(labels_hw: np.ndarray) -> Features:
    """Return the features of a label image, (H, W) uint8 with 0 = unknown, from its boundaries. Raises ImageError."""
    _require_8_bits(labels_hw, labels_hw.ndim == 2)
    shades = (25 + 205 * (np.arange(256) * _GOLDEN % 1)).astype(np.uint8)
    is_boundary = np.zeros(labels_hw.shape, bool)
    is_boundary[:, 1:] |= labels_hw[:, 1:] != labels_hw[:, :-1]
    is_boundary[1:] |= labels_hw[1:] != labels_hw[:-1]
    distances = cv2.distanceTransform((~is_boundary).astype(np.uint8), cv2.DIST_L2, 5)
    reach = REACH_PX * max(1.0, max(labels_hw.shape) / WORKING_EDGE)
    near = 1 - np.minimum(distances, reach) / reach
    drawn = cv2.GaussianBlur((0.5 * shades[labels_hw] + 127 * near).astype(np.uint8), (0, 0), LABEL_BLUR_PX)
    is_known = labels_hw > 0
    return _features(drawn, None if is_known.all() else is_known, None)


def _require_8_bits(image: np.ndarray, has_shape: bool) -> None:
    if image.dtype != np.uint8 or not image.size or not has_shape:
        raise ImageError(
            "This is not a photo or label image of 8 bits: its pixels are {shape} of {kind}.",
            shape=image.shape,
            kind=image.dtype,
        )


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
    """Return (N, 2) corners from the center and (N, 32) uint8 descriptors, where the picture has data."""
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
    # On coarser levels, ORB gives the first corner of the pixel, not its center.
    return points + 0.5 * (levels - 1)[:, None] - (np.array(picture_hw.shape[::-1]) - 1) / 2, descriptors


def even_contrast(gray_hw: np.ndarray) -> np.ndarray:
    """Return (H, W) uint8 with even brightness and contrast: without effects of exposure, vignetting and haze.

    Args:
        gray_hw: (H, W) uint8.
    """
    gray = gray_hw.astype(np.float32)
    around = cv2.GaussianBlur(gray, (0, 0), EVENED_OVER_PX)
    detail = gray - around
    spread = cv2.sqrt(cv2.GaussianBlur(detail * detail, (0, 0), EVENED_OVER_PX))
    return np.clip(127.5 + EVEN_CONTRAST * detail / (spread + LEAST_CONTRAST), 0, 255).astype(np.uint8)
