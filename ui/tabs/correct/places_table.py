"""Places of the tab Correct: issues of a check, or disagreements of two label maps."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from qgis.core import QgsFeature, QgsMapLayer, QgsVectorLayer
from qgis.PyQt.QtCore import QEvent, QItemSelectionModel, Qt
from qgis.PyQt.QtGui import QPaintEvent, QResizeEvent
from qgis.PyQt.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem

from ....core.annotation.findings import SEVERITIES, WARNING
from ....processing.compat import POLYGON_GEOMETRY, is_null
from ....processing.messages.annotation_messages import kind_titles, severity_title
from ....processing.translation import tr
from ...widgets.controls import number_text, paint_placeholder, plain_tip, sign_icon

SEVERITY_COLUMN, KIND_COLUMN, MESSAGE_COLUMN = range(3)

SEVERITY = "severity"
"""Severity field of the issues of *Check land-cover layer*."""

KIND = "kind"
"""Field with the kind of an issue, a key of ``kind_titles``."""

AREA = "area"
"""Field with the area in m²."""

ISSUES, DISAGREEMENTS = (KIND, "message"), ("annotated_class", "predicted_class")
"""Fields that the list shows: of issues, and of disagreements of label maps."""

_FLAGS = QItemSelectionModel.SelectionFlag
_LINES = 2
"""Lines of a message before it is cut off; enough for most in a dock of usual width."""
_MARGIN_PX = 6


class PlaceRow(NamedTuple):
    """One row of the list.

    Attributes:
        severity: Severity of an issue; empty for disagreements.
        texts: Texts of the other columns.
        kind: Kind of an issue, or both classes of a disagreement.
    """

    id: int
    severity: str
    texts: list[str]
    kind: str = ""
    kind_title: str = ""


class PlacesTable(QTableWidget):
    """Table of places; done ones are struck through."""

    def __init__(self) -> None:
        super().__init__(0, 3)
        self._icons = {severity: sign_icon(severity) for severity in SEVERITIES}
        self.setObjectName("SemRefPlaces")
        self.setAccessibleName(tr("Places"))
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setWordWrap(True)
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        header = self.horizontalHeader()
        header.setMinimumSectionSize(self.fontMetrics().height())
        header.setSectionResizeMode(MESSAGE_COLUMN, QHeaderView.ResizeMode.Stretch)
        self.show_titles(None)
        self._fit_rows()

    def _fit_rows(self) -> None:
        self.verticalHeader().setDefaultSectionSize(_LINES * self.fontMetrics().lineSpacing() + _MARGIN_PX)
        self.setColumnWidth(SEVERITY_COLUMN, 2 * self.fontMetrics().height())

    def show_titles(self, layer: QgsVectorLayer | None) -> None:
        """Set the headings for a layer, or those of issues without one."""
        titles = {ISSUES: (tr("Kind"), tr("Message")), DISAGREEMENTS: (tr("Annotated"), tr("Predicted"))}
        self.setHorizontalHeaderLabels(["", *titles[shown_fields(layer) or ISSUES]])
        self.horizontalHeaderItem(SEVERITY_COLUMN).setToolTip(tr("Severity"))
        self.horizontalHeaderItem(SEVERITY_COLUMN).setIcon(self._icons[WARNING])
        self.setColumnHidden(SEVERITY_COLUMN, layer is not None and not has_severity(layer))
        self.setColumnWidth(SEVERITY_COLUMN, 2 * self.fontMetrics().height())

    def add(self, place: PlaceRow) -> int:
        """Append a row. Return its number."""
        number = self.rowCount()
        self.setRowCount(number + 1)
        severity = QTableWidgetItem()
        if place.severity:
            severity.setIcon(self._icons.get(place.severity, self._icons[WARNING]))
            title = severity_title(place.severity)
            severity.setToolTip(title)
            severity.setData(Qt.ItemDataRole.AccessibleTextRole, title)
        for column, item in enumerate((severity, *(QTableWidgetItem(text) for text in place.texts))):
            item.setData(Qt.ItemDataRole.UserRole, place.id)
            if column == MESSAGE_COLUMN:
                item.setToolTip(plain_tip(item.text()))
            self.setItem(number, column, item)
        return number

    def id_of(self, row: int) -> int:
        return self.item(row, 0).data(Qt.ItemDataRole.UserRole)

    def selectRow(self, row: int) -> None:
        """Select a row. In right-to-left layouts Qt's method selects nothing if the columns exactly fill the view."""
        shown = SEVERITY_COLUMN if not self.isColumnHidden(SEVERITY_COLUMN) else KIND_COLUMN
        self.setCurrentCell(row, shown, _FLAGS.ClearAndSelect | _FLAGS.Rows)

    def selected_row(self) -> int:
        """Return the selected row; -1 without one."""
        rows = self.selectionModel().selectedRows()
        return rows[0].row() if rows else -1

    def strike_out(self, row: int, done: bool) -> None:
        """Strike a row through if its place is done."""
        for column in range(KIND_COLUMN, self.columnCount()):
            item = self.item(row, column)
            font = item.font()
            font.setStrikeOut(done)
            item.setFont(font)

    def fit_columns(self) -> None:
        """Fit the column of kinds to its content, up to a third of the width."""
        self.resizeColumnToContents(KIND_COLUMN)
        self._fit_width()

    def _fit_width(self) -> None:
        width = self.viewport().width() // 3
        self.setColumnWidth(KIND_COLUMN, min(max(self.columnWidth(KIND_COLUMN), 1), width))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_width()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        # QGIS sets fonts by a style sheet after a widget is created.
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange, QEvent.Type.Polish):
            self._fit_rows()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self.rowCount():
            paint_placeholder(
                self,
                tr("Places to check appear here. Run “Check land-cover layer” or “Compare label maps” to find them."),
            )


