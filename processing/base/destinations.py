"""Where outputs are written, and the check that they replace no other output, input or foreign file."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import astuple, dataclass
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsDataSourceUri,
    QgsMapLayer,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingFeedback,
    QgsProcessingOutputLayerDefinition,
    QgsProcessingParameterDefinition,
    QgsProcessingUtils,
    QgsProperty,
    QgsProviderRegistry,
    QgsRasterFileWriter,
    QgsVectorFileWriter,
)

from ...core.errors import ParameterError
from ...storage.atomic_output import require_empty
from ...storage.replaceable import require_replaceable

_OGR = re.compile(r"^ogr:(?=.*dbname=)", re.IGNORECASE)
_PROVIDER = re.compile(r"^(memory|postgis|postgres|spatialite|mssql|oracle|hana|mysql|ogr):", re.IGNORECASE)
_LAYER_NAME = re.compile(r"layername=([^|]*)", re.IGNORECASE)
_LAYER_OF_FILE = re.compile(r"\|(layername|layerid|table)=", re.IGNORECASE)
_READ_AS_PROVIDER = re.compile(r".{3,}?:")
"""QGIS reads the text before a colon in the path of a layer as the name of a data provider; “C:” is too short."""
_ESCAPE = re.compile(r"%[0-9a-fA-F]{2}")
"""GDAL opens a GeoPackage by an address, in which “%20” is a space."""
_SPECIAL = "`~!@#$%^&*()+-={}|[]\\:\";'<>?,./"
"""Characters with which GDAL lets no layer of a GeoPackage begin; QGIS names the layer after the file."""
RASTER_SUFFIXES = ".tif", ".tiff"
"""Of GeoTIFF, the only raster format of outputs."""
_ROWS = "semref_outputs_of_rows"
"""Qt property of a batch's feedback."""


@dataclass(frozen=True)
class Destination:
    """Where a layer is written.

    Attributes:
        text: The destination in QGIS's form.
        path: The file; empty without one, as in memory or on a database server.
        is_table: Whether the file is a database to which the layer is added; other layers in it stay.
        has_index: Whether the file is a GeoPackage, which has a spatial index unless the user chose otherwise.
    """

    text: str
    path: str = ""
    is_table: bool = False
    has_index: bool = False

    def in_file(self, path: str) -> str:
        if not self.is_table:
            return path
        uri = _uri(self.text)
        uri.setDatabase(path)
        return f"ogr:{uri.uri(False)}"

    def collides(self, other: Destination) -> bool:
        """Return whether one of two outputs would replace the other."""
        is_shared = self.is_table and other.is_table and self.text != other.text
        return _same(self.path, other.path) and not is_shared


