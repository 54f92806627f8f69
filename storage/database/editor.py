"""Apply the changes of an update to a copy of a reference database; unchanged rows keep their fids."""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Iterator, Sequence

import numpy as np
from osgeo import gdal, ogr

from ...core.database.model import Windows
from ...core.database.parameters import BuildParameters
from ...core.database.update import DatabaseChanges
from ...core.steps import Steps
from ..gdal_errors import unwritten_database
from ..vector_files import leave_wal
from . import schema
from .copying import copy_database
from .reader import StoredDatabase, store_checksums

_FEATURES_A_STEP = 500

_UNSAFE = ["PRELUDE_STATEMENTS=PRAGMA synchronous=OFF"]
"""Waiting for the disk after each step would take most of the time; the finished file is flushed once."""


def write_changes(path: str, stored: StoredDatabase, changes: DatabaseChanges) -> Steps[None]:
    """Write a changed database as a new file.

    Raises:
        UnwritableError: GDAL can't write.
    """
    try:
        copy_database(stored.database.source, path, stored.state)
        yield "Writing the database", 0.2
        yield from _edit(path, stored, changes)
        _edit_overview(path, changes)
        leave_wal(path)
        store_checksums(path)
        with open(path, "rb+") as file:
            os.fsync(file.fileno())
        yield "Writing the database", 1.0
    except (RuntimeError, sqlite3.Error) as error:
        raise unwritten_database(error) from None


def _edit(path: str, stored: StoredDatabase, changes: DatabaseChanges) -> Steps[None]:
    dataset = _open(path, gdal.OF_VECTOR)
    dataset.StartTransaction()
    total = len(changes.touched) + len(changes.removed) + len(changes.added) + 1
    for n, _ in enumerate(_edit_layers(dataset, stored, changes)):
        if n % _FEATURES_A_STEP == 0:
            yield "Writing the database", 0.2 + 0.6 * n / total
    if len(changes.removed):
        # Deleting features does not shrink the extent of the layer.
        dataset.ExecuteSQL("RECOMPUTE EXTENT ON references")
    schema.commit(dataset)
    schema.flush(dataset)


def _edit_layers(dataset: gdal.Dataset, stored: StoredDatabase, changes: DatabaseChanges) -> Iterator[None]:
    """Edit windows, landmarks and parameters; yield after each feature."""
    windows = dataset.GetLayerByName(schema.WINDOWS)
    for i in changes.touched.tolist():
        feature = windows.GetFeature(stored.window_fids[i])
        _set_window(feature, changes.windows, i)
        _check(windows.SetFeature(feature))
        yield
    references = dataset.GetLayerByName(schema.REFERENCES)
    bounds = dataset.GetLayerByName(schema.BOUNDS)
    for i in changes.removed.tolist():
        for layer in (references, bounds):
            _check(layer.DeleteFeature(stored.reference_fids[i]))
        yield
    rows = schema.reference_rows(changes.added, stored.database.class_table)
    for (wkb, values), corners in zip(rows, changes.added.bounds_px.tolist()):
        fid = schema.write_feature(references, schema.REFERENCE_FIELDS, wkb, values)
        schema.write_feature(bounds, schema.BOUNDS_FIELDS, None, corners, fid)
        yield
    _edit_parameters(dataset.GetLayerByName(schema.PARAMETERS), changes.parameters)
    yield


def _set_window(feature: ogr.Feature, windows: Windows, i: int) -> None:
    distinctiveness = windows.distinctiveness[i]
    feature.SetField("reference_count", int(windows.counts[i]))
    if windows.described[i]:
        index = feature.GetFieldIndex("vector")
        feature.SetFieldBinaryFromHexString(index, windows.vectors[i].astype("<f4").tobytes().hex())
    else:
        feature.SetFieldNull("vector")
    if np.isfinite(distinctiveness):
        feature.SetField("distinctiveness", float(distinctiveness))
    else:
        feature.SetFieldNull("distinctiveness")


def _edit_parameters(layer: ogr.Layer, parameters: BuildParameters) -> None:
    texts = schema.parameter_texts(parameters)
    for feature in list(layer):
        if feature.GetField("key") in texts:
            feature.SetField("value", texts[feature.GetField("key")])
            _check(layer.SetFeature(feature))


def _edit_overview(path: str, changes: DatabaseChanges) -> None:
    dataset = _open(path, gdal.OF_RASTER, [f"TABLE={schema.OVERVIEW}"])
    band = dataset.GetRasterBand(1)
    for column, row, labels in changes.overview:
        band.WriteArray(labels, column, row)
    schema.flush(dataset)


def _open(path: str, kind: int, options: Sequence[str] = ()) -> gdal.Dataset:
    dataset = gdal.OpenEx(path, kind | gdal.OF_UPDATE, ["GPKG"], [*_UNSAFE, *options])
    if dataset is None:
        raise unwritten_database()
    return dataset


def _check(failure: int) -> None:
    if failure != ogr.OGRERR_NONE:
        raise unwritten_database()
