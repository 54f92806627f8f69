"""Rows and margins that are the same all over the dock."""

from __future__ import annotations

from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtWidgets import QBoxLayout, QHBoxLayout, QToolButton, QWidget

from ...processing.translation import tr

MARGIN_PX = 5
"""Around the content of the dock and of its boxes: width is scarce in a dock."""


def row_of(*widgets: QWidget | tuple[QWidget, int]) -> QHBoxLayout:
    """Widgets side by side.

    Args:
        *widgets: From left to right; (widget, stretch) for one that takes what room is left.
    """
    made = QHBoxLayout()
    for entry in widgets:
        widget, stretch = entry if isinstance(entry, tuple) else (entry, 0)
        made.addWidget(widget, stretch)
    return made


def narrow(layout: QBoxLayout, margin: int = MARGIN_PX) -> QBoxLayout:
    """The layout with margins as narrow as a dock needs them."""
    layout.setContentsMargins(margin, margin, margin, margin)
    return layout


def name_fold(box: QgsCollapsibleGroupBox) -> None:
    """Gives the triangle that folds a box a name for screen readers, which QGIS does not."""
    for button in box.findChildren(QToolButton, "collapseButton"):
        button.setAccessibleName(tr("Fold or unfold: {title}").format(title=box.title()))