def shown_fields(layer: QgsMapLayer | None) -> tuple[str, str] | None:
    """Return ISSUES or DISAGREEMENTS; None for a layer of neither."""
    if not isinstance(layer, QgsVectorLayer) or layer.geometryType() != POLYGON_GEOMETRY:
        return None
    return next((fields for fields in (ISSUES, DISAGREEMENTS) if set(fields) <= set(layer.fields().names())), None)


def is_places(layer: QgsMapLayer) -> bool:
    """Return whether a layer has the fields of a result of *Check land-cover layer* or *Compare label maps*."""
    return shown_fields(layer) is not None


def has_severity(layer: QgsVectorLayer) -> bool:
    """Return whether the places have a severity, as issues do."""
    return SEVERITY in layer.fields().names()


def places_of(layer: QgsVectorLayer) -> Iterator[PlaceRow]:
    fields, kinds = shown_fields(layer), kind_titles()
    for feature in layer.getFeatures():
        first, second, area, position = _texts(feature, layer, kinds)
        place, severity = feature.id(), _value(feature, SEVERITY)
        if fields == DISAGREEMENTS:
            # All may have the same classes, so area and position are shown below.
            kind = f"{first} → {second}"
            yield PlaceRow(place, severity, [first, f"{second}\n{_joined(area, position)}"], kind, kind)
        else:
            yield PlaceRow(place, severity, [first, _joined(area, second)], _value(feature, KIND), first)


def place_text(feature: QgsFeature, layer: QgsVectorLayer) -> str:
    """Return all data of a place in one line."""
    severity = _value(feature, SEVERITY)
    return _joined(severity and severity_title(severity), *_texts(feature, layer, kind_titles()))


def _joined(*texts: str) -> str:
    return " · ".join(filter(None, texts))


def _value(feature: QgsFeature, field: str) -> Any:
    """Return a value; an empty text for NULL and for a field that the layer does not have."""
    index = feature.fieldNameIndex(field)
    return "" if index < 0 or is_null(feature[index]) else feature[index]


def _texts(feature: QgsFeature, layer: QgsVectorLayer, kinds: dict[str, str]) -> tuple[str, str, str, str]:
    """Return kind, message, area and position; for disagreements both classes instead of kind and message."""
    first, second = shown_fields(layer) or ISSUES
    area = _value(feature, AREA)
    size = "" if area == "" else tr("{area} m²").format(area=number_text(area, 1))
    position = _position(feature, 5 if layer.crs().isGeographic() else 0)
    kind = _text(_value(feature, first), kinds if first == KIND else {})
    return kind, _text(_value(feature, second), {}), size, position


def _position(feature: QgsFeature, decimals: int) -> str:
    """Return the center, in the layer's CRS."""
    if feature.geometry().isNull():
        return ""
    middle = feature.geometry().boundingBox().center()
    return f"{middle.x():.{decimals}f}, {middle.y():.{decimals}f}"


def _text(value: object, words: dict[str, str]) -> str:
    """Return the words for a key, or other identifiers without underscores."""
    text = str(value)
    return words.get(text) or (text.replace("_", " ") if text.isidentifier() else text)
