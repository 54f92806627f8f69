"""List of images to localize: files, folders and layers, which can also be dropped on it."""

from __future__ import annotations

import os
from collections.abc import Iterable

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QDragEnterEvent, QDragMoveEvent, QDropEvent, QKeyEvent, QKeySequence, QPaintEvent
from qgis.PyQt.QtWidgets import QAbstractItemView, QListWidget, QListWidgetItem

from ....processing.translation import tr
from ...layer_files import dropped_files
from ...widgets.controls import paint_placeholder, plain_tip

_PATH_ROLE = Qt.ItemDataRole.UserRole
_VISIBLE_ROWS = 3


class ImageList(QListWidget):
    """Emits ``changed`` when entries change, and ``refused`` with names of dropped layers that are not files."""

    changed = pyqtSignal()
    refused = pyqtSignal(list)

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(tr("Images"))
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setUniformItemSizes(True)
        self.setIconSize(QSize(self.fontMetrics().height(), self.fontMetrics().height()))
        self.setAcceptDrops(True)

    def paths(self) -> list[str]:
        """Return the paths of all entries, from top to bottom."""
        return [self.item(row).data(_PATH_ROLE) for row in range(self.count())]

    def add(self, paths: Iterable[str]) -> None:
        """Add files and folders that are not in the list yet."""
        known = set(self.paths())
        for path in paths:
            if path and path not in known:
                known.add(path)
                self.addItem(_item(path))
        self.changed.emit()

    def show_only(self, paths: Iterable[str]) -> None:
        """Replace all entries, and select the first one."""
        self.clear()
        self.add(paths)
        self.setCurrentRow(0)

    def remove_selected(self) -> None:
        """Remove the selected entries, not their files."""
        for item in self.selectedItems():
            self.takeItem(self.row(item))
        self.changed.emit()

    # --- QListWidget ---

    def sizeHint(self) -> QSize:
        return QSize(200, _VISIBLE_ROWS * (self.fontMetrics().height() + 6))

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint().boundedTo(QSize(120, 1000))

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self.count():
            paint_placeholder(self, tr("Add photos or label images, or drop files, folders and layers here."))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Delete):
            self.remove_selected()
        else:
            super().keyPressEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        self.dragMoveEvent(event)

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        if any(dropped_files(event.mimeData())):
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
        else:
            event.ignore()

    def dropEvent(self, event: QDropEvent) -> None:
        files, others = dropped_files(event.mimeData())
        self.add(files)
        if others:
            self.refused.emit(others)
        event.setDropAction(Qt.DropAction.CopyAction)
        event.accept()


def _item(path: str) -> QListWidgetItem:
    icon = "/mIconFolder.svg" if os.path.isdir(path) else "/mIconRaster.svg"
    item = QListWidgetItem(QgsApplication.getThemeIcon(icon), os.path.basename(path.rstrip("/\\")) or path)
    item.setData(_PATH_ROLE, path)
    item.setToolTip(plain_tip(path))
    return item
