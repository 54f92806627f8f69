"""Polygons that share borders (a coverage): made such, and simplified alike on both sides."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely


def can_simplify() -> bool:
    """Whether this shapely and GEOS can simplify polygons that share borders (shapely 2.1 and GEOS 3.12 can)."""
    return hasattr(shapely, "coverage_simplify") and shapely.geos_version >= (3, 12, 0)


def from_wkb(outlines: Sequence[bytes]) -> np.ndarray:
    """(n,) shapely polygons of their well-known binary."""
    return np.asarray(shapely.from_wkb(np.array(outlines, object)), object)


def simplified(polygons: np.ndarray, tolerance: float) -> np.ndarray:
    """(n,) polygons of a coverage, borders straightened alike on both sides; needs ``can_simplify``.

    Args:
        polygons: (n,) shapely polygons that share borders vertex by vertex.
        tolerance: Corners go whose triangle is smaller than the square of it (Visvalingam and Whyatt 1993).
    """
    return np.asarray(shapely.coverage_simplify(polygons, tolerance), object)


def with_nodes(polygons: np.ndarray, nodes: np.ndarray, width: int) -> np.ndarray:
    """Polygons of pixels' edges with a vertex at each node that lies on them, as a coverage needs it.

    GDAL's polygons have vertices where they turn; a neighbor's corner on a straight edge is none of them.

    Args:
        polygons: (n,) shapely polygons, all edges along rows or columns of whole numbers.
        nodes: (m, 2) sorted (row, column).
        width: More than the largest column.

    Returns:
        (n,) the same polygons.
    """
    kind, coordinates, (ring_ends, polygon_ends) = shapely.to_ragged_array(polygons)
    points = coordinates.astype(np.int64)
    start, end = points, np.roll(points, -1, axis=0)
    in_ring = np.ones(len(points), bool)
    in_ring[ring_ends[1:] - 1] = False
    level = start[:, 1] == end[:, 1]
    height = int(points[:, 1].max()) + 2
    along_rows = nodes[:, 0] * width + nodes[:, 1]
    along_columns = np.sort(nodes[:, 1] * height + nodes[:, 0])
    before, count = np.zeros(len(points), np.int64), np.zeros(len(points), np.int64)
    for chosen, keys, axis, factor in ((level, along_rows, 0, width), (~level, along_columns, 1, height)):
        chosen = chosen & in_ring
        base = start[chosen, 1 - axis] * factor
        low, high = np.sort([start[chosen, axis], end[chosen, axis]], axis=0)
        before[chosen] = np.searchsorted(keys, base + low, "right")
        count[chosen] = np.searchsorted(keys, base + high, "left") - before[chosen]
    places = np.arange(len(points)) + np.cumsum(count) - count
    made = np.empty((len(points) + int(count.sum()), 2))
    made[places] = points
    edge = np.repeat(np.arange(len(points)), count)
    step = np.arange(len(edge)) - np.repeat(np.cumsum(count) - count, count)
    backwards = (end - start).sum(axis=1)[edge] < 0
    key = before[edge] + np.where(backwards, count[edge] - 1 - step, step)
    inserted = np.empty((len(edge), 2))
    for chosen, keys, axis, factor in ((level[edge], along_rows, 0, width), (~level[edge], along_columns, 1, height)):
        across, position = np.divmod(keys[key[chosen]], factor)
        inserted[chosen, axis], inserted[chosen, 1 - axis] = position, across
    made[places[edge] + 1 + step] = inserted
    moved = np.append(places, len(made))
    return shapely.from_ragged_array(kind, made, (moved[ring_ends], polygon_ends))


def on_map(polygons: np.ndarray, transform: Sequence[float]) -> np.ndarray:
    """(n,) polygons in pixel coordinates (column, row), in map coordinates; ``transform``: GDAL's six numbers."""
    x0, x_column, x_row, y0, y_column, y_row = transform

    def moved(points: np.ndarray) -> np.ndarray:
        columns, rows = points.T
        return np.column_stack([x0 + columns * x_column + rows * x_row, y0 + columns * y_column + rows * y_row])

    return shapely.transform(polygons, moved)
