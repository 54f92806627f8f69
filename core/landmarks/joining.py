"""Joining what belongs together: THE joiner of pieces of regions, for tiles of a map and for burnt annotations."""

from __future__ import annotations

import numpy as np


def connected_components(count: int, pairs: np.ndarray) -> np.ndarray:
    """Join things that are linked, also over others.

    Args:
        count: How many things there are.
        pairs: (E, 2) numbers of things that are linked.

    Returns:
        (count,) int64 component of each, numbered in order of their first.
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
    """Run of pixels that touch (8-connected) in rows that follow each other.

    Args:
        rows: (K,) int64 row of each run; runs are in reading order.
        starts: (K,) int64 first column of each.
        stops: (K,) int64 column after its last.

    Returns:
        (L, 2) int64 numbers of the runs, the upper one first.
    """
    width = int(stops.max(initial=0)) + 2
    starts, stops = rows * width + starts, rows * width + stops
    # In the next row: from the first run that does not end left of this one to the last that begins not right of it.
    first = np.searchsorted(stops, starts + width, "left")
    last = np.searchsorted(starts, stops + width, "right")
    counts = np.maximum(last - first, 0)
    upper = np.repeat(np.arange(len(rows)), counts)
    lower = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts) + np.repeat(first, counts)
    return np.column_stack([upper, lower])
