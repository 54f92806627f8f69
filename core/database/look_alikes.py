"""Which windows elsewhere look like a given one, so that an image of it may be taken for them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..windows.topology_vector import vector_distances, vector_objects
from .model import ReferenceDatabase, Windows


@dataclass(frozen=True)
class DescribedWindow:
    """One window, and the windows elsewhere with the nearest vectors.

    Attributes:
        objects: (K,) indices into the database's references of the landmarks of its vector, in the vector's order.
        look_alikes: (M,) indices of windows, nearest vector first.
        distances: (M,) distances of the look-alikes' vectors.
    """

    index: int
    objects: np.ndarray
    look_alikes: np.ndarray
    distances: np.ndarray


def window_at(windows: Windows, x: float, y: float) -> int:
    """Return index of the window whose center is nearest to map (x, y), of the smallest windows that hold it; −1: none."""
    away = np.abs(windows.centers - (x, y)).max(axis=1)
    holding = np.flatnonzero(away <= windows.sizes / 2)
    if not len(holding):
        return -1
    smallest = holding[windows.sizes[holding] == windows.sizes[holding].min()]
    return int(smallest[np.hypot(*(windows.centers[smallest] - (x, y)).T).argmin()])


def describe_window(database: ReferenceDatabase, index: int, count: int = 5) -> DescribedWindow:
    """Return the window at ``index`` with up to ``count`` look-alikes, none of which overlaps it or another of them.

    The objects are those of the map whose centers lie in the window; an object that the window's border cuts has its
    center of gravity elsewhere in the window's own description.
    """
    windows = database.windows
    center, half = windows.centers[index], windows.sizes[index] / 2
    if not windows.described[index]:
        return DescribedWindow(index, np.empty(0, np.int64), np.empty(0, np.int64), np.empty(0))
    references = database.references
    inside = np.flatnonzero((np.abs(references.positions - center) < half).all(axis=1))
    offsets = (references.positions[inside] - center) * (1, -1)
    kept = vector_objects(
        offsets,
        references.classes[inside],
        (0.0, 0.0),
        database.class_table.reference_values,
        database.parameters.references_per_vector,
    )
    distances = vector_distances(windows.vectors[index], windows.vectors)
    distances[~windows.described] = np.inf
    found = _apart(windows, index, np.argsort(distances, kind="stable"), count)
    found = found[np.isfinite(distances[found])]
    return DescribedWindow(index, inside[kept], found, distances[found])


def _apart(windows: Windows, index: int, order: np.ndarray, count: int) -> np.ndarray:
    """Return the first ``count`` of ``order`` that overlap neither the window nor one another."""
    chosen = [index]
    for candidate in order.tolist():
        reach = (windows.sizes[chosen] + windows.sizes[candidate]) / 2
        if (np.abs(windows.centers[chosen] - windows.centers[candidate]).max(axis=1) >= reach * (1 - 1e-6)).all():
            chosen.append(candidate)
            if len(chosen) > count:
                break
    return np.array(chosen[1:], np.int64)


def vector_rows(vector: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Distance ratios, angle differences and class ranks of a (3·X,) vector, without the padding at their ends."""
    ratios, angles, ranks = np.asarray(vector).reshape(3, -1)
    count = int((ranks > 0).sum())
    return ratios[:count], angles[:count], ranks[:count]
