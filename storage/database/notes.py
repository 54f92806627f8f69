"""What a database's layers tell about themselves where there is no QGIS: in words and place of QGIS's own notes.

``processing/exchange/layer_notes.py`` has QGIS write them.
"""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path

from osgeo import gdal, osr

from ...core.errors import DatabaseError
from ..gdal_errors import gdal_failures
from . import schema

SENTENCES_OF_TITLES = {schema.REFERENCES: "Landmarks", schema.WINDOWS: "Windows"}

SENTENCES_OF_TABLES = {
    schema.REFERENCES: (
        "The landmarks of the whole map: center of gravity, class and area of each region of their classes."
    ),
    schema.WINDOWS: "The windows that slide over the map, each described by the topology vector of its landmarks.",
}

SENTENCES_OF_SOURCES = {"made_of": "Made of: {sources}"}

_ABOUT = (
    "One GeoPackage with the layers windows, references, overview, classes and parameters.",
    "Slides windows over a label map and describes each by the topology vector of its landmarks; saves windows, "
    "landmarks of the whole map, a reduced map, classes and parameters in one GeoPackage.",
)
"""What *Build reference database* says of its output and of itself."""

QGIS_STANDARD = "http://mrcc.com/qgis.dtd"
"""What QGIS calls the standard of its own metadata in a GeoPackage."""

LONGEST_NOTE = 1_000_000
"""Bytes of a note that is read."""

_DOCTYPE = "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"

# As GDAL makes them; a database with an overview has them.
_TABLES = (
    "CREATE TABLE IF NOT EXISTS gpkg_metadata (id INTEGER CONSTRAINT m_pk PRIMARY KEY ASC NOT NULL,"
    "md_scope TEXT NOT NULL DEFAULT 'dataset',md_standard_uri TEXT NOT NULL,"
    "mime_type TEXT NOT NULL DEFAULT 'text/xml',metadata TEXT NOT NULL DEFAULT '')",
    "CREATE TABLE IF NOT EXISTS gpkg_metadata_reference (reference_scope TEXT NOT NULL,table_name TEXT,"
    "column_name TEXT,row_id_value INTEGER,timestamp DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')),"
    "md_file_id INTEGER NOT NULL,md_parent_id INTEGER,"
    "CONSTRAINT crmr_mfi_fk FOREIGN KEY (md_file_id) REFERENCES gpkg_metadata(id),"
    "CONSTRAINT crmr_mpi_fk FOREIGN KEY (md_parent_id) REFERENCES gpkg_metadata(id))",
)


@dataclass(frozen=True)
class Source:
    """What a file tells of itself by the note that QGIS keeps beside it.

    Attributes:
        title: Its name, where it tells none.
        licenses: That it names.
        rights: As well.
    """

    title: str
    licenses: tuple[str, ...] = ()
    rights: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """Title, with licenses in brackets."""
        return f"{self.title} ({', '.join(self.licenses)})" if self.licenses else self.title


def source_of(path: str) -> Source:
    """What is known of a raster; its name alone where there is no note, or none that can be read."""
    beside, root = Path(path).with_suffix(".qmd"), None
    with contextlib.suppress(OSError, ValueError):
        if beside.is_file() and beside.stat().st_size <= LONGEST_NOTE:
            text = beside.read_text(encoding="utf-8")
            with gdal_failures():
                root = gdal.ParseXMLString(text)
    told = list(_elements(root)) if root else []

    def texts(name: str) -> tuple[str, ...]:
        return tuple(dict.fromkeys(text for found, text in told if found == name and text))

    return Source((texts("title") or (Path(path).stem,))[0], texts("license"), texts("rights"))


def write_notes(path: str, source: Source, crs_wkt: str, history: str, moment: str) -> None:
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
    try:
        with contextlib.closing(sqlite3.connect(path)) as connection, connection:
            for statement in _TABLES:
                connection.execute(statement)
            for table in SENTENCES_OF_TITLES:
                row = connection.execute(
                    "SELECT min_x, min_y, max_x, max_y FROM gpkg_contents WHERE table_name = ?", (table,)
                ).fetchone()
                note = _xml(table, source, crs_wkt, history, row)
                number = connection.execute(
                    "INSERT INTO gpkg_metadata (md_scope, md_standard_uri, mime_type, metadata) "
                    "VALUES ('dataset', ?, 'text/xml', ?)",
                    (QGIS_STANDARD, note),
                ).lastrowid
                connection.execute(
                    "INSERT INTO gpkg_metadata_reference (reference_scope, table_name, timestamp, md_file_id) "
                    "VALUES ('table', ?, ?, ?)",
                    (table, moment, number),
                )
    except sqlite3.Error as error:
        raise DatabaseError("storage.database_unwritable", reason=str(error).rstrip(".")) from None


def _xml(table: str, source: Source, crs_wkt: str, history: str, bounds: Sequence[float | None] | None) -> str:
    made_of = SENTENCES_OF_SOURCES["made_of"].format(sources=source.text)
    parts = (SENTENCES_OF_TABLES[table], *_ABOUT, made_of)
    srs = osr.SpatialReference(crs_wkt)
    code = f"{srs.GetAuthorityName(None)}:{srs.GetAuthorityCode(None)}" if srs.GetAuthorityCode(None) else ""
    extent = ""
    if bounds is not None and None not in bounds:
        sides = " ".join(f'{name}="{side!r}"' for name, side in zip(("minx", "miny", "maxx", "maxy"), bounds))
        extent = f'<extent><spatial dimensions="2" crs="{escape(code)}" {sides} minz="0" maxz="0"/></extent>'
    lines = [
        "<identifier></identifier><parentidentifier></parentidentifier><language></language><type>dataset</type>",
        _element("title", SENTENCES_OF_TITLES[table]),
        _element("abstract", "\n\n".join(parts)),
        "<links/>",
        *(_element("rights", text) for text in source.rights),
        *(_element("license", text) for text in source.licenses),
        _element("history", history),
        "<fees></fees><encoding></encoding>",
        f"<crs><spatialrefsys>{_element('wkt', crs_wkt)}{_element('authid', code)}</spatialrefsys></crs>",
        extent,
    ]
    return f'{_DOCTYPE}<qgis version="3.22">\n{"".join(f"{line}{chr(10)}" for line in lines if line)}</qgis>\n'


def _element(name: str, text: str) -> str:
    return f"<{name}>{escape(text, quote=False)}</{name}>"


def _elements(node: Sequence) -> Iterator[tuple[str, str]]:
    """(name, text) of the elements right in a note; GDAL gives [kind, name or text, *children]."""
    kind, name, *children = node
    if kind == gdal.CXT_Element and name not in ("", "qgis"):
        yield name, "".join(child[1] for child in children if child[0] == gdal.CXT_Text).strip()
        return
    for child in children:
        yield from _elements(child)
