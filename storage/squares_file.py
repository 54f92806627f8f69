"""Squares of ground as the layer of a GeoPackage, by GDAL alone: the same rows, the same bytes."""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from osgeo import gdal, ogr, osr

from ..core.errors import ParameterError
from .database.schema import STYLE_FIELDS, STYLES, create_layer, field_definition, square_wkb, write_feature
from .gdal_errors import close, gdal_failures
from .notes import LayerText
from .vector_files import STYLE_OF_SEMREF, leave_wal, tell_moment

ABOUT_SQUARES = LayerText(
    "Expected success",
    "Squares of ground; of several footprints one square each, of which the first footprint’s are drawn.\n\n"
    "Shows where images will be localized with a reference database, and where not: expected success and error of "
    "each square of ground under the noise that you state, number of landmarks, look-alikes, and the reason where it "
    "fails.",
)
"""What *Assess reference database* says of its squares and of itself."""


def write_squares(  # noqa: PLR0913 - what a file holds
    path: str,
    fields: Sequence[tuple[str, str]],
    squares: Iterable[tuple[tuple[float, float], float, Mapping[str, Any]]],
    crs_wkt: str,
    moment: str,
    style: str,
) -> None:
    """Writes a new GeoPackage, whose one layer is called as the file is.

    Args:
        path: Of the file.
        fields: (name, kind) of each column, kinds as of the schema of databases.
        squares: Center, edge and values by name of each; None is written as NULL.
        crs_wkt: What centers are in.
        moment: What the file says of when it was written (ISO 8601, UTC).
        style: QML of how QGIS draws them.

    Raises:
        ParameterError: It can't be written.
    """
    with gdal_failures() as failures:
        dataset = gdal.GetDriverByName("GPKG").Create(path, 0, 0, 0, gdal.GDT_Unknown)
        if dataset is not None:
            layer = dataset.CreateLayer(Path(path).stem, osr.SpatialReference(crs_wkt), ogr.wkbPolygon)
            for field in fields:
                layer.CreateField(field_definition(*field))
            _add(dataset, layer, squares)
            del layer
            _add_style(dataset, Path(path).stem, style)
        close(dataset)
        del dataset
    try:
        if not failures:
            leave_wal(path)
            with contextlib.closing(sqlite3.connect(path)) as connection, connection:
                tell_moment(connection, moment)
    except sqlite3.Error as error:
        failures.append(str(error))
    if failures:
        raise ParameterError("storage.file_unwritable", path=path, reason=failures[0].rstrip("."))


def _add(dataset: gdal.Dataset, layer: ogr.Layer, squares: Iterable[tuple]) -> None:
    dataset.StartTransaction()
    for (x, y), edge, values in squares:
        feature = ogr.Feature(layer.GetLayerDefn())
        for name, value in values.items():
            if value is not None:
                feature.SetField(name, value)
        half = edge / 2
        feature.SetGeometryDirectly(ogr.CreateGeometryFromWkb(square_wkb(x - half, y - half, x + half, y + half)))
        layer.CreateFeature(feature)
    dataset.CommitTransaction()


def _add_style(dataset: gdal.Dataset, layer: str, qml: str) -> None:
    """As the layer's default, called as that of *Assess reference database* is."""
    row = ("", "", layer, "geom", "SemRef", qml, None, 1, STYLE_OF_SEMREF, "", None, "now")
    write_feature(create_layer(dataset, STYLES, None), STYLE_FIELDS, None, row)
