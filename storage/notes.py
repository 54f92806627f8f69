"""What files tell about themselves: QGIS's own notes, read and written where there is no QGIS.

``processing/exchange/layer_notes.py`` has QGIS write them.
"""

from __future__ import annotations

import contextlib
import shlex
import sqlite3
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import NamedTuple

from osgeo import gdal, osr

from .gdal_errors import gdal_failures

SENTENCES_OF_SOURCES = {"made_of": "Made of: {sources}"}

QGIS_STANDARD = "http://mrcc.com/qgis.dtd"
"""What QGIS calls the standard of its own metadata in a GeoPackage."""

LONGEST_NOTE = 1_000_000
"""Bytes of a note that is read."""

MOST_SOURCES = 200
"""That are asked for their notes: photos, of which there are thousands, have none."""

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

_STEPS_TO_READ = 200_000
"""Of SQLite's machine: a note is found in some hundred; who made the file may have made it hard on purpose."""

_METADATA_TABLES = "gpkg_metadata", "gpkg_metadata_reference"
_EXTENSION = (
    "INSERT INTO gpkg_extensions (table_name, column_name, extension_name, definition, scope) "
    "SELECT ?, NULL, 'gpkg_metadata', 'http://www.geopackage.org/spec120/#extension_metadata', 'read-write' "
    "WHERE NOT EXISTS (SELECT 1 FROM gpkg_extensions WHERE table_name = ?)"
)
"""They are an extension of GeoPackage, and registered as GDAL registers them."""


class LayerText(NamedTuple):
    """What a layer is called, and what it says of itself."""

    title: str
    abstract: str


@dataclass(frozen=True)
class Source:
    """What a file tells of itself by the note that QGIS keeps beside or in it.

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


def note_text(source: str) -> str:
    """The note that QGIS keeps of a file, as XML: beside a raster, in a GeoPackage; empty without one.

    Args:
        source: Path of the file; of a layer in a GeoPackage with ``|layername=NAME``, else the first note counts.
    """
    path, _, rest = source.partition("|")
    with contextlib.suppress(OSError, ValueError, sqlite3.Error):
        if path.lower().endswith(".gpkg") and Path(path).is_file():
            return _note_in_geopackage(path, rest.partition("layername=")[2].partition("|")[0])
        beside = Path(path).with_suffix(".qmd")
        if beside.is_file() and beside.stat().st_size <= LONGEST_NOTE:
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
            (QGIS_STANDARD, LONGEST_NOTE, table, table),
        ).fetchone()
    return str(row[0]) if row else ""


def raster_source(path: str) -> Source:
    """What is known of a raster; its name alone where there is no note, or none that can be read."""
    told = _told(path)
    titles = _texts(told, "title")
    return Source((titles or (Path(path).stem,))[0], _texts(told, "license"), _texts(told, "rights"))


def database_sources(path: str) -> list[Source]:
    """What is known of a database that has a note: called as its file, the note is a layer's."""
    told = _told(path)
    return [Source(Path(path).stem, _texts(told, "license"), _texts(told, "rights"))] if told else []


def _told(path: str) -> list[tuple[str, str]]:
    text, root = note_text(path), None
    with contextlib.suppress(RuntimeError), gdal_failures():
        root = gdal.ParseXMLString(text) if text else None
    return list(_elements(root)) if root else []


def _texts(told: Iterable[tuple[str, str]], name: str) -> tuple[str, ...]:
    return tuple(dict.fromkeys(text for found, text in told if found == name and text))


def history(moment: str, version: str, command: Sequence[str]) -> str:
    """A line that tells what made a file, and when.

    Args:
        moment: When (ISO 8601, UTC).
        version: Of the plugin.
        command: Of ``python -m cluster``, argument by argument.
    """
    return f"{moment[:10]} {moment[11:16]} UTC, SemRef {version}: python -m cluster {shlex.join(command)}"


def write_notes(  # noqa: PLR0913 - what a note tells
    path: str,
    texts: Mapping[str, LayerText],
    sources: Sequence[Source],
    crs_wkt: str,
    history: str,
    moment: str,
) -> None:
    """Writes the notes of a new GeoPackage, which has none.

    Args:
        path: The file.
        texts: Title and abstract of each of its tables that get a note.
        sources: What it was made of.
        crs_wkt: Its CRS.
        history: One line: what made it, and when.
        moment: What the file says of when notes were written (ISO 8601, UTC).

    Raises:
        sqlite3.Error: They can't be written.
    """
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        for statement in _TABLES:
            connection.execute(statement)
        connection.executemany(_EXTENSION, [(table, table) for table in _METADATA_TABLES])
        for table, text in texts.items():
            row = connection.execute(
                "SELECT min_x, min_y, max_x, max_y FROM gpkg_contents WHERE table_name = ?", (table,)
            ).fetchone()
            number = connection.execute(
                "INSERT INTO gpkg_metadata (md_scope, md_standard_uri, mime_type, metadata) "
                "VALUES ('dataset', ?, 'text/xml', ?)",
                (QGIS_STANDARD, _xml(text, sources, crs_wkt, history, row)),
            ).lastrowid
            connection.execute(
                "INSERT INTO gpkg_metadata_reference (reference_scope, table_name, timestamp, md_file_id) "
                "VALUES ('table', ?, ?, ?)",
                (table, moment, number),
            )


def _xml(
    text: LayerText, sources: Sequence[Source], crs_wkt: str, history: str, bounds: Sequence[float | None] | None
) -> str:
    parts = [text.abstract]
    if sources:
        parts.append(SENTENCES_OF_SOURCES["made_of"].format(sources="; ".join(source.text for source in sources)))
    srs = osr.SpatialReference(crs_wkt)
    code = f"{srs.GetAuthorityName(None)}:{srs.GetAuthorityCode(None)}" if srs.GetAuthorityCode(None) else ""
    extent = ""
    if bounds is not None and None not in bounds:
        sides = " ".join(f'{name}="{side!r}"' for name, side in zip(("minx", "miny", "maxx", "maxy"), bounds))
        extent = f'<extent><spatial dimensions="2" crs="{escape(code)}" {sides} minz="0" maxz="0"/></extent>'
    lines = [
        "<identifier></identifier><parentidentifier></parentidentifier><language></language><type>dataset</type>",
        _element("title", text.title),
        _element("abstract", "\n\n".join(parts)),
        "<links/>",
        *(_element("rights", each) for each in dict.fromkeys(each for source in sources for each in source.rights)),
        *(_element("license", each) for each in dict.fromkeys(each for source in sources for each in source.licenses)),
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
