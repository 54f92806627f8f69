"""A reference database on the map: its layers with their own styles, as one group."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsLayerTreeGroup, QgsProject, QgsRasterLayer, QgsVectorLayer

from ...core.errors import DatabaseError
from ...processing.translation import tr


def add_database_to_map(path: str, project: QgsProject) -> QgsLayerTreeGroup:
    """Adds references, windows and overview, from top to bottom, and gives their group.

    Raises DatabaseError and adds nothing.
    """
    if not Path(path).is_file():
        raise DatabaseError("storage.no_database", path=path)
    layers = [
        QgsVectorLayer(f"{path}|layername=references", tr("Landmarks"), "ogr"),
        QgsVectorLayer(f"{path}|layername=windows", tr("Windows"), "ogr"),
        QgsRasterLayer(_overview_source(path), tr("Overview"), "gdal"),
    ]
    if not all(layer.isValid() for layer in layers):
        raise DatabaseError("exchange.no_database_layers", path=path)
    # Not at the top: it brings GDAL's arrays, and the dock shall open at once.
    from ...processing.exchange.styles import apply_overview_style

    apply_overview_style(layers[-1], path)
    project.addMapLayers(layers, False)
    group = project.layerTreeRoot().insertGroup(0, Path(path).stem)
    for layer in layers:
        group.addLayer(layer)
    return group


def _overview_source(path: str) -> str:
    """What QGIS opens the overview by; GDAL's name of a part of a file can't hold every path."""
    is_plain = '"' not in path and ":" not in Path(path).name and ":" not in str(Path(path).parent)[2:]
    return f"GPKG:{path}:overview" if is_plain else f"{path}|option:TABLE=overview"
