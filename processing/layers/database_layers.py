"""Show a reference database on the map: its layers with their styles as one group. Place new layers."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path

from qgis.core import (
    QgsLayerTree,
    QgsLayerTreeGroup,
    QgsLayerTreeNode,
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
from .styles import name_columns

OVERVIEW = "overview"
"""Table of the overview, the lowest layer."""

_SUFFIX = ".gpkg"
_KEPT: list[QgsProcessingLayerPostProcessorInterface] = []
_MOST_KEPT = 40
"""Number of the latest post-processors to keep: QGIS does not keep their Python objects."""


class Opened(QObject):
    """Signals: ``database``, path of a database that an algorithm opened; ``raster``, path of a written raster."""

    database = pyqtSignal(str)
    raster = pyqtSignal(str)


OPENED = Opened()
"""The dock connects to these signals."""


def add_database_to_map(path: str, project: QgsProject, references: QgsVectorLayer | None = None) -> QgsLayerTreeGroup:
    """Add references, windows and overview as a group and return it; only the references are visible.

    Args:
        references: Existing layer of the references; None to add it.

    Raises:
        DatabaseError: The file is not a database; nothing was added.
    """
    if not Path(path).is_file():
        # Imported here: QGIS must start without loading numpy.
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
    # Imported here: the dock must open without loading GDAL's arrays.
    from .class_styles import apply_overview_style

    apply_overview_style(added[-1], path)
    _copy_metadata(added[-2], added[-1])
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
    # After the styles, which have the language of the database's creator.
    for layer in shown:
        if isinstance(layer, QgsVectorLayer):
            name_columns(layer)
    return group


def _copy_metadata(windows: QgsVectorLayer, overview: QgsRasterLayer) -> None:
    """Copy the history to the overview, because QGIS reads no metadata of rasters in a GeoPackage."""
    metadata = windows.metadata()
    metadata.setTitle(overview.name())
    metadata.setAbstract(tr("The label map reduced to the most frequent class of each block."))
    overview.setMetadata(metadata)


def database_file(layer: QgsMapLayer) -> str:
    """Return the path of the reference database that a layer belongs to; empty for another layer."""
    path, table = _file_and_table(layer)
    return path if path.endswith(_SUFFIX) and table in (REFERENCES, WINDOWS, OVERVIEW) else ""


def database_layers(path: str, project: QgsProject) -> list[QgsMapLayer]:
    wanted = os.path.realpath(path)
    found = [(layer, database_file(layer)) for layer in project.mapLayers().values()]
    return [layer for layer, file in found if file and os.path.realpath(file) == wanted]


def reload_database(path: str, project: QgsProject) -> None:
    """Reload the layers of a database that was replaced."""
    _reload(database_layers(path, project))


def reload_raster(path: str, project: QgsProject) -> None:
    """Reload the layers of a raster file that was replaced."""
    rasters = [layer for layer in project.mapLayers().values() if isinstance(layer, QgsRasterLayer)]
    files = [_file_and_table(layer)[0] for layer in rasters]
    wanted = os.path.realpath(path)
    _reload([layer for layer, file in zip(rasters, files) if file and os.path.realpath(file) == wanted])


def _reload(layers: list[QgsMapLayer]) -> None:
    for layer in layers:
        layer.dataProvider().reloadData()
        layer.reload()
        layer.triggerRepaint()


def open_when_done(path: str, output: str, context: QgsProcessingContext) -> None:
    """Open a database in QGIS when its algorithm is done. Scripts without a project open nothing."""
    if context.project() is None:
        return
    details = QgsProcessingContext.LayerDetails(
        tr("Landmarks"), context.project(), output, QgsProcessingUtils.LayerHint.Vector
    )
    when_loaded(details, partial(_open_others, path))
    context.addLayerToLoadOnCompletion(_table_source(path, REFERENCES), details)


def when_loaded(
    details: QgsProcessingContext.LayerDetails, process: Callable[[QgsMapLayer, QgsProject | None], None]
) -> None:
    """Call a function with a layer and its project after QGIS opened the layer."""
    processor = _PostProcessor(process)
    _KEPT.append(processor)
    del _KEPT[:-_MOST_KEPT]
    details.setPostProcessor(processor)


class _PostProcessor(QgsProcessingLayerPostProcessorInterface):
    def __init__(self, process: Callable[[QgsMapLayer, QgsProject | None], None]) -> None:
        super().__init__()
        self._process = process

    def postProcessLayer(self, layer, context, feedback):
        self._process(layer, context.project())


def _open_others(path: str, references: QgsVectorLayer, project: QgsProject) -> None:
    """Open the other layers of a database after QGIS opened the references."""
    others = [other for other in database_layers(path, project) if other.id() != references.id()]
    if others:
        # The project already has this database, which was updated.
        if any(_file_and_table(other)[1] == REFERENCES for other in others):
            project.removeMapLayer(references.id())
        reload_database(path, project)
    else:
        add_database_to_map(path, project, references)
    OPENED.database.emit(path)


def _file_and_table(layer: QgsMapLayer) -> tuple[str, str]:
    parts = QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source())
    path = parts.get("path") or ""
    return (path, parts.get("layerName") or "") if os.path.exists(path) else ("", "")


def _table_source(path: str, table: str) -> str:
    return f"{path}|layername={table}"


def _overview_source(path: str) -> str:
    """Return the overview's source for QGIS; GDAL's name of a table can't contain every path."""
    is_plain = '"' not in path and ":" not in Path(path).name and ":" not in str(Path(path).parent)[2:]
    return f"GPKG:{path}:overview" if is_plain else f"{path}|option:TABLE=overview"


def place_on_top(layer: QgsMapLayer, project: QgsProject) -> None:
    """Add a layer to the project above all others."""
    project.addMapLayer(layer, False)
    project.layerTreeRoot().insertLayer(0, layer)


def place_at_bottom(layer: QgsMapLayer, project: QgsProject | None) -> None:
    """Move a new layer below all others except map tiles, so that it covers no layer of the user."""
    node = None if project is None else project.layerTreeRoot().findLayer(layer.id())
    if node is not None:
        root = project.layerTreeRoot()
        others = [child for child in root.children() if child is not node]
        while others and _is_drawn(others[-1]):
            others.pop()
        move(node, root, root.children().index(others[-1]) + 1 if others else 0)


def move(node: QgsLayerTreeNode, group: QgsLayerTreeGroup, index: int) -> QgsLayerTreeNode:
    """Move a node to an index in a group; return the new node."""
    moved = node.clone()
    group.insertChildNode(index, moved)
    node.parent().removeChildNode(node)
    return moved


def _is_drawn(node: QgsLayerTreeNode) -> bool:
    """Whether a node is a raster without a file, such as map tiles."""
    layer = node.layer() if QgsLayerTree.isLayer(node) else None
    return isinstance(layer, QgsRasterLayer) and layer.providerType() != "gdal"
