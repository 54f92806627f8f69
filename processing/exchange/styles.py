"""Styles that travel with layers, so that they look right when dropped on a canvas."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Callable
from uuid import uuid4

from osgeo import gdal
from qgis.core import (
    QgsCategorizedSymbolRenderer,
    QgsColorRampShader,
    QgsFeatureRenderer,
    QgsFeatureRequest,
    QgsFillSymbol,
    QgsMapLayer,
    QgsMarkerSymbol,
    QgsPalettedRasterRenderer,
    QgsRasterLayer,
    QgsRasterRenderer,
    QgsRasterShader,
    QgsReadWriteContext,
    QgsRendererCategory,
    QgsSingleBandPseudoColorRenderer,
    QgsSingleSymbolRenderer,
    QgsVectorLayer,
)
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtXml import QDomDocument

from ...core.annotation import findings
from ...core.labels.class_table import ClassTable
from ...storage.database.reader import stored_style
from ...storage.database.schema import REFERENCE_FIELDS, WINDOW_FIELDS
from ...storage.replaceable import MARK_OF_NOTE
from ..wording.annotation_messages import severity_title
from .column_names import name_columns
from .layer_metadata import Note, keep_beside
from .palette import BAD, INFORMATION, WARNING

WINDOW_COLOR = "#1f5fbf"

SEVERITY_STYLES = (
    (findings.ERROR, BAD, "0.6"),
    (findings.WARNING, WARNING, "0.5"),
    (findings.INFORMATION, INFORMATION, "0.2"),
)
"""Severity of a finding, color, width of its outline in millimeters."""

PERCENT_COLORS = ((0, "#440154"), (25, "#3b528b"), (50, "#21918c"), (75, "#5ec962"), (100, "#fde725"))
"""Percent and color: the steps of viridis (S. van der Walt and N. Smith, 2015)."""


def database_styles(table: ClassTable) -> dict[str, str]:
    """QML of the default style of each layer of a database, by table name."""
    return {
        "windows": _qml("Polygon", WINDOW_FIELDS, windows_renderer()),
        "references": _qml("Point", REFERENCE_FIELDS, references_renderer(table)),
        "overview": _overview_qml(table),
    }


def windows_renderer() -> QgsSingleSymbolRenderer:
    """Thin outlines without fill: thousands of overlapping windows stay readable."""
    symbol = QgsFillSymbol.createSimple(
        {"style": "no", "outline_color": WINDOW_COLOR, "outline_width": "0.2", "outline_style": "solid"}
    )
    return QgsSingleSymbolRenderer(symbol)


def references_renderer(table: ClassTable) -> QgsCategorizedSymbolRenderer:
    """Dots colored by class; the legend shows the reference classes by name."""
    categories = []
    for c in table.references:
        symbol = QgsMarkerSymbol.createSimple(
            {"name": "circle", "color": c.color, "size": "1.8", "outline_color": "#ffffff", "outline_width": "0.2"}
        )
        categories.append(QgsRendererCategory(c.value, symbol, c.name))
    return QgsCategorizedSymbolRenderer("class", categories)


def annotation_renderer(table: ClassTable, class_field: str, priority_field: str = "") -> QgsCategorizedSymbolRenderer:
    """Polygons in the class colors, without outlines; higher priorities on top where a field tells them."""
    categories = []
    for c in table:
        symbol = QgsFillSymbol.createSimple({"color": c.color, "outline_style": "no"})
        categories.append(QgsRendererCategory(c.name, symbol, c.name))
    renderer = QgsCategorizedSymbolRenderer(class_field, categories)
    if priority_field:
        renderer.setOrderBy(QgsFeatureRequest.OrderBy([QgsFeatureRequest.OrderByClause(priority_field)]))
        renderer.setOrderByEnabled(True)
    return renderer


def issues_renderer() -> QgsCategorizedSymbolRenderer:
    """Findings by severity, errors on top; outlines show even slivers."""
    categories = []
    for severity, color, width in SEVERITY_STYLES:
        fill = QColor(color)
        # Information may cover whole fields: it must not dye them.
        fill.setAlpha(0 if severity == findings.INFORMATION else 60)
        symbol = QgsFillSymbol.createSimple({"outline_color": color, "outline_width": width})
        symbol.symbolLayer(0).setFillColor(fill)
        # There may be thousands, of which the most say that all is as it was meant.
        symbol.setOpacity(0.5 if severity == findings.INFORMATION else 1.0)
        categories.append(QgsRendererCategory(severity, symbol, severity_title(severity)))
    renderer = QgsCategorizedSymbolRenderer("severity", categories)
    clause = QgsFeatureRequest.OrderByClause("array_find(array('information', 'warning', 'error'), \"severity\")")
    renderer.setOrderBy(QgsFeatureRequest.OrderBy([clause]))
    renderer.setOrderByEnabled(True)
    return renderer


def write_label_map_style(path: str, table: ClassTable, note: Note | None = None) -> str:
    """Write the style that QGIS finds beside a label map: only the map's own classes, 0 transparent.

    Without it the legend lists all 256 entries of the GeoTIFF's color table.

    Args:
        path: Of the label map.
        table: Its classes.
        note: What the map tells about itself, written beside it as well.

    Returns:
        The style as QML.
    """
    if note is not None:
        keep_beside(path, QgsRasterLayer(path, "note"), note)
    return _write_style(path, lambda layer: label_renderer(layer, table))


def write_percent_style(path: str, band: int = 1) -> str:
    """Write the style that QGIS finds beside a raster of percent, dark for doubt; returns it as QML."""
    return _write_style(path, lambda layer: percent_renderer(layer, band))


def _write_style(path: str, renderer: Callable[[QgsRasterLayer], QgsRasterRenderer]) -> str:
    layer = QgsRasterLayer(path, "style")
    layer.setRenderer(renderer(layer))
    qml = _exported(layer)
    marked = qml.replace("</qgis>", f"{MARK_OF_NOTE}</qgis>")
    Path(path).with_suffix(".qml").write_text(marked, encoding="utf-8")
    return qml


def label_renderer(layer: QgsRasterLayer, table: ClassTable) -> QgsPalettedRasterRenderer:
    """Class colors and names for a raster of class values."""
    classes = [QgsPalettedRasterRenderer.Class(c.value, QColor(c.color), c.name) for c in table if c.value]
    return QgsPalettedRasterRenderer(layer.dataProvider(), 1, classes)


def percent_renderer(layer: QgsRasterLayer, band: int) -> QgsSingleBandPseudoColorRenderer:
    """Colors that tell percent apart, also for people who see fewer colors."""
    colors = QgsColorRampShader(0.0, 100.0)
    colors.setColorRampItemList(
        [QgsColorRampShader.ColorRampItem(value, QColor(color), f"{value} %") for value, color in PERCENT_COLORS]
    )
    shader = QgsRasterShader()
    shader.setRasterShaderFunction(colors)
    return QgsSingleBandPseudoColorRenderer(layer.dataProvider(), band, shader)


def apply_overview_style(layer: QgsRasterLayer, database: str) -> None:
    """Gives an overview layer the style in its database; QGIS itself does so for vector layers only."""
    qml = stored_style(database, "overview")
    document = QDomDocument()
    if qml and document.setContent(qml):
        layer.importNamedStyle(document)


def _overview_qml(table: ClassTable) -> str:
    # A style is exported from a layer, and a raster layer needs a raster: one pixel in memory.
    path = f"/vsimem/semref_style_{uuid4().hex}.tif"
    try:
        raster = gdal.GetDriverByName("GTiff").Create(path, 1, 1, 1, gdal.GDT_Byte)
        raster.SetGeoTransform((0.0, 1.0, 0.0, 0.0, 0.0, -1.0))
        raster.FlushCache()
        layer = QgsRasterLayer(path, "overview")
        layer.setRenderer(label_renderer(layer, table))
        return _exported(layer)
    finally:
        gdal.Unlink(path)


def _qml(geometry: str, fields: Sequence[tuple[str, str]], renderer: QgsFeatureRenderer) -> str:
    # Of fields a style holds titles by name, and no types.
    columns = "&".join(f"field={name}" for name, _ in fields)
    layer = QgsVectorLayer(f"{geometry}?{columns}", "style", "memory")
    layer.setRenderer(renderer)
    name_columns(layer)
    return _exported(layer, QgsMapLayer.StyleCategory.Fields)


def _exported(layer: QgsMapLayer, *more: QgsMapLayer.StyleCategory) -> str:
    document = QDomDocument()
    # The other categories hold colors that QGIS draws by lot.
    categories = QgsMapLayer.StyleCategory.Symbology | QgsMapLayer.StyleCategory.CustomProperties
    for category in more:
        categories |= category
    error = layer.exportNamedStyle(document, QgsReadWriteContext(), categories)
    if document.isNull():
        raise RuntimeError(f"the style of {layer.name()} could not be exported: {error}")
    return document.toString()
