"""How a run makes what it writes: the call, what it reads, and the licenses of that, of layers and files alike."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsLayerMetadata,
    QgsMapLayer,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingUtils,
)
from qgis.PyQt.QtXml import QDomDocument

from ...storage.notes import MOST_SOURCES, note_text

LONGEST_COMMAND = 20_000
"""Characters of a lineage: a run of thousands of images names each."""

_LAYERS = "source", "vector", "raster", "multilayer"


@dataclass(frozen=True)
class Lineage:
    """How a run made what it writes.

    Attributes:
        command: That makes it again, as Python.
        version: Of the plugin.
        licenses: That inputs name, each once.
        rights: That inputs name, each once.
        sources: Titles of the inputs that tell one, with their licenses in brackets.
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


def lineage_of(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext, version: str
) -> Lineage:
    """How a run makes what it will write; call it where layers live, after they were read."""
    told = list(_told_by_inputs(algorithm, parameters, context))
    return Lineage(
        _command(algorithm, parameters, context),
        version,
        each_once(text for _, one in told for text in one.licenses()),
        each_once(text for _, one in told for text in one.rights()),
        each_once(_source(title, one) for title, one in told),
    )


def each_once(texts: Iterable[str]) -> tuple[str, ...]:
    """Those that are not empty, in their order."""
    return tuple(dict.fromkeys(text for text in texts if text))


def _source(title: str, told: QgsLayerMetadata) -> str:
    licenses = ", ".join(told.licenses())
    return f"{title} ({licenses})" if licenses else title


def _command(algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext) -> str:
    try:
        text = algorithm.asPythonCommand(parameters, context)
    except Exception:
        # QGIS raises anything for values that it can't write down; the layer is worth more than its lineage.
        text = f"processing.run({algorithm.id()!r}, …)"
    return text if len(text) <= LONGEST_COMMAND else f"{text[:LONGEST_COMMAND]}…"


def _told_by_inputs(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Iterable[tuple[str, QgsLayerMetadata]]:
    """(title, metadata) of the inputs that are loaded layers, or files with a note; no layer is loaded for this."""
    for definition in algorithm.parameterDefinitions():
        value = parameters.get(definition.name())
        if definition.isDestination() or definition.type() not in (*_LAYERS, "file"):
            continue
        for one in _each(value)[:MOST_SOURCES]:
            if isinstance(one, QgsProcessingFeatureSourceDefinition):
                one = one.source.staticValue()
            layer = one if isinstance(one, QgsMapLayer) else None
            if isinstance(one, str) and one and definition.type() != "file":
                layer = QgsProcessingUtils.mapLayerFromString(one, context, False)
            told = _told_by(layer) if layer is not None else note_of_file(one) if isinstance(one, str) else None
            if told is not None:
                # A database's note is of one of its layers, so that it is called by its file.
                title = "" if definition.type() == "file" else told.title()
                yield title or (layer.name() if layer is not None else Path(one).stem), told


def _each(value: Any) -> list[Any]:
    return list(value) if isinstance(value, (list, tuple)) else [value]


def _told_by(layer: QgsMapLayer) -> QgsLayerMetadata:
    """What a layer tells; one that only algorithms have loaded has not read what lies beside it."""
    told = layer.metadata()
    return told if told.title() or told.licenses() or told.rights() else note_of_file(layer.source()) or told


def note_of_file(source: str) -> QgsLayerMetadata | None:
    """What QGIS has noted of a file that no layer is loaded of: beside a raster, in a GeoPackage; None without it."""
    text = note_text(source)
    document, told = QDomDocument(), QgsLayerMetadata()
    # Qt 6.5 and later have another type of answer; false in both where it is no XML.
    if not text or not document.setContent(text) or not told.readMetadataXml(document.documentElement()):
        return None
    return told
