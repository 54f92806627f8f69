"""Metadata of a layer: title, abstract, history, and the licenses of its sources.

QGIS shows it under Properties ▸ Metadata and Information. It is stored in ``gpkg_metadata`` of a GeoPackage, or in
``NAME.qmd`` beside a raster.
"""

from __future__ import annotations

import contextlib
import os
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

from ...core import limits
from ...storage.replaceable import MARK_OF_NOTE
from ...storage.vector_files import leave_wal
from ..translation import tr

_QGIS_STANDARD = "http://mrcc.com/qgis.dtd"
"""Standard of QGIS's metadata in a GeoPackage."""

_LONGEST_COMMAND = 20_000
"""Characters of a command; the command of a run may name thousands of images."""

_LAYERS = "source", "vector", "raster", "multilayer"

_MOST_LINES = 50
"""Lines of a history; each update of a database adds one."""

REFERENCES, WINDOWS = "references", "windows"
"""Tables of a database that are layers with metadata."""


@dataclass(frozen=True)
class Note:
    """Metadata of a layer.

    Attributes:
        history: Lines, the oldest first. Each run adds a line with time, version and Python command.
        sources: Titles of the inputs with licenses or rights, which follow in brackets.
    """

    title: str = ""
    abstract: str = ""
    history: tuple[str, ...] = ()
    sources: str = ""

    def metadata(self, layer: QgsMapLayer) -> QgsLayerMetadata:
        """Return QGIS's metadata with the CRS and extent of ``layer``; a long history is cut after its first line."""
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
        """Return the metadata of an updated layer: its old abstract and history, with the line of this run."""
        return replace(
            self,
            abstract=known.abstract() or self.abstract,
            history=(*known.history(), *self.history),
            sources=_each_once([*known.rights(), self.sources]),
        )


