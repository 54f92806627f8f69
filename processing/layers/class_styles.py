"""Styles that depend on a class table or a threshold, and style files beside rasters."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCategorizedSymbolRenderer,
    QgsFeatureRequest,
    QgsFillSymbol,
    QgsGraduatedSymbolRenderer,
    QgsMapLayer,
    QgsMarkerSymbol,
    QgsRasterLayer,
    QgsReadWriteContext,
    QgsRendererCategory,
    QgsRendererRange,
    QgsVectorLayer,
)
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtXml import QDomDocument

from ...core.annotation.classes import ClassLookup
from ...core.labels.class_table import ClassTable
from ...storage.database.reader import stored_style
from ...storage.database.schema import REFERENCE_FIELDS, WINDOW_FIELDS
from ...storage.replaceable import MARK_OF_NOTE
from ..messages.columns import verdict_words
from ..messages.numbers import shown
from .layer_metadata import Note, save_beside
from .styles import STYLES, apply_style, name_columns, style_renderer

if TYPE_CHECKING:
    from .annotation import AnnotationSource


def database_styles(table: ClassTable) -> dict[str, str]:
    """Return the default style of each layer of a database as QML by table name."""
    windows, references = _fields_only("Polygon", WINDOW_FIELDS), _fields_only("Point", REFERENCE_FIELDS)
    apply_style(windows, "windows")
    references.setRenderer(references_renderer(table))
    return {
        "windows": _style_with_titles(windows),
        "references": _style_with_titles(references),
        "overview": label_style(table),
    }


def _fields_only(geometry: str, fields: Sequence[tuple[str, str]]) -> QgsVectorLayer:
    # A style has titles of fields by name, but no types.
    columns = "&".join(f"field={name}" for name, _ in fields)
    return QgsVectorLayer(f"{geometry}?{columns}", "style", "memory")


def _style_with_titles(layer: QgsVectorLayer) -> str:
    name_columns(layer)
    document, categories = QDomDocument(), QgsMapLayer.StyleCategory
    # Other categories contain random colors.
    shown = categories.Symbology | categories.CustomProperties | categories.Fields
    error = layer.exportNamedStyle(document, QgsReadWriteContext(), shown)
    if document.isNull():
        raise RuntimeError(f"the style of {layer.name()} could not be exported: {error}")
    return document.toString()


def references_renderer(table: ClassTable) -> QgsCategorizedSymbolRenderer:
    """Return a renderer of dots in class colors; the legend shows the reference classes by name."""
    categories = []
    for c in table.references:
        symbol = QgsMarkerSymbol.createSimple(
            {"name": "circle", "color": c.color, "size": "1.8", "outline_color": "#ffffff", "outline_width": "0.2"}
        )
        categories.append(QgsRendererCategory(c.value, symbol, c.name))
    return QgsCategorizedSymbolRenderer("class", categories)


def annotation_renderer(table: ClassTable, class_field: str, priority_field: str = "") -> QgsCategorizedSymbolRenderer:
    """Return a renderer of polygons in class colors without outlines, drawn in the order of a priority field."""
    categories = []
    for c in table:
        symbol = QgsFillSymbol.createSimple({"color": c.color, "outline_style": "no"})
        categories.append(QgsRendererCategory(c.name, symbol, c.name))
    renderer = QgsCategorizedSymbolRenderer(class_field, categories)
    if priority_field:
        renderer.setOrderBy(QgsFeatureRequest.OrderBy([QgsFeatureRequest.OrderByClause(priority_field)]))
        renderer.setOrderByEnabled(True)
    return renderer


def repaired_renderer(lookup: ClassLookup, source: AnnotationSource) -> QgsCategorizedSymbolRenderer:
    """Return a renderer of a land-cover layer in class colors by the values of its class column."""
    categories = []
    for one in lookup.table:
        symbol = QgsFillSymbol.createSimple({"color": one.color, "outline_style": "no"})
        for raw in lookup.raw_values(one.value, source.class_is_number):
            categories.append(QgsRendererCategory(raw, symbol.clone(), one.name))
    return QgsCategorizedSymbolRenderer(source.class_expression, categories)


def label_style(table: ClassTable) -> str:
    """Return the style of a label map as QML: class colors and names, 0 transparent."""
    # As text: Qt writes the attributes of an element in random order.
    entries = (
        f'    <paletteEntry value="{one.value}" color="{one.color}" label="{escape(one.name)}" alpha="255"/>\n'
        for one in table
        if one.value
    )
    qml = (STYLES / "labels.qml").read_text(encoding="utf-8")
    return qml.replace("<colorPalette/>", "<colorPalette>\n" + "".join(entries) + "   </colorPalette>")


def write_label_map_style(path: str, table: ClassTable, note: Note | None = None) -> str:
    """Write the style beside a label map: the map's classes only, 0 transparent.

    Without a style the legend would list all 256 entries of the GeoTIFF's color table.

    Args:
        note: Metadata of the map, written beside it as well.

    Returns:
        The style as QML.
    """
    if note is not None:
        save_beside(path, QgsRasterLayer(path, "note"), note)
    return _write_beside(path, label_style(table))


def write_percent_style(path: str, band: int = 1) -> str:
    """Write the style beside a raster of probabilities, dark for low ones; return it as QML."""
    qml = (STYLES / "percent.qml").read_text(encoding="utf-8")
    return _write_beside(path, qml.replace('band="1"', f'band="{band}"'))


def _write_beside(path: str, qml: str) -> str:
    marked = qml.replace("</qgis>", f"{MARK_OF_NOTE}</qgis>")
    Path(path).with_suffix(".qml").write_text(marked, encoding="utf-8")
    return qml


def apply_overview_style(layer: QgsRasterLayer, database: str) -> None:
    """Apply the style in a database to its overview layer; QGIS itself does this for vector layers only."""
    qml = stored_style(database, "overview")
    document = QDomDocument()
    if qml and document.setContent(qml):
        layer.importNamedStyle(document)


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
