"""Shared parts of lists and tables: row selection, severity icons, placeholder texts."""

from __future__ import annotations

from pathlib import Path

from qgis.PyQt.QtCore import QItemSelectionModel, QRectF, Qt
from qgis.PyQt.QtGui import QIcon, QPainter, QPalette, QTextOption
from qgis.PyQt.QtWidgets import QAbstractScrollArea, QTableView, QWidget

from ...core.annotation.findings import SEVERITIES, WARNING

_SIGNS = Path(__file__).resolve().parents[2] / "resources" / "severity"
"""QGIS's own error sign is gray in some versions."""

LIKELY = "likely"
"""Name of the sign of a likely position."""

_FLAGS = QItemSelectionModel.SelectionFlag
_MARGIN_PX = 12


def select_row(view: QTableView, row: int) -> None:
    """Select a row and make it current.

    In right-to-left layouts Qt's own method selects nothing if the columns exactly fill the view.
    """
    header = view.horizontalHeader()
    shown = (column for column in range(view.model().columnCount()) if not header.isSectionHidden(column))
    index = view.model().index(row, next(shown, 0))
    view.selectionModel().setCurrentIndex(index, _FLAGS.ClearAndSelect | _FLAGS.Rows)
    view.scrollTo(index)


def severity_icon(severity: str) -> QIcon:
    """Return a cross in a disk, a triangle, or an i in a disk; a triangle for unknown severities."""
    return sign_icon(severity if severity in SEVERITIES else WARNING)


def sign_icon(name: str) -> QIcon:
    """Return the sign of a severity, or of a likely position: a question mark in an amber disk."""
    return QIcon(str(_SIGNS / f"{name}.svg"))


def paint_placeholder(view: QWidget, text: str) -> None:
    """Paint ``text`` in the middle of an empty view or widget; call it in paintEvent."""
    surface = view.viewport() if isinstance(view, QAbstractScrollArea) else view
    painter = QPainter(surface)
    painter.setPen(view.palette().color(QPalette.ColorRole.PlaceholderText))
    area = surface.rect().adjusted(_MARGIN_PX, 0, -_MARGIN_PX, 0)
    painter.drawText(QRectF(area), text, QTextOption(Qt.AlignmentFlag.AlignCenter))
    painter.end()
