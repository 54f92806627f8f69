"""Where photos come from, piece by piece, so that an orthophoto never has to fit into memory."""

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
        """Return (height, width, 3) uint8 pixels, red first, and (height, width) bool: where there is data; None everywhere.

        Pixels without data are 0, or as they are where they are merely not wanted. The piece lies wholly on the image.
        Pieces are asked for row by row of tiles, from top to bottom.
        """


class ArrayImage:
    """An image in memory, (H, W, 3) uint8, red first."""

    def __init__(self, image_hw3: np.ndarray, has_data_hw: np.ndarray | None = None) -> None:
        """Keep the image, without a copy.

        Args:
            image_hw3: (H, W, 3) uint8, red first.
            has_data_hw: (H, W) bool, where there is data; None everywhere.
        """
        self._image_hw3 = image_hw3
        self._has_data_hw = has_data_hw

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self._image_hw3.shape[0], self._image_hw3.shape[1]

    def read(self, column: int, row: int, width: int, height: int) -> tuple[np.ndarray, np.ndarray | None]:
        """Views of a piece of the image, and of where it has data."""
        piece = slice(row, row + height), slice(column, column + width)
        return self._image_hw3[piece], None if self._has_data_hw is None else self._has_data_hw[piece]


@dataclass(frozen=True)
class Photo:
    """A photo as its file has it.

    Attributes:
        image: Its pixels.
        pixel_size_m: Ground meters along a row and along a column of a pixel; None where the file does not say.
    """

    image: ImageSource
    pixel_size_m: tuple[float, float] | None


class ImagePart:
    """A piece of another image, as an image of its own."""

    def __init__(self, image: ImageSource, column: int, row: int, shape_hw: tuple[int, int]) -> None:
        """Nothing is read yet.

        Args:
            column: Of the whole, the piece's first.
            row: Of the whole, the piece's first.
            shape_hw: (height, width) of the piece, which lies wholly on the image.
        """
        self._image, self._column, self._row, self._shape_hw = image, column, row, shape_hw

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self._shape_hw

    def read(self, column: int, row: int, width: int, height: int) -> tuple[np.ndarray, np.ndarray | None]:
        """As the whole reads it."""
        return self._image.read(self._column + column, self._row + row, width, height)


class PixelMask(Protocol):
    """Which pixels of an image are wanted, told in pieces."""

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """Return (height, width) bool of a piece that lies wholly on the image."""


class MaskedImage:
    """An image of which only some pixels are wanted; the others have no data, but still surround those that have."""

    def __init__(self, image: ImageSource, mask: PixelMask) -> None:
        """Nothing is read yet.

        Args:
            mask: What of it is wanted.
        """
        self._image, self._mask = image, mask

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self._image.shape_hw

    def read(self, column: int, row: int, width: int, height: int) -> tuple[np.ndarray, np.ndarray | None]:
        """As ``ImageSource`` says; what lies wholly outside the mask is not read."""
        wanted = self._mask.read(column, row, width, height)
        if not wanted.any():
            return np.zeros((height, width, 3), np.uint8), wanted
        pixels, has_data = self._image.read(column, row, width, height)
        return pixels, wanted if has_data is None else wanted & has_data
