"""Vector outputs come with a style: in the file where it can hold one, and on the layer that QGIS loads."""

from __future__ import annotations

from pathlib import Path
from typing import List

from qgis.core import (
    QgsFeatureRenderer,
    QgsProcessingContext,
    QgsProcessingLayerPostProcessorInterface,
    QgsVectorLayer,
)

from ...storage.database.reader import leave_wal

_KEPT: List["_Styler"] = []
_MOST_KEPT = 20
"""QGIS takes no care of the Python half of a post-processor, so the last ones are kept."""


def style_in_file(destination: str, renderer: QgsFeatureRenderer) -> None:
    """Gives a layer in a GeoPackage its style, as its default; other files can't hold one."""
    path = destination.split("|")[0]
    if Path(path).suffix.lower() != ".gpkg" or not Path(path).is_file():
        return
    layer = QgsVectorLayer(destination, "output", "ogr")
    if layer.isValid():
        layer.setRenderer(renderer.clone())
        layer.saveStyleToDatabase("SemRef", "", True, "")
    del layer
    leave_wal(path)


def style_when_loaded(destination: str, renderer: QgsFeatureRenderer, context: QgsProcessingContext) -> None:
    """Gives the layer that QGIS will load its style."""
    if context.willLoadLayerOnCompletion(destination):
        _KEPT.append(_Styler(renderer.clone()))
        del _KEPT[:-_MOST_KEPT]
        context.layerToLoadOnCompletionDetails(destination).setPostProcessor(_KEPT[-1])


class _Styler(QgsProcessingLayerPostProcessorInterface):
    def __init__(self, renderer: QgsFeatureRenderer) -> None:
        super().__init__()
        self._renderer = renderer

    def postProcessLayer(self, layer, context, feedback):
        if isinstance(layer, QgsVectorLayer):
            layer.setRenderer(self._renderer.clone())
            layer.triggerRepaint()
