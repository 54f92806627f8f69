"""Symbols of positions: an arrow where the image's top points to, on the 95 % ellipse, which has the map's scale."""

from __future__ import annotations

from qgis.core import (
    QgsEllipseSymbolLayer,
    QgsMarkerSymbol,
    QgsProperty,
    QgsSimpleMarkerSymbolLayer,
    QgsSymbolLayer,
    QgsUnitTypes,
)
from qgis.PyQt.QtGui import QColor

from .palette import CASING

ARROW_MM = (3.2, 5.0)
"""Width and height of the slender triangle whose tip points to the image's top."""

DISC_MM = 2.6
CASING_MM = 0.8
"""How far the white casing reaches beyond a mark, both sides together."""

FILLED, HOLLOW, DISC, CROSS = "filled", "hollow", "disc", "cross"
"""Shapes of marks: arrows, and what has no heading or does not hold."""


def pose_symbol(color: str, shape: str) -> QgsMarkerSymbol:
    """A mark with a white casing on its ellipse."""
    symbol = QgsMarkerSymbol.createSimple({})
    # Not from a list of layers: QGIS would not take them over, and Python deletes what it keeps.
    symbol.changeSymbolLayer(0, _ellipse(color))
    for one in (_mark(CASING, CASING, shape, 0.6 + CASING_MM), _mark(color, _fill(color, shape), shape, 0.6)):
        symbol.appendSymbolLayer(one)
    return symbol


def _fill(color: str, shape: str) -> str:
    return CASING if shape == HOLLOW else color


def _ellipse(color: str) -> QgsEllipseSymbolLayer:
    layer = QgsEllipseSymbolLayer()
    fill = QColor(color)
    fill.setAlpha(45)
    layer.setFillColor(fill)
    layer.setStrokeColor(QColor(color))
    layer.setStrokeWidth(0.3)
    for set_unit in (layer.setSymbolWidthUnit, layer.setSymbolHeightUnit):
        set_unit(QgsUnitTypes.RenderMapUnits)
    minor = 'coalesce(2 * coalesce("error_95_minor", "error_95"), 0)'
    for kind, expression in (
        (QgsSymbolLayer.PropertyWidth, minor),
        (QgsSymbolLayer.PropertyHeight, 'coalesce(2 * "error_95", 0)'),
        (QgsSymbolLayer.PropertyAngle, 'coalesce("error_95_direction", 0)'),
    ):
        layer.setDataDefinedProperty(kind, QgsProperty.fromExpression(expression))
    return layer


def _mark(color: str, fill: str, shape: str, width_mm: float) -> QgsSymbolLayer:
    """A mark without its ellipse, turned by the heading."""
    outline = {"color": fill, "fill_color": fill, "outline_color": color, "outline_width": str(width_mm)}
    if shape in (FILLED, HOLLOW):
        width, height = ARROW_MM
        arrow = {"symbol_name": "triangle", "symbol_width": str(width), "symbol_height": str(height)}
        layer = QgsEllipseSymbolLayer.create({**outline, **arrow})
    else:
        name = {DISC: "circle", CROSS: "cross2"}[shape]
        layer = QgsSimpleMarkerSymbolLayer.create({**outline, "name": name, "size": str(DISC_MM)})
    turned = QgsProperty.fromExpression('coalesce("heading", 0)')
    layer.setDataDefinedProperty(QgsSymbolLayer.PropertyAngle, turned)
    return layer
