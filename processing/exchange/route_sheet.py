"""A route on paper: a QGIS layout with map, legend, key figures and the stretches without an expected fix."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil

from qgis.core import (
    QgsFillSymbol,
    QgsLayoutExporter,
    QgsLayoutFrame,
    QgsLayoutItem,
    QgsLayoutItemLabel,
    QgsLayoutItemLegend,
    QgsLayoutItemManualTable,
    QgsLayoutItemMap,
    QgsLayoutItemScaleBar,
    QgsLayoutItemShape,
    QgsLayoutPoint,
    QgsLayoutSize,
    QgsLayoutTable,
    QgsMapLayer,
    QgsPrintLayout,
    QgsProject,
    QgsRectangle,
    QgsTableCell,
    QgsTextFormat,
    QgsUnitTypes,
    QgsVectorLayer,
)
from qgis.PyQt.QtGui import QColor

from ...core.errors import ParameterError
from .palette import FIX, INK, LINE, SOFT_INK

_MM = QgsUnitTypes.LayoutMillimeters
PAGE_MM = (297.0, 210.0)
MARGIN_MM = 12.0
MAP_MM = (12.0, 34.0, 192.0, 140.0)
"""Left, top, width, height of the map on an A4 page in landscape."""

AROUND = 1.15
"""The map shows so many times the route's extent."""

LINES_A_PAGE = 26
"""Of the table; more rows go on on further pages."""

CELL_MARGIN_MM, GRID_MM = 1.0, 0.2

LETTER_MM, LONGEST_CELL = 2.0, 60
"""A wide letter of the table; letters of a cell beyond which it is broken into lines."""


@dataclass(frozen=True)
class RouteSheet:
    """What a sheet shows.

    Attributes:
        title: Its heading.
        subtitle: Below it.
        route: The points along the route, styled.
        below: Layers under them, from top to bottom.
        figures: (what, value) of the key figures.
        header: Of the table.
        rows: Of the table.
        table_title: Above it.
    """

    title: str
    subtitle: str
    route: QgsVectorLayer
    below: Sequence[QgsMapLayer]
    figures: Sequence[tuple[str, str]]
    header: Sequence[str]
    rows: Sequence[Sequence[str]]
    table_title: str

    def write(self, path: str) -> None:
        """Writes the PDF; for the main thread. Raises ParameterError when it can't be written."""
        project = QgsProject()
        project.setCrs(self.route.crs())
        layout = QgsPrintLayout(project)
        layout.initializeDefaults()
        legend_layers = [layer.clone() for layer in (self.route, *self.below) if isinstance(layer, QgsVectorLayer)]
        grounds = [layer.clone() for layer in self.below if not isinstance(layer, QgsVectorLayer)]
        for layer in legend_layers:
            layer.setName(layer.metadata().title() or layer.name())
        project.addMapLayers(legend_layers)
        project.addMapLayers(grounds, False)
        self._add_head(layout)
        shown = self._add_map(layout, [*legend_layers, *grounds])
        self._add_side(layout, shown)
        self._add_table(layout)
        code = QgsLayoutExporter(layout).exportToPdf(path, QgsLayoutExporter.PdfExportSettings())
        if code != QgsLayoutExporter.Success:
            raise ParameterError("framework.not_written", name=path)

    def _add_head(self, layout: QgsPrintLayout) -> None:
        width = PAGE_MM[0] - 2 * MARGIN_MM
        _text(layout, self.title, (MARGIN_MM, 10.0, width, 11.0), 20, INK)
        _text(layout, self.subtitle, (MARGIN_MM, 21.0, width, 7.0), 10, SOFT_INK)
        line = QgsLayoutItemShape(layout)
        line.setShapeType(QgsLayoutItemShape.Rectangle)
        line.setSymbol(QgsFillSymbol.createSimple({"color": FIX, "outline_style": "no"}))
        _place(layout, line, (MARGIN_MM, 29.5, width, 0.8))

    def _add_map(self, layout: QgsPrintLayout, layers: list[QgsMapLayer]) -> QgsLayoutItemMap:
        item = QgsLayoutItemMap(layout)
        _place(layout, item, MAP_MM)
        item.setCrs(self.route.crs())
        item.setLayers(layers)
        item.setKeepLayerSet(True)
        item.setFrameEnabled(True)
        item.setExtent(_as_wide_as_map(self.route.extent()))
        return item

    def _add_side(self, layout: QgsPrintLayout, shown: QgsLayoutItemMap) -> None:
        left = MAP_MM[0] + MAP_MM[2] + 8
        width, top = PAGE_MM[0] - MARGIN_MM - left, MAP_MM[1]
        for what, value in self.figures:
            _text(layout, what, (left, top, width, 5.0), 8, SOFT_INK)
            _text(layout, value, (left, top + 4.5, width, 8.0), 14, INK)
            top += 14.5
        legend = QgsLayoutItemLegend(layout)
        legend.setLinkedMap(shown)
        legend.setAutoUpdateModel(True)
        _place(layout, legend, (left - 2, top + 2, width, 40.0))
        bar = QgsLayoutItemScaleBar(layout)
        bar.setLinkedMap(shown)
        bar.applyDefaultSize()
        _place(layout, bar, (MAP_MM[0], MAP_MM[1] + MAP_MM[3] + 3, 60.0, 12.0))

    def _add_table(self, layout: QgsPrintLayout) -> None:
        width, columns = PAGE_MM[0] - 2 * MARGIN_MM, len(self.header)
        # QGIS adds its margins and the grid to the columns' widths.
        room = width - columns * 2 * CELL_MARGIN_MM - (columns + 1) * GRID_MM
        widths = [room * share for share in column_shares([self.header, *self.rows])]
        for number, rows in enumerate(rows_by_page(self.rows, widths), start=1):
            layout.pageCollection().extendByNewPage()
            top = number * (PAGE_MM[1] + layout.pageCollection().spaceBetweenPages())
            _text(layout, self.table_title, (MARGIN_MM, top + 10.0, width, 10.0), 14, INK)
            table = QgsLayoutItemManualTable.create(layout)
            layout.addMultiFrame(table)
            table.setTableContents([[QgsTableCell(cell) for cell in line] for line in (self.header, *rows)])
            table.setGridColor(QColor(LINE))
            table.setGridStrokeWidth(GRID_MM)
            table.setCellMargin(CELL_MARGIN_MM)
            table.setWrapBehavior(QgsLayoutTable.WrapText)
            table.setColumnWidths(widths)
            frame = QgsLayoutFrame(layout, table)
            frame.attemptMove(QgsLayoutPoint(MARGIN_MM, top + 22.0, _MM))
            frame.attemptResize(QgsLayoutSize(width, PAGE_MM[1] - 34.0, _MM))
            table.addFrame(frame)


