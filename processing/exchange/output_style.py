"""Vector outputs come with a style: in the file where it can hold one, and on the layer that QGIS loads."""

from __future__ import annotations

import contextlib
import sqlite3
from pathlib import Path

from qgis.core import (
    QgsFeatureRenderer,
    QgsProcessingContext,
    QgsProcessingLayerPostProcessorInterface,
    QgsVectorLayer,
)

from ...storage.vector_files import leave_wal

_KEPT: list[_Styler] = []
_MOST_KEPT = 20
"""QGIS takes no care of the Python half of a post-processor, so the last ones are kept."""


def style_in_file(destination: str, renderer: QgsFeatureRenderer) -> bool:
    """Gives a layer in a GeoPackage its style, as its default; other files can't hold one.

    Returns:
        Whether all is there that should be: on a full disk QGIS leaves a style out without a word.
    """
    path = destination.split("|")[0]
    if Path(path).suffix.lower() != ".gpkg" or not Path(path).is_file():
        return True
    layer = QgsVectorLayer(destination, "output", "ogr")
    if layer.isValid():
        layer.setRenderer(renderer.clone())
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
