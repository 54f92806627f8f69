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


def style_output(destination: str, renderer: QgsFeatureRenderer, context: QgsProcessingContext) -> None:
    """Gives an output its style: in a GeoPackage as its default, and to the layer that QGIS will load."""
    path = destination.split("|")[0]
    if Path(path).suffix.lower() == ".gpkg" and Path(path).is_file():
        layer = QgsVectorLayer(destination, "output", "ogr")
        if layer.isValid():
            layer.setRenderer(renderer.clone())
            layer.saveStyleToDatabase("SemRef", "", True, "")
        del layer
        leave_wal(path)
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
