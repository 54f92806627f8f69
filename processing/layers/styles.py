"""Styles of SemRef's layers: the files of ``resources/styles`` in the user's language.

Translated parts of a file are aliases, labels of categories and rules, titles of form pages, and ``_('…')`` in the
expressions of display names and map tips.
"""

from __future__ import annotations

import re
from html import escape
from pathlib import Path
from typing import Callable

from qgis.core import QgsEditorWidgetSetup, QgsFeatureRenderer, QgsMapLayer, QgsReadWriteContext, QgsVectorLayer
from qgis.PyQt.QtXml import QDomDocument, QDomElement

from ..messages.columns import column_words
from ..translation import tr

STYLES = Path(__file__).resolve().parents[2] / "resources" / "styles"

_TITLES = {"alias": "name", "attributeEditorContainer": "name", "category": "label", "rule": "label"}
"""Translated attributes by element."""

_TEXT = re.compile(r"_\('([^']+)'\)")

_CATEGORY = QgsMapLayer.StyleCategory
_FIELDS = _CATEGORY.Fields
_FORMS = _CATEGORY.Forms
_LOOK = _CATEGORY.LayerConfiguration | _CATEGORY.Symbology | _CATEGORY.Labeling | _CATEGORY.MapTips
_TEMPORAL = _CATEGORY.Temporal


def style_document(name: str) -> QDomDocument:
    """Return the translated style file ``name``."""
    document = QDomDocument()
    document.setContent((STYLES / f"{name}.qml").read_text(encoding="utf-8"))
    for tag, attribute in _TITLES.items():
        nodes = document.elementsByTagName(tag)
        for element in (nodes.at(n).toElement() for n in range(nodes.count())):
            element.setAttribute(attribute, tr(element.attribute(attribute)))
    root = document.documentElement()
    _translate_expressions(root.firstChildElement("previewExpression"), str)
    _translate_expressions(root.firstChildElement("mapTip"), escape)
    return document


def _translate_expressions(element: QDomElement, escaped: Callable[[str], str]) -> None:
    """Replace each ``_('…')`` by its quoted translation, which is also valid inside [% %]."""

    def quoted(found: re.Match) -> str:
        text = escaped(tr(found[1]))
        return "'" + text.replace("'", "''").replace("%]", "% ]") + "'"

    text = element.firstChild()
    text.setNodeValue(_TEXT.sub(quoted, text.nodeValue()))


def apply_style(layer: QgsVectorLayer, name: str, is_timed: bool = False) -> None:
    """Apply the style file ``name`` to a layer, with its settings for the temporal controller if ``is_timed``."""
    layer.importNamedStyle(style_document(name), _LOOK | _FORMS | _TEMPORAL if is_timed else _LOOK | _FORMS)


def style_renderer(name: str) -> QgsFeatureRenderer:
    element = style_document(name).documentElement().firstChildElement("renderer-v2")
    return QgsFeatureRenderer.load(element, QgsReadWriteContext())


def name_columns(layer: QgsVectorLayer, with_editors: bool = False) -> None:
    """Set the titles of columns and the texts of keys in them; ``with_editors``: also editors of texts and pictures.

    The columns' names are public and do not change.
    """
    layer.importNamedStyle(style_document("columns"), _FIELDS | _FORMS if with_editors else _FIELDS)
    for name, words in column_words(layer.fields().names()).items():
        entries = [{text: key} for key, text in words.items()]
        index = layer.fields().lookupField(name)
        layer.setEditorWidgetSetup(index, QgsEditorWidgetSetup("ValueMap", {"map": entries}))
