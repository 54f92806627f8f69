"""What a label map has to have: a north-up grid of square pixels, and the classes of a database."""

from __future__ import annotations

from collections.abc import Sequence

from ..core.errors import LabelMapError
from ..core.labels.class_table import ClassTable
from .rasters import GdalLabels, named_classes, stored_class_table

_WGS84 = 4326
_POINTS_AT_ONCE = 50_000


def require_map_grid(transform: Sequence[float] | None, path: str) -> None:
    """Raises LabelMapError for a georeference that is none, or of no north-up grid of square pixels.

    Args:
        transform: GDAL's six numbers.
        path: What the raster is called in what is said.
    """
    if transform is None:
        raise LabelMapError("{path} has no georeference, so its windows would have no place on the map.", path=path)
    _, pixel_x, turn_x, _, turn_y, pixel_y = transform
    if turn_x or turn_y or pixel_y >= 0 or pixel_x <= 0:
        raise LabelMapError("{path} is rotated or mirrored; warp it to a north-up grid first.", path=path)
    if abs(pixel_x + pixel_y) > 1e-6 * pixel_x:
        raise LabelMapError(
            "{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.",
            path=path,
            pixel_x=pixel_x,
            pixel_y=-pixel_y,
        )


def require_classes_of(labels: GdalLabels, table: ClassTable, path: str) -> None:
    """Raises LabelMapError for a label map that calls a class otherwise than the database does.

    Args:
        path: What the map is called in what is said.
    """
    for found in stored_class_table(labels.dataset, path) or named_classes(labels.dataset):
        known = table.by_value(found.value)
        if known is not None and known.name != found.name:
            raise LabelMapError(
                "{path} calls the class {value} “{name}” and the database “{known}”; rasterize the map with the "
                "database’s class table.",
                path=path,
                value=found.value,
                name=found.name,
                known=known.name,
            )
