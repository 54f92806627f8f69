"""Read layer metadata from the .qmd file or the GeoPackage that QGIS wrote it into."""

from __future__ import annotations

import contextlib
import sqlite3
from pathlib import Path

from ..core import limits

QGIS_STANDARD = "http://mrcc.com/qgis.dtd"
"""What QGIS calls the standard of its own metadata in a GeoPackage."""

_STEPS_TO_READ = 200_000
"""Of SQLite's machine: a note is found in some hundred; who made the file may have made it hard on purpose."""


def metadata_text(source: str) -> str:
    """The note that QGIS keeps of a file, as XML: beside a raster, in a GeoPackage; empty without one.

    Args:
        source: Path of the file; of a layer in a GeoPackage with ``|layername=NAME``, else the first note counts.
    """
    path, _, rest = source.partition("|")
    with contextlib.suppress(OSError, ValueError, sqlite3.Error):
        if path.lower().endswith(".gpkg") and Path(path).is_file():
            return _note_in_geopackage(path, rest.partition("layername=")[2].partition("|")[0])
        beside = Path(path).with_suffix(".qmd")
        if beside.is_file() and beside.stat().st_size <= limits.METADATA_BYTES:
            return beside.read_text(encoding="utf-8")
    return ""


def _note_in_geopackage(path: str, table: str) -> str:
    """That of a table, or the first without a name; empty without one. Raises sqlite3.Error, ValueError."""
    uri = f"{Path(path).resolve().as_uri()}?mode=ro&immutable=1"
    with contextlib.closing(sqlite3.connect(uri, uri=True)) as connection:
        connection.execute("PRAGMA trusted_schema=OFF")
        connection.set_progress_handler(lambda: 1, _STEPS_TO_READ)
        row = connection.execute(
            "SELECT m.metadata FROM gpkg_metadata m JOIN gpkg_metadata_reference r ON r.md_file_id = m.id "
            "WHERE m.md_standard_uri = ? AND length(m.metadata) <= ? AND (? = '' OR r.table_name = ?) "
            "ORDER BY m.id LIMIT 1",
            (QGIS_STANDARD, limits.METADATA_BYTES, table, table),
        ).fetchone()
    return str(row[0]) if row else ""
