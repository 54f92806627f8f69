"""Similar windows: windows elsewhere that an image of a given window may be mistaken for."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..windows.topology_vector import vector_distances, vector_objects
from .model import ReferenceDatabase, Windows

COUNT = 5
"""Most similar windows of a window."""


@dataclass(frozen=True)
class DescribedWindow:
    """A window, and the windows elsewhere with the nearest vectors.

    Attributes:
        objects: (K,) indices into the database's landmarks of those in its vector, in the vector's order.
        look_alikes: (M,) indices of the similar windows, nearest vector first.
        distances: (M,) distances of their vectors.
    """

    index: int
    objects: np.ndarray
    look_alikes: np.ndarray
    distances: np.ndarray


def window_at(windows: Windows, x: float, y: float) -> int:
    """Return the index of the smallest window around map (x, y), of several the nearest center; −1 without one."""
    away = np.abs(windows.centers - (x, y)).max(axis=1)
    holding = np.flatnonzero(away <= windows.sizes / 2)
    if not len(holding):
        return -1
    smallest = holding[windows.sizes[holding] == windows.sizes[holding].min()]
    return int(smallest[np.hypot(*(windows.centers[smallest] - (x, y)).T).argmin()])


def describe_window(database: ReferenceDatabase, index: int) -> DescribedWindow:
    """Return the window at ``index`` with up to COUNT similar windows that overlap neither it nor each other.

    The landmarks are those of the map with centers in the window. A landmark that the window's border cuts has another
    center in the window's own description.
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
    found = _apart(windows, index, np.argsort(distances, kind="stable"))
    found = found[np.isfinite(distances[found])]
    return DescribedWindow(index, inside[kept], found, distances[found])


def _apart(windows: Windows, index: int, order: np.ndarray) -> np.ndarray:
    """Return the first COUNT of ``order`` that overlap neither the window nor each other."""
    chosen = [index]
    for candidate in order.tolist():
        reach = (windows.sizes[chosen] + windows.sizes[candidate]) / 2
        if (np.abs(windows.centers[chosen] - windows.centers[candidate]).max(axis=1) >= reach * (1 - 1e-6)).all():
            chosen.append(candidate)
            if len(chosen) > COUNT:
                break
    return np.array(chosen[1:], np.int64)


def vector_rows(vector: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return distance ratios, angle differences and class ranks of a (3·X,) vector, without the padding."""
    ratios, angles, ranks = np.asarray(vector).reshape(3, -1)
    count = int((ranks > 0).sum())
    return ratios[:count], angles[:count], ranks[:count]
