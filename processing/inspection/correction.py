"""What a corrected annotation is rasterized with, so that it fits the reference database that it was made into."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsCsException,
    QgsRectangle,
    QgsReferencedRectangle,
)

from ...core.errors import ParameterError
from ...storage.database.reader import read_database
from ...storage.text_tables import CLASSES_FILE
from ..exchange.reference_systems import database_crs


class LayerGround(NamedTuple):
    """What a layer shows: its name, its extent, and what that is in."""

    name: str
    extent: QgsRectangle
    crs: QgsCoordinateReferenceSystem


def rasterize_parameters(
    path: str, grounds: Sequence[LayerGround], folder: str, context: QgsCoordinateTransformContext
) -> dict[str, Any]:
    """CLASS_TABLE, PIXEL_SIZE, EXTENT and TARGET_CRS of semref:rasterizeannotation for the map of a database.

    Args:
        path: Of the database.
        grounds: What must lie on its map: the annotation, the places that were corrected.
        folder: Where the database's class table is written.
        context: How the project transforms coordinates.

    Raises:
        DatabaseError: It can't be read.
        ParameterError: A layer lies elsewhere: it belongs to another map.
    """
    database = read_database(path)
    crs, extent = database_crs(database), QgsRectangle(*database.parameters.extent)
    for ground in grounds:
        if not _meets(ground, extent, crs, context):
            raise ParameterError(
                "“{layer}” lies outside the map of {name}; choose the annotation and the places that belong to this "
                "database.",
                layer=ground.name,
                name=os.path.basename(path),
            )
    os.makedirs(folder, exist_ok=True)
    classes = Path(folder) / CLASSES_FILE
    classes.write_text(database.class_table.to_csv(), encoding="utf-8")
    return {
        "CLASS_TABLE": str(classes),
        "PIXEL_SIZE": database.parameters.pixel_size,
        "EXTENT": QgsReferencedRectangle(extent, crs),
        "TARGET_CRS": crs,
    }


def _meets(
    ground: LayerGround,
    extent: QgsRectangle,
    crs: QgsCoordinateReferenceSystem,
    context: QgsCoordinateTransformContext,
) -> bool:
    try:
        there = QgsCoordinateTransform(ground.crs, crs, context).transformBoundingBox(ground.extent)
    except QgsCsException:
        return False
    return there.intersects(extent)
