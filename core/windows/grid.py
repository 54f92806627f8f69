"""Grid of the windows of a reference database on its label map (paper §3.1)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import WindowError


@dataclass(frozen=True)
class WindowGrid:
    """Windows of one size sliding over a map; only those completely inside it count, as in the paper.

    Attributes:
        width: Of the map, pixels.
        height: Of the map, pixels.
        size: Edge of a window, pixels.
        stride: From one window to the next, pixels.

    Raises:
        WindowError: No window fits on the map, or the stride would leave gaps.
    """

    width: int
    height: int
    size: int
    stride: int

    def __post_init__(self) -> None:
        if self.size < 1 or self.stride < 1:
            raise WindowError(
                "Window size ({size} px) and stride ({stride} px) must be at least one pixel; increase them.",
                size=self.size,
                stride=self.stride,
            )
        if self.stride > self.size:
            raise WindowError(
                "The stride ({stride} px) is larger than the window ({size} px), so windows would leave gaps; choose a "
                "stride up to the window size.",
                stride=self.stride,
                size=self.size,
            )
        if self.size > min(self.width, self.height):
            raise WindowError(
                "The window ({size} px) is larger than the map ({width} × {height} px); choose a smaller window or a "
                "larger map.",
                size=self.size,
                width=self.width,
                height=self.height,
            )

    @property
    def columns(self) -> np.ndarray:
        """First pixel column of each window of a row of windows."""
        return np.arange(0, self.width - self.size + 1, self.stride)

    @property
    def rows(self) -> np.ndarray:
        """First pixel row of each row of windows."""
        return np.arange(0, self.height - self.size + 1, self.stride)

    def __len__(self) -> int:
        return len(self.columns) * len(self.rows)


def window_name(column: int, row: int) -> str:
    """Return the name of a window, made of its first pixel as in the paper: ``5950_2100``."""
    return f"{column}_{row}"


def whole_pixels(length: float, pixel_size: float) -> int:
    """Return a length in map units as the nearest whole number of pixels."""
    return int(np.floor(length / pixel_size + 0.5))


def centered_square(shape_hw: Sequence[int]) -> tuple[int, int, int]:
    """Return the largest centered square of an image (docs/explanation/method.md#topology-vector).

    Args:
        shape_hw: (height, width) of the image, pixels.

    Returns:
        (first column, first row, size).
    """
    height, width = shape_hw
    size = min(height, width)
    return (width - size) // 2, (height - size) // 2, size
