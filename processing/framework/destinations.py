"""Where a layer is to be written, as QGIS states it: a file, a table of a file, or something else."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingOutputLayerDefinition,
    QgsProcessingUtils,
    QgsProperty,
    QgsVectorFileWriter,
)

_OGR = re.compile(r"^ogr:(?=.*dbname=)", re.IGNORECASE)
_DATABASE = re.compile(r"""dbname=(?:'([^']*)'|"([^"]*)"|(\S+))""")
_PROVIDER = re.compile(r"^(memory|postgis|postgres|spatialite|mssql|oracle|hana|mysql|ogr):", re.IGNORECASE)


@dataclass(frozen=True)
class Destination:
    """Where a layer goes.

    Attributes:
        text: As QGIS states it.
        path: The file; empty where there is none, as in memory or in a database server.
        is_table: Whether the file is a database that the layer is added to, with all else in it kept.
        has_index: Whether the file is a GeoPackage, which has a spatial index unless the user said otherwise.
    """

    text: str
    path: str = ""
    is_table: bool = False
    has_index: bool = False

    def moved(self, path: str) -> str:
        """The same destination in another file."""
        return self.text.replace(self.path, path, 1) if self.is_table else path


def destination_of(value: Any, context: QgsProcessingContext, is_layer: bool = True) -> Destination:
    """Reads the value of a layer output.

    Args:
        value: A path, an ``ogr:dbname='…' table="…"`` text, ``memory:``, ``TEMPORARY_OUTPUT``, or a definition that
            holds one of these.
        context: Whose expressions count.
        is_layer: Whether it is a vector layer, to whose name QGIS adds a suffix where it knows no format by it.
    """
    options = ""
    if isinstance(value, QgsProcessingOutputLayerDefinition):
        value, options = value.sink, str(value.createOptions)
    if isinstance(value, QgsProperty):
        value, _ = value.valueAsString(context.expressionContext(), "")
    text = str(value or "")
    if not text or text == QgsProcessing.TEMPORARY_OUTPUT:
        return Destination(text)
    if _OGR.match(text):
        found = _DATABASE.search(text)
        path = next((group for group in found.groups() if group), "") if found else ""
        return Destination(text, path, bool(path))
    if _PROVIDER.match(text):
        return Destination(text)
    path = text
    if is_layer and Path(text).suffix[1:].lower() not in QgsVectorFileWriter.supportedFormatExtensions():
        path = f"{text}.{QgsProcessingUtils.defaultVectorExtension()}"
    has_index = path.lower().endswith(".gpkg") and "SPATIAL_INDEX" not in options.upper()
    return Destination(text, path, has_index=has_index)


def with_destination(value: Any, text: str) -> QgsProcessingOutputLayerDefinition:
    """The value of a layer output that goes elsewhere: the same project, name and options."""
    if not isinstance(value, QgsProcessingOutputLayerDefinition):
        return QgsProcessingOutputLayerDefinition(text)
    made = QgsProcessingOutputLayerDefinition(text, value.destinationProject)
    made.destinationName = value.destinationName
    made.createOptions = value.createOptions
    return made
