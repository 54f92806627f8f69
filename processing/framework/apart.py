"""Where inputs and outputs are, before any work: no output where another, an input or anything foreign is."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsMapLayer,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingParameterDefinition,
    QgsProcessingUtils,
    QgsProperty,
    QgsProviderRegistry,
)

from ...core.errors import ParameterError
from ...storage.atomic_output import require_empty
from ...storage.replaceable import require_replaceable
from .destinations import Destination, destination_of

if TYPE_CHECKING:
    from .values import Values

_LAYER_NAME = re.compile(r"layername=([^|]*)", re.IGNORECASE)
_LAYER_OF_FILE = re.compile(r"\|(layername|layerid|table)=", re.IGNORECASE)
_TABLE = re.compile(r"""table=(?:"([^"]*)"|'([^']*)'|(\S+))""")


@dataclass(frozen=True)
class _Input:
    """A file that is read: its path, and which of its layers, empty for all."""

    key: str
    title: str
    path: str
    layer: str = ""


def require_outputs_apart(algorithm: QgsProcessingAlgorithm, values: Values, may_replace: dict) -> None:
    """Refuses an output that is an input, or another output, by name, link or inode, or would replace anything foreign.

    Args:
        algorithm: Whose parameters are looked at.
        values: What the user gave; call it where layers live.
        may_replace: Output keys whose file may be that of an input key, since it is read whole before.

    Raises:
        ParameterError: With both titles and the path.
    """
    seen: list[tuple[QgsProcessingParameterDefinition, Destination]] = []
    inputs = list(_inputs(algorithm, values))
    for definition in algorithm.parameterDefinitions():
        if not definition.isDestination():
            continue
        is_layer = definition.type() in ("sink", "vectorDestination")
        wanted = destination_of(values.raw(definition.name()), values.context, is_layer)
        if not wanted.path:
            continue
        if _LAYER_OF_FILE.search(wanted.path):
            raise ParameterError("framework.layer_as_output", output=definition.description(), path=wanted.path)
        for read in inputs:
            allowed = may_replace.get(definition.name()) == read.key or _adds_a_layer(wanted, read)
            if not allowed and _same(wanted.path, read.path):
                raise ParameterError(
                    "framework.output_is_input", output=definition.description(), input=read.title, path=wanted.path
                )
        for other, place in seen:
            if _same(wanted.path, place.path) and (
                wanted.text == place.text or not (wanted.is_table and place.is_table)
            ):
                raise ParameterError(
                    "framework.same_output",
                    output=definition.description(),
                    other=other.description(),
                    path=wanted.path,
                )
        seen.append((definition, wanted))
        _require_free(definition, wanted, values)


def _require_free(definition: QgsProcessingParameterDefinition, wanted: Destination, values: Values) -> None:
    """As when the output is written, which may be after hours."""
    if definition.type() == "folderDestination":
        require_empty(Path(wanted.path))
    else:
        suffix, tables = values.replaces(definition.name())
        require_replaceable(wanted.path, suffix, None if wanted.is_table else tables)


def _adds_a_layer(wanted: Destination, read: _Input) -> bool:
    """Whether an output only adds a layer to the file that an input lies in."""
    if not wanted.is_table:
        return False
    found = _TABLE.search(wanted.text)
    table = next((group for group in found.groups() if group), "") if found else ""
    return bool(table) and bool(read.layer) and table != read.layer


def _inputs(algorithm: QgsProcessingAlgorithm, values: Values) -> Iterator[_Input]:
    for definition in algorithm.parameterDefinitions():
        if not definition.isDestination():
            for source in _sources(values.raw(definition.name()), values.context):
                path = source.split("|")[0]
                if os.path.exists(path):
                    layer = _LAYER_NAME.search(source)
                    name = layer.group(1) if layer else ""
                    yield _Input(definition.name(), definition.description(), path, name)


def _sources(value: Any, context: QgsProcessingContext) -> Iterator[str]:
    """The files, as “path|layername=…”, that a value of any kind stands for."""
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
            # Of the layers that are there already: by id or name.
            layer = QgsProcessingUtils.mapLayerFromString(value, context, False)
            if layer is not None:
                yield from _sources(layer, context)


def _same(one: str, other: str) -> bool:
    """Whether two paths are one file, through links and other spellings."""
    if os.path.exists(one) and os.path.exists(other):
        return os.path.samefile(one, other)
    return _normal(one) == _normal(other)


def _normal(path: str) -> str:
    return os.path.normcase(os.path.realpath(path))
