"""How expected success looks on a map and in reports: five steps of the evenly perceived ramp cividis, with words."""

from __future__ import annotations

from qgis.core import QgsGraduatedSymbolRenderer, QgsRendererRange
from qgis.PyQt.QtGui import QColor

from ..messages.columns import verdict_words
from ..messages.numbers import shown
from .styles import style_renderer

COLORS = ("#00204d", "#46516c", "#7c7b78", "#bcad6c", "#ffea46")
"""Expected success from hardly ever to very reliably: cividis (Nuñez et al. 2018) at even steps, dark to light."""


def success_classes(threshold: float) -> list[tuple[float, float, str, str]]:
    """(from, to, color, legend text) of five classes of success 0…1; the upper two are good enough."""
    # OpenCV is not there when the plugin starts.
    from ...core.assessment.squares import verdict_edges

    edges = verdict_edges(threshold)
    return [
        (low, high, color, f"{word} ({shown(100 * low, '.3g')}–{shown(100 * high, '.3g')} %)")
        for low, high, color, word in zip(edges, edges[1:], COLORS, verdict_words().values())
    ]


def cells_renderer(threshold: float, footprint: float, is_only: bool) -> QgsGraduatedSymbolRenderer:
    """Return squares colored by success; of several footprints in one layer those of ``footprint`` alone."""
    value = "success" if is_only else f'if("footprint" = {footprint!r}, "success", NULL)'
    return _graduated("cells", value, threshold)


def route_renderer(threshold: float) -> QgsGraduatedSymbolRenderer:
    """Return stretches of a route colored by success."""
    return _graduated("route", "success", threshold)


def _graduated(name: str, value: str, threshold: float) -> QgsGraduatedSymbolRenderer:
    """The symbol of a style in five steps; its uppermost layer has the color of the step."""
    style = style_renderer(name)
    ranges = []
    for low, high, color, text in success_classes(threshold):
        symbol = style.symbol().clone()
        uppermost = symbol.symbolLayer(symbol.symbolLayerCount() - 1)
        (uppermost.subSymbol() or uppermost).setColor(QColor(color))
        ranges.append(QgsRendererRange(low, high, symbol, text))
    # From good to bad, as a legend is read.
    renderer = QgsGraduatedSymbolRenderer(value, ranges[::-1])
    renderer.setUsingSymbolLevels(style.usingSymbolLevels())
    return renderer
