"""What a layer tells about itself: title, abstract, licenses of what it was made from, and how it was made.

QGIS shows it under Properties ▸ Metadata and Information; in a GeoPackage it stands in ``gpkg_metadata``, beside a
raster in ``NAME.qmd``.
"""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterable
from dataclasses import dataclass, field
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
)

LONGEST_COMMAND = 20_000
"""Characters of a lineage: a run of thousands of images names each."""

_SQLITE_STANDARD = "http://mrcc.com/qgis.dtd"
"""What QGIS calls the standard of its own metadata in a GeoPackage."""


@dataclass(frozen=True)
class Lineage:
    """How a run made what it writes.

    Attributes:
        command: That makes it again, as Python.
        version: Of the plugin.
        licenses: That input layers name, each once.
        rights: That input layers name, each once.
        sources: Titles of the input layers.
    """

    command: str = ""
    version: str = ""
    licenses: tuple[str, ...] = ()
    rights: tuple[str, ...] = ()
    sources: tuple[str, ...] = ()

    def history(self) -> list[str]:
        """One line that says what made the layer, and when."""
        now = datetime.now(timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
        return [f"{now}, SemRef {self.version}: {self.command}"] if self.command else []


@dataclass(frozen=True)
class Note:
    """What a layer tells about itself."""

    title: str
    abstract: str
    lineage: Lineage = field(default_factory=Lineage)

    def metadata(self, layer: QgsMapLayer) -> QgsLayerMetadata:
        """For QGIS; ``layer``: whose CRS and extent it tells."""
        made = QgsLayerMetadata()
        made.setType("dataset")
        made.setTitle(self.title)
        made.setAbstract(self.abstract)
        made.setLicenses(list(self.lineage.licenses))
        made.setRights(list(self.lineage.rights))
        made.setHistory(self.lineage.history())
        made.setCrs(layer.crs())
        extent = QgsLayerMetadata.Extent()
        spatial = QgsLayerMetadata.SpatialExtent()
        spatial.extentCrs = layer.crs()
        if not layer.extent().isEmpty():
            spatial.bounds = QgsBox3d(layer.extent())
        extent.setSpatialExtents([spatial])
        made.setExtent(extent)
        return made


def lineage_of(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext, version: str
) -> Lineage:
    """How a run makes what it will write; call it where layers live, after they were read."""
    layers = list(_input_layers(algorithm, parameters, context))
    told = [layer.metadata() for layer in layers]
    return Lineage(
        _command(algorithm, parameters, context),
        version,
        _each_once(text for one in told for text in one.licenses()),
        _each_once(text for one in told for text in one.rights()),
        _each_once(layer.name() for layer in layers),
    )


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
        row = connection.execute(query, (_SQLITE_STANDARD,)).fetchone()
    return row is not None and str(row[0]).rstrip().endswith("</qgis>")


def _holds_notes(destination: str, path: str) -> bool:
    """Whether QGIS finds the file to write a note into; in a folder such as “maps.tar” it looks for an archive."""
    return QgsProviderRegistry.instance().decodeUri("ogr", destination).get("path") == path


def keep_beside(path: str, layer: QgsMapLayer, note: Note) -> None:
    """Writes a note where QGIS finds it beside a raster."""
    layer.setMetadata(note.metadata(layer))
    layer.saveNamedMetadata(str(Path(path).with_suffix(".qmd")))


def _command(algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext) -> str:
    try:
        text = algorithm.asPythonCommand(parameters, context)
    except Exception:
        # QGIS raises anything for values that it can't write down; the layer is worth more than its lineage.
        text = f"processing.run({algorithm.id()!r}, …)"
    return text if len(text) <= LONGEST_COMMAND else f"{text[:LONGEST_COMMAND]}…"


def _input_layers(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Iterable[QgsMapLayer]:
    """The layers among the inputs that are loaded; none is loaded for this."""
    for definition in algorithm.parameterDefinitions():
        value = parameters.get(definition.name())
        if definition.isDestination() or definition.type() not in ("source", "vector", "raster", "multilayer"):
            continue
        for one in value if isinstance(value, (list, tuple)) else (value,):
            if isinstance(one, QgsProcessingFeatureSourceDefinition):
                one = one.source.staticValue()
            if isinstance(one, QgsMapLayer):
                yield one
            elif isinstance(one, str) and one:
                layer = QgsProcessingUtils.mapLayerFromString(one, context, False)
                if layer is not None:
                    yield layer


def _each_once(texts: Iterable[str]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(text for text in texts if text))
