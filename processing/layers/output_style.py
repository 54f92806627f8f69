"""Vector outputs come with a look: in the file where it can hold one, and on the layer that QGIS loads."""

from __future__ import annotations

import contextlib
import sqlite3
from dataclasses import dataclass, field, replace
from pathlib import Path

from qgis.core import (
    QgsFeatureRenderer,
    QgsProcessingContext,
    QgsProcessingLayerPostProcessorInterface,
    QgsVectorLayer,
)
from qgis.PyQt.QtXml import QDomDocument

from ...storage.vector_files import STYLE_OF_SEMREF, leave_wal
from .database_layers import place_new_layer, set_post_processor
from .layer_metadata import Note, keep_in_file
from .styles import apply_style, name_columns


@dataclass(frozen=True)
class Look:
    """What a layer comes with.

    Attributes:
        style: Name of its file in ``resources/styles``; empty for none.
        renderer: In place of the file's, where it depends on classes or a threshold.
        is_timed: Whether features have times, by which QGIS's temporal controller can play the layer.
        is_own: Whether the columns are SemRef's; those of the user's own layers keep their names.
        note: What the layer tells about itself.
    """

    style: str = ""
    renderer: QgsFeatureRenderer | None = None
    is_timed: bool = False
    is_own: bool = True
    note: Note | None = field(default=None, compare=False)

    def give(self, layer: QgsVectorLayer) -> None:
        """Has a layer look so; columns get their titles, and keys in them their words."""
        if self.is_own:
            name_columns(layer, with_editors=True)
        if self.style:
            apply_style(layer, self.style, self.is_timed)
        if self.renderer is not None:
            layer.setRenderer(self.renderer.clone())
        if self.note is not None:
            layer.setMetadata(self.note.metadata(layer))


def style_in_file(destination: str, look: Look) -> bool:
    """Gives a layer in a GeoPackage its look, as its default; other files can't hold one.

    Returns:
        Whether all is there that should be: on a full disk QGIS leaves a style out without a word.
    """
    path = destination.split("|")[0]
    if Path(path).suffix.lower() != ".gpkg" or not Path(path).is_file():
        return True
    layer = QgsVectorLayer(destination, "output", "ogr")
    noted = True
    try:
        if layer.isValid():
            look.give(layer)
            _remove_style(path, destination.partition("layername=")[2].partition("|")[0])
            layer.saveStyleToDatabase("SemRef", STYLE_OF_SEMREF, True, "")
            noted = look.note is None or keep_in_file(destination, layer, look.note)
        del layer
        leave_wal(path)
        return noted and _has_style(path)
    except sqlite3.Error:
        return False


def _remove_style(path: str, table: str) -> None:
    """Remove the style of an older layer of that name: QGIS asks in a window before it replaces one, and waits."""
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        if connection.execute("SELECT 1 FROM sqlite_master WHERE name = 'layer_styles'").fetchone():
            query = "DELETE FROM layer_styles WHERE f_table_name = ? AND styleName = 'SemRef'"
            connection.execute(query, (table,))


def style_in_memory(destination: str, look: Look, context: QgsProcessingContext) -> None:
    """Gives a layer that is no file its look; one that lies elsewhere is left as it is."""
    layer = context.getMapLayer(destination)
    if isinstance(layer, QgsVectorLayer) and layer.providerType() == "memory":
        look.give(layer)


def _has_style(path: str) -> bool:
    """Whether the style that was written last is whole."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        row = connection.execute("SELECT styleQML FROM layer_styles ORDER BY id DESC LIMIT 1").fetchone()
    return row is not None and str(row[0]).rstrip().endswith("</qgis>")


def style_when_loaded(destination: str, look: Look, context: QgsProcessingContext) -> None:
    """Gives the layer that QGIS will load its look."""
    if context.willLoadLayerOnCompletion(destination):
        set_post_processor(context.layerToLoadOnCompletionDetails(destination), _Styler(look))


def raster_style_when_loaded(path: str, qml: str, context: QgsProcessingContext) -> None:
    """Gives the raster that QGIS will load its look, whatever style is beside it."""
    if context.willLoadLayerOnCompletion(path):
        set_post_processor(context.layerToLoadOnCompletionDetails(path), _RasterStyler(qml))


class _RasterStyler(QgsProcessingLayerPostProcessorInterface):
    def __init__(self, qml: str) -> None:
        super().__init__()
        self._qml = qml

    def postProcessLayer(self, layer, context, feedback):
        document = QDomDocument()
        document.setContent(self._qml)
        layer.importNamedStyle(document)
        place_new_layer(layer, context.project())
        layer.triggerRepaint()


class _Styler(QgsProcessingLayerPostProcessorInterface):
    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = replace(look, renderer=look.renderer and look.renderer.clone())

    def postProcessLayer(self, layer, context, feedback):
        if isinstance(layer, QgsVectorLayer):
            self._look.give(layer)
            place_new_layer(layer, context.project())
            layer.triggerRepaint()
