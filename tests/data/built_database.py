"""Shared parts of the tests of semref:builddatabase."""

import contextlib
import sqlite3

import numpy as np
from made_inputs import scattered_objects
from osgeo import ogr

BUILD = "semref:builddatabase"
HEIGHT, WIDTH, SIZE, STRIDE, MINIMUM_AREA = 300, 420, 120, 50, 40

LAYERS = {
    "windows": (
        ogr.wkbPolygon,
        "name String, level Integer, size Real, center_x Real, center_y Real, longitude Real, latitude Real, "
        "reference_count Integer, vector Binary, distinctiveness Real",
    ),
    "references": (ogr.wkbPoint, "class Integer, class_name String, area Real, touches_edge Integer(Boolean)"),
    "reference_bounds": (ogr.wkbNone, "first_column Integer, first_row Integer, end_column Integer, end_row Integer"),
    "classes": (
        ogr.wkbNone,
        "value Integer, name String, color String, role String, draw_order Real, hsv_min String, hsv_max String",
    ),
    "parameters": (ogr.wkbNone, "key String, value String"),
}

LONGITUDE = 7
"""Column of the table windows, after fid and geom."""


def map_labels() -> np.ndarray:
    """Return (H, W) labels with objects everywhere but in the left third, so that some windows have too few."""
    labels = scattered_objects(HEIGHT, WIDTH, 150, seed=5)
    labels[:, :140] = 4
    labels[20:30, 20:30] = 1
    labels[150:162, 30:45] = 2
    labels[-20:, -30:] = 0
    return labels


def columns_of(layer) -> str:
    definition, found = layer.GetLayerDefn(), []
    for index in range(definition.GetFieldCount()):
        field = definition.GetFieldDefn(index)
        kind = ogr.GetFieldTypeName(field.GetType())
        if field.GetSubType() != ogr.OFSTNone:
            kind += f"({ogr.GetFieldSubTypeName(field.GetSubType())})"
        found.append(f"{field.GetName()} {kind}")
    return ", ".join(found)


def content(database) -> dict:
    """Return all rows of the tables of the format, without the time of building."""
    with contextlib.closing(sqlite3.connect(f"file:{database}?mode=ro", uri=True)) as connection:
        return {name: connection.execute(f'SELECT * FROM "{name}" ORDER BY fid').fetchall() for name in LAYERS}


def most_frequent(labels: np.ndarray, factor: int) -> np.ndarray:
    """Return the most frequent value of each block; of equals the smallest."""
    height, width = (n // factor for n in labels.shape)
    blocks = labels[: height * factor, : width * factor].reshape(height, factor, width, factor).swapaxes(1, 2)
    return np.array([[np.bincount(block.ravel()).argmax() for block in row] for row in blocks])
