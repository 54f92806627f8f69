"""A reference database on the map: its layers with their own styles, as one group, and rasters that are opened."""

from __future__ import annotations

import os
from pathlib import Path

from qgis.core import (
    QgsLayerTree,
    QgsLayerTreeGroup,
    QgsMapLayer,
    QgsProcessingContext,
    QgsProcessingLayerPostProcessorInterface,
    QgsProcessingUtils,
    QgsProject,
    QgsProviderRegistry,
    QgsRasterLayer,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...core.errors import DatabaseError
from ..translation import tr
from .layer_metadata import REFERENCES, WINDOWS
from .layer_tree import leave_group, move, place_at_bottom
from .styles import name_columns

OVERVIEW = "overview"
"""The table that is a layer without a note, below the others."""

_SUFFIX = ".gpkg"
_KEPT: list[QgsProcessingLayerPostProcessorInterface] = []
_MOST_KEPT = 40
"""Post-processors of the last layers: QGIS takes no care of their Python half."""


class Opened(QObject):
    """``database``: the path of one that a user had an algorithm open; ``raster``: that of one that was written."""

    database = pyqtSignal(str)
    raster = pyqtSignal(str)


OPENED = Opened()
"""Whoever shows databases follows it."""


def add_database_to_map(path: str, project: QgsProject, references: QgsVectorLayer | None = None) -> QgsLayerTreeGroup:
    """Adds references, windows and overview, from top to bottom, and gives their group; only references are visible.

    Args:
        path: Of the database.
        project: Where to.
        references: The layer of that table where the project has it already.

    Raises:
        DatabaseError: Nothing was added.
    """
    if not Path(path).is_file():
        # Not at the top: it loads numpy, and QGIS starts without.
        from ...storage.database.connection import no_database

        raise no_database(path)
    added: list[QgsMapLayer] = [
        QgsVectorLayer(_table_source(path, WINDOWS), tr("Windows"), "ogr"),
        QgsRasterLayer(_overview_source(path), tr("Overview"), "gdal"),
    ]
    if references is None:
        added.insert(0, QgsVectorLayer(_table_source(path, REFERENCES), tr("Landmarks"), "ogr"))
    if not all(layer.isValid() for layer in added):
        raise DatabaseError(
            "{path} is not a SemRef reference database; choose one made by “Build reference database”.", path=path
        )
    # Not at the top: it brings GDAL's arrays, and the dock shall open at once.
    from .class_styles import apply_overview_style

    apply_overview_style(added[-1], path)
    _tell_of(added[-1], added[-2])
    project.addMapLayers(added, False)
    shown = added if references is None else [references, *added]
    root = project.layerTreeRoot()
    group = root.insertGroup(0, Path(path).stem)
    for layer in added:
        group.addLayer(layer)
    if references is not None:
        references.setName(tr("Landmarks"))
        references.loadDefaultStyle()
        before = root.findLayer(references.id())
        if before is None:
            group.insertLayer(0, references)
        else:
            move(before, group, 0)
    for node in group.findLayers():
        node.setExpanded(False)
        node.setItemVisibilityChecked(node.layerId() == shown[0].id())
    # After the styles: these have the language of whoever built the database.
    for layer in shown:
        if isinstance(layer, QgsVectorLayer):
            name_columns(layer)
    return group


def _tell_of(overview: QgsRasterLayer, windows: QgsVectorLayer) -> None:
    """Has the overview tell what made the database: QGIS reads the note of no raster in a GeoPackage."""
    told = windows.metadata()
    told.setTitle(overview.name())
    told.setAbstract(tr("The label map reduced to the most frequent class of each block."))
    overview.setMetadata(told)


def database_file(layer: QgsMapLayer) -> str:
    """The reference database that a layer is of, by the names of its tables; empty for any other layer."""
    path, table = _file_and_table(layer)
    return path if path.endswith(_SUFFIX) and table in (REFERENCES, WINDOWS, OVERVIEW) else ""


def database_layers(path: str, project: QgsProject) -> list[QgsMapLayer]:
    """Those of a database that the project has."""
    wanted = os.path.realpath(path)
    found = [(layer, database_file(layer)) for layer in project.mapLayers().values()]
    return [layer for layer, file in found if file and os.path.realpath(file) == wanted]


def reload_database(path: str, project: QgsProject) -> None:
    """Shows what a database holds now that it was replaced."""
    _reload(database_layers(path, project))


def reload_raster(path: str, project: QgsProject) -> None:
    """Show what a raster file holds now that it was replaced."""
    rasters = [layer for layer in project.mapLayers().values() if isinstance(layer, QgsRasterLayer)]
    _reload([layer for layer in rasters if _is_of(layer, path)])


def _is_of(layer: QgsRasterLayer, path: str) -> bool:
    file = _file_and_table(layer)[0]
    return bool(file) and os.path.realpath(file) == os.path.realpath(path)


def _reload(layers: list[QgsMapLayer]) -> None:
    for layer in layers:
        layer.dataProvider().reloadData()
        layer.reload()
        layer.triggerRepaint()


def open_when_done(path: str, labels: object, output: str, context: QgsProcessingContext) -> None:
    """Has QGIS open a database when the algorithm that wrote it is done, as it opens layers; scripts open nothing.

    Args:
        path: Of the database.
        labels: LABELS as given: where the same run opens that file as well, it joins the group of the database.
        output: The key of the output.
    """
    if context.project() is None:
        return
    details = QgsProcessingContext.LayerDetails(
        tr("Landmarks"), context.project(), output, QgsProcessingUtils.LayerHint.Vector
    )
    is_opened = isinstance(labels, str) and context.willLoadLayerOnCompletion(labels)
    set_post_processor(details, _Opener(path, labels if is_opened else ""))
    context.addLayerToLoadOnCompletion(_table_source(path, REFERENCES), details)


def set_post_processor(
    details: QgsProcessingContext.LayerDetails, processor: QgsProcessingLayerPostProcessorInterface
) -> None:
    """Have QGIS call a post-processor with the layer when it has opened it, and keep it alive until then."""
    _KEPT.append(processor)
    del _KEPT[:-_MOST_KEPT]
    details.setPostProcessor(processor)


class _Opener(QgsProcessingLayerPostProcessorInterface):
    """QGIS opens one layer and calls this with it, in the main thread."""

    def __init__(self, path: str, labels: str) -> None:
        super().__init__()
        self._path, self._labels = path, labels
        self.taken = ""

    def postProcessLayer(self, layer, context, feedback):
        project = context.project()
        others = [other for other in database_layers(self._path, project) if other.id() != layer.id()]
        if others:
            # Updated in place: the project has it already.
            if any(_file_and_table(other)[1] == REFERENCES for other in others):
                project.removeMapLayer(layer.id())
            reload_database(self._path, project)
        else:
            add_database_to_map(self._path, project, layer)
        self.take_labels(project)
        OPENED.database.emit(self._path)

    def take_labels(self, project: QgsProject) -> None:
        """Moves the label map of the same run into the group, invisible, once both are in the project."""
        group = next((database_group(layer, project) for layer in database_layers(self._path, project)), None)
        found = [layer for layer in project.mapLayers().values() if self._labels and layer.source() == self._labels]
        if group is not None and found:
            self._labels, self.taken = "", found[0].id()
            node = move(project.layerTreeRoot().findLayer(found[0].id()), group, len(group.children()))
            node.setExpanded(False)
            node.setItemVisibilityChecked(False)


def _openers() -> list[_Opener]:
    return [one for one in _KEPT if isinstance(one, _Opener)]


def place_new_layer(layer: QgsMapLayer, project: QgsProject | None) -> None:
    """Moves a layer that QGIS has just opened to its place: never into the group of another database."""
    # QGIS 3.40 opens all layers of a run before it passes on the first one.
    if project is None or any(opener.taken == layer.id() for opener in _openers()):
        return
    if isinstance(layer, QgsRasterLayer):
        place_at_bottom(layer, project)
    else:
        leave_group(layer, database_group(layer, project), project)
    for opener in _openers():
        opener.take_labels(project)


def database_group(layer: QgsMapLayer, project: QgsProject) -> QgsLayerTreeGroup | None:
    """The group of a layer, if it is that of a database."""
    node = project.layerTreeRoot().findLayer(layer.id())
    group = None if node is None else node.parent()
    if group is None or group.parent() is None:
        return None
    layers = [child.layer() for child in group.children() if QgsLayerTree.isLayer(child)]
    return group if any(one is not None and database_file(one) for one in layers) else None


def _file_and_table(layer: QgsMapLayer) -> tuple[str, str]:
    parts = QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source())
    path = parts.get("path") or ""
    return (path, parts.get("layerName") or "") if os.path.exists(path) else ("", "")


def _table_source(path: str, table: str) -> str:
    return f"{path}|layername={table}"


def _overview_source(path: str) -> str:
    """What QGIS opens the overview by; GDAL's name of a part of a file can't hold every path."""
    is_plain = '"' not in path and ":" not in Path(path).name and ":" not in str(Path(path).parent)[2:]
    return f"GPKG:{path}:overview" if is_plain else f"{path}|option:TABLE=overview"
