"""Apply the changes of an update to a copy of a reference database; unchanged rows keep their fids."""

from __future__ import annotations

import contextlib
import os
import sqlite3
import tempfile
from collections.abc import Iterator, Sequence
from functools import cache

import numpy as np
from osgeo import gdal, ogr

from ...core.database.model import Windows
from ...core.database.parameters import BuildParameters
from ...core.database.update import DatabaseChanges
from ...core.steps import Steps
from ..gdal_errors import unwritten_database
from ..vector_files import copy_whole, leave_wal
from . import schema
from .connection import require_unchanged_since, snapshot
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


_OWN = (*schema.LAYERS, schema.OVERVIEW)
_LOOSE_SHARE = 0.1
_KEPT_PREFIXES = ("gpkg_", "sqlite_", "rtree_windows_geom", "rtree_references_geom")


def copy_database(path: str, target: str, state_when_read: tuple) -> None:
    """Copy SemRef's tables of a database, including changes in its journal.

    Foreign tables, views and triggers are not copied. GDAL's triggers for the spatial index are created again.

    Args:
        state_when_read: ``connection.state`` of the database when it was read.

    Raises:
        DatabaseError: The database is in use, damaged, or changed since it was read; or the copy can't be written.
        sqlite3.Error: The copy can't be edited.
    """
    with contextlib.closing(_connect(target)) as copy:
        with snapshot(path) as source:
            require_unchanged_since(path, state_when_read)
            source.rollback()
            copy_whole(source, copy)
            require_unchanged_since(path, state_when_read)
        _remove_foreign(copy)
    # A new connection: the old one still has the removed parts of the schema.
    with contextlib.closing(_connect(target)) as copy:
        copy.execute("BEGIN")
        _drop_foreign_tables(copy)
        there = {name for (name,) in copy.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
        for table, statement in _own_triggers():
            if table in there:
                copy.execute(statement)
        copy.execute("COMMIT")
        if _is_loose(copy):
            copy.execute("VACUUM")


def _connect(target: str) -> sqlite3.Connection:
    """Open a copy that nobody else uses and that is flushed when it is complete."""
    connection = sqlite3.connect(target, isolation_level=None)
    connection.execute("PRAGMA synchronous=OFF")
    return connection


def _is_loose(copy: sqlite3.Connection) -> bool:
    """Whether enough pages are free to compact the file, for example after dropping large foreign tables."""
    ((free,), (pages,)) = (copy.execute(f"PRAGMA {name}").fetchone() for name in ("freelist_count", "page_count"))
    return free > _LOOSE_SHARE * pages


def _remove_foreign(copy: sqlite3.Connection) -> None:
    """Remove triggers and views from the schema without a statement that could run them."""
    copy.execute("PRAGMA trusted_schema=OFF")
    copy.execute("PRAGMA writable_schema=ON")
    copy.execute("DELETE FROM sqlite_master WHERE type IN ('trigger', 'view')")
    copy.execute("PRAGMA writable_schema=RESET")


def _drop_foreign_tables(copy: sqlite3.Connection) -> None:
    # %w is SQLite's own way to quote a name.
    rows = copy.execute(
        "SELECT name, printf('DROP TABLE IF EXISTS \"%w\"', name) FROM sqlite_master WHERE type = 'table'"
    )
    foreign = [drop for name, drop in rows.fetchall() if name not in _OWN and not name.startswith(_KEPT_PREFIXES)]
    for drop in foreign:
        copy.execute(drop)
    for statement in _FORGET:
        if foreign:
            copy.execute(statement)


_FORGET = (
    "DELETE FROM gpkg_contents WHERE table_name NOT IN (SELECT name FROM sqlite_master)",
    "DELETE FROM gpkg_ogr_contents WHERE table_name NOT IN (SELECT name FROM sqlite_master)",
    "DELETE FROM gpkg_geometry_columns WHERE table_name NOT IN (SELECT name FROM sqlite_master)",
    "DELETE FROM gpkg_extensions WHERE table_name NOT IN (SELECT name FROM sqlite_master)",
)


@cache
def _own_triggers() -> list[tuple[str, str]]:
    """Return (table, SQL) of the triggers that this version of GDAL creates."""
    with tempfile.TemporaryDirectory(prefix="semref-") as folder:
        path = os.path.join(folder, "empty.gpkg")
        dataset = ogr.GetDriverByName("GPKG").CreateDataSource(path)
        for name in schema.LAYERS:
            schema.create_layer(dataset, name, None)
        schema.flush(dataset)
        del dataset
        options = ["APPEND_SUBDATASET=YES", f"RASTER_TABLE={schema.OVERVIEW}"]
        pixel = gdal.GetDriverByName("MEM").Create("", 1, 1)
        pixel.SetGeoTransform((0.0, 1.0, 0.0, 0.0, 0.0, -1.0))
        schema.flush(gdal.GetDriverByName("GPKG").CreateCopy(path, pixel, options=options))
        with contextlib.closing(sqlite3.connect(path)) as template:
            return template.execute("SELECT tbl_name, sql FROM sqlite_master WHERE type = 'trigger'").fetchall()
