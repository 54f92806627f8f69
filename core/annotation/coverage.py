"""Polygons that share borders (a coverage): simplified alike on both sides, and laid on the map."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely


def can_simplify() -> bool:
    """Whether this shapely and GEOS can simplify polygons that share borders (shapely 2.1 and GEOS 3.12 can)."""
    return hasattr(shapely, "coverage_simplify") and shapely.geos_version >= (3, 12, 0)


def areas_and_wkb(polygons: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(n,) areas and (n,) well-known binaries; of all at once, for asking each polygon takes several times as long."""
    return shapely.area(polygons), np.asarray(shapely.to_wkb(polygons), object)


def simplified(polygons: np.ndarray, tolerance: float) -> np.ndarray:
    """(n,) polygons of a coverage, borders straightened alike on both sides; needs ``can_simplify``.

    Args:
        polygons: (n,) shapely polygons that share borders vertex by vertex.
        tolerance: Corners go whose triangle is smaller than the square of it (Visvalingam and Whyatt 1993).
    """
    return np.asarray(shapely.coverage_simplify(polygons, tolerance), object)


def on_map(polygons: np.ndarray, transform: Sequence[float]) -> np.ndarray:
    """(n,) polygons in pixel coordinates (column, row), in map coordinates; ``transform``: GDAL's six numbers."""
    x0, x_column, x_row, y0, y_column, y_row = transform

    def moved(points: np.ndarray) -> np.ndarray:
        columns, rows = points.T
        return np.column_stack([x0 + columns * x_column + rows * x_row, y0 + columns * y_column + rows * y_row])

    return shapely.transform(polygons, moved)
