"""Apply the changes of an update to a copy of a reference database; unchanged rows keep their fids."""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Iterator, Sequence
from dataclasses import fields

import numpy as np
from osgeo import gdal, ogr

from ...core.database.update import DatabaseChanges
from ...core.errors import DatabaseError
from ..gdal_errors import gdal_failure
from ..vector_files import leave_wal
from . import schema
from .copying import copy_database
from .reader import StoredDatabase, store_checksums

_FEATURES_A_STEP = 500

_UNSAFE = ["PRELUDE_STATEMENTS=PRAGMA synchronous=OFF"]
"""Waiting for the disk after each step would take most of the time; the finished file is flushed once."""


class DatabaseEditor:
    """Writer of a changed database as a new file. Iterate ``steps()`` to the end."""

    def __init__(self, path: str, stored: StoredDatabase, changes: DatabaseChanges) -> None:
        """Prepare without writing.

        Args:
            stored: The database before the update.
        """
        self._path = path
        self._stored = stored
        self._changes = changes

    def steps(self) -> Iterator[tuple[str, float]]:
        """Yield (current step, share done 0…1).

        Raises:
            DatabaseError: GDAL can't write.
        """
        try:
            copy_database(self._stored.database.source, self._path, self._stored.state)
            yield "Writing the database", 0.2
            for share in self._edit():
                yield "Writing the database", 0.2 + 0.6 * share
            self._edit_overview()
            leave_wal(self._path)
            store_checksums(self._path)
            with open(self._path, "rb+") as file:
                os.fsync(file.fileno())
            yield "Writing the database", 1.0
        except (RuntimeError, sqlite3.Error) as error:
            raise DatabaseError("The database can't be written: {reason}.", reason=gdal_failure(error)) from None

    def _edit(self) -> Iterator[float]:
        dataset = _open(self._path, gdal.OF_VECTOR)
        dataset.StartTransaction()
        total = len(self._changes.touched) + len(self._changes.removed) + len(self._changes.added) + 1
        for n, _ in enumerate(self._edit_layers(dataset)):
            if n % _FEATURES_A_STEP == 0:
                yield n / total
        if len(self._changes.removed):
            # Deleting features does not shrink the extent of the layer.
            dataset.ExecuteSQL("RECOMPUTE EXTENT ON references")
        dataset.CommitTransaction()
        schema.close(dataset)

    def _edit_layers(self, dataset: gdal.Dataset) -> Iterator[None]:
        windows = dataset.GetLayerByName(schema.WINDOWS)
        for i in self._changes.touched.tolist():
            feature = windows.GetFeature(self._stored.window_fids[i])
            self._set_window(feature, i)
            _check(windows.SetFeature(feature))
            yield
        references = dataset.GetLayerByName(schema.REFERENCES)
        bounds = dataset.GetLayerByName(schema.BOUNDS)
        for i in self._changes.removed.tolist():
            for layer in (references, bounds):
                _check(layer.DeleteFeature(self._stored.reference_fids[i]))
            yield
        added = self._changes.added
        rows = schema.reference_rows(added, self._stored.database.class_table)
        for (wkb, values), corners in zip(rows, added.bounds_px.tolist()):
            fid = schema.write_feature(references, schema.REFERENCE_FIELDS, wkb, values)
            schema.write_feature(bounds, schema.BOUNDS_FIELDS, None, corners, fid)
            yield
        self._edit_parameters(dataset.GetLayerByName(schema.PARAMETERS))
        yield

    def _set_window(self, feature: ogr.Feature, i: int) -> None:
        windows, distinctiveness = self._changes.windows, self._changes.windows.distinctiveness[i]
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

    def _edit_parameters(self, layer: ogr.Layer) -> None:
        parameters = self._changes.parameters
        texts = {item.name: schema.parameter_text(parameters, item.name) for item in fields(parameters)}
        for feature in list(layer):
            if feature.GetField("key") in texts:
                feature.SetField("value", texts[feature.GetField("key")])
                _check(layer.SetFeature(feature))

    def _edit_overview(self) -> None:
        dataset = _open(self._path, gdal.OF_RASTER, [f"TABLE={schema.OVERVIEW}"])
        band = dataset.GetRasterBand(1)
        for column, row, labels in self._changes.overview:
            band.WriteArray(labels, column, row)
        schema.close(dataset)


def _open(path: str, kind: int, options: Sequence[str] = ()) -> gdal.Dataset:
    dataset = gdal.OpenEx(path, kind | gdal.OF_UPDATE, ["GPKG"], [*_UNSAFE, *options])
    if dataset is None:
        raise DatabaseError("The database can't be written: {reason}.", reason=gdal_failure())
    return dataset


def _check(failure: int) -> None:
    if failure != ogr.OGRERR_NONE:
        raise DatabaseError("The database can't be written: {reason}.", reason=gdal_failure())
