"""Metadata of a layer: title, abstract, what made it and when, and the licenses of what it was made from.

QGIS shows it under Properties ▸ Metadata and Information; in a GeoPackage it is in ``gpkg_metadata``, beside a
raster in ``NAME.qmd``.
"""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsBox3d,
    QgsLayerMetadata,
    QgsMapLayer,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingUtils,
    QgsProviderRegistry,
    QgsVectorLayer,
)
from qgis.PyQt.QtXml import QDomDocument

from ...core import limits
from ...storage.qgis_metadata import QGIS_STANDARD, metadata_text
from ...storage.replaceable import MARK_OF_NOTE
from ...storage.vector_files import leave_wal
from ..translation import tr

_LONGEST_COMMAND = 20_000
"""Characters of a command: a run of thousands of images names each."""

_LAYERS = "source", "vector", "raster", "multilayer"

_MOST_LINES = 50
"""Of a history; each update of a database adds one."""

REFERENCES, WINDOWS = "references", "windows"
"""The tables of a database that are layers with a note."""

SENTENCES_OF_TITLES = {REFERENCES: "Landmarks", WINDOWS: "Windows"}

SENTENCES_OF_TABLES = {
    REFERENCES: "The landmarks of the whole map: center of gravity, class and area of each region of their classes.",
    WINDOWS: "The windows that slide over the map, each described by the topology vector of its landmarks.",
}
"""What a database's layers are, by table."""


@dataclass(frozen=True)
class Note:
    """Metadata of a layer.

    Attributes:
        history: Lines, the oldest first. A run adds one: when, by which version, and the call that makes it again.
        sources: Of the inputs that name licenses or rights: title, with these in brackets.
    """

    title: str = ""
    abstract: str = ""
    history: tuple[str, ...] = ()
    sources: str = ""

    def metadata(self, layer: QgsMapLayer) -> QgsLayerMetadata:
        """For QGIS; ``layer`` gives CRS and extent. Of a long history the first line and the newest stay."""
        lines = list(self.history)
        made = QgsLayerMetadata()
        made.setType("dataset")
        made.setTitle(self.title)
        made.setAbstract(self.abstract)
        made.setRights([self.sources] if self.sources else [])
        made.setHistory(lines if len(lines) <= _MOST_LINES else [lines[0], "…", *lines[1 - _MOST_LINES :]])
        made.setCrs(layer.crs())
        extent = QgsLayerMetadata.Extent()
        spatial = QgsLayerMetadata.SpatialExtent()
        spatial.extentCrs = layer.crs()
        if not layer.extent().isEmpty():
            spatial.bounds = QgsBox3d(layer.extent())
        extent.setSpatialExtents([spatial])
        made.setExtent(extent)
        return made

    def after(self, known: QgsLayerMetadata) -> Note:
        """Of a layer that this run changed: it stays what it was, and what made it before is its history, too."""
        return replace(
            self,
            abstract=known.abstract() or self.abstract,
            history=(*known.history(), *self.history),
            sources=_each_once([*known.rights(), self.sources]),
        )