def destination_of(value: Any, context: QgsProcessingContext, is_layer: bool = True) -> Destination:
    """Parse the value of a layer output.

    Args:
        value: A path, an ``ogr:dbname='…' table="…"`` text, ``memory:``, ``TEMPORARY_OUTPUT``, or a definition that
            contains one of these.
        is_layer: Whether it is a vector layer: QGIS adds a suffix to names without a known format.
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
        path = _uri(text).database()
        return Destination(text, path, bool(path))
    if _PROVIDER.match(text):
        return Destination(text)
    path = text
    if is_layer and Path(text).suffix[1:].lower() not in QgsVectorFileWriter.supportedFormatExtensions():
        path = f"{text}.{QgsProcessingUtils.defaultVectorExtension()}"
    has_index = path.lower().endswith(".gpkg") and "SPATIAL_INDEX" not in options.upper()
    return Destination(text, path, has_index=has_index)


def with_destination(value: Any, text: str) -> QgsProcessingOutputLayerDefinition:
    """Return the value of a layer output with another destination: project, name and options are the same."""
    if not isinstance(value, QgsProcessingOutputLayerDefinition):
        return QgsProcessingOutputLayerDefinition(text)
    made = QgsProcessingOutputLayerDefinition(text, value.destinationProject)
    made.destinationName = value.destinationName
    made.createOptions = value.createOptions
    return made


@dataclass(frozen=True)
class _Input:
    """An input file: its path, and the name of its layer, empty for all layers."""

    key: str
    title: str
    path: str
    layer: str = ""


def replaced_by(definition: QgsProcessingParameterDefinition) -> tuple[str, tuple[str, ...] | None]:
    """Return the usual suffix and the tables of files that an output may replace, see ``require_replaceable``."""
    from ...storage.database.schema import TABLES

    if definition.type() == "rasterDestination":
        return ".tif", ()
    if definition.type() != "fileDestination":
        return "", ()
    suffix = f".{definition.defaultFileExtension()}"
    return suffix, TABLES if suffix == ".gpkg" else ()


def require_outputs_apart(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext, may_replace: dict
) -> None:
    """Refuse outputs that are an input or another output, by name, link or inode, or that replace a foreign file.

    Args:
        context: Context of the run; call this in the thread of its layers.
        may_replace: Output keys that may have the file of an input key, because the input is read before.

    Raises:
        ParameterError: With both titles and the path.
    """
    seen: list[tuple[QgsProcessingParameterDefinition, Destination]] = []
    inputs = list(_inputs(algorithm, parameters, context))
    for definition, wanted in _outputs(algorithm, parameters, context):
        if _LAYER_OF_FILE.search(wanted.path):
            raise ParameterError(
                "“{output}” is {path}, which is a layer of a file. Select a file, or use “Save to GeoPackage” to add "
                "a layer.",
                output=definition.description(),
                path=wanted.path,
            )
        _require_possible(definition, wanted)
        for read in inputs:
            allowed = may_replace.get(definition.name()) == read.key or _adds_a_layer(wanted, read)
            if not allowed and _same(wanted.path, read.path):
                raise ParameterError(
                    "“{output}” is the same file as “{input}” ({path}), which would be overwritten. Select another "
                    "file for “{output}”.",
                    output=definition.description(),
                    input=read.title,
                    path=wanted.path,
                )
        for other, place in seen:
            if wanted.collides(place):
                raise ParameterError(
                    "“{output}” and “{other}” are the same file ({path}). Select two different files.",
                    output=definition.description(),
                    other=other.description(),
                    path=wanted.path,
                )
        seen.append((definition, wanted))
        _require_free(definition, wanted)


def require_rows_apart(
    algorithm: QgsProcessingAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    may_replace: dict,
    feedback: QgsProcessingFeedback,
) -> None:
    """Refuse an output that an earlier row of a QGIS batch has, too, because the last row would replace it.

    Args:
        may_replace: As for ``require_outputs_apart``.
        feedback: Feedback of the run. It is the only object that the rows of a batch share.

    Raises:
        ParameterError: With title and path.
    """
    if not is_batch(feedback):
        return
    earlier = [Destination(*row) for row in feedback.property(_ROWS) or ()]
    updated = {(read.key, _normal(read.path)) for read in _inputs(algorithm, parameters, context)}
    for definition, wanted in _outputs(algorithm, parameters, context):
        if (may_replace.get(definition.name()), _normal(wanted.path)) in updated:
            continue
        if any(wanted.collides(place) for place in earlier):
            raise ParameterError(
                "“{output}” ({path}) is also in an earlier row, which would be overwritten. Select another file in "
                "each row.",
                output=definition.description(),
                path=wanted.path,
            )
        earlier.append(wanted)
    feedback.setProperty(_ROWS, [astuple(place) for place in earlier])


def is_batch(feedback: QgsProcessingFeedback) -> bool:
    """Return whether the run is a row of QGIS's batch dialog, which runs its rows in the main thread in QGIS 3.22."""
    return feedback.metaObject().className().endswith("BatchFeedback")


