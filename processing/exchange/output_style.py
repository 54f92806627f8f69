"""Vector outputs come with a style: in the file where it can hold one, and on the layer that QGIS loads."""

from __future__ import annotations

import contextlib
import sqlite3
from dataclasses import dataclass
from pathlib import Path

from qgis.core import (
    QgsFeatureRenderer,
    QgsProcessingContext,
    QgsProcessingLayerPostProcessorInterface,
    QgsVectorLayer,
    QgsVectorLayerTemporalProperties,
)

from ...storage.vector_files import leave_wal

_KEPT: list[_Styler] = []
_MOST_KEPT = 20
"""QGIS takes no care of the Python half of a post-processor, so the last ones are kept."""


@dataclass(frozen=True)
class Look:
    """What a layer comes with.

    Attributes:
        renderer: Its style.
        time_field: The field of date and time by which QGIS's temporal controller plays it, what was seen staying;
            empty for none.
    """

    renderer: QgsFeatureRenderer
    time_field: str = ""

    def give(self, layer: QgsVectorLayer) -> None:
        """Has a layer look so."""
        layer.setRenderer(self.renderer.clone())
        if self.time_field:
            played = layer.temporalProperties()
            played.setMode(QgsVectorLayerTemporalProperties.ModeFeatureDateTimeInstantFromField)
            played.setStartField(self.time_field)
            played.setAccumulateFeatures(True)
            played.setIsActive(True)


def style_in_file(destination: str, look: Look) -> bool:
    """Gives a layer in a GeoPackage its style, as its default; other files can't hold one.

    Returns:
        Whether all is there that should be: on a full disk QGIS leaves a style out without a word.
    """
    path = destination.split("|")[0]
    if Path(path).suffix.lower() != ".gpkg" or not Path(path).is_file():
        return True
    layer = QgsVectorLayer(destination, "output", "ogr")
    if layer.isValid():
        look.give(layer)
        layer.saveStyleToDatabase("SemRef", "", True, "")
    del layer
    try:
        leave_wal(path)
        return _has_style(path)
    except sqlite3.Error:
        return False


def _has_style(path: str) -> bool:
    """Whether the style that was written last is whole."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        row = connection.execute("SELECT styleQML FROM layer_styles ORDER BY id DESC LIMIT 1").fetchone()
    return row is not None and str(row[0]).rstrip().endswith("</qgis>")


def style_when_loaded(destination: str, look: Look, context: QgsProcessingContext) -> None:
    """Gives the layer that QGIS will load its style."""
    if context.willLoadLayerOnCompletion(destination):
        _KEPT.append(_Styler(look))
        del _KEPT[:-_MOST_KEPT]
        context.layerToLoadOnCompletionDetails(destination).setPostProcessor(_KEPT[-1])


class _Styler(QgsProcessingLayerPostProcessorInterface):
    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = Look(look.renderer.clone(), look.time_field)

    def postProcessLayer(self, layer, context, feedback):
        if isinstance(layer, QgsVectorLayer):
            self._look.give(layer)
            layer.triggerRepaint()
