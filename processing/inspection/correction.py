"""Plan of an update: how a corrected land-cover layer is rasterized on the pixels of its reference database."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsCsException,
    QgsFeatureRequest,
    QgsRectangle,
    QgsReferencedRectangle,
    QgsVectorLayerFeatureSource,
)

from ...core.errors import ParameterError
from ...storage.database.reader import read_database
from ...storage.database.undo import stated_checksums
from ...storage.text_tables import CLASSES_FILE
from ..compat import is_null
from ..layers.reference_systems import database_crs, transformed_box

_MARGIN_PX = 2
"""Margin around changes, because their bounds are rounded to whole pixels, also in another CRS."""


class LayerGround(NamedTuple):
    """The ground of a layer: its name, its extent, and the CRS of the extent."""

    name: str
    extent: QgsRectangle
    crs: QgsCoordinateReferenceSystem


class DrawnFeature(NamedTuple):
    """What determines the pixels of a feature: a hash, and its bounds."""

    digest: int
    bounds: QgsRectangle


class RasterizePlan(NamedTuple):
    """What is to be rasterized.

    Attributes:
        grid: CLASS_TABLE, PIXEL_SIZE, EXTENT and TARGET_CRS of semref:rasterizeannotation for the map of the database.
        drawn: Features of the layer by id, in their order; None if each feature affects distant ground, as with a
            single class, where ground without a polygon is class “other”.
        checksums: Checksums that the database to update states.
    """

    grid: dict[str, Any]
    drawn: dict[int, DrawnFeature] | None
    checksums: str | None


def plan_rasterizing(
    path: str,
    grounds: Sequence[LayerGround],
    folder: str,
    context: QgsCoordinateTransformContext,
    source: QgsVectorLayerFeatureSource,
    fields: Sequence[int],
) -> RasterizePlan:
    """Read what an update of a database needs.

    Args:
        grounds: Layers that must overlap its map: the land-cover layer, the corrected places.
        folder: Where the class table of the database is written.
        source: A snapshot of the land-cover layer.
        fields: Indices of the fields of class and priority.

    Raises:
        DatabaseError: It cannot be read.
        ParameterError: A layer is elsewhere, so it belongs to another map.
    """
    checksums = stated_checksums(path)
    database = read_database(path)
    crs, extent = database_crs(database), QgsRectangle(*database.parameters.extent)
    for ground in grounds:
        if not _meets(ground, extent, crs, context):
            raise ParameterError(
                "“{layer}” does not overlap the map of {name}. Select the land-cover layer and the places of this "
                "database.",
                layer=ground.name,
                name=os.path.basename(path),
            )
    os.makedirs(folder, exist_ok=True)
    classes = Path(folder) / CLASSES_FILE
    classes.write_text(database.class_table.to_csv(), encoding="utf-8")
    grid = {
        "CLASS_TABLE": str(classes),
        "PIXEL_SIZE": database.parameters.pixel_size,
        "EXTENT": QgsReferencedRectangle(extent, crs),
        "TARGET_CRS": crs,
    }
    has_filling = sum(bool(one.value) for one in database.class_table) == 1
    return RasterizePlan(grid, None if has_filling else _drawn(source, fields), checksums)


def _drawn(source: QgsVectorLayerFeatureSource, fields: Sequence[int]) -> dict[int, DrawnFeature]:
    found = {}
    for feature in source.getFeatures(QgsFeatureRequest().setSubsetOfAttributes(list(fields))):
        geometry, values = feature.geometry(), map(feature.attribute, fields)
        if not geometry.isNull():
            shown = bytes(geometry.asWkb().data()), *(None if is_null(value) else repr(value) for value in values)
            found[feature.id()] = DrawnFeature(hash(shown), geometry.boundingBox())
    return found


def changed_bounds(before: Mapping[int, DrawnFeature], now: Mapping[int, DrawnFeature]) -> list[QgsRectangle]:
    """Return old and new bounds of changed features: of all if their order changed, where the last is on top."""
    same = [feature for feature, drawn in now.items() if feature in before and before[feature].digest == drawn.digest]
    kept = set(same)
    if same != [feature for feature in before if feature in kept]:
        kept = set()
    return [drawn.bounds for some in (before, now) for feature, drawn in some.items() if feature not in kept]


def part_to_rasterize(
    grid: Mapping[str, Any],
    changed: Sequence[QgsRectangle],
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
) -> QgsReferencedRectangle | None:
    """Return the part of a label map around all changes; None if it is outside or cannot be transformed.

    Args:
        grid: As in ``RasterizePlan``.
        changed: One or more of ``changed_bounds``.
    """
    whole, pixel = grid["EXTENT"], grid["PIXEL_SIZE"]
    try:
        transform = QgsCoordinateTransform(crs, whole.crs(), context)
        there = [transform.transformBoundingBox(bounds) for bounds in changed]
    except QgsCsException:
        return None
    part = QgsRectangle(there[0])
    for bounds in there:
        part.combineExtentWith(bounds)
    part.grow(_MARGIN_PX * pixel)
    part = part.intersect(whole)
    return None if part.isEmpty() else QgsReferencedRectangle(part, whole.crs())


def _meets(
    ground: LayerGround, extent: QgsRectangle, crs: QgsCoordinateReferenceSystem, context: QgsCoordinateTransformContext
) -> bool:
    there = transformed_box(QgsCoordinateTransform(ground.crs, crs, context), ground.extent)
    return not there.isNull() and there.intersects(extent)
