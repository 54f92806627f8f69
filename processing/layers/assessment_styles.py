"""Styles of expected success on maps and in reports: five steps of the color ramp cividis."""

from __future__ import annotations

from qgis.core import QgsGraduatedSymbolRenderer, QgsRendererRange
from qgis.PyQt.QtGui import QColor

from ..messages.columns import verdict_words
from ..messages.numbers import shown
from .styles import style_renderer

COLORS = ("#00204d", "#46516c", "#7c7b78", "#bcad6c", "#ffea46")
"""Colors from the lowest to the highest expected success: cividis (Nuñez et al. 2018) in even steps."""


def success_classes(threshold: float) -> list[tuple[float, float, str, str]]:
    """Return (from, to, color, legend text) of five classes of success 0…1; the upper two are above the threshold."""
    # OpenCV may be missing when the plugin starts.
    from ...core.assessment.squares import verdict_edges

    edges = verdict_edges(threshold)
    return [
        (low, high, color, f"{word} ({shown(100 * low, '.3g')}–{shown(100 * high, '.3g')} %)")
        for low, high, color, word in zip(edges, edges[1:], COLORS, verdict_words().values())
    ]


def cells_renderer(threshold: float, footprint: float, is_only: bool) -> QgsGraduatedSymbolRenderer:
    """Return a renderer of squares by success; for several footprints in a layer, only of ``footprint``."""
    value = "success" if is_only else f'if("footprint" = {footprint!r}, "success", NULL)'
    return _graduated_renderer("cells", value, threshold)


def route_renderer(threshold: float) -> QgsGraduatedSymbolRenderer:
    """Return a renderer of route stretches by success."""
    return _graduated_renderer("route", "success", threshold)


def _graduated_renderer(name: str, value: str, threshold: float) -> QgsGraduatedSymbolRenderer:
    """Return a renderer with the symbol of a style file; the color of its top symbol layer shows the success."""
    style = style_renderer(name)
    ranges = []
    for low, high, color, text in success_classes(threshold):
        symbol = style.symbol().clone()
        uppermost = symbol.symbolLayer(symbol.symbolLayerCount() - 1)
        (uppermost.subSymbol() or uppermost).setColor(QColor(color))
        ranges.append(QgsRendererRange(low, high, symbol, text))
    # The legend begins with the best class.
    renderer = QgsGraduatedSymbolRenderer(value, ranges[::-1])
    renderer.setUsingSymbolLevels(style.usingSymbolLevels())
    return renderer
