"""The dock's second tab: one window of the database, its vector, and what looks like it elsewhere."""

from __future__ import annotations

from html import escape
from typing import Optional

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsPointXY,
    QgsProject,
)
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QLabel,
    QLineEdit,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ....core.database.look_alikes import DescribedWindow, describe_window, vector_rows, window_at
from ....core.database.model import ReferenceDatabase
from ....core.windows.matching import vector_confidence, vector_distances
from ....processing.translation import tr
from ...canvas.window_marks import WindowMarks
from ...canvas.window_tool import WindowTool
from ...widgets.buttons import tool_button
from ...widgets.layouts import narrow, row_of
from .vector_plot import VectorPlot

_DIFFERS = 0.1
"""Elements of two vectors farther apart than this are marked: over all 30 they make a distance of 0.5."""


class InspectTab(QWidget):
    """Asks for a database with ``databaseWanted``; ``use`` gives it. ``shut_down`` before it is deleted."""

    databaseWanted = pyqtSignal()
    said = pyqtSignal(str)

    def __init__(self, canvas: QgsMapCanvas, parent: Optional[QWidget] = None) -> None:
        super().__init__(parent)
        self._canvas = canvas
        self._database: Optional[ReferenceDatabase] = None
        self._crs: Optional[QgsCoordinateReferenceSystem] = None
        self._window: Optional[DescribedWindow] = None
        self._image_vector: Optional[np.ndarray] = None
        self._image_name = ""
        self._wanted_name = ""
        self._wanted_point: Optional[QgsPointXY] = None
        self.tool = WindowTool(canvas)
        self._marks = WindowMarks(canvas)
        self._lay_out()
        self._connect()
        self._show_nothing()

    def _lay_out(self) -> None:
        self.pick = tool_button(
            "/mActionIdentify.svg", tr("Click on the map to inspect the window there"), checkable=True
        )
        self.pick.setText(tr("Pick on map"))
        self.pick.setAccessibleName("")
        self.pick.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.name = QLineEdit()
        self.name.setPlaceholderText(tr("Window name"))
        self.name.setClearButtonEnabled(True)
        self.before = tool_button("/mActionArrowLeft.svg", tr("Window before"))
        self.after = tool_button("/mActionArrowRight.svg", tr("Next window"))
        self.title = QLabel()
        self.title.setWordWrap(True)
        self.title.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.plot = VectorPlot()
        self.numbers = QTableWidget(0, 4)
        self.numbers.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.numbers.verticalHeader().hide()
        self.numbers.setHorizontalHeaderLabels([tr("Class"), tr("Distance"), tr("Angle"), tr("Image")])
        self.numbers.horizontalHeaderItem(1).setToolTip(tr("Distance from the center over the largest distance"))
        self.numbers.horizontalHeaderItem(2).setToolTip(tr("Angle to the next landmark over the largest angle"))
        self.numbers.horizontalHeaderItem(3).setToolTip(tr("How far the compared image’s vector differs here"))
        self.look_alikes = QTableWidget(0, 2)
        self.look_alikes.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.look_alikes.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.look_alikes.verticalHeader().hide()
        self.look_alikes.setHorizontalHeaderLabels([tr("Looks like"), tr("Distance")])
        for table in (self.numbers, self.look_alikes):
            table.horizontalHeader().setStretchLastSection(True)
            table.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 8)
        self.look_alikes.setToolTip(tr("Windows elsewhere with the nearest vectors; double-click to inspect one"))
        self.compare = QPushButton(tr("Compare with the selected image"))
        self.compare.setCheckable(True)
        self.compare.setToolTip(tr("Draws the vector of the image selected in the results over the window’s"))
        layout = narrow(QVBoxLayout(self), 0)
        layout.addLayout(row_of(self.pick, (self.name, 1), self.before, self.after))
        layout.addWidget(self.title)
        layout.addWidget(self.plot, 3)
        layout.addWidget(self.compare)
        layout.addWidget(self.numbers, 2)
        layout.addWidget(self.look_alikes, 2)

    def _connect(self) -> None:
        self.pick.toggled.connect(self._pick)
        self.tool.picked.connect(self._show_at)
        self.tool.deactivated.connect(self._unpick)
        self.name.returnPressed.connect(self._show_named)
        self.before.clicked.connect(lambda: self._step(-1))
        self.after.clicked.connect(lambda: self._step(1))
        self.compare.toggled.connect(self._refresh)
        self.look_alikes.cellDoubleClicked.connect(self._show_look_alike)

    def shut_down(self) -> None:
        """Gives the map tool back and takes everything off the canvas."""
        self.tool.picked.disconnect(self._show_at)
        self.tool.deactivated.disconnect(self._unpick)
        self._canvas.unsetMapTool(self.tool)
        self._marks.remove()

    # --- what is inspected ---

    def use(self, database: Optional[ReferenceDatabase]) -> None:
        """Takes another database; the wish that made it be read is fulfilled."""
        self._database = database
        self._show_nothing()
        if database is None:
            return
        self._crs = QgsCoordinateReferenceSystem.fromWkt(database.parameters.crs)
        name, point = self._wanted_name, self._wanted_point
        self._wanted_name, self._wanted_point = "", None
        if name:
            self.show_window(name)
        elif point is not None:
            self._show_at(point)

    def show_window(self, name: str) -> None:
        """Inspects the window of this name, once the database is read."""
        if self._database is None:
            self._wanted_name = name
            self.databaseWanted.emit()
            return
        found = np.flatnonzero(self._database.windows.names == name)
        if not len(found):
            self.said.emit(tr("The database has no window “{name}”.").format(name=name))
            return
        self._show(int(found[0]))

    def compare_with(self, name: str, vector: Optional[np.ndarray]) -> None:
        """The image that “compare” means; None when there is none, or it has no vector."""
        self._image_name, self._image_vector = name, vector
        self.compare.setEnabled(vector is not None)
        self._refresh()

    def _show(self, index: int) -> None:
        self._window = describe_window(self._database, index)
        self._marks.show(self._database, self._crs, self._window)
        self._marks.zoom()
        self._refresh()

    def _show_at(self, point: QgsPointXY) -> None:
        if self._database is None:
            self._wanted_point = point
            self.databaseWanted.emit()
            return
        try:
            project = QgsProject.instance()
            crs = self._canvas.mapSettings().destinationCrs()
            place = QgsCoordinateTransform(crs, self._crs, project).transform(point)
        except QgsCsException:
            return
        index = window_at(self._database.windows, place.x(), place.y())
        if index < 0:
            self.said.emit(tr("No window of the database lies there."))
            return
        self._show(index)

    def _show_named(self) -> None:
        if self.name.text().strip():
            self.show_window(self.name.text().strip())

    def _show_look_alike(self, row: int, _column: int) -> None:
        self._show(int(self._window.look_alikes[row]))

    def _step(self, step: int) -> None:
        if self._database is None:
            self.databaseWanted.emit()
            return
        start = -min(step, 0) if self._window is None else self._window.index
        self._show((start + step) % len(self._database.windows))

    def _pick(self, on: bool) -> None:
        if on:
            self._canvas.setMapTool(self.tool)
        else:
            self._canvas.unsetMapTool(self.tool)

    def _unpick(self) -> None:
        self.pick.setChecked(False)

    # --- showing it ---

    def _show_nothing(self) -> None:
        self._window = None
        self._marks.clear()
        self._refresh()

    def _refresh(self) -> None:
        self.numbers.setRowCount(0)
        self.look_alikes.setRowCount(0)
        if self._window is None:
            self.title.setText(tr("Pick a window on the map, or give its name."))
            self.plot.clear("")
            return
        windows, index = self._database.windows, self._window.index
        self.name.setText(str(windows.names[index]))
        if not windows.described[index]:
            self.title.setText(_title(windows, self._window))
            self.plot.clear(tr("Fewer than three landmarks: no vector."))
            return
        classes = self._database.class_table.references
        compared = self._image_vector if self.compare.isChecked() else None
        if compared is not None and len(compared) != windows.vectors.shape[1]:
            compared = None
        self.title.setText(_title(windows, self._window, compared, self._image_name))
        self.plot.show_vectors(windows.vectors[index], [c.color for c in classes], compared)
        self._fill_numbers(windows.vectors[index], [c.name for c in classes], compared)
        self._fill_look_alikes(windows)

    def _fill_numbers(self, vector: np.ndarray, names: list, compared: Optional[np.ndarray]) -> None:
        ratios, angles, ranks = vector_rows(vector)
        self.numbers.setRowCount(len(ratios))
        apart = None if compared is None else np.abs(np.reshape(compared, (3, -1)) - np.reshape(vector, (3, -1)))
        for row, (ratio, angle, rank) in enumerate(zip(ratios, angles, ranks)):
            texts = [names[int(round(rank * len(names))) - 1], f"{ratio:.3f}", f"{angle:.3f}"]
            texts.append("" if apart is None else f"{apart[:, row].max():.3f}")
            for column, text in enumerate(texts):
                item = QTableWidgetItem(text)
                if apart is not None and apart[:, row].max() > _DIFFERS:
                    font = item.font()
                    font.setBold(True)
                    item.setFont(font)
                self.numbers.setItem(row, column, item)
        self.numbers.setColumnHidden(3, apart is None)
        self.numbers.resizeColumnsToContents()

    def _fill_look_alikes(self, windows) -> None:
        self.look_alikes.setRowCount(len(self._window.look_alikes))
        for row, (other, distance) in enumerate(zip(self._window.look_alikes, self._window.distances)):
            self.look_alikes.setItem(row, 0, QTableWidgetItem(str(windows.names[other])))
            self.look_alikes.setItem(row, 1, QTableWidgetItem(f"{distance:.3f}"))
        self.look_alikes.resizeColumnsToContents()


def _title(windows, window: DescribedWindow, compared=None, image: str = "") -> str:
    """Rich text: what the window is, and how far an image's vector is from its."""
    x, y = windows.centers[window.index].tolist()
    lines = [
        "<b>"
        + escape(str(windows.names[window.index]))
        + "</b>: "
        + tr("{count} landmarks, center {x:.0f} {y:.0f}").format(count=int(windows.counts[window.index]), x=x, y=y)
    ]
    if len(window.distances):
        lines.append(tr("Nearest look-alike at distance {value:.3f}").format(value=float(window.distances[0])))
    if compared is not None:
        distance = float(vector_distances(compared, windows.vectors[window.index][None])[0])
        text = tr("{image}: distance {distance:.3f}, confidence {confidence:.2f}")
        lines.append(escape(text.format(image=image, distance=distance, confidence=vector_confidence(distance))))
    return "<br>".join(lines)
