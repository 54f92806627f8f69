"""Sources of photos, read piece by piece, so that an orthophoto never has to fit into memory."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np


class ImageSource(Protocol):
    """A color image that is read in pieces; rasters on disk implement it outside ``core``."""

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""

    def read(self, column: int, row: int, width: int, height: int) -> tuple[np.ndarray, np.ndarray | None]:
        """Read (height, width, 3) uint8 pixels, red first, and (height, width) bool of pixels with data (None: all).

        Pixels without data are 0, or unchanged if they are only unwanted. The piece must be inside the image.
        Callers read row by row of tiles, from top to bottom.
        """


class ArrayImage:
    """An image in memory, (H, W, 3) uint8, red first."""

    def __init__(self, image_hw3: np.ndarray, has_data_hw: np.ndarray | None = None) -> None:
        """Wrap the image without a copy.

        Args:
            image_hw3: (H, W, 3) uint8, red first.
            has_data_hw: (H, W) bool, pixels with data; None for all.
        """
        self._image_hw3, self._has_data_hw = image_hw3, has_data_hw
        self.shape_hw = image_hw3.shape[0], image_hw3.shape[1]

    def read(self, column: int, row: int, width: int, height: int) -> tuple[np.ndarray, np.ndarray | None]:
        """Return views of a piece of the image and of its data mask."""
        piece = slice(row, row + height), slice(column, column + width)
        return self._image_hw3[piece], None if self._has_data_hw is None else self._has_data_hw[piece]


@dataclass(frozen=True)
class Photo:
    """A photo from a file.

    Attributes:
        pixel_size_m: Ground meters along a row and along a column of a pixel; None if the file does not state them.
    """

    image: ImageSource
    pixel_size_m: tuple[float, float] | None


class ImagePart:
    """A piece of another image, as an image of its own."""

    def __init__(self, image: ImageSource, column: int, row: int, shape_hw: tuple[int, int]) -> None:
        """Read nothing yet.

        Args:
            column: First column in the whole image.
            row: First row in the whole image.
            shape_hw: (height, width) of the piece, which must be inside the image.
        """
        self._image, self._column, self._row, self.shape_hw = image, column, row, shape_hw

    def read(self, column: int, row: int, width: int, height: int) -> tuple[np.ndarray, np.ndarray | None]:
        """Read a piece; see ``ImageSource``."""
        return self._image.read(self._column + column, self._row + row, width, height)


class PixelMask(Protocol):
    """Mask of the wanted pixels of an image, read in pieces."""

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """Return (height, width) bool of a piece inside the image."""


class MaskedImage:
    """An image with a mask; unwanted pixels have no data but stay visible as surroundings of wanted ones."""

    def __init__(self, image: ImageSource, mask: PixelMask) -> None:
        self._image, self._mask, self.shape_hw = image, mask, image.shape_hw

    def read(self, column: int, row: int, width: int, height: int) -> tuple[np.ndarray, np.ndarray | None]:
        """Read a piece, see ``ImageSource``; a piece outside the mask is not read."""
        wanted = self._mask.read(column, row, width, height)
        if not wanted.any():
            return np.zeros((height, width, 3), np.uint8), wanted
        pixels, has_data = self._image.read(column, row, width, height)
        return pixels, wanted if has_data is None else wanted & has_data