def _outputs(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Iterator[tuple[QgsProcessingParameterDefinition, Destination]]:
    for definition in algorithm.parameterDefinitions():
        if definition.isDestination():
            wanted = destination_of(parameters.get(definition.name()), context, _is_layer(definition))
            if wanted.path:
                yield definition, wanted


def _is_layer(definition: QgsProcessingParameterDefinition) -> bool:
    return definition.type() in ("sink", "vectorDestination")


def _require_possible(definition: QgsProcessingParameterDefinition, wanted: Destination) -> None:
    """Refuse a path that QGIS would refuse when the layer is written, after all the work."""
    path = os.path.abspath(wanted.path)
    is_layer, is_database = _is_layer(definition), path.lower().endswith(".gpkg")
    found, escape = "", _ESCAPE.search(path) if is_database else None
    if escape:
        found = escape.group()
    elif "|" in path and (is_layer or is_database):
        found = "|"
    elif is_layer and not wanted.is_table:
        name = os.path.basename(path)
        if _READ_AS_PROVIDER.match(path):
            found = ":"
        elif is_database and name[0] in _SPECIAL:
            found = name[0]
    if found:
        raise ParameterError(
            "“{output}” is {path}. QGIS cannot write to this path because of the character “{character}”. Select "
            "another folder or file name.",
            output=definition.description(),
            path=wanted.path,
            character=found,
        )


def _require_free(definition: QgsProcessingParameterDefinition, wanted: Destination) -> None:
    """Check the target as when the output is written, which may be hours later, and the format of a raster."""
    if definition.type() == "folderDestination":
        require_empty(Path(wanted.path))
    else:
        suffix, tables = replaced_by(definition)
        require_replaceable(wanted.path, suffix, None if wanted.is_table else tables)
    ending = Path(wanted.path).suffix.lower()
    is_other_format = ending not in RASTER_SUFFIXES and QgsRasterFileWriter.driverForExtension(ending[1:])
    if definition.type() == "rasterDestination" and is_other_format:
        raise ParameterError(
            "“{output}” is {path}, but SemRef writes GeoTIFF. Select a file name that ends with “.tif” instead of "
            "“{ending}”.",
            output=definition.description(),
            path=wanted.path,
            ending=ending,
        )


def _adds_a_layer(wanted: Destination, read: _Input) -> bool:
    """Return whether an output only adds a layer to the file of an input."""
    return wanted.is_table and bool(read.layer) and _uri(wanted.text).table() not in ("", read.layer)


def _uri(text: str) -> QgsDataSourceUri:
    """Parse ``ogr:dbname='…' table="…"``, as QGIS does when it writes the layer."""
    return QgsDataSourceUri(text.partition(":")[2])


def _inputs(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Iterator[_Input]:
    for definition in algorithm.parameterDefinitions():
        if not definition.isDestination():
            for source in _sources(parameters.get(definition.name()), context):
                path = source.split("|")[0]
                if os.path.exists(path):
                    layer = _LAYER_NAME.search(source)
                    name = layer.group(1) if layer else ""
                    yield _Input(definition.name(), definition.description(), path, name)


def _sources(value: Any, context: QgsProcessingContext) -> Iterator[str]:
    """Yield the files, as “path|layername=…”, in a value of any kind."""
    if isinstance(value, QgsProcessingFeatureSourceDefinition):
        value = value.source
    if isinstance(value, QgsProperty):
        value, _ = value.valueAsString(context.expressionContext(), "")
    if isinstance(value, (list, tuple)):
        for part in value:
            yield from _sources(part, context)
    elif isinstance(value, QgsMapLayer):
        parts = QgsProviderRegistry.instance().decodeUri(value.providerType(), value.source())
        name = parts.get("layerName")
        yield f"{parts.get('path') or value.source()}{f'|layername={name}' if name else ''}"
    elif isinstance(value, str) and value:
        yield value
        if not os.path.exists(value.split("|")[0]):
            yield from (part.strip() for part in value.split(";") if ";" in value)
            # Layers of the project, by id or name.
            layer = QgsProcessingUtils.mapLayerFromString(value, context, False)
            if layer is not None:
                yield from _sources(layer, context)


def _same(one: str, other: str) -> bool:
    """Return whether two paths are one file, through links and other spellings."""
    if os.path.exists(one) and os.path.exists(other):
        return os.path.samefile(one, other)
    return _normal(one) == _normal(other)


def _normal(path: str) -> str:
    return os.path.normcase(os.path.realpath(path))