def note_of_run(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext, version: str
) -> Note:
    """History and sources of what a run will write; call it where layers live, after they were read."""
    try:
        command = algorithm.asPythonCommand(parameters, context)
    except Exception:
        # QGIS raises anything for values that it can't write down; the layer is worth more than its history.
        command = f"processing.run({algorithm.id()!r}, …)"
    if len(command) > _LONGEST_COMMAND:
        command = f"{command[:_LONGEST_COMMAND]}…"
    now = datetime.now(timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    sources = _each_once(_source(title, one) for title, one in _inputs(algorithm, parameters, context))
    return Note(history=(f"{now}, SemRef {version}: {command}",), sources=sources)


def _each_once(texts: Iterable[str]) -> str:
    """The sources that some texts name, in their order, as one text."""
    return "; ".join(dict.fromkeys(source for text in texts for source in text.split("; ") if source))


def _source(title: str, one: QgsLayerMetadata) -> str:
    """What an input says of licenses; what SemRef made of others says it of them."""
    return f"{title} ({', '.join([*one.licenses(), *one.rights()])})" if one.licenses() else "; ".join(one.rights())


def _inputs(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Iterator[tuple[str, QgsLayerMetadata]]:
    """(title, metadata) of the inputs that are loaded layers, or files with a note; no layer is loaded for this."""
    for definition in algorithm.parameterDefinitions():
        value = parameters.get(definition.name())
        if definition.isDestination() or definition.type() not in (*_LAYERS, "file"):
            continue
        for one in (list(value) if isinstance(value, (list, tuple)) else [value])[: limits.SOURCES]:
            if isinstance(one, QgsProcessingFeatureSourceDefinition):
                one = one.source.staticValue()
            layer = one if isinstance(one, QgsMapLayer) else None
            if isinstance(one, str) and one and definition.type() != "file":
                layer = QgsProcessingUtils.mapLayerFromString(one, context, False)
            known = _of_layer(layer) if layer is not None else _of_file(one) if isinstance(one, str) else None
            if known is not None:
                # A database's note is of one of its layers, so that it is called by its file.
                title = "" if definition.type() == "file" else known.title()
                yield title or (layer.name() if layer is not None else Path(one).stem), known


def _of_layer(layer: QgsMapLayer) -> QgsLayerMetadata:
    """Return the metadata of a layer. A layer that only an algorithm loaded has not read the file beside it."""
    known = layer.metadata()
    return known if known.title() or known.licenses() or known.rights() else _of_file(layer.source()) or known


def _of_file(source: str) -> QgsLayerMetadata | None:
    """Return the metadata that QGIS stored for a file without a layer: beside a raster, in a GeoPackage; else None."""
    text = metadata_text(source)
    document, known = QDomDocument(), QgsLayerMetadata()
    # Qt 6.5 and later have another type of answer; false in both where it is no XML.
    if not text or not document.setContent(text) or not known.readMetadataXml(document.documentElement()):
        return None
    return known


def keep_in_file(destination: str, layer: QgsMapLayer, note: Note) -> bool:
    """Writes a note into a GeoPackage; ``layer``: the one at ``destination``. Whether it is there."""
    path = destination.split("|")[0]
    with contextlib.closing(sqlite3.connect(path)) as connection:
        # A file of one layer is named by its path alone, of which QGIS would find no layer to write about.
        table = connection.execute("SELECT table_name FROM gpkg_contents WHERE data_type = 'features'").fetchone()
    whole = destination if "layername=" in destination or table is None else f"{path}|layername={table[0]}"
    if not _holds_notes(whole, path):
        return True
    QgsProviderRegistry.instance().saveLayerMetadata("ogr", whole, note.metadata(layer))
    with contextlib.closing(sqlite3.connect(path)) as connection:
        query = "SELECT metadata FROM gpkg_metadata WHERE md_standard_uri = ? ORDER BY id DESC LIMIT 1"
        row = connection.execute(query, (QGIS_STANDARD,)).fetchone()
    return row is not None and str(row[0]).rstrip().endswith("</qgis>")


def _holds_notes(destination: str, path: str) -> bool:
    """Whether QGIS finds the file to write a note into; in a folder such as “maps.tar” it looks for an archive."""
    return QgsProviderRegistry.instance().decodeUri("ogr", destination).get("path") == path


def keep_beside(path: str, layer: QgsMapLayer, note: Note) -> None:
    """Writes a note where QGIS finds it beside a raster."""
    layer.setMetadata(note.metadata(layer))
    beside = Path(path).with_suffix(".qmd")
    layer.saveNamedMetadata(str(beside))
    text = beside.read_text(encoding="utf-8")
    beside.write_text(text.replace("</qgis>", f"{MARK_OF_NOTE}</qgis>"), encoding="utf-8")


def keep_in_database(path: str, note: Note) -> bool:
    """Writes a note into a reference database, to each of its layers; whether they are there.

    Of one that was changed, lines are added to the history that it has.
    """
    kept = True
    try:
        for table, title, abstract in _tables():
            source = f"{path}|layername={table}"
            layer = QgsVectorLayer(source, table, "ogr")
            own = replace(note, title=title, abstract=f"{abstract}\n\n{note.abstract}").after(layer.metadata())
            kept = layer.isValid() and keep_in_file(source, layer, own) and kept
            del layer
        leave_wal(path)
        _drop_copies(path)
    except sqlite3.Error:
        return False
    return kept


def _drop_copies(path: str) -> None:
    """Removes what GDAL writes of one table's note while that of the next is written: the same again, as its own."""
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        copies = connection.execute(
            "SELECT id FROM gpkg_metadata WHERE md_standard_uri = 'http://gdal.org' "
            "AND metadata LIKE '%<MDI key=\"GPKG_METADATA_ITEM_%'"
        ).fetchall()
        connection.executemany("DELETE FROM gpkg_metadata_reference WHERE md_file_id = ?", copies)
        connection.executemany("DELETE FROM gpkg_metadata WHERE id = ?", copies)


def _tables() -> tuple[tuple[str, str, str], ...]:
    """(table, title, what it holds) of a database's layers that can hold a note."""
    return tuple(
        (table, tr(SENTENCES_OF_TITLES[table]), tr(SENTENCES_OF_TABLES[table])) for table in (REFERENCES, WINDOWS)
    )
