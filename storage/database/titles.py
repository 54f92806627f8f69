"""What the columns of a database's layers are called, for people: in English, in the file for any program.

QGIS shows them in the user's language; both come from the aliases of ``resources/styles/columns.qml``.
"""

from __future__ import annotations

import contextlib
import re
import sqlite3
from html import unescape
from pathlib import Path

from .schema import REFERENCE_FIELDS, WINDOW_FIELDS

_TITLES = Path(__file__).resolve().parents[2] / "resources" / "styles" / "columns.qml"
_ALIAS = re.compile('<alias field="([^"]+)" name="([^"]+)"/>')

# As GDAL makes them, and as GeoPackage's extension for schemas wants them: both tables, registered.
_TABLES = (
    "CREATE TABLE gpkg_data_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, name TEXT, title TEXT, "
    "description TEXT, mime_type TEXT, constraint_name TEXT, "
    "CONSTRAINT pk_gdc PRIMARY KEY (table_name, column_name), CONSTRAINT gdc_tn UNIQUE (table_name, name))",
    "CREATE TABLE gpkg_data_column_constraints (constraint_name TEXT NOT NULL, constraint_type TEXT NOT NULL, "
    "value TEXT, min NUMERIC, min_is_inclusive BOOLEAN, max NUMERIC, max_is_inclusive BOOLEAN, description TEXT, "
    "CONSTRAINT gdcc_ntv UNIQUE (constraint_name, constraint_type, value))",
)
_REGISTER = (
    "INSERT INTO gpkg_extensions (table_name, column_name, extension_name, definition, scope) "
    "VALUES (?, NULL, 'gpkg_schema', 'http://www.geopackage.org/spec121/#extension_schema', 'read-write')"
)


def tell_titles(path: str) -> None:
    """Writes the titles into a new database; GDAL 3.6 can't write them itself. Raises sqlite3.Error."""
    titles = {name: unescape(text) for name, text in _ALIAS.findall(_TITLES.read_text(encoding="utf-8"))}
    tables = ("windows", WINDOW_FIELDS), ("references", REFERENCE_FIELDS)
    rows = [(table, name, titles[name], titles[name]) for table, fields in tables for name, _ in fields]
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        for statement in _TABLES:
            connection.execute(statement)
        connection.executemany(
            "INSERT INTO gpkg_data_columns (table_name, column_name, name, title) VALUES (?, ?, ?, ?)", rows
        )
        connection.executemany(_REGISTER, [("gpkg_data_columns",), ("gpkg_data_column_constraints",)])
