"""What the columns of a database's layers are called, for people: in English here, and in the file for any program.

QGIS shows them in the user's language once the plugin has loaded the layers (``processing/wording/columns.py``).
"""

from __future__ import annotations

import contextlib
import sqlite3

SENTENCES_OF_WINDOWS = {
    "name": "Name",
    "level": "Level",
    "size": "Size (m)",
    "center_x": "Easting of the center",
    "center_y": "Northing of the center",
    "longitude": "Longitude",
    "latitude": "Latitude",
    "reference_count": "Landmarks",
    "vector": "Topology vector",
    "distinctiveness": "Distinctiveness",
}

SENTENCES_OF_REFERENCES = {
    "class": "Class value",
    "class_name": "Class",
    "area": "Area (m²)",
    "touches_edge": "Touches the edge",
}

_TITLES = {"windows": SENTENCES_OF_WINDOWS, "references": SENTENCES_OF_REFERENCES}

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
    rows = [(table, name, text, text) for table, titles in _TITLES.items() for name, text in titles.items()]
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        for statement in _TABLES:
            connection.execute(statement)
        connection.executemany(
            "INSERT INTO gpkg_data_columns (table_name, column_name, name, title) VALUES (?, ?, ?, ?)", rows
        )
        connection.executemany(_REGISTER, [("gpkg_data_columns",), ("gpkg_data_column_constraints",)])
