"""Inverses and eigenvectors of small symmetric matrices by OpenCV: LAPACK would start threads that keep spinning."""

from __future__ import annotations

import cv2
import numpy as np


def inverse_of(matrix: np.ndarray) -> np.ndarray:
    """Return the inverse of a positive definite (n, n) matrix. Raises LinAlgError for another one."""
    # OpenCV's limit for pivots is absolute, so the diagonal must be 1.
    units = 1 / np.sqrt(np.diagonal(matrix))
    both = units[:, None] * units
    is_definite, found = cv2.invert(matrix * both, flags=cv2.DECOMP_CHOLESKY)
    if not is_definite:
        raise np.linalg.LinAlgError
    return found * both


def eigen(matrix: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return eigenvalues (n,), largest first, and eigenvectors (n, n) in columns of a symmetric (n, n) matrix."""
    _, values, vectors = cv2.eigen(matrix)
    return values[:, 0], vectors.T
