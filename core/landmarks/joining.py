"""Join pieces of regions, for tiles of a map and for rasterized polygons."""

from __future__ import annotations

import numpy as np


def connected_components(count: int, pairs: np.ndarray) -> np.ndarray:
    """Return the connected components of a graph.

    Args:
        pairs: (E, 2) linked nodes.

    Returns:
        (count,) int64 component of each node, numbered in order of their first nodes.
    """
    labels = np.arange(count)
    first, second = pairs.T
    while True:
        roots = labels[first], labels[second]
        lower = np.minimum(*roots)
        linked = labels.copy()
        for root in roots:
            np.minimum.at(linked, root, lower)
        while not np.array_equal(linked, linked[linked]):
            linked = linked[linked]
        if np.array_equal(linked, labels):
            return np.unique(labels, return_inverse=True)[1].reshape(-1)
        labels = linked


def touching_runs(rows: np.ndarray, starts: np.ndarray, stops: np.ndarray) -> np.ndarray:
    """Return pairs of runs of pixels that touch (8-connected) in consecutive rows.

    Args:
        rows: (K,) int64 row of each run; runs are in reading order.
        starts: (K,) int64 first column of each.
        stops: (K,) int64 last column of each + 1.

    Returns:
        (L, 2) int64 numbers of the runs, the upper one first.
    """
    width = int(stops.max(initial=0)) + 2
    starts, stops = rows * width + starts, rows * width + stops
    # In the next row: from the first run that does not end left of this one to the last that starts not right of it.
    first = np.searchsorted(stops, starts + width, "left")
    last = np.searchsorted(starts, stops + width, "right")
    counts = np.maximum(last - first, 0)
    upper = np.repeat(np.arange(len(rows)), counts)
    lower = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts) + np.repeat(first, counts)
    return np.column_stack([upper, lower])
