"""Images laid on the map as their fixes say."""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingUtils, QgsProject, QgsRasterLayer

from ...core.errors import LabelMapError
from ...processing.layers.layer_tree import place_on_top

OPACITY = 0.6


def place_image(image: str, corners: tuple, crs_wkt: str) -> str:
    """Georeferences an image, in the background.

    Args:
        corners: Map (x, y) of its four corners (``Finding.corners``).
        crs_wkt: What they are in.

    Returns:
        The raster that QGIS opens, which lasts as long as QGIS runs.

    Raises:
        LabelMapError: The image can't be read.
    """
    # Not at the top: the dock has to open, and say so, where OpenCV is missing.
    from ...storage.georeferenced_vrt import write_draped

    target = QgsProcessingUtils.generateTempFilename("image.vrt")
    write_draped(image, target, crs_wkt, corners)
    return target


def add_placed(placed: str, name: str, crs_wkt: str, database: str, project: QgsProject) -> QgsRasterLayer:
    """Adds what ``place_image`` gave to the project, half-transparent, above all other layers.

    Label values get the colors of ``database``. Raises LabelMapError.
    """
    layer = QgsRasterLayer(placed, name, "gdal")
    if not layer.isValid():
        raise LabelMapError("{image} can’t be shown on the map.", image=name)
    if layer.bandCount() == 1:
        # Not at the top: it brings GDAL's arrays, and the dock shall open at once.
        from ...processing.layers.class_styles import apply_overview_style

        apply_overview_style(layer, database)
    if not layer.crs().isValid():
        # QGIS asks nobody about a layer that SemRef has placed itself.
        layer.setCrs(QgsCoordinateReferenceSystem.fromWkt(crs_wkt))
    layer.setOpacity(OPACITY)
    place_on_top(layer, project)
    return layer
