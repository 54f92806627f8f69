"""Resample photos piece by piece to the resolution that a network was trained on.

The arithmetic is exact: weights are integers, so a pixel has exactly the same value in every piece and on every
computer, in QGIS and on board. OpenCV and GDAL both resample in floating point, and OpenCV only whole images.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import gcd, sqrt

import numpy as np

from ..errors import ImageError
from ..labels.image_source import ImageSource

SAME_RESOLUTION = 0.05
"""Largest relative difference of resolutions for an image that is not resampled."""


def at_resolution(
    image: ImageSource, pixel_size_m: tuple[float, float] | None, resolution_m: float | None
) -> ImageSource:
    """Return a photo at a network's resolution: means where it shrinks, bilinear where it grows.

    Args:
        pixel_size_m: Ground meters along a row and along a column of one of its pixels; None if unknown.
        resolution_m: Ground meters per pixel of the network; None if not stated.

    Returns:
        The resampled photo, or ``image`` itself if a resolution is unknown or both are equal within
        ``SAME_RESOLUTION``.

    Raises:
        ImageError: The image has no pixel left at that resolution.
    """
    if pixel_size_m is None or not resolution_m:
        return image
    if max(abs(size / resolution_m - 1) for size in pixel_size_m) < SAME_RESOLUTION:
        return image
    height, width = image.shape_hw
    width, height = (round(size * edge / resolution_m) for size, edge in zip(pixel_size_m, (width, height)))
    if min(width, height) < 1:
        raise ImageError(
            "At {resolution_cm:g} cm per pixel the image has no pixel left; choose a finer resolution.",
            resolution_cm=100 * resolution_m,
        )
    return ResampledImage(image, (height, width))


def resized_transform(
    transform: tuple[float, ...] | None, old_hw: tuple[int, int], new_hw: tuple[int, int]
) -> tuple[float, ...] | None:
    """Return GDAL's six numbers of an image after resizing; None for None.

    Heights and widths are integers, so pixels would be slightly longer than wide, and their labels useless as a map. If
    that is the only difference, they become squares around the image's middle: its edges move by at most half a pixel.

    Args:
        transform: Of the image before.
        old_hw: (height, width) before.
        new_hw: (height, width) after.
    """
    if transform is None or old_hw == new_hw:
        return transform
    x, x_column, x_row, y, y_column, y_row = transform
    down, across = (old / new for old, new in zip(old_hw, new_hw))
    columns, rows = across * complex(x_column, y_column), down * complex(x_row, y_row)
    width, height = abs(columns), abs(rows)
    middle = complex(x, y) + columns * new_hw[1] / 2 + rows * new_hw[0] / 2
    if abs(width / height - 1) * max(new_hw) <= 1 + max(new_hw) / min(new_hw):
        edge = sqrt(width * height)
        columns, rows = columns * edge / width, rows * edge / height
    first = middle - columns * new_hw[1] / 2 - rows * new_hw[0] / 2
    return first.real, columns.real, rows.real, first.imag, columns.imag, rows.imag


class ResampledImage:
    """An ImageSource of another size: means of pixels where it gets narrower, otherwise bilinear.

    Pixels without data are ignored; a new pixel has data if any of its old ones has.
    """

    def __init__(self, image: ImageSource, shape_hw: tuple[int, int]) -> None:
        self._image = image
        self.shape_hw = shape_hw
        shrinks = shape_hw[1] < image.shape_hw[1]
        self._rows, self._columns = (_Axis(old, new, shrinks) for old, new in zip(image.shape_hw, shape_hw))

    def read(self, column: int, row: int, width: int, height: int) -> tuple[np.ndarray, np.ndarray | None]:
        """Return a piece of the resampled image, see ``ImageSource``."""
        rows, columns = self._rows.taps(row, height), self._columns.taps(column, width)
        pixels, has_data = self._image.read(columns.first, rows.first, columns.count, rows.count)
        total = float(self._rows.total * self._columns.total)
        if has_data is None:
            return _rounded(_weighted(pixels, rows, columns), total), None
        with_data = has_data.astype(np.uint8)[..., None]
        sums = _weighted(np.concatenate([pixels * with_data, with_data], axis=2), rows, columns)
        weights = sums[..., 3:]
        found = weights[..., 0] > 0
        return _rounded(sums[..., :3], np.maximum(weights, 1)), None if found.all() else found


@dataclass(frozen=True)
class _Taps:
    """Old pixels that form a run of new ones.

    Attributes:
        first: The first old pixel.
        count: Number of old pixels from there.
        places: (N, K) intp, for each new pixel its K old ones, counted from ``first``.
        weights: (N, K) float64 integers.
    """

    first: int
    count: int
    places: np.ndarray
    weights: np.ndarray


class _Axis:
    """Rows or columns: how ``old`` pixels become ``new`` ones, with weights that sum to ``total``."""

    def __init__(self, old: int, new: int, shrinks: bool) -> None:
        common = gcd(old, new)
        self._old = old
        # A new pixel is numerator / denominator old ones wide.
        self._numerator, self._denominator = old // common, new // common
        self._shrinks = shrinks
        self.total = self._numerator if shrinks else 2 * self._denominator

    def taps(self, first: int, count: int) -> _Taps:
        """Return the old pixels and weights of ``count`` new pixels from ``first``."""
        wanted = np.arange(first, first + count, dtype=np.int64)
        places, weights = self._means(wanted) if self._shrinks else self._between(wanted)
        places = np.clip(places, 0, self._old - 1)
        start = int(places.min())
        return _Taps(start, int(places.max()) + 1 - start, places - start, weights.astype(np.float64))

    def _means(self, wanted: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Weigh each old pixel by its share inside the new one, in units of 1 / denominator of an old one."""
        begin = wanted * self._numerator
        end = begin + self._numerator
        most = 2 + (self._numerator - 1) // self._denominator
        places = begin[:, None] // self._denominator + np.arange(most)
        from_, to = places * self._denominator, (places + 1) * self._denominator
        weights = np.minimum(end[:, None], to) - np.maximum(begin[:, None], from_)
        return places, np.maximum(weights, 0)

    def _between(self, wanted: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the old pixels with centers on both sides of the new one's, weighed in units of half a new pixel."""
        center = (2 * wanted + 1) * self._numerator - self._denominator
        before = center // (2 * self._denominator)
        beyond = center - before * 2 * self._denominator
        return np.stack([before, before + 1], axis=1), np.stack([2 * self._denominator - beyond, beyond], axis=1)


def _weighted(pixels: np.ndarray, rows: _Taps, columns: _Taps) -> np.ndarray:
    """Return (N, M, C) float64 weighted sums of (H, W, C) uint8: integers below 2⁵³ for up to 10¹² pixels."""
    _, width, bands = pixels.shape
    by_row = _sums_along(pixels.reshape(len(pixels), -1), rows).reshape(-1, width, bands)
    by_column = _sums_along(by_row.swapaxes(0, 1).reshape(width, -1), columns)
    return by_column.reshape(-1, len(by_row), bands).swapaxes(0, 1)


def _sums_along(values: np.ndarray, taps: _Taps) -> np.ndarray:
    """Return (N, X) float64 weighted sums of rows of the (Y, X) values for each new row."""
    sums = np.zeros((len(taps.places), values.shape[1]))
    for places, weights in zip(taps.places.T, taps.weights.T):
        sums += np.multiply(values[places], weights[:, None], dtype=np.float64)
    return sums


def _rounded(sums: np.ndarray, totals: float | np.ndarray) -> np.ndarray:
    """Return sums / totals as uint8, halves rounded up."""
    return ((sums + totals / 2) / totals).astype(np.uint8)
