"""Map tools of the dock: pick a window, and draw the search area."""

from __future__ import annotations

from qgis.core import QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapMouseEvent, QgsMapTool
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeyEvent
from qgis.PyQt.QtWidgets import QAbstractButton


class ButtonTool(QgsMapTool):
    """Tool that a checkable button starts. The button, Escape and any other tool end it."""

    def __init__(self, canvas: QgsMapCanvas, button: QAbstractButton, cursor: Qt.CursorShape) -> None:
        super().__init__(canvas)
        self.setCursor(cursor)
        self.setParent(button)
        # QGIS checks and unchecks the button.
        self.setButton(button)
        button.clicked.connect(self._follow_button)

    def shut_down(self) -> None:
        """Return to the previous tool."""
        self.canvas().unsetMapTool(self)

    def _follow_button(self, checked: bool) -> None:
        if checked:
            self.canvas().setMapTool(self)
        else:
            self.shut_down()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.shut_down()
        else:
            super().keyPressEvent(event)


class WindowTool(ButtonTool):
    """Emits ``picked`` with the point in the canvas's CRS."""

    picked = pyqtSignal(QgsPointXY)

    def __init__(self, canvas: QgsMapCanvas, button: QAbstractButton) -> None:
        super().__init__(canvas, button, Qt.CursorShape.WhatsThisCursor)

    def canvasReleaseEvent(self, event: QgsMapMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.picked.emit(event.mapPoint())


class CircleTool(ButtonTool):
    """A press at the center and a drag to the edge draw a circle.

    dragged: center and edge so far, in the canvas's CRS; drawn: center and edge at the end.
    """

    dragged = pyqtSignal(QgsPointXY, QgsPointXY)
    drawn = pyqtSignal(QgsPointXY, QgsPointXY)

    def __init__(self, canvas: QgsMapCanvas, button: QAbstractButton) -> None:
        super().__init__(canvas, button, Qt.CursorShape.CrossCursor)
        self._middle: QgsPointXY | None = None

    def canvasPressEvent(self, event: QgsMapMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._middle = event.mapPoint()

    def canvasMoveEvent(self, event: QgsMapMouseEvent) -> None:
        if self._middle is not None:
            self.dragged.emit(self._middle, event.mapPoint())

    def canvasReleaseEvent(self, event: QgsMapMouseEvent) -> None:
        middle, self._middle = self._middle, None
        if middle is not None and middle.distance(event.mapPoint()) > 0:
            self.drawn.emit(middle, event.mapPoint())
