"""From layers to the files they show: of the project, or dropped from the layer tree or the browser."""

from __future__ import annotations

import os

from qgis.core import (
    QgsMapLayer,
    QgsMimeDataUtils,
    QgsProject,
    QgsProviderRegistry,
    QgsRasterLayer,
    QgsRectangle,
    QgsReferencedRectangle,
)
from qgis.PyQt.QtCore import QMimeData

from ..processing.layers.database_layers import database_file

_DATABASE_SUFFIX = ".gpkg"
_COLOR_BANDS = 3


def layer_file(layer: QgsMapLayer) -> str:
    """The file that a layer shows; empty where it shows none, as a web map does."""
    return _file_of(layer.providerType(), layer.source())


def raster_layers(project: QgsProject) -> list[QgsRasterLayer]:
    """Those of one file each, in the order of their names."""
    layers = [layer for layer in project.mapLayers().values() if isinstance(layer, QgsRasterLayer)]
    # A database's overview is a raster, too; its file holds other things.
    found = [layer for layer in layers if layer_file(layer) and not layer_file(layer).endswith(_DATABASE_SUFFIX)]
    return sorted(found, key=lambda layer: layer.name().lower())


def photo_layer(project: QgsProject) -> QgsRasterLayer | None:
    """The project's one raster file with colors; None where it could be several, and never a label map."""
    found = [layer for layer in raster_layers(project) if layer.bandCount() >= _COLOR_BANDS]
    return found[0] if len(found) == 1 else None


def label_maps_of(project: QgsProject, extent: QgsReferencedRectangle, pixel_size: float) -> list[QgsRasterLayer]:
    """Those that have the pixels of a database's map: one band, in its CRS, on its grid."""
    close = pixel_size / 100
    return [
        layer
        for layer in raster_layers(project)
        if layer.bandCount() == 1
        and layer.crs() == extent.crs()
        and abs(layer.rasterUnitsPerPixelX() - pixel_size) < close
        and all(abs(a - b) < close for a, b in zip(_edges(layer.extent()), _edges(extent)))
    ]


def _edges(extent: QgsRectangle) -> tuple[float, ...]:
    return extent.xMinimum(), extent.yMinimum(), extent.xMaximum(), extent.yMaximum()


def drawn_layers(project: QgsProject) -> list[QgsRasterLayer]:
    """Rasters that are no file of GDAL's, as map tiles are, in the order of their names."""
    layers = [layer for layer in project.mapLayers().values() if isinstance(layer, QgsRasterLayer)]
    found = [layer for layer in layers if layer.isValid() and layer.providerType() != "gdal"]
    return sorted(found, key=lambda layer: layer.name().lower())


def project_databases(project: QgsProject) -> dict[str, str]:
    """Names of the reference databases whose layers the project has, by path: that of the group, else of the file."""
    found: dict[str, str] = {}
    for node in project.layerTreeRoot().findLayers():
        layer = node.layer()
        path = "" if layer is None else database_file(layer)
        if path and path not in found:
            group = node.parent()
            in_group = group is not None and group.parent() is not None
            found[path] = group.name() if in_group else os.path.splitext(os.path.basename(path))[0]
    return found


def dropped_files(data: QMimeData) -> tuple[list[str], list[str]]:
    """(files and folders, names of layers that are no file) of what was dropped: layers, or files from anywhere."""
    if not QgsMimeDataUtils.isUriList(data):
        return [url.toLocalFile() for url in data.urls() if url.isLocalFile()], []
    files, others = [], []
    for uri in QgsMimeDataUtils.decodeUriList(data):
        path = _file_of(uri.providerKey, uri.uri)
        if path:
            files.append(path)
        else:
            others.append(uri.name)
    return files, others


def _file_of(provider: str, source: str) -> str:
    path = QgsProviderRegistry.instance().decodeUri(provider, source).get("path") or ""
    return path if os.path.exists(path) else ""
