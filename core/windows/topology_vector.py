"""Topology vector: description of an image by its landmarks, independent of scale and rotation (paper §2.2.1)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

REFERENCES_PER_VECTOR = 10
"""X of the paper (its Tables 1–3): largest number of landmarks in a vector."""

MINIMUM_REFERENCES = 3
"""Smallest number of landmarks for a vector: two points do not determine a shape."""

TIE_DECIMALS = 6
"""Distances in pixels and angles in degrees that are equal to this many decimals are tied; rounding errors are near
1e-11."""


DISTANCE_THRESHOLD = 2.0
"""T: a larger distance is not a match. The paper does not state it; 1 − d/2 gives all confidences of its Tables 4 and
5."""


def topology_vector(
    centers_xy: np.ndarray,
    classes: np.ndarray,
    image_center_xy: Sequence[float],
    reference_values: Sequence[int],
    references_per_vector: int = REFERENCES_PER_VECTOR,
) -> np.ndarray | None:
    """Return the vector of one image, by equations (1)–(4) of the paper.

    Args:
        centers_xy: (N, 2) centers of gravity (column, row), pixels.
        classes: (N,) class values, each one of ``reference_values``.
        image_center_xy: (column, row) of the image's center, pixels.
        references_per_vector: X, largest number of landmarks in the vector.

    Returns:
        (3·X,) float32 in [0, 1]; None with fewer than MINIMUM_REFERENCES landmarks.
    """
    if len(classes) < MINIMUM_REFERENCES:
        return None
    offsets = np.asarray(centers_xy, np.float64)[None] - np.asarray(image_center_xy, np.float64)
    ranks = class_ranks(classes, reference_values)[None]
    return topology_vectors(offsets, ranks, references_per_vector)[0]


def class_ranks(classes: np.ndarray, reference_values: Sequence[int]) -> np.ndarray:
    """Return (N,) float64 ranks of (N,) class values: the index among the landmark classes over their number."""
    values = np.asarray(sorted(reference_values))
    return (np.searchsorted(values, classes) + 1) / len(values)


def topology_vectors(offsets_xy: np.ndarray, ranks: np.ndarray, references_per_vector: int) -> np.ndarray:
    """Return the vectors of M images at once.

    For each image: keep the X nearest landmarks; order them by their angle from the +x axis in [0°, 360°); start with
    the farthest. Then make three rows, zero-padded at the end: distance ratios (eq. 2), angle differences to the next
    one, from the last to the first, over the largest (eqs. 3, 4), and ranks. Ties, to a millionth of a pixel or degree,
    are ordered by distance, then angle, then rank.

    Args:
        offsets_xy: (M, N, 2) float64 offsets (column, row) in pixels of the landmarks from each image's center, padded
            with infinity; every image has at least one.
        ranks: (M, N) as from ``class_ranks``.
        references_per_vector: X, largest number of landmarks in a vector.

    Returns:
        (M, 3·X) float32, row after row.
    """
    _, distances, angles, ranks = _in_order(offsets_xy, ranks, references_per_vector)
    kept = distances.shape[1]
    present = np.isfinite(distances)
    counts = present.sum(axis=1)
    place = np.arange(kept)
    following = np.where(present, (place + 1) % counts[:, None], place)
    with np.errstate(invalid="ignore"):
        differences = (np.take_along_axis(angles, following, axis=1) - angles) % 360.0
    vectors = np.zeros((len(offsets_xy), 3, references_per_vector), np.float32)
    vectors[:, 0, :kept] = _over_largest(np.where(present, distances, 0.0))
    vectors[:, 1, :kept] = _over_largest(np.where(present, differences, 0.0))
    vectors[:, 2, :kept] = np.where(present, ranks, 0.0)
    return vectors.reshape(len(vectors), 3 * references_per_vector)


def vector_objects(
    centers_xy: np.ndarray,
    classes: np.ndarray,
    image_center_xy: Sequence[float],
    reference_values: Sequence[int],
    references_per_vector: int = REFERENCES_PER_VECTOR,
) -> np.ndarray:
    """Return (K,) indices of the landmarks in the result of ``topology_vector``, in its order; same arguments."""
    if not len(classes):
        return np.empty(0, np.int64)
    offsets = np.asarray(centers_xy, np.float64)[None] - np.asarray(image_center_xy, np.float64)
    return _in_order(offsets, class_ranks(classes, reference_values)[None], references_per_vector)[0][0]


def _in_order(offsets_xy: np.ndarray, ranks: np.ndarray, references_per_vector: int) -> tuple[np.ndarray, ...]:
    """Return indices (M, K) of the landmarks in the vector's order, with their distances, angles and ranks."""
    kept = min(references_per_vector, offsets_xy.shape[1])
    distances = np.hypot(offsets_xy[..., 0], offsets_xy[..., 1])
    with np.errstate(invalid="ignore"):
        angles = np.degrees(np.arctan2(offsets_xy[..., 1], offsets_xy[..., 0]))
    # Equal objects have tied distances; the last bits depend on where the map was cut and must not order them.
    distances = np.round(distances, TIE_DECIMALS)
    # Round before the modulo: a tiny negative angle would become 360 instead of 0.
    angles = np.round(angles, TIE_DECIMALS) % 360.0
    angles[distances == 0.0] = 0.0
    angles[np.isinf(distances)] = np.inf

    order = np.lexsort((ranks, angles, distances), axis=-1)[:, :kept]
    by_angle = np.lexsort([np.take_along_axis(a, order, axis=1) for a in (ranks, distances, angles)], axis=-1)
    order = np.take_along_axis(order, by_angle, axis=1)
    present = np.isfinite(np.take_along_axis(distances, order, axis=1))
    farthest = np.where(present, np.take_along_axis(distances, order, axis=1), -1.0).argmax(axis=1)
    place = np.arange(kept)
    turned = np.where(present, (farthest[:, None] + place) % present.sum(axis=1)[:, None], place)
    order = np.take_along_axis(order, turned, axis=1)
    return (order, *(np.take_along_axis(a, order, axis=1) for a in (distances, angles, ranks)))


def _over_largest(values: np.ndarray) -> np.ndarray:
    largest = values.max(axis=1, keepdims=True)
    return values / np.where(largest > 0, largest, 1.0)


def vector_distances(query: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Return Euclidean distances (N,) float64 of ``query`` (3·X,) to every row of ``vectors`` (N, 3·X) (eq. 5)."""
    difference = vectors.astype(np.float64) - query.astype(np.float64)
    return np.sqrt(np.einsum("ij,ij->i", difference, difference))


def vector_confidence(distance: float) -> float:
    """Return 1 − d/T, and 0 beyond T where the match counts as failed."""
    return max(0.0, 1.0 - float(distance) / DISTANCE_THRESHOLD)
