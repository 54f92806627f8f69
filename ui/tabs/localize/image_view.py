"""View of the selected image with its labels and landmarks."""

from __future__ import annotations

from collections.abc import Sequence

from qgis.core import QgsSettings
from qgis.PyQt.QtCore import QPointF, QRectF, QSize, Qt
from qgis.PyQt.QtGui import (
    QColor,
    QFont,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
    QTransform,
    QWheelEvent,
)
from qgis.PyQt.QtWidgets import (
    QCheckBox,
    QGraphicsItem,
    QGraphicsScene,
    QGraphicsView,
    QLabel,
    QSlider,
    QStyleOptionGraphicsItem,
    QVBoxLayout,
    QWidget,
)

from ....processing.translation import tr
from ...canvas.marks import RIM
from ...canvas.match_marks import paint_numbers, paint_ring
from ...widgets.controls import paint_placeholder, remember
from ...widgets.layouts import narrow, row_of
from .picture import ImagePicture

_LANDMARKS_SETTING = "semref/dock/show_landmarks"
_OPACITY_SETTING = "semref/dock/label_opacity"

_ZOOM_STEP = 1.25
_MOST_ZOOM = 40.0

_LANDMARK_PX = 7
_RING_PX = 4.0


class ImageView(QWidget):
    """Image view: wheel zooms, drag moves, double click shows the whole image."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("SemRefImageView")
        self.canvas = _Canvas()
        self.opacity = QSlider(Qt.Orientation.Horizontal)
        self.opacity.setRange(0, 100)
        self.opacity.setToolTip(tr("Opacity of the labels"))
        self.opacity.setMinimumWidth(40)
        self.landmarks = QCheckBox(tr("Landmarks"))
        self.opacity.setValue(QgsSettings().value(_OPACITY_SETTING, 60, type=int))
        remember(self.landmarks, _LANDMARKS_SETTING, True)
        label = QLabel(tr("Labels"))
        label.setBuddy(self.opacity)
        layout = narrow(QVBoxLayout(self), 0)
        layout.addWidget(self.canvas, 1)
        layout.addLayout(row_of(label, (self.opacity, 1), self.landmarks))
        self.opacity.valueChanged.connect(self._apply)
        self.landmarks.toggled.connect(self._apply)
        self.clear("")

    def show_picture(self, picture: ImagePicture, matched: Sequence[tuple[float, float]]) -> None:
        """Show a picture. ``matched``: (column, row) of the matched landmarks."""
        self.canvas.show_picture(picture, matched)
        self._apply()

    def clear(self, text: str) -> None:
        self.canvas.clear(text)

    def _apply(self) -> None:
        QgsSettings().setValue(_OPACITY_SETTING, self.opacity.value())
        self.canvas.apply(self.opacity.value() / 100, self.landmarks.isChecked())


class _Canvas(QGraphicsView):
    """Graphics view; its scene has the pixels of the image."""

    def __init__(self) -> None:
        super().__init__()
        self.setScene(QGraphicsScene(self))
        self.setRenderHint(QPainter.RenderHint.Antialiasing)
        self.setDragMode(QGraphicsView.DragMode.ScrollHandDrag)
        self.setTransformationAnchor(QGraphicsView.ViewportAnchor.AnchorUnderMouse)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setAccessibleName(tr("Selected image. Press + or - to zoom, and 0 to show the whole image."))
        self._text = ""
        self._labels: QGraphicsItem | None = None
        self._landmarks: _LandmarkDots | None = None

    def show_picture(self, picture: ImagePicture, matched: Sequence[tuple[float, float]]) -> None:
        scene = self.scene()
        scene.clear()
        self._text = ""
        if picture.photo is not None:
            self._add(picture.photo, picture)
        self._labels = self._add(picture.labels, picture)
        self._landmarks = _LandmarkDots(picture, matched, self.font())
        scene.addItem(self._landmarks)
        scene.setSceneRect(QRectF(0, 0, *picture.size_wh))
        self.fit()

    def _add(self, image: QImage, picture: ImagePicture) -> QGraphicsItem:
        item = self.scene().addPixmap(QPixmap.fromImage(image))
        width, height = picture.size_wh
        scale = width / max(image.width(), 1), height / max(image.height(), 1)
        item.setTransform(QTransform.fromScale(*scale))
        return item

    def clear(self, text: str) -> None:
        self.scene().clear()
        self._labels = self._landmarks = None
        self._text = text
        self.viewport().update()

    def apply(self, opacity: float, landmarks: bool) -> None:
        if self._labels is not None:
            self._labels.setOpacity(opacity)
            self._landmarks.setVisible(landmarks)

    def fit(self) -> None:
        self.fitInView(self.sceneRect(), Qt.AspectRatioMode.KeepAspectRatio)

    # --- QGraphicsView ---

    def sizeHint(self) -> QSize:
        return QSize(220, 220)

    def minimumSizeHint(self) -> QSize:
        return QSize(120, 140)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self._labels is not None:
            self.fit()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self.fit()

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._zoom(_ZOOM_STEP if event.angleDelta().y() > 0 else 1 / _ZOOM_STEP)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        factors = {"+": _ZOOM_STEP, "-": 1 / _ZOOM_STEP}
        if event.text() in factors:
            self._zoom(factors[event.text()])
        elif event.text() == "0":
            self.fit()
        else:
            super().keyPressEvent(event)

    def _zoom(self, factor: float) -> None:
        if self._labels is None:
            return
        fitted = min(self.width() / self.sceneRect().width(), self.height() / self.sceneRect().height())
        if fitted / 2 < self.transform().m11() * factor < _MOST_ZOOM:
            self.scale(factor, factor)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._text:
            paint_placeholder(self, self._text)


class _LandmarkDots(QGraphicsItem):
    """Dots of constant size in the colors of the classes; hollow for landmarks that the image's edge cuts.

    Matched landmarks have a ring and a number.
    """

    def __init__(self, picture: ImagePicture, matched: Sequence[tuple[float, float]], font: QFont) -> None:
        super().__init__()
        landmarks = picture.seen.landmarks
        self._rect = QRectF(0, 0, *picture.size_wh)
        self._dots = [
            (QPointF(*center), QColor(picture.colors[int(value)]), bool(cut))
            for center, value, cut in zip(landmarks.centers_xy.tolist(), landmarks.classes, landmarks.touches_edge)
        ]
        self.matched = [(number, QPointF(*pixel)) for number, pixel in enumerate(matched, start=1)]
        self._font = font

    def boundingRect(self) -> QRectF:
        return self._rect

    def paint(self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: QWidget | None = None) -> None:
        transform = painter.worldTransform()
        painter.resetTransform()
        for center, color, cut in self._dots:
            painter.setPen(QPen(RIM if not cut else color, 1.5))
            painter.setBrush(Qt.BrushStyle.NoBrush if cut else color)
            painter.drawEllipse(transform.map(center), _LANDMARK_PX / 2, _LANDMARK_PX / 2)
        places = [(number, transform.map(center)) for number, center in self.matched]
        for _, place in places:
            paint_ring(painter, place, _RING_PX)
        paint_numbers(painter, self._font, places)
        painter.setWorldTransform(transform)
