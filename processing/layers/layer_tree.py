"""Place new layers in the project's layer tree."""

from __future__ import annotations

from qgis.core import QgsLayerTree, QgsLayerTreeGroup, QgsLayerTreeNode, QgsMapLayer, QgsProject, QgsRasterLayer


def place_on_top(layer: QgsMapLayer, project: QgsProject) -> None:
    """Add a layer to the project above all others."""
    project.addMapLayer(layer, False)
    project.layerTreeRoot().insertLayer(0, layer)


def place_at_bottom(layer: QgsMapLayer, project: QgsProject) -> None:
    """Move a new layer below all others except map tiles, so that it covers no layer of the user."""
    node = project.layerTreeRoot().findLayer(layer.id())
    if node is not None:
        root = project.layerTreeRoot()
        others = [child for child in root.children() if child is not node]
        while others and _is_drawn(others[-1]):
            others.pop()
        move(node, root, root.children().index(others[-1]) + 1 if others else 0)


def leave_group(layer: QgsMapLayer, group: QgsLayerTreeGroup | None, project: QgsProject) -> None:
    """Move a layer that QGIS added to the selected ``group`` to the position above the group."""
    node = project.layerTreeRoot().findLayer(layer.id())
    if group is not None and node is not None and node.parent() is group:
        move(node, group.parent(), group.parent().children().index(group))


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
