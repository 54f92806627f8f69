"""How a flight looks on a map: where its images' tops point to, how exactly that is known, what each pose rests on."""

from __future__ import annotations

from qgis.core import (
    QgsEllipseSymbolLayer,
    QgsLineSymbol,
    QgsMarkerSymbol,
    QgsProperty,
    QgsRuleBasedRenderer,
    QgsSimpleMarkerSymbolLayer,
    QgsSingleSymbolRenderer,
    QgsSymbolLayer,
    QgsUnitTypes,
    QgsVectorLayer,
)
from qgis.PyQt.QtGui import QColor

from ..compat import is_null
from ..translation import tr
from .output_style import Look

OWN_COLOR, FLIGHT_COLOR, OUTVOTED_COLOR = "#0067a5", "#e08a00", "#d7263d"
"""Blue, orange and red that the color-blind tell apart; shapes differ, too."""

TRACK_COLOR = "#3a4147"


def pose_kinds() -> tuple[tuple[str, str, str, str], ...]:
    """(expression, color, shape of the marker, words of the legend) of each kind of pose."""
    return (
        ("\"source\" = 'own'", OWN_COLOR, "filled_arrowhead", tr("Fix of the image itself")),
        (
            '"source" = \'flight\' AND coalesce("outvoted", 0) = 0',
            FLIGHT_COLOR,
            "arrowhead",
            tr("Placed by the flight"),
        ),
        ('"source" = \'flight\' AND "outvoted"', OUTVOTED_COLOR, "cross2", tr("Its own fix was outvoted")),
    )


def poses_renderer() -> QgsRuleBasedRenderer:
    """Arrows where the images' tops point to, on their 95 % ellipses, which have the map's own scale."""
    root = QgsRuleBasedRenderer.Rule(None)
    for expression, color, shape, words in pose_kinds():
        # Not from a list of layers: QGIS would not take them over, and Python deletes what it keeps.
        symbol = QgsMarkerSymbol.createSimple({})
        symbol.changeSymbolLayer(0, _ellipse(color))
        symbol.appendSymbolLayer(_arrow(color, shape))
        root.appendChild(QgsRuleBasedRenderer.Rule(symbol, 0, 0, expression, words))
    return QgsRuleBasedRenderer(root)


def track_renderer() -> QgsSingleSymbolRenderer:
    """Thin dark lines, which cover neither arrows nor ellipses."""
    return QgsSingleSymbolRenderer(QgsLineSymbol.createSimple({"line_color": TRACK_COLOR, "line_width": "0.4"}))


def flight_look(positions: QgsVectorLayer) -> Look:
    """What positions of a flight come with: their style and, with times, that QGIS plays them."""
    is_timed = any(not is_null(feature["time"]) for feature in positions.getFeatures())
    return Look(poses_renderer(), "time" if is_timed else "")


def track_look() -> Look:
    """What tracks come with."""
    return Look(track_renderer())


def _ellipse(color: str) -> QgsEllipseSymbolLayer:
    layer = QgsEllipseSymbolLayer()
    fill = QColor(color)
    fill.setAlpha(45)
    layer.setFillColor(fill)
    layer.setStrokeColor(QColor(color))
    layer.setStrokeWidth(0.2)
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


def _arrow(color: str, shape: str) -> QgsSimpleMarkerSymbolLayer:
    layer = QgsSimpleMarkerSymbolLayer.create(
        {"name": shape, "color": color, "outline_color": color, "outline_width": "0.6", "size": "3.4"}
    )
    # The head of QGIS's arrows points to the right.
    turned = 'coalesce("heading", 0) - 90' if shape != "cross2" else 'coalesce("heading", 0)'
    layer.setDataDefinedProperty(QgsSymbolLayer.PropertyAngle, QgsProperty.fromExpression(turned))
    return layer