def _as_wide_as_map(extent: QgsRectangle) -> QgsRectangle:
    """An extent around another one, of the map's proportions: QGIS would change the map's size instead."""
    width, height = max(extent.width(), 1.0) * AROUND, max(extent.height(), 1.0) * AROUND
    ratio = MAP_MM[2] / MAP_MM[3]
    return QgsRectangle.fromCenterAndSize(extent.center(), max(width, height * ratio), max(height, width / ratio))


def column_shares(lines: Sequence[Sequence[str]]) -> list[float]:
    """Share of a table's width that each column gets, by its longest cell; none less than a short number needs."""
    longest = [max(6, *(min(len(cell), LONGEST_CELL) for cell in column)) for column in zip(*lines)]
    return [one / sum(longest) for one in longest]


def rows_by_page(rows: Sequence[Sequence[str]], widths_mm: Sequence[float]) -> list[list[Sequence[str]]]:
    """Rows of a table as pages have room for them below its header, when long cells are broken into lines."""
    pages: list[list[Sequence[str]]] = []
    left = 0
    for row in rows:
        lines = max(ceil(len(cell) * LETTER_MM / width) for cell, width in zip(row, widths_mm)) or 1
        if not pages or lines > left:
            pages.append([])
            left = LINES_A_PAGE
        pages[-1].append(row)
        left -= lines
    return pages


def _text(
    layout: QgsPrintLayout, text: str, place_mm: tuple[float, float, float, float], size: int, color: str
) -> None:
    label, look = QgsLayoutItemLabel(layout), QgsTextFormat()
    look.setSize(size)
    look.setColor(QColor(color))
    if hasattr(label, "setTextFormat"):
        label.setTextFormat(look)
    else:
        font = label.font()
        font.setPointSize(size)
        label.setFont(font)
        label.setFontColor(QColor(color))
    # Two brackets and a percent sign would be an expression.
    label.setText(text.replace("[%", "[ %"))
    _place(layout, label, place_mm)


def _place(layout: QgsPrintLayout, item: QgsLayoutItem, place_mm: tuple[float, float, float, float]) -> None:
    left, top, width, height = place_mm
    layout.addLayoutItem(item)
    item.attemptMove(QgsLayoutPoint(left, top, _MM))
    item.attemptResize(QgsLayoutSize(width, height, _MM))
