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

from ...storage import map_tips, squares_style
from ..translation import tr
from ..wording.numbers import shown
from .output_style import Look
from .palette import CASING, INK

_IN_LEGEND = "make_line(translate($geometry, -7, 0), translate($geometry, 7, 0))"
"""Expression of the line in a legend, which has a point without columns."""


def success_classes(threshold: float) -> list[tuple[float, float, str, str]]:
    """(from, to, color, legend text) of five classes of success 0…1; the upper two are good enough."""
    return squares_style.success_classes(threshold, tr, lambda percent: shown(percent, ".3g"))


def cells_look(threshold: float, footprint: float, is_only: bool) -> Look:
    """Translucent squares colored by success; of several footprints in one layer those of ``footprint`` alone."""
    value = squares_style.success_expression(footprint, is_only)
    return Look(_graduated(value, threshold, _square), tip=squares_style.squares_tip(tr))


def route_look(threshold: float) -> Look:
    """A line with a dark and a white rim, which shows on squares of the same colors, graded by success."""
    rows = [
        *squares_style.expected_rows(tr),
        (tr("Along the route"), map_tips.number("along", 2, 0.001, "km")),
        (tr("Stretch without an expected fix"), f'if("gap" > 0, {map_tips.number("gap", 0, unit="m")}, NULL)'),
    ]
    renderer = _graduated("success", threshold, _stretch)
    renderer.setUsingSymbolLevels(True)
    return Look(renderer, tip=map_tips.tip(squares_style.success_heading(), rows))


def _graduated(value: str, threshold: float, symbol: Callable[[str], QgsSymbol]) -> QgsGraduatedSymbolRenderer:
    ranges = [QgsRendererRange(low, high, symbol(color), text) for low, high, color, text in success_classes(threshold)]
    # From good to bad, as a legend is read.
    return QgsGraduatedSymbolRenderer(value, ranges[::-1])


def _square(color: str) -> QgsFillSymbol:
    symbol = QgsFillSymbol.createSimple({"color": color, "outline_style": "no"})
    symbol.setOpacity(squares_style.OPACITY)
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
