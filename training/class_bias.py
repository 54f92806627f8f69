"""Measure the class offsets of a network on validation tiles, for the model's metadata.

The network gets each tile rotated by 0, 90, 180 and 270 degrees. Offsets that rotate with the tile come from the
ground, for example from shadows. Offsets that do not rotate come from the network.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import numpy as np

from ..core.geometry.error_settings import ClassBias
from ..core.landmarks.class_shifts import ClassShift, PieceShift, class_shifts, piece_shifts

QUARTERS = 4
MOST_TILES = 100
"""Largest number of tiles; the network gets each of them four times."""


@dataclass(frozen=True)
class ClassShiftRow:
    """Offset of a class along the axes of the ground and of the image, pixels."""

    ground: ClassShift
    image: ClassShift

    def bias(self, pixel_m: float) -> ClassBias:
        """Return the offset in meters; tiles have north up."""
        east, north = pixel_m * self.ground.shift.real, -pixel_m * self.ground.shift.imag
        right, down = pixel_m * self.image.shift.real, pixel_m * self.image.shift.imag
        if self.ground.spread is None or self.image.spread is None:
            return ClassBias(0, east, north, right, down)
        return ClassBias(0, east, north, right, down, pixel_m * float(np.hypot(self.ground.spread, self.image.spread)))


def measure_class_biases(
    answer: Callable[[np.ndarray], np.ndarray], reader: object, channels: int
) -> list[ClassShiftRow]:
    """Return the offset of each channel from 1 on with enough landmarks.

    Args:
        answer: Function from image (H, W, 3) to channels (H, W).
        reader: Sequence of images with their true channels.
    """
    on_ground: list[PieceShift] = []
    in_image: list[PieceShift] = []
    for index in range(min(len(reader), MOST_TILES)):
        image, labels = reader(index)
        by_turn = [
            {piece.value: piece for piece in piece_shifts(labels, _turned_answer(answer, image, k), range(1, channels))}
            for k in range(QUARTERS)
        ]
        for value in set.intersection(*map(set, by_turn)):
            pieces = [found[value] for found in by_turn]
            pairs, variance = (np.mean([getattr(piece, name) for piece in pieces]) for name in ("pairs", "variance"))
            shifts = [piece.shift for piece in pieces]
            # A quarter turn counterclockwise turns right into up.
            own = [shift * (-1j) ** k for k, shift in enumerate(shifts)]
            on_ground.append(PieceShift(value, round(pairs), complex(np.mean(shifts)), float(variance)))
            in_image.append(PieceShift(value, round(pairs), complex(np.mean(own)), float(variance)))
    return [ClassShiftRow(*pair) for pair in zip(class_shifts(on_ground), class_shifts(in_image))]


def _turned_answer(answer: Callable[[np.ndarray], np.ndarray], image: np.ndarray, quarters: int) -> np.ndarray:
    return np.ascontiguousarray(np.rot90(answer(np.ascontiguousarray(np.rot90(image, quarters))), -quarters))
