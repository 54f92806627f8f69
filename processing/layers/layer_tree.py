"""Where new layers are placed among the layers of the project."""

from __future__ import annotations

from qgis.core import QgsLayerTree, QgsLayerTreeGroup, QgsLayerTreeNode, QgsMapLayer, QgsProject, QgsRasterLayer


def place_on_top(layer: QgsMapLayer, project: QgsProject) -> None:
    """Adds a layer to the project above everything else."""
    project.addMapLayer(layer, False)
    project.layerTreeRoot().insertLayer(0, layer)


def place_at_bottom(layer: QgsMapLayer, project: QgsProject) -> None:
    """Moves a new layer of the project below all others except map tiles: it covers nothing of the user's."""
    node = project.layerTreeRoot().findLayer(layer.id())
    if node is not None:
        root = project.layerTreeRoot()
        others = [child for child in root.children() if child is not node]
        while others and _is_drawn(others[-1]):
            others.pop()
        move(node, root, root.children().index(others[-1]) + 1 if others else 0)


def leave_group(layer: QgsMapLayer, group: QgsLayerTreeGroup | None, project: QgsProject) -> None:
    """Moves a layer that QGIS put into ``group``, because a layer of it was selected, to the place above it."""
    node = project.layerTreeRoot().findLayer(layer.id())
    if group is not None and node is not None and node.parent() is group:
        move(node, group.parent(), group.parent().children().index(group))


def move(node: QgsLayerTreeNode, group: QgsLayerTreeGroup, index: int) -> QgsLayerTreeNode:
    """Moves a node to a place in a group; gives the new node."""
    moved = node.clone()
    group.insertChildNode(index, moved)
    node.parent().removeChildNode(node)
    return moved


def _is_drawn(node: QgsLayerTreeNode) -> bool:
    """Whether it is a raster that is no file, such as map tiles."""
    layer = node.layer() if QgsLayerTree.isLayer(node) else None
    return isinstance(layer, QgsRasterLayer) and layer.providerType() != "gdal"
