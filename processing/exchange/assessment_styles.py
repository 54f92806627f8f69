"""How assessments look on a map: five steps of the evenly perceived ramp cividis, with words in the legend."""

from __future__ import annotations

from typing import Callable

from qgis.core import (
    QgsFillSymbol,
    QgsGeometryGeneratorSymbolLayer,
    QgsGraduatedSymbolRenderer,
    QgsLineSymbol,
    QgsMarkerSymbol,
    QgsRendererRange,
    QgsSymbol,
)

from ...storage import map_tips
from ..translation import tr
from ..wording.columns import verdict_words
from ..wording.numbers import shown
from .output_style import Look
from .palette import CASING, INK

COLORS = ("#00204d", "#46516c", "#7c7b78", "#bcad6c", "#ffea46")
"""Expected success from hardly ever to very reliably: cividis (Nuñez et al. 2018) at even steps, dark to light."""

_OPACITY = 0.5
"""Of squares: forest, roads and roofs of a base map stay readable, and the steps of the ramp can be distinguished."""

_IN_LEGEND = "make_line(translate($geometry, -7, 0), translate($geometry, 7, 0))"
"""Expression of the line in a legend, which has a point without columns."""


def success_classes(threshold: float) -> list[tuple[float, float, str, str]]:
    """(from, to, color, legend text) of five classes of success 0…1; the upper two are good enough."""
    # OpenCV is not there when the plugin starts.
    from ...core.assessment.squares import verdict_edges

    edges = verdict_edges(threshold)
    return [
        (low, high, color, f"{word} ({shown(100 * low, '.3g')}–{shown(100 * high, '.3g')} %)")
        for low, high, color, word in zip(edges, edges[1:], COLORS, verdict_words().values())
    ]


def cells_look(threshold: float, footprint: float, is_only: bool) -> Look:
    """Translucent squares colored by success; of several footprints in one layer those of ``footprint`` alone."""
    value = "success" if is_only else f'if("footprint" = {footprint!r}, "success", NULL)'
    rows = [
        *_expected_rows(),
        (tr("Verdict"), map_tips.worded("verdict", verdict_words())),
        (tr("Distinctiveness"), map_tips.number("distinctiveness", 2)),
    ]
    return Look(_graduated(value, threshold, _square), tip=map_tips.tip(_percent("success"), rows))


def route_look(threshold: float) -> Look:
    """A line with a dark and a white rim, which shows on squares of the same colors, graded by success."""
    rows = [
        *_expected_rows(),
        (tr("Along the route"), map_tips.number("along", 2, 0.001, "km")),
        (tr("Stretch without an expected fix"), f'if("gap" > 0, {map_tips.number("gap", 0, unit="m")}, NULL)'),
    ]
    renderer = _graduated("success", threshold, _stretch)
    renderer.setUsingSymbolLevels(True)
    return Look(renderer, tip=map_tips.tip(_percent("success"), rows))


def _expected_rows() -> list[tuple[str, str]]:
    """(title, expression) of what is expected at a place, for its map tip."""
    return [
        (tr("95 % interval"), f"{_percent('success_low')} || '–' || {_percent('success_high')}"),
        (tr("Expected error"), map_tips.number("error", 1, unit="m")),
        (tr("Landmarks in view"), map_tips.number("objects", 0)),
        (tr("Reason"), f"nullif({map_tips.text('reason')}, '')"),
    ]


def _percent(column: str) -> str:
    return map_tips.number(column, 0, 100, "%")


def _graduated(value: str, threshold: float, symbol: Callable[[str], QgsSymbol]) -> QgsGraduatedSymbolRenderer:
    ranges = [QgsRendererRange(low, high, symbol(color), text) for low, high, color, text in success_classes(threshold)]
    # From good to bad, as a legend is read.
    return QgsGraduatedSymbolRenderer(value, ranges[::-1])


def _square(color: str) -> QgsFillSymbol:
    symbol = QgsFillSymbol.createSimple({"color": color, "outline_style": "no"})
    symbol.setOpacity(_OPACITY)
    return symbol


def _stretch(color: str) -> QgsMarkerSymbol:
    """The stretch of the route that a point stands for, as the column ``stretch`` has it."""
    symbol = QgsMarkerSymbol.createSimple({})
    for n, (line_color, width) in enumerate(((INK, "2.8"), (CASING, "2.3"), (color, "1.6"))):
        layer = QgsGeometryGeneratorSymbolLayer.create(
            {"SymbolType": "Line", "geometryModifier": f'coalesce(geom_from_wkt("stretch"), {_IN_LEGEND})'}
        )
        line = QgsLineSymbol.createSimple({"line_color": line_color, "line_width": width, "capstyle": "round"})
        layer.setSubSymbol(line)
        # All rims lie below all colors, so that stretches join without seams.
        layer.setRenderingPass(n)
        if n == 0:
            symbol.changeSymbolLayer(0, layer)
        else:
            symbol.appendSymbolLayer(layer)
    return symbol
