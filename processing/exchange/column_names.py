"""Columns of SemRef's own layers shown in the user's language; their own names are public and stay."""

from __future__ import annotations

from qgis.core import QgsEditorWidgetSetup, QgsVectorLayer

from ..wording.columns import column_titles, column_words

_SENTENCES = "message", "reason"
"""Columns of texts that are longer than a line."""


def name_columns(layer: QgsVectorLayer, picture: str = "") -> None:
    """Aliases in the user's language, words for keys, and the picture that the column ``picture`` names."""
    names = [one.name() for one in layer.fields()]
    titles = column_titles()
    words = column_words(names)
    for index, name in enumerate(names):
        if name in titles:
            layer.setFieldAlias(index, titles[name])
        if name in words:
            entries = [{text: key} for key, text in words[name].items()]
            layer.setEditorWidgetSetup(index, QgsEditorWidgetSetup("ValueMap", {"map": entries}))
        elif name in _SENTENCES:
            layer.setEditorWidgetSetup(index, QgsEditorWidgetSetup("TextEdit", {"IsMultiline": True}))
        elif name == picture:
            shown = {"DocumentViewer": 1, "DocumentViewerHeight": 260, "FileWidget": True, "StorageMode": 0}
            layer.setEditorWidgetSetup(index, QgsEditorWidgetSetup("ExternalResource", shown))
