"""Styles that travel inside a reference database, so that its layers look right when dropped on a canvas."""

from __future__ import annotations

from typing import Dict

from qgis.core import (
    QgsCategorizedSymbolRenderer,
    QgsFillSymbol,
    QgsMarkerSymbol,
    QgsRendererCategory,
    QgsSingleSymbolRenderer,
    QgsVectorLayer,
)
from qgis.PyQt.QtXml import QDomDocument

from ...core.class_table import ClassTable

WINDOW_COLOR = "#1f5fbf"
WINDOW_NO_VECTOR_COLOR = "#c0392b"


def database_styles(table: ClassTable) -> Dict[str, str]:
    """QML of the default style of each vector layer of a database, by table name."""
    return {
        "windows": _qml("Polygon", "reference_count:integer", windows_renderer()),
        "references": _qml("Point", "class:integer&field=class_name:string", references_renderer(table)),
    }


def windows_renderer() -> QgsSingleSymbolRenderer:
    """Thin outlines without fill: thousands of overlapping windows stay readable."""
    symbol = QgsFillSymbol.createSimple(
        {"style": "no", "outline_color": WINDOW_COLOR, "outline_width": "0.2", "outline_style": "solid"}
    )
    return QgsSingleSymbolRenderer(symbol)


def references_renderer(table: ClassTable) -> QgsCategorizedSymbolRenderer:
    """Dots coloured by class; the legend shows the reference classes by name."""
    categories = []
    for c in table.references:
        symbol = QgsMarkerSymbol.createSimple(
            {"name": "circle", "color": c.color, "size": "1.8", "outline_color": "#ffffff", "outline_width": "0.2"}
        )
        categories.append(QgsRendererCategory(c.value, symbol, c.name))
    return QgsCategorizedSymbolRenderer("class", categories)


def _qml(geometry: str, fields: str, renderer) -> str:
    layer = QgsVectorLayer(f"{geometry}?field={fields}", "style", "memory")
    layer.setRenderer(renderer)
    document = QDomDocument()
    error = layer.exportNamedStyle(document)
    # 3.22 returns the message, later versions may return (None/"", …); an empty document is the failure either way.
    if document.isNull():
        raise RuntimeError(f"the style of {geometry} could not be exported: {error}")
    return document.toString()
