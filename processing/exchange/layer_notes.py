"""What a layer tells about itself: title, abstract, licenses of what it was made from, and how it was made.

QGIS shows it under Properties ▸ Metadata and Information; in a GeoPackage it stands in ``gpkg_metadata``, beside a
raster in ``NAME.qmd``.
"""

from __future__ import annotations

import contextlib
import sqlite3
from dataclasses import dataclass, field, replace
from pathlib import Path

from qgis.core import QgsBox3d, QgsLayerMetadata, QgsMapLayer, QgsProviderRegistry, QgsVectorLayer

from ...storage.notes import QGIS_STANDARD
from ...storage.vector_files import leave_wal
from ..translation import tr
from .database_layers import REFERENCES, WINDOWS
from .lineage import Lineage, each_once

_MOST_LINES, _LONGEST_HISTORY = 50, 150_000
"""Lines and characters of a history: no note of more than a million is read, and in XML a sign may take six."""

_LEFT_OUT = "…"

SENTENCES_OF_TITLES = {REFERENCES: "Landmarks", WINDOWS: "Windows"}

SENTENCES_OF_TABLES = {
    REFERENCES: "The landmarks of the whole map: center of gravity, class and area of each region of their classes.",
    WINDOWS: "The windows that slide over the map, each described by the topology vector of its landmarks.",
}
"""What a database's layers are, by table."""


@dataclass(frozen=True)
class Note:
    """What a layer tells about itself; ``earlier``: lines of its history before this run."""

    title: str
    abstract: str
    lineage: Lineage = field(default_factory=Lineage)
    earlier: tuple[str, ...] = ()

    def metadata(self, layer: QgsMapLayer) -> QgsLayerMetadata:
        """For QGIS; ``layer``: whose CRS and extent it tells."""
        made = QgsLayerMetadata()
        made.setType("dataset")
        made.setTitle(self.title)
        made.setAbstract(self._abstract())
        made.setLicenses(list(self.lineage.licenses))
        made.setRights(list(self.lineage.rights))
        made.setHistory(_shortened([*self.earlier, *self.lineage.history()]))
        made.setCrs(layer.crs())
        extent = QgsLayerMetadata.Extent()
        spatial = QgsLayerMetadata.SpatialExtent()
        spatial.extentCrs = layer.crs()
        if not layer.extent().isEmpty():
            spatial.bounds = QgsBox3d(layer.extent())
        extent.setSpatialExtents([spatial])
        made.setExtent(extent)
        return made

    def after(self, told: QgsLayerMetadata) -> Note:
        """Of a layer that this run changed: it stays what it was, and what made it before is its history, too."""
        own = self.lineage
        lineage = replace(
            own,
            licenses=each_once((*told.licenses(), *own.licenses)),
            rights=each_once((*told.rights(), *own.rights)),
            sources=() if told.abstract() else own.sources,
        )
        return replace(self, abstract=told.abstract() or self.abstract, lineage=lineage, earlier=tuple(told.history()))

    def _abstract(self) -> str:
        if not self.lineage.sources:
            return self.abstract
        made_of = tr("Made of: {sources}").format(sources="; ".join(self.lineage.sources))
        return f"{self.abstract}\n\n{made_of}"


def _shortened(history: list[str]) -> list[str]:
    """The first line, which tells what made the layer, and the newest; a line of “…” where others are left out."""
    lines = [line for line in history if line != _LEFT_OUT]
    was_shortened = len(lines) < len(history)
    first, newest, length = lines[:1], [], sum(map(len, lines[:1]))
    for line in reversed(lines[1:]):
        length += len(line)
        if len(newest) == _MOST_LINES - 1 or length > _LONGEST_HISTORY:
            was_shortened = True
            break
        newest.insert(0, line)
    return [*first, *([_LEFT_OUT] if was_shortened else []), *newest]


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
    layer.saveNamedMetadata(str(Path(path).with_suffix(".qmd")))


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
