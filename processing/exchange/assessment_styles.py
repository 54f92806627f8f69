"""How assessments look on a map: five steps of the evenly perceived ramp cividis, with words in the legend."""

from __future__ import annotations

from typing import Callable

from qgis.core import (
    QgsFillSymbol,
    QgsGraduatedSymbolRenderer,
    QgsMarkerSymbol,
    QgsRendererRange,
    QgsSymbol,
)

from ..translation import tr

COLORS = ("#00204d", "#46516c", "#7c7b78", "#bcad6c", "#ffea46")
"""Cividis (Nuñez et al. 2018) at even steps, dark to light; told apart by the color-blind and in grey."""


def success_classes(threshold: float) -> list[tuple[float, float, str, str]]:
    """(from, to, color, legend text) of five classes of success 0…1; the upper two are good enough."""
    edges = [0.0, threshold / 3, 2 * threshold / 3, threshold, (1 + threshold) / 2, 1.0]
    words = [tr("hardly ever"), tr("sometimes"), tr("often"), tr("reliably"), tr("very reliably")]
    return [
        (low, high, color, f"{word} ({100 * low:.3g}–{100 * high:.3g} %)")
        for low, high, color, word in zip(edges, edges[1:], COLORS, words)
    ]


def cell_renderer(threshold: float, footprint: float, is_only: bool) -> QgsGraduatedSymbolRenderer:
    """Squares colored by success; of several footprints in one layer those of ``footprint`` alone."""
    value = "success" if is_only else f'if("footprint" = {footprint!r}, "success", NULL)'
    return _graduated(
        value, threshold, lambda color: QgsFillSymbol.createSimple({"color": color, "outline_style": "no"})
    )


def point_renderer(threshold: float) -> QgsGraduatedSymbolRenderer:
    """Points along a route, colored by success."""
    return _graduated(
        "success",
        threshold,
        lambda color: QgsMarkerSymbol.createSimple(
            {"name": "circle", "color": color, "size": "2.6", "outline_color": "#ffffff", "outline_width": "0.2"}
        ),
    )


def _graduated(value: str, threshold: float, symbol: Callable[[str], QgsSymbol]) -> QgsGraduatedSymbolRenderer:
    ranges = [QgsRendererRange(low, high, symbol(color), text) for low, high, color, text in success_classes(threshold)]
    # From good to bad, as a legend is read.
    return QgsGraduatedSymbolRenderer(value, ranges[::-1])
