"""Style vector outputs: in the GeoPackage, and on the layer that QGIS loads."""

from __future__ import annotations

import contextlib
import sqlite3
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeatureRenderer,
    QgsMapLayer,
    QgsProcessingContext,
    QgsProject,
    QgsVectorLayer,
)
from qgis.PyQt.QtXml import QDomDocument

from ...storage.vector_files import STYLE_OF_SEMREF, leave_wal
from .database_layers import place_at_bottom, when_loaded
from .layer_metadata import Note, save_in_file
from .styles import apply_style, name_columns


@dataclass(frozen=True)
class Look:
    """Style and metadata of a layer.

    Attributes:
        style: Name of its file in ``resources/styles``; empty without one.
        renderer: Replaces the file's renderer if it depends on classes or a threshold.
        is_timed: Whether features have times for QGIS's temporal controller.
        is_own: Whether the columns are SemRef's; columns of the user's layers keep their names.
    """

    style: str = ""
    renderer: QgsFeatureRenderer | None = None
    is_timed: bool = False
    is_own: bool = True
    note: Note | None = field(default=None, compare=False)

    def apply(self, layer: QgsVectorLayer) -> None:
        """Style a layer; columns get their titles, and keys in them their texts."""
        if self.is_own:
            name_columns(layer, with_editors=True)
        if self.style:
            apply_style(layer, self.style, self.is_timed)
        if self.renderer is not None:
            layer.setRenderer(self.renderer.clone())
        if self.note is not None:
            layer.setMetadata(self.note.metadata(layer))


def style_in_file(destination: str, look: Look) -> bool:
    """Write the style of a layer into its GeoPackage as the default; other formats are skipped.

    Returns:
        Whether the style is complete. On a full disk QGIS omits it without an error.
    """
    path = destination.split("|")[0]
    if Path(path).suffix.lower() != ".gpkg" or not Path(path).is_file():
        return True
    layer = QgsVectorLayer(destination, "output", "ogr")
    noted = True
    try:
        if layer.isValid():
            look.apply(layer)
            _remove_style(path, destination.partition("layername=")[2].partition("|")[0])
            layer.saveStyleToDatabase("SemRef", STYLE_OF_SEMREF, True, "")
            noted = look.note is None or save_in_file(destination, layer, look.note)
        del layer
        leave_wal(path)
        return noted and _has_style(path)
    except sqlite3.Error:
        return False


def _remove_style(path: str, table: str) -> None:
    """Remove the style of an older layer of that name: QGIS would ask in a window before replacing it."""
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        if connection.execute("SELECT 1 FROM sqlite_master WHERE name = 'layer_styles'").fetchone():
            query = "DELETE FROM layer_styles WHERE f_table_name = ? AND styleName = 'SemRef'"
            connection.execute(query, (table,))


def style_in_memory(
    destination: str, crs: QgsCoordinateReferenceSystem, look: Look, context: QgsProcessingContext
) -> None:
    """Style a layer in memory and set its CRS; other layers are not changed."""
    layer = context.getMapLayer(destination)
    if isinstance(layer, QgsVectorLayer) and layer.providerType() == "memory":
        # QGIS gives a layer without a CRS degrees.
        layer.setCrs(crs)
        look.apply(layer)


def _has_style(path: str) -> bool:
    """Whether the last written style is complete."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        row = connection.execute("SELECT styleQML FROM layer_styles ORDER BY id DESC LIMIT 1").fetchone()
    return row is not None and str(row[0]).rstrip().endswith("</qgis>")


def style_when_loaded(destination: str, look: Look, context: QgsProcessingContext) -> None:
    """Style the layer that QGIS will load."""
    if context.willLoadLayerOnCompletion(destination):
        own = replace(look, renderer=look.renderer and look.renderer.clone())
        when_loaded(context.layerToLoadOnCompletionDetails(destination), partial(_style, own))


def raster_style_when_loaded(path: str, qml: str, context: QgsProcessingContext) -> None:
    """Style the raster that QGIS will load, also if another style is beside it."""
    if context.willLoadLayerOnCompletion(path):
        when_loaded(context.layerToLoadOnCompletionDetails(path), partial(_style_raster, qml))


def _style_raster(qml: str, layer: QgsMapLayer, project: QgsProject | None) -> None:
    document = QDomDocument()
    document.setContent(qml)
    layer.importNamedStyle(document)
    place_at_bottom(layer, project)
    layer.triggerRepaint()


def _style(look: Look, layer: QgsMapLayer, _project: QgsProject | None) -> None:
    if isinstance(layer, QgsVectorLayer):
        look.apply(layer)
        layer.triggerRepaint()
