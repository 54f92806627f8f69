"""Nearest topology vector and its confidence (docs/method.md#matching; paper eq. 5)."""

from __future__ import annotations

import numpy as np

DISTANCE_THRESHOLD = 2.0
"""T: a larger distance is no match. Not printed in the paper; 1 − d/2 gives all confidences of its Tables 4 and 5."""


def vector_distances(query: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Euclidean distances (N,) float64 of ``query`` (3·X,) to every row of ``vectors`` (N, 3·X) (eq. 5)."""
    difference = vectors.astype(np.float64) - query.astype(np.float64)
    return np.sqrt(np.einsum("ij,ij->i", difference, difference))


def vector_confidence(distance: float) -> float:
    """1 − d/T, and 0 beyond T where the matching counts as failed."""
    return max(0.0, 1.0 - float(distance) / DISTANCE_THRESHOLD)
