"""Vector outputs come with a look: in the file where it can hold one, and on the layer that QGIS loads."""

from __future__ import annotations

import contextlib
import sqlite3
from dataclasses import dataclass, field, replace
from pathlib import Path

from qgis.core import (
    QgsAttributeEditorContainer,
    QgsAttributeEditorField,
    QgsEditFormConfig,
    QgsFeatureRenderer,
    QgsPalLayerSettings,
    QgsProcessingContext,
    QgsProcessingLayerPostProcessorInterface,
    QgsTextBufferSettings,
    QgsTextFormat,
    QgsVectorLayer,
    QgsVectorLayerSimpleLabeling,
    QgsVectorLayerTemporalProperties,
)
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtXml import QDomDocument

from ...storage.vector_files import STYLE_OF_SEMREF, leave_wal
from .column_names import name_columns
from .database_layers import place_new_layer
from .layer_metadata import Note, keep_in_file
from .palette import CASING, INK

_KEPT: list[QgsProcessingLayerPostProcessorInterface] = []
_MOST_KEPT = 20
"""QGIS takes no care of the Python half of a post-processor, so the last ones are kept."""

LABELS_FROM_SCALE = 250_000
"""Labels are drawn where a centimeter of the map is 2.5 km or less."""


@dataclass(frozen=True)
class Look:
    """What a layer comes with.

    Attributes:
        renderer: Its style; None for QGIS's own.
        time_field: The field of date and time by which QGIS's temporal controller plays it, what was seen staying;
            empty for none.
        name: Expression by which a feature is called, in lists and above its map tip; empty for QGIS's choice.
        label: Expression of the text beside features; empty for none.
        tip: HTML of the map tip, see ``map_tips.tip``; empty for QGIS's own.
        groups: (title, columns) of each page of the form; none for QGIS's own form.
        picture: Column that names a picture, which the form shows; empty for none.
        is_own: Whether the columns are SemRef's; those of the user's own layers keep their names.
        note: What the layer tells about itself.
    """

    renderer: QgsFeatureRenderer | None = None
    time_field: str = ""
    name: str = ""
    label: str = ""
    tip: str = ""
    groups: tuple[tuple[str, tuple[str, ...]], ...] = ()
    picture: str = ""
    is_own: bool = True
    note: Note | None = field(default=None, compare=False)

    def give(self, layer: QgsVectorLayer) -> None:
        """Has a layer look so; columns get their titles, and keys in them their words."""
        if self.renderer is not None:
            layer.setRenderer(self.renderer.clone())
        if self.time_field:
            played = layer.temporalProperties()
            played.setMode(QgsVectorLayerTemporalProperties.ModeFeatureDateTimeInstantFromField)
            played.setStartField(self.time_field)
            played.setAccumulateFeatures(True)
            played.setIsActive(True)
        if self.name:
            layer.setDisplayExpression(self.name)
        if self.label:
            layer.setLabeling(QgsVectorLayerSimpleLabeling(_labeling(self.label)))
            layer.setLabelsEnabled(True)
        if self.tip:
            layer.setMapTipTemplate(self.tip)
        if self.is_own:
            name_columns(layer, self.picture)
        if self.groups:
            layer.setEditFormConfig(_form(layer, self.groups))
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
        _KEPT.append(_Styler(look))
        del _KEPT[:-_MOST_KEPT]
        context.layerToLoadOnCompletionDetails(destination).setPostProcessor(_KEPT[-1])


def raster_style_when_loaded(path: str, qml: str, context: QgsProcessingContext) -> None:
    """Gives the raster that QGIS will load its look, whatever style is beside it."""
    if context.willLoadLayerOnCompletion(path):
        _KEPT.append(_RasterStyler(qml))
        del _KEPT[:-_MOST_KEPT]
        context.layerToLoadOnCompletionDetails(path).setPostProcessor(_KEPT[-1])


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


def _labeling(expression: str) -> QgsPalLayerSettings:
    """Small dark text with a white rim, not from far away; what would cover something else is left out."""
    settings = QgsPalLayerSettings()
    settings.fieldName, settings.isExpression = expression, True
    settings.dist = 2.2
    settings.scaleVisibility, settings.minimumScale, settings.maximumScale = True, LABELS_FROM_SCALE, 1
    text, rim = QgsTextFormat(), QgsTextBufferSettings()
    text.setSize(8)
    text.setColor(QColor(INK))
    rim.setEnabled(True)
    rim.setSize(0.9)
    rim.setColor(QColor(CASING))
    text.setBuffer(rim)
    settings.setFormat(text)
    return settings


def _form(layer: QgsVectorLayer, groups: tuple[tuple[str, tuple[str, ...]], ...]) -> QgsEditFormConfig:
    """A form with a page a group."""
    form = layer.editFormConfig()
    form.clearTabs()
    form.setLayout(QgsEditFormConfig.TabLayout)
    for title, names in groups:
        page = QgsAttributeEditorContainer(title, None)
        page.setIsGroupBox(False)
        for name in names:
            index = layer.fields().lookupField(name)
            if index >= 0:
                page.addChildElement(QgsAttributeEditorField(name, index, page))
        form.addTab(page)
    return form
