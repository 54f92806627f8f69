"""Tab *Inspect*: one window of the database, its topology vector, and similar windows elsewhere."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from html import escape
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsPointXY, QgsProject
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ....core.database.model import ReferenceDatabase
from ....processing.inspection.window import (
    Comparison,
    InspectedWindow,
    compare,
    find_window,
    inspect_window,
    window_at_point,
)
from ....processing.layers.reference_systems import transformed_point
from ....processing.messages.numbers import LocalTemplate
from ....processing.translation import tr
from ...canvas.map_tools import WindowTool
from ...canvas.marks import WindowMarks
from ...running.background import Reader, latest_database
from ...widgets.controls import number_text, tool_button
from ...widgets.database_box import DatabaseBox
from ...widgets.layouts import narrow, row_of
from ...widgets.messages import Messages
from .vector_plot import VectorPlot

if TYPE_CHECKING:
    import numpy as np

_APART = 3
"""Column of the difference from the compared image."""

_DIFFERS = 0.1
"""Larger differences are bold. Such a difference in all 30 elements gives a distance of about 0.5."""


class InspectTab(QWidget):
    """Reads the chosen database for the first window."""

    def __init__(self, canvas: QgsMapCanvas, database: DatabaseBox, messages: Messages) -> None:
        super().__init__()
        self._canvas, self._chosen, self._messages = canvas, database, messages
        self._reader = Reader(self)
        self._database: ReferenceDatabase | None = None
        self._crs: QgsCoordinateReferenceSystem | None = None
        self._window: InspectedWindow | None = None
        self._image_vector: np.ndarray | None = None
        self._image_name = ""
        self._wanted: Callable[[], None] = self._show_nothing
        self._marks = WindowMarks(canvas, self)
        self._lay_out()
        self._connect()
        self._show_nothing()

    def _lay_out(self) -> None:
        self.pick = tool_button(
            "/mActionIdentify.svg", tr("Click on the map to inspect the window there"), checkable=True
        )
        self.pick.setText(tr("Pick on map"))
        self.pick.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.tool = WindowTool(self._canvas, self.pick)
        self.name = QLineEdit()
        self.name.setPlaceholderText(tr("Window name"))
        self.name.setAccessibleName(tr("Window name"))
        self.name.setClearButtonEnabled(True)
        self.before = tool_button("/mActionArrowLeft.svg", tr("Previous window"))
        self.after = tool_button("/mActionArrowRight.svg", tr("Next window"))
        self.title = QLabel()
        self.title.setWordWrap(True)
        self.title.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.plot = VectorPlot()
        distance = tr("Distance from the center, in m. In brackets: the distance divided by the largest one")
        angle = tr("Angle to the next landmark. In brackets: the angle divided by the largest one")
        difference = tr("Largest difference from the vector of the compared image")
        headings = (tr("Class"), ""), (tr("Distance"), distance), (tr("Angle"), angle), (tr("Image"), difference)
        self.numbers = _table(tr("Landmarks of the vector"), headings)
        self.numbers.setColumnHidden(_APART, True)
        similarity = tr("Distance between the topology vectors: 0 is a perfect match, above 2 is no match")
        self.look_alikes = _table(tr("Similar windows"), ((tr("Similar window"), ""), (tr("Distance"), similarity)))
        self.look_alikes.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.look_alikes.setToolTip(
            tr("Windows elsewhere with the most similar vectors. Double-click one to inspect it.")
        )
        self.compare = QPushButton(tr("Compare with the selected image"))
        self.compare.setCheckable(True)
        self.compare.setEnabled(False)
        self.compare.setToolTip(tr("Draw the vector of the selected image over the vector of the window"))
        layout = narrow(QVBoxLayout(self), 0)
        layout.addLayout(row_of(self.pick, (self.name, 1), self.before, self.after))
        layout.addWidget(self.title)
        layout.addWidget(self.plot, 3)
        layout.addWidget(self.compare)
        layout.addWidget(self.numbers, 2)
        layout.addWidget(self.look_alikes, 2)

    def _connect(self) -> None:
        self._chosen.changed.connect(self.forget_database)
        self._reader.answered.connect(self._use)
        self._reader.failed.connect(self._messages.error)
        self.tool.picked.connect(self._show_at)
        self.name.returnPressed.connect(self._show_named)
        self.before.clicked.connect(lambda: self._step(-1))
        self.after.clicked.connect(lambda: self._step(1))
        self.compare.toggled.connect(self._refresh)
        self.look_alikes.cellDoubleClicked.connect(self._show_look_alike)

    # --- choosing a window ---

    def forget_database(self) -> None:
        """Clear window and marks. The next step reads the chosen database."""
        self._reader.forget()
        self._database = None
        self.name.clear()
        self._show_nothing()

    def _must_wait(self, step: Callable[..., None], *arguments) -> bool:
        """Return whether there is no database yet. It is then read, and the step follows."""
        if self._database is not None:
            return False
        if self._chosen.path():
            self._wanted = partial(step, *arguments)
            self._reader.read(tr("Reading the database"), latest_database, self._chosen.path())
        else:
            self._messages.info(tr("Choose a database."))
        return True

    def _use(self, database: ReferenceDatabase) -> None:
        self._database = database
        self._crs = QgsCoordinateReferenceSystem.fromWkt(database.parameters.crs)
        self._wanted()

    def show_window(self, name: str) -> None:
        """Inspect the window with this name as soon as the database is read."""
        if self._must_wait(self.show_window, name):
            return
        index = find_window(self._database, name)
        if index is None:
            self._messages.info(tr("The database has no window “{name}”.").format(name=name))
            return
        self._show(index)

    def compare_with(self, name: str, vector: np.ndarray | None) -> None:
        """Set the image to compare with; ``vector`` is None without one."""
        self._image_name, self._image_vector = name, vector
        self.compare.setEnabled(vector is not None)
        self._refresh()

    def _show(self, index: int) -> None:
        self._window = inspect_window(self._database, index)
        self._marks.show(self._window, self._crs)
        self._marks.zoom()
        self._refresh()

    def _show_at(self, point: QgsPointXY) -> None:
        if self._must_wait(self._show_at, point):
            return
        crs = self._canvas.mapSettings().destinationCrs()
        place = transformed_point(QgsCoordinateTransform(crs, self._crs, QgsProject.instance()), point)
        if place is None:
            return
        index = window_at_point(self._database, place.x(), place.y())
        if index is None:
            self._messages.info(tr("The database has no window at this place."))
            return
        self._show(index)

    def _show_named(self) -> None:
        if self.name.text().strip():
            self.show_window(self.name.text().strip())

    def _show_look_alike(self, row: int, _column: int) -> None:
        self._show(self._window.look_alikes[row].index)

    def _step(self, step: int) -> None:
        if self._must_wait(self._step, step):
            return
        # Without a window, the next one is the first and the previous one is the last.
        start = -max(step, 0) if self._window is None else self._window.index
        self._show((start + step) % len(self._database.windows))

    # --- display ---

    def _show_nothing(self) -> None:
        self._window = None
        self._marks.clear()
        self._refresh()

    def _refresh(self) -> None:
        self.numbers.setRowCount(0)
        self.look_alikes.setRowCount(0)
        if self._window is None:
            self.title.setText(tr("Pick a window on the map, or enter its name."))
            self.plot.clear("")
            return
        window = self._window
        self.name.setText(window.name)
        compared = None
        if self.compare.isChecked() and self._image_vector is not None:
            compared = compare(window, self._image_vector, self._database.class_table)
        self.title.setText(_title(window, compared, self._image_name))
        if window.vector is None:
            self.plot.clear(tr("The window has fewer than three landmarks, so it has no vector."))
            return
        self.plot.show_rays(window.rays, () if compared is None else compared.rays)
        self._fill_numbers(window, compared)
        self._fill_look_alikes(window)

    def _fill_numbers(self, window: InspectedWindow, compared: Comparison | None) -> None:
        self.numbers.setRowCount(len(window.rays))
        for number, ray in enumerate(window.rays):
            apart = None if compared is None else compared.apart[number]
            distance = f"{number_text(window.distances[number])} m ({number_text(ray.length, 3)})"
            angle = f"{number_text(ray.angle_deg, 1)}° ({number_text(ray.step, 3)})"
            texts = [ray.class_name, distance, angle, "" if apart is None else number_text(apart, 3)]
            for column, text in enumerate(texts):
                item = QTableWidgetItem(text)
                # A whole row in bold would be wider than the dock.
                if column == _APART and apart is not None and apart > _DIFFERS:
                    font = item.font()
                    font.setBold(True)
                    item.setFont(font)
                self.numbers.setItem(number, column, item)
        self.numbers.setColumnHidden(_APART, compared is None)

    def _fill_look_alikes(self, window: InspectedWindow) -> None:
        self.look_alikes.setRowCount(len(window.look_alikes))
        for number, other in enumerate(window.look_alikes):
            self.look_alikes.setItem(number, 0, QTableWidgetItem(other.name))
            self.look_alikes.setItem(number, 1, QTableWidgetItem(number_text(other.distance, 3)))


def _table(name: str, headings: Sequence[tuple[str, str]]) -> QTableWidget:
    """Return an empty read-only table. ``headings``: title and tool tip of each column."""
    table = QTableWidget(0, len(headings))
    table.setAccessibleName(name)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    # Otherwise the Tab key would not leave the table.
    table.setTabKeyNavigation(False)
    # In right-to-left layouts “3360_960” would be painted as “960_3360”, another window.
    table.setLayoutDirection(Qt.LayoutDirection.LeftToRight)
    table.setHorizontalHeaderLabels([title for title, _ in headings])
    for column, (_, tip) in enumerate(headings):
        table.horizontalHeaderItem(column).setToolTip(tip)
    table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    table.horizontalHeader().setStretchLastSection(True)
    table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
    table.verticalHeader().hide()
    return table


def _title(window: InspectedWindow, compared: Comparison | None, image: str) -> str:
    """Return HTML with the data of the window and its distance from an image's vector."""
    x, y = window.center_xy
    counted = tr("center {x:.0f} {y:.0f}, landmarks: {count}").format(count=window.landmark_count, x=x, y=y)
    lines = [f"<b>{escape(window.name)}</b>: {counted}"]
    if window.look_alikes:
        nearest = window.look_alikes[0].distance
        lines.append(LocalTemplate(tr("Most similar window: distance {value:.3f}")).format(value=nearest))
    if compared is not None:
        text = tr("{image}: distance {distance:.3f}, confidence {confidence:.2f}")
        text = LocalTemplate(text).format(image=image, distance=compared.distance, confidence=compared.confidence)
        lines.append(escape(text))
    return "<br>".join(lines)
