"""Shapely geometries as well-known binary."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import shapely

if TYPE_CHECKING:
    import numpy as np
    from shapely.geometry.base import BaseGeometry

_DIMENSION = 3
"""Said, because the default of new versions of shapely is 4. Inside desktop QGIS on Linux shapely's calls end in the
GEOS that QGIS brings, which before 3.12 refuses a 4."""


def to_wkb(geometries: BaseGeometry | np.ndarray) -> Any:  # noqa: ANN401 - bytes, or an array of them
    """WKB of a geometry, or of an array of them; Z is kept, M is not."""
    return shapely.to_wkb(geometries, output_dimension=_DIMENSION)
