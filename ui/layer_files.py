"""Files of layers: layers of the project, or dropped from the layer tree or the browser."""

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

_DATABASE_SUFFIX = ".gpkg"
_COLOR_BANDS = 3


def layer_file(layer: QgsMapLayer) -> str:
    """Return the file of a layer; empty for layers without a file, such as web maps."""
    return _file_of(layer.providerType(), layer.source())


def raster_layers(project: QgsProject) -> list[QgsRasterLayer]:
    """Return the raster layers that have a file, sorted by name. Overviews of databases are left out."""
    layers = [layer for layer in project.mapLayers().values() if isinstance(layer, QgsRasterLayer)]
    # The overview of a database is a raster in a GeoPackage.
    found = [layer for layer in layers if layer_file(layer) and not layer_file(layer).endswith(_DATABASE_SUFFIX)]
    return sorted(found, key=lambda layer: layer.name().lower())


def photo_layer(project: QgsProject) -> QgsRasterLayer | None:
    """Return the project's only raster file with colors; None for several. Label maps never count."""
    found = [layer for layer in raster_layers(project) if layer.bandCount() >= _COLOR_BANDS]
    return found[0] if len(found) == 1 else None


def label_maps_of(project: QgsProject, extent: QgsReferencedRectangle, pixel_size: float) -> list[QgsRasterLayer]:
    """Return single-band layers with CRS and grid of a database's map."""
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


def dropped_files(data: QMimeData) -> tuple[list[str], list[str]]:
    """Return (dropped files and folders, names of dropped layers that are not files)."""
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
