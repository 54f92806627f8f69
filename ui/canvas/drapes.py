"""Add localized images to the map."""

from __future__ import annotations

import os
from typing import NamedTuple

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingUtils, QgsProject, QgsRasterLayer

from ...core.errors import ImageError
from ...processing.layers.database_layers import place_on_top

OPACITY = 0.6


class PlacedImage(NamedTuple):
    """A raster that exists as long as QGIS runs, the name of its image, and its CRS."""

    raster: str
    name: str
    crs_wkt: str


def place_image(image: str, corners: tuple, crs_wkt: str) -> PlacedImage:
    """Georeference an image. For a background thread.

    Args:
        corners: Map (x, y) of its four corners (``Finding.corners``).

    Raises:
        ImageError: The image can't be read.
    """
    # Imported here because the dock must open without OpenCV.
    from ...storage.georeferencing import write_draped

    target = QgsProcessingUtils.generateTempFilename("image.vrt")
    write_draped(image, target, crs_wkt, corners)
    return PlacedImage(target, os.path.basename(image), crs_wkt)


def add_placed(placed: PlacedImage, database: str, project: QgsProject) -> QgsRasterLayer:
    """Add an image to the project, half-transparent, above all other layers.

    Label images get the colors of ``database``. Raises ImageError.
    """
    layer = QgsRasterLayer(placed.raster, placed.name, "gdal")
    if not layer.isValid():
        raise ImageError("{image} can’t be shown on the map.", image=placed.name)
    if layer.bandCount() == 1:
        # Imported here because it loads GDAL's arrays, which would delay the opening of the dock.
        from ...processing.layers.class_styles import apply_overview_style

        apply_overview_style(layer, database)
    if not layer.crs().isValid():
        # QGIS must not ask for the CRS of a layer that SemRef georeferenced.
        layer.setCrs(QgsCoordinateReferenceSystem.fromWkt(placed.crs_wkt))
    layer.setOpacity(OPACITY)
    place_on_top(layer, project)
    return layer
