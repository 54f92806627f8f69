"""Copy a reference database with SemRef's tables only."""

from __future__ import annotations

import contextlib
import os
import sqlite3
import tempfile
from functools import cache

from osgeo import gdal, ogr

from ..vector_files import copy_whole
from . import schema
from .connection import require_unchanged_since, snapshot

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