def note_of_run(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext, version: str
) -> Note:
    """Return history and sources for the outputs of a run; call it in the layers' thread after reading the layers."""
    try:
        command = algorithm.asPythonCommand(parameters, context)
    except Exception:
        # QGIS raises errors for values that it can't express; the run continues without the full command.
        command = f"processing.run({algorithm.id()!r}, …)"
    if len(command) > _LONGEST_COMMAND:
        command = f"{command[:_LONGEST_COMMAND]}…"
    now = datetime.now(timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    sources = _each_once(_source(title, one) for title, one in _inputs(algorithm, parameters, context))
    return Note(history=(f"{now}, SemRef {version}: {command}",), sources=sources)


def _each_once(texts: Iterable[str]) -> str:
    """Join texts of sources without duplicates."""
    return "; ".join(dict.fromkeys(source for text in texts for source in text.split("; ") if source))


def _source(title: str, one: QgsLayerMetadata) -> str:
    """Return an input's title with its licenses, or the sources of a layer that SemRef made."""
    return f"{title} ({', '.join([*one.licenses(), *one.rights()])})" if one.licenses() else "; ".join(one.rights())


def _inputs(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Iterator[tuple[str, QgsLayerMetadata]]:
    """Yield (title, metadata) of inputs that are loaded layers or files with metadata, without loading layers."""
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
            source = f"{one}|layername={WINDOWS}" if definition.type() == "file" else one
            known = _of_layer(layer) if layer is not None else _of_file(source) if isinstance(one, str) else None
            if known is not None:
                # The metadata of a database belong to one of its layers, so use the name of the file.
                title = "" if definition.type() == "file" else known.title()
                yield title or (layer.name() if layer is not None else Path(one).stem), known


def _of_layer(layer: QgsMapLayer) -> QgsLayerMetadata:
    """Return the metadata of a layer, or of its file: layers of algorithms have not read the file beside it."""
    known = layer.metadata()
    return known if known.title() or known.licenses() or known.rights() else _of_file(layer.source()) or known


def _of_file(source: str) -> QgsLayerMetadata | None:
    """Return the metadata of a layer in a GeoPackage, or in the .qmd file beside another file; None without any."""
    path = source.partition("|")[0]
    if path.lower().endswith(".gpkg"):
        options = QgsVectorLayer.LayerOptions(loadDefaultStyle=False)
        layer = QgsVectorLayer(source, "", "ogr", options) if os.path.isfile(path) else None
        return layer.metadata() if layer is not None and layer.isValid() else None
    beside = os.path.splitext(path)[0] + ".qmd"
    # A layer in memory reads the file as any other layer does.
    layer = QgsVectorLayer("Point", "", "memory")
    if not os.path.isfile(beside) or os.path.getsize(beside) > limits.METADATA_BYTES:
        return None
    return layer.metadata() if layer.loadNamedMetadata(beside)[1] else None


def save_in_file(destination: str, layer: QgsMapLayer, note: Note) -> bool:
    """Write metadata of the layer at ``destination`` into its GeoPackage; return whether they are complete."""
    path = destination.split("|")[0]
    with contextlib.closing(sqlite3.connect(path)) as connection:
        # QGIS needs the name of the layer, also for a file with one layer.
        table = connection.execute("SELECT table_name FROM gpkg_contents WHERE data_type = 'features'").fetchone()
    whole = destination if "layername=" in destination or table is None else f"{path}|layername={table[0]}"
    # For a folder like “maps.tar” QGIS assumes an archive, and can't write metadata.
    if QgsProviderRegistry.instance().decodeUri("ogr", whole).get("path") != path:
        return True
    QgsProviderRegistry.instance().saveLayerMetadata("ogr", whole, note.metadata(layer))
    with contextlib.closing(sqlite3.connect(path)) as connection:
        query = "SELECT metadata FROM gpkg_metadata WHERE md_standard_uri = ? ORDER BY id DESC LIMIT 1"
        row = connection.execute(query, (_QGIS_STANDARD,)).fetchone()
    return row is not None and str(row[0]).rstrip().endswith("</qgis>")


def save_beside(path: str, layer: QgsMapLayer, note: Note) -> None:
    """Write metadata beside a raster."""
    layer.setMetadata(note.metadata(layer))
    beside = Path(path).with_suffix(".qmd")
    layer.saveNamedMetadata(str(beside))
    text = beside.read_text(encoding="utf-8")
    beside.write_text(text.replace("</qgis>", f"{MARK_OF_NOTE}</qgis>"), encoding="utf-8")


def save_in_database(path: str, note: Note) -> bool:
    """Write metadata of each layer of a reference database, after its old history; return whether they are complete."""
    saved = True
    try:
        for table, title, abstract in _tables():
            source = f"{path}|layername={table}"
            layer = QgsVectorLayer(source, table, "ogr", QgsVectorLayer.LayerOptions(loadDefaultStyle=False))
            own = replace(note, title=title, abstract=f"{abstract}\n\n{note.abstract}").after(layer.metadata())
            saved = layer.isValid() and save_in_file(source, layer, own) and saved
            del layer
        leave_wal(path)
        _drop_copies(path)
    except sqlite3.Error:
        return False
    return saved


def _drop_copies(path: str) -> None:
    """Remove the copies of metadata that GDAL writes when the next table's metadata are written."""
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        copies = connection.execute(
            "SELECT id FROM gpkg_metadata WHERE md_standard_uri = 'http://gdal.org' "
            "AND metadata LIKE '%<MDI key=\"GPKG_METADATA_ITEM_%'"
        ).fetchall()
        connection.executemany("DELETE FROM gpkg_metadata_reference WHERE md_file_id = ?", copies)
        connection.executemany("DELETE FROM gpkg_metadata WHERE id = ?", copies)


def _tables() -> tuple[tuple[str, str, str], ...]:
    """Return (table, title, abstract) of a database's layers with metadata."""
    return (
        (
            REFERENCES,
            tr("Landmarks"),
            tr("The landmarks of the whole map: center of gravity, class and area of each region of their classes."),
        ),
        (
            WINDOWS,
            tr("Windows"),
            tr("The windows that slide over the map, each described by the topology vector of its landmarks."),
        ),
    )
