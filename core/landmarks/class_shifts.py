"""Class offsets of a network: how far from their true positions a prediction shows the landmarks of each class.

See docs/explanation/method.md#class-offset. Landmarks of two label images of one ground are paired. Each piece
of ground has the median of its pairs; the variation between pieces beyond chance is the spread of the offset.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from .landmarks import Landmarks, extract_landmarks

PIECE_PX = 512
"""Edge of the pieces of a map that are compared: the ground of one image, whose offset differs from another's."""

LEAST_AREA_PX = 50.0
"""The centers of smaller landmarks are too uncertain."""

REACH = 0.7
"""Two landmarks are the same if their centers are at most this far apart, in √area of the true one …"""

LARGEST_RATIO = 1.6
"""… and the ratio of their areas is at most this: merged or split houses have other centers."""

ROUNDS = 3
"""Pairs are searched again after the shift found so far is applied."""

LEAST_PAIRS = 3
"""Smallest number of pairs for a piece to count."""

LEAST_PIECES = 3
"""Smallest number of pieces for the spread between them to be known."""

MEDIAN_COST = np.pi / 2
"""Variance of a median relative to that of a mean, for normally distributed values."""

DEVIATION_OF_MEDIAN = 1.4826
"""Standard deviation of normally distributed values relative to the median distance from their median."""


@dataclass(frozen=True)
class PieceShift:
    """Offset of one class in one piece of ground.

    Attributes:
        pairs: Landmarks that both label images show.
        shift: Median offset of the prediction to the right and, as imaginary part, down, pixels.
        variance: Of that median, along each axis, pixels².
        points: (n,) complex centers of the true landmarks of all pairs, right and down from ``corner``, pixels.
        offsets: (n,) complex offsets of the predicted ones, right and down, pixels.
        corner: Upper left corner of the piece on the map, right and down, pixels.
    """

    value: int
    pairs: int
    shift: complex
    variance: float
    points: np.ndarray = field(default_factory=lambda: np.zeros(0, complex))
    offsets: np.ndarray = field(default_factory=lambda: np.zeros(0, complex))
    corner: complex = 0j


@dataclass(frozen=True)
class ClassShift:
    """Offset of one class over all pieces, pixels.

    Attributes:
        pairs: Landmarks that both label images show, over all pieces.
        pieces: Pieces with enough pairs.
        shift: Offset to the right and, as imaginary part, down.
        deviation: Standard deviation of the offset along each axis.
        spread: Standard deviation along each axis of a piece's offset from it, including its own uncertainty; None
            with too few pieces.
    """

    value: int
    pairs: int
    pieces: int
    shift: complex
    deviation: float
    spread: float | None


def piece_shifts(
    true_hw: np.ndarray, predicted_hw: np.ndarray, class_values: Sequence[int], corner: complex = 0j
) -> list[PieceShift]:
    """Return the offset of each class with enough pairs.

    Args:
        true_hw: (H, W) uint8 labels.
        corner: Of the piece on the map, right and down, pixels.
    """
    every = [extract_landmarks(labels, class_values, LEAST_AREA_PX) for labels in (true_hw, predicted_hw)]
    true, predicted = (found.select(~found.touches_edge) for found in every)
    shifts = []
    for value in class_values:
        points, off = _paired(true.select(true.classes == value), predicted.select(predicted.classes == value))
        if len(off) < LEAST_PAIRS:
            continue
        middle = complex(np.median(off.real), np.median(off.imag))
        apart = np.concatenate([off.real - middle.real, off.imag - middle.imag])
        deviation = DEVIATION_OF_MEDIAN * float(np.median(np.abs(apart)))
        # A few pairs may coincide by chance.
        variance = MEDIAN_COST * max(deviation, 0.1) ** 2 / len(off)
        shifts.append(PieceShift(int(value), len(off), middle, variance, points, off, corner))
    return shifts


def class_shifts(pieces: Sequence[PieceShift]) -> list[ClassShift]:
    """Combine the pieces of each class by a random-effects model with DerSimonian and Laird's variance (1986)."""
    found = []
    for value in sorted({piece.value for piece in pieces}):
        own = [piece for piece in pieces if piece.value == value]
        shifts, variances = np.array([piece.shift for piece in own]), np.array([piece.variance for piece in own])
        between = _between(shifts, variances)
        weights = 1 / (variances + between)
        deviation = float(np.sqrt(1 / weights.sum()))
        spread = float(np.hypot(np.sqrt(between), deviation)) if len(own) >= LEAST_PIECES else None
        shift = complex((weights * shifts).sum() / weights.sum())
        found.append(ClassShift(value, sum(piece.pairs for piece in own), len(own), shift, deviation, spread))
    return found


def _between(shifts: np.ndarray, variances: np.ndarray) -> float:
    """Return the variance along each axis between (n,) complex shifts beyond their own variances (n,)."""
    weights = 1 / variances
    total = weights.sum()
    mean = (weights * shifts).sum() / total
    # Half of the squared distances belongs to each axis.
    excess = float((weights * np.abs(shifts - mean) ** 2).sum() / 2 - (len(shifts) - 1))
    return max(excess / max(float(total - (weights**2).sum() / total), 1e-12), 0.0)


def _paired(true: Landmarks, predicted: Landmarks) -> tuple[np.ndarray, np.ndarray]:
    """Return (n,) complex centers of true landmarks, and (n,) offsets right and down to their mutual nearest neighbors.

    The neighbors are the predicted landmarks of similar area.
    """
    points = true.centers_xy @ (1, 1j)
    if not len(true) or not len(predicted):
        return points[:0], points[:0]
    apart = predicted.centers_xy @ (1, 1j) - points[:, None]
    ratios = np.abs(np.log(predicted.areas_px / true.areas_px[:, None]))
    reach = REACH * np.sqrt(true.areas_px)[:, None]
    shift = 0j
    found, off = points[:0], points[:0]
    for _ in range(ROUNDS):
        distances = np.where(ratios <= np.log(LARGEST_RATIO), np.abs(apart - shift), np.inf)
        nearest = distances.argmin(axis=1)
        rows = np.arange(len(true))
        kept = (distances.argmin(axis=0)[nearest] == rows) & (distances[rows, nearest] <= reach[:, 0])
        found, off = points[kept], apart[rows[kept], nearest[kept]]
        if not len(off):
            break
        shift = complex(np.median(off.real), np.median(off.imag))
    return found, off
