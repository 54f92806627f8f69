"""What a database's layers tell about themselves where there is no QGIS."""

from __future__ import annotations

import sqlite3

from ...core.errors import DatabaseError
from .. import notes
from . import schema

SENTENCES_OF_TITLES = {schema.REFERENCES: "Landmarks", schema.WINDOWS: "Windows"}

SENTENCES_OF_TABLES = {
    schema.REFERENCES: (
        "The landmarks of the whole map: center of gravity, class and area of each region of their classes."
    ),
    schema.WINDOWS: "The windows that slide over the map, each described by the topology vector of its landmarks.",
}

_ABOUT = (
    "One GeoPackage with the layers windows, references, overview, classes and parameters.",
    "Slides windows over a label map and describes each by the topology vector of its landmarks; saves windows, "
    "landmarks of the whole map, a reduced map, classes and parameters in one GeoPackage.",
)
"""What *Build reference database* says of its output and of itself."""


def write_notes(path: str, source: notes.Source, crs_wkt: str, history: str, moment: str) -> None:
    """Writes the notes of a new database, which has none.

    Args:
        path: The database.
        source: What it was made of.
        crs_wkt: Its CRS.
        history: One line: what made it, and when.
        moment: What the file says of when notes were written (ISO 8601, UTC).

    Raises:
        DatabaseError: They can't be written.
    """
    texts = {
        table: notes.LayerText(title, "\n\n".join((SENTENCES_OF_TABLES[table], *_ABOUT)))
        for table, title in SENTENCES_OF_TITLES.items()
    }
    try:
        notes.write_notes(path, texts, [source], crs_wkt, history, moment)
    except sqlite3.Error as error:
        raise DatabaseError("storage.database_unwritable", reason=str(error).rstrip(".")) from None
