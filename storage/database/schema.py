"""Layers and columns of a reference database (docs/reference/file_formats.md), and writing a row."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Iterator, Sequence

import numpy as np
from osgeo import gdal, ogr, osr

from ...core.database.model import MapLandmarks
from ...core.database.parameters import BuildParameters
from ...core.labels.class_table import ClassTable
from ...core.values import schema
from ..gdal_errors import unwritten_database

WINDOWS, REFERENCES, BOUNDS, OVERVIEW = "windows", "references", "reference_bounds", "overview"
CLASSES, PARAMETERS, STYLES = "classes", "parameters", "layer_styles"

_OGR_TYPES = {
    "integer": ogr.OFTInteger,
    "real": ogr.OFTReal,
    "text": ogr.OFTString,
    "blob": ogr.OFTBinary,
    "boolean": ogr.OFTInteger,
    "datetime": ogr.OFTDateTime,
}

WINDOW_FIELDS = schema(
    "name text, level integer, size real, center_x real, center_y real, longitude real, latitude real, "
    "reference_count integer, vector blob, distinctiveness real"
)
REFERENCE_FIELDS = schema("class integer, class_name text, area real, touches_edge boolean")
BOUNDS_FIELDS = schema("first_column integer, first_row integer, end_column integer, end_row integer")
CLASS_FIELDS = schema("value integer, name text, color text, role text, draw_order real, hsv_min text, hsv_max text")
CLASS_COLUMNS = tuple(name for name, _ in CLASS_FIELDS)
PARAMETER_FIELDS = schema("key text, value text")
STYLE_FIELDS = schema(
    "f_table_catalog text, f_table_schema text, f_table_name text, f_geometry_column text, styleName text, "
    "styleQML text, styleSLD text, useAsDefault boolean, description text, owner text, ui text, update_time datetime"
)

LAYERS = {
    WINDOWS: (ogr.wkbPolygon, WINDOW_FIELDS),
    REFERENCES: (ogr.wkbPoint, REFERENCE_FIELDS),
    BOUNDS: (ogr.wkbNone, BOUNDS_FIELDS),
    CLASSES: (ogr.wkbNone, CLASS_FIELDS),
    PARAMETERS: (ogr.wkbNone, PARAMETER_FIELDS),
    STYLES: (ogr.wkbNone, STYLE_FIELDS),
}
"""Geometry type and columns of each layer, in the order of writing."""

TABLES = (*LAYERS, OVERVIEW)
"""All tables of a database."""


def create_layer(dataset: ogr.DataSource, name: str, srs: osr.SpatialReference | None) -> ogr.Layer:
    """Create an empty layer of the schema; ``srs``: for layers with geometry. Raises UnwritableError."""
    geometry, columns = LAYERS[name]
    fid = "FID=id" if name == STYLES else "FID=fid"
    layer = dataset.CreateLayer(name, None if geometry == ogr.wkbNone else srs, geometry, [fid])
    if layer is None:
        raise unwritten_database()
    for column, kind in columns:
        definition = ogr.FieldDefn(column, _OGR_TYPES[kind])
        if kind == "boolean":
            definition.SetSubType(ogr.OFSTBoolean)
        layer.CreateField(definition)
    return layer


def reference_rows(references: MapLandmarks, table: ClassTable) -> Iterator[tuple[bytes, tuple]]:
    """Yield the WKB geometry and the column values of each reference."""
    names = {c.value: c.name for c in table}
    for i in range(len(references)):
        x, y = references.positions[i].tolist()
        value = int(references.classes[i])
        values = value, names[value], float(references.areas_m2[i]), int(references.touches_edge[i])
        yield struct.pack("<BIdd", 1, ogr.wkbPoint, x, y), values


def parameter_texts(parameters: BuildParameters) -> dict[str, str]:
    """Return the rows of the table ``parameters``."""
    return {name: json.dumps(value) for name, value in vars(parameters).items()}


def write_feature(
    layer: ogr.Layer, fields: Sequence[tuple[str, str]], wkb: bytes | None, values: Sequence, fid: int | None = None
) -> int:
    """Add a feature and return its fid; None and NaN become NULL."""
    feature = ogr.Feature(layer.GetLayerDefn())
    if fid is not None:
        feature.SetFID(fid)
    for index, ((_, kind), value) in enumerate(zip(fields, values)):
        if value is None or (kind == "real" and not math.isfinite(value)):
            continue
        if kind == "blob":
            feature.SetFieldBinaryFromHexString(index, value.hex())
        elif kind == "datetime":
            now = np.datetime64("now").astype(object)
            feature.SetField(index, now.year, now.month, now.day, now.hour, now.minute, float(now.second), 100)
        else:
            feature.SetField(index, value)
    if wkb is not None:
        feature.SetGeometryDirectly(ogr.CreateGeometryFromWkb(wkb))
    if layer.CreateFeature(feature) != ogr.OGRERR_NONE:
        raise unwritten_database()
    return feature.GetFID()


def commit(dataset: gdal.Dataset) -> None:
    """End a transaction. Raises UnwritableError if this fails: SQLite then drops all its rows."""
    if dataset.CommitTransaction() != ogr.OGRERR_NONE:
        raise unwritten_database()


def flush(dataset: gdal.Dataset) -> None:
    """Write pending data. Raises UnwritableError if this fails."""
    gdal.ErrorReset()
    dataset.FlushCache()
    if gdal.GetLastErrorType() >= gdal.CE_Failure:
        raise unwritten_database()


def square_wkb(left: float, bottom: float, right: float, top: float) -> bytes:
    """Return the WKB of a square with a counterclockwise ring from the lower left corner, as QGIS writes it."""
    ring = (left, bottom, right, bottom, right, top, left, top, left, bottom)
    return struct.pack("<BIII10d", 1, ogr.wkbPolygon, 1, 5, *ring)
