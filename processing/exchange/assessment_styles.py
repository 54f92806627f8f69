"""How assessments look on a map: five steps of the evenly perceived ramp cividis, with words in the legend."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, List, Tuple

from qgis.core import (
    QgsFeatureRenderer,
    QgsFillSymbol,
    QgsGraduatedSymbolRenderer,
    QgsMarkerSymbol,
    QgsProcessingContext,
    QgsProcessingLayerPostProcessorInterface,
    QgsRendererRange,
    QgsSymbol,
    QgsVectorLayer,
)

from ..translation import tr
from .geopackage import leave_wal

COLORS = ("#00204d", "#46516c", "#7c7b78", "#bcad6c", "#ffea46")
"""Cividis (Nuñez et al. 2018) at even steps, dark to light; told apart by the colour-blind and in grey."""

_KEPT: List["_Styler"] = []
_MOST_KEPT = 20
"""QGIS takes no care of the Python half of a post-processor, so the last ones are kept."""


def success_classes(threshold: float) -> List[Tuple[float, float, str, str]]:
    """(from, to, colour, legend text) of five classes of success 0…1; the upper two are good enough."""
    edges = [0.0, threshold / 3, 2 * threshold / 3, threshold, (1 + threshold) / 2, 1.0]
    words = [tr("hardly ever"), tr("sometimes"), tr("often"), tr("reliably"), tr("very reliably")]
    return [
        (low, high, color, f"{word} ({100 * low:.3g}–{100 * high:.3g} %)")
        for low, high, color, word in zip(edges, edges[1:], COLORS, words)
    ]


def cell_renderer(threshold: float, footprint: float, is_only: bool) -> QgsGraduatedSymbolRenderer:
    """Squares coloured by success; of several footprints in one layer those of ``footprint`` alone."""
    value = "success" if is_only else f'if("footprint" = {footprint!r}, "success", NULL)'
    return _graduated(
        value, threshold, lambda color: QgsFillSymbol.createSimple({"color": color, "outline_style": "no"})
    )


def point_renderer(threshold: float) -> QgsGraduatedSymbolRenderer:
    """Points along a route, coloured by success."""
    return _graduated(
        "success",
        threshold,
        lambda color: QgsMarkerSymbol.createSimple(
            {"name": "circle", "color": color, "size": "2.6", "outline_color": "#ffffff", "outline_width": "0.2"}
        ),
    )


def _graduated(value: str, threshold: float, symbol: Callable[[str], QgsSymbol]) -> QgsGraduatedSymbolRenderer:
    ranges = [
        QgsRendererRange(low, high, symbol(color), text) for low, high, color, text in success_classes(threshold)
    ]
    # From good to bad, as a legend is read.
    return QgsGraduatedSymbolRenderer(value, ranges[::-1])


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
