"""Styles that travel inside a reference database, so that its layers look right when dropped on a canvas."""

from __future__ import annotations

from pathlib import Path
from typing import Dict

from qgis.core import (
    QgsCategorizedSymbolRenderer,
    QgsFillSymbol,
    QgsMapLayer,
    QgsMarkerSymbol,
    QgsPalettedRasterRenderer,
    QgsRasterLayer,
    QgsRendererCategory,
    QgsSingleSymbolRenderer,
    QgsVectorLayer,
)
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtXml import QDomDocument

from ...core.class_table import ClassTable
from .files import written_beside

WINDOW_COLOR = "#1f5fbf"

_OURS = "semref/style"
"""Custom property that marks a style file as written by SemRef, so that it may be replaced."""


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


def write_label_map_style(path: str, table: ClassTable) -> None:
    """Writes the style that QGIS finds beside a label map: only the map's own classes, 0 transparent.

    Without it the legend lists all 256 entries of the GeoTIFF's colour table. A style that somebody else put
    there stays.
    """
    style = Path(path).with_suffix(".qml")
    if style.exists() and _OURS not in style.read_text(encoding="utf-8", errors="replace"):
        return
    layer = QgsRasterLayer(path, "style")
    layer.setRenderer(label_renderer(layer, table))
    layer.setCustomProperty(_OURS, True)
    with written_beside(str(style)) as temporary:
        Path(temporary).write_text(_exported(layer), encoding="utf-8")


def label_renderer(layer: QgsRasterLayer, table: ClassTable) -> QgsPalettedRasterRenderer:
    """Class colours and names for a raster of class values."""
    classes = [QgsPalettedRasterRenderer.Class(c.value, QColor(c.color), c.name) for c in table if c.value]
    return QgsPalettedRasterRenderer(layer.dataProvider(), 1, classes)


def _qml(geometry: str, fields: str, renderer) -> str:
    layer = QgsVectorLayer(f"{geometry}?field={fields}", "style", "memory")
    layer.setRenderer(renderer)
    return _exported(layer)


def _exported(layer: QgsMapLayer) -> str:
    document = QDomDocument()
    error = layer.exportNamedStyle(document)
    if document.isNull():
        raise RuntimeError(f"the style of {layer.name()} could not be exported: {error}")
    return document.toString()
