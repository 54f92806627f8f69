"""Inverses and eigenvectors of small symmetric matrices by OpenCV: LAPACK would start threads that keep spinning."""

from __future__ import annotations

import cv2
import numpy as np

LEAST = 1e-15
"""Least eigenvalue, as a share of the largest, of a matrix with a diagonal of 1: smaller ones are rounding errors."""


def inverse_of(matrix: np.ndarray) -> np.ndarray:
    """Return the inverse of a positive definite (n, n) matrix; of an almost singular one, a large finite inverse."""
    units = 1 / np.sqrt(np.diagonal(matrix))
    both = units[:, None] * units
    values, vectors = eigen(matrix * both)
    return (vectors / np.maximum(values, LEAST * values[0])) @ vectors.T * both


def eigen(matrix: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return eigenvalues (n,), largest first, and eigenvectors (n, n) in columns of a symmetric (n, n) matrix."""
    _, values, vectors = cv2.eigen(matrix)
    return values[:, 0], vectors.T
