"""Dialog with the models of a folder, with the card of the selected model."""

from __future__ import annotations

from html import escape

from qgis.gui import QgsFileWidget, QgsGui
from qgis.PyQt.QtCore import QSize, Qt, pyqtSignal
from qgis.PyQt.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QLabel,
    QPushButton,
    QSplitter,
    QTextBrowser,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ..processing.inspection.models import choose_models_folder, listed_models, models_folder
from ..processing.reports.model_card import card_html, card_title, quality_text, resolution_text
from ..processing.translation import tr
from ..processing.version import guide_url
from .add_model import AddModelDialog
from .widgets.controls import plain_tip
from .widgets.layouts import row_of

_SMALLEST_PX = 760, 460
_LIST_SHARE, _CARD_SHARE = 5, 4
_CARD = Qt.ItemDataRole.UserRole
_NAME, _CLASSES, _QUALITY = 0, 1, 3


class ModelsDialog(QDialog):
    """Folder, its models, and the card of the selected model. chosen: path of the model to use."""

    chosen = pyqtSignal(str)

    def __init__(self, current: str = "", parent: QWidget | None = None) -> None:
        """``current``: path of the model in use."""
        super().__init__(parent)
        self.setObjectName("SemRefModels")
        self.setWindowTitle(tr("Models for photos"))
        self.folder = QgsFileWidget()
        self.folder.setStorageMode(QgsFileWidget.StorageMode.GetDirectory)
        self.folder.setDialogTitle(tr("Choose the folder of your models"))
        self.folder.setFilePath(str(models_folder()))
        self.list = QTreeWidget()
        self.card = QTextBrowser()
        self.add = QPushButton(tr("Add a model…"))
        self.add.setToolTip(tr("Add a network of others: an ONNX file, or a checkpoint of PyTorch"))
        self.adding: AddModelDialog | None = None
        self.where = QLabel(_where_to_get_more())
        self.buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        self.use = self.buttons.addButton(tr("Use this model"), QDialogButtonBox.ButtonRole.AcceptRole)
        self._lay_out()
        self.add.clicked.connect(self._add_model)
        self.folder.fileChanged.connect(self._change_folder)
        self.list.currentItemChanged.connect(self._show_card)
        self.list.itemActivated.connect(self._take)
        self.buttons.accepted.connect(self._take)
        self.buttons.rejected.connect(self.reject)
        self.refresh()
        self.select(current)
        self.resize(self.sizeHint().expandedTo(QSize(*_SMALLEST_PX)))
        QgsGui.enableAutoGeometryRestore(self)

    def path(self) -> str:
        """Return the path of the selected model; empty without a usable selected model."""
        item = self.list.currentItem()
        card = None if item is None else item.data(0, _CARD)
        return "" if card is None or card.fault is not None else card.file

    def select(self, path: str) -> None:
        for row in range(self.list.topLevelItemCount()):
            item = self.list.topLevelItem(row)
            if item.data(0, _CARD).file == path:
                self.list.setCurrentItem(item)

    def refresh(self) -> None:
        """Read the folder again."""
        self.list.clear()
        for card in listed_models(models_folder()):
            item = QTreeWidgetItem(
                [card_title(card), ", ".join(card.classes), resolution_text(card), quality_text(card)]
            )
            item.setData(0, _CARD, card)
            item.setToolTip(0, plain_tip(card.file))
            item.setToolTip(_CLASSES, plain_tip(", ".join(card.classes)))
            item.setTextAlignment(_QUALITY, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            self.list.addTopLevelItem(item)
        self.list.setCurrentItem(self.list.topLevelItem(0))

    def _lay_out(self) -> None:
        self.list.setHeaderLabels([tr("Model"), tr("Classes"), tr("Pixel size"), tr("IoU")])
        self.list.headerItem().setToolTip(
            _QUALITY, tr("Mean over classes, measured on areas that were not used for training")
        )
        self.list.setRootIsDecorated(False)
        self.list.setUniformRowHeights(True)
        header = self.list.header()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        for column in (_NAME, _CLASSES):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Stretch)
        self.card.setOpenExternalLinks(True)
        self.where.setWordWrap(True)
        self.where.setOpenExternalLinks(True)
        both = QSplitter()
        both.setChildrenCollapsible(False)
        both.addWidget(self.list)
        both.addWidget(self.card)
        both.setStretchFactor(0, _LIST_SHARE)
        both.setStretchFactor(1, _CARD_SHARE)
        layout = QVBoxLayout(self)
        layout.addLayout(row_of(QLabel(tr("Folder")), (self.folder, 1), self.add))
        layout.addWidget(both, 1)
        layout.addWidget(self.where)
        layout.addWidget(self.buttons)

    def _add_model(self) -> None:
        self.adding = AddModelDialog(self)
        self.adding.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.adding.added.connect(self._select_new)
        self.adding.open()

    def _select_new(self, path: str) -> None:
        self.refresh()
        self.select(path)

    def _change_folder(self, path: str) -> None:
        choose_models_folder(path.strip())
        self.refresh()

    def _show_card(self, item: QTreeWidgetItem | None) -> None:
        self.card.setHtml("" if item is None else card_html(item.data(0, _CARD)))
        self.use.setEnabled(bool(self.path()))

    def _take(self, *_item: object) -> None:
        if self.path():
            self.chosen.emit(self.path())
            self.accept()


def _where_to_get_more() -> str:
    text = tr(
        "To get more models, train one on your own area (button next to the model in the dock) or on "
        "published photos. You can also add networks of others, such as those of the Deepness plugin. {how}"
    )
    link = f'<a href="{guide_url("reference/networks.md")}">{escape(tr("Instructions and licenses"))}</a>'
    return escape(text).replace("{how}", link)
