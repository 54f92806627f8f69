"""How far from where they are a prediction shows the landmarks of each class: a network's bias, and its spread.

See docs/explanation/method.md#class-offset.

Landmarks of two label images of one ground are paired; each piece of
ground has the median of its pairs, and what the pieces differ by beyond chance is the bias' spread.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .landmarks import Landmarks, extract_landmarks

PIECE_PX = 512
"""Edge of the pieces that a map is compared in: an image's ground, of which a bias differs from another's."""

LEAST_AREA_PX = 50.0
"""Smaller landmarks have no center to speak of."""

REACH = 0.7
"""Landmarks are the same when their centers are at most so far apart, in √area of the true one …"""

LARGEST_RATIO = 1.6
"""… and neither is larger by more: houses that were merged or split have other centers."""

ROUNDS = 3
"""Pairs are sought again where the shift that was found puts them."""

LEAST_PAIRS = 3
"""Pairs without which a piece says nothing."""

LEAST_PIECES = 3
"""Pieces without which nothing is known of what they differ by."""

MEDIAN_COST = np.pi / 2
"""Variance of a median, in that of a mean, of normally distributed values."""

DEVIATION_OF_MEDIAN = 1.4826
"""Standard deviation of normally distributed values, in the median of their distances from their median."""


@dataclass(frozen=True)
class PieceShift:
    """Of one class in one piece of ground.

    Attributes:
        pairs: Landmarks that both label images show.
        shift: Median of how far right and, as imaginary part, down the prediction shows them, pixels.
        variance: Of that median, along each axis, pixels².
    """

    value: int
    pairs: int
    shift: complex
    variance: float


@dataclass(frozen=True)
class ClassShift:
    """Of one class over all pieces, pixels.

    Attributes:
        pairs: Landmarks that both show, over all pieces.
        pieces: That said something.
        shift: Right and, as imaginary part, down.
        deviation: How exactly the shift is known, along each axis.
        spread: Standard deviation along each axis of what a piece's shift differs from it, its own uncertainty in it;
            None where there are too few pieces.
    """

    value: int
    pairs: int
    pieces: int
    shift: complex
    deviation: float
    spread: float | None


def piece_shifts(true_hw: np.ndarray, predicted_hw: np.ndarray, class_values: Sequence[int]) -> list[PieceShift]:
    """Return of each class with enough pairs.

    Args:
        true_hw: (H, W) uint8 labels.
        predicted_hw: The same ground, predicted.
        class_values: Classes that are compared.
    """
    every = [extract_landmarks(labels, class_values, LEAST_AREA_PX) for labels in (true_hw, predicted_hw)]
    true, predicted = (found.select(~found.touches_edge) for found in every)
    shifts = []
    for value in class_values:
        off = _paired(true.select(true.classes == value), predicted.select(predicted.classes == value))
        if len(off) < LEAST_PAIRS:
            continue
        middle = complex(np.median(off.real), np.median(off.imag))
        apart = np.concatenate([off.real - middle.real, off.imag - middle.imag])
        deviation = DEVIATION_OF_MEDIAN * float(np.median(np.abs(apart)))
        # Few pairs may lie on each other by chance.
        variance = MEDIAN_COST * max(deviation, 0.1) ** 2 / len(off)
        shifts.append(PieceShift(int(value), len(off), middle, variance))
    return shifts


def class_shifts(pieces: Sequence[PieceShift]) -> list[ClassShift]:
    """Return all pieces together, by class: a random effect a piece, its variance by DerSimonian and Laird (1986)."""
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
    """Variance along each axis of what (n,) complex shifts differ by beyond their own variances (n,)."""
    weights = 1 / variances
    total = weights.sum()
    mean = (weights * shifts).sum() / total
    # Half of the squared distances belongs to each axis.
    excess = float((weights * np.abs(shifts - mean) ** 2).sum() / 2 - (len(shifts) - 1))
    return max(excess / max(float(total - (weights**2).sum() / total), 1e-12), 0.0)


def _paired(true: Landmarks, predicted: Landmarks) -> np.ndarray:
    """Return (n,) complex: how far right and down of the true ones those lie that are each other's nearest and as large."""
    if not len(true) or not len(predicted):
        return np.zeros(0, complex)
    apart = predicted.centers_xy @ (1, 1j) - (true.centers_xy @ (1, 1j))[:, None]
    ratios = np.abs(np.log(predicted.areas_px / true.areas_px[:, None]))
    reach = REACH * np.sqrt(true.areas_px)[:, None]
    shift = 0j
    off = np.zeros(0, complex)
    for _ in range(ROUNDS):
        distances = np.where(ratios <= np.log(LARGEST_RATIO), np.abs(apart - shift), np.inf)
        nearest = distances.argmin(axis=1)
        rows = np.arange(len(true))
        kept = (distances.argmin(axis=0)[nearest] == rows) & (distances[rows, nearest] <= reach[:, 0])
        off = apart[rows[kept], nearest[kept]]
        if not len(off):
            break
        shift = complex(np.median(off.real), np.median(off.imag))
    return off
