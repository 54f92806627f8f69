"""Images laid on the map as their fixes say."""

from __future__ import annotations

from qgis.core import QgsProcessingUtils, QgsProject, QgsRasterLayer

from ..core.errors import LabelMapError
from ..processing.compat import wkt_for_gdal
from ..processing.exchange.styles import apply_overview_style
from ..processing.translation import tr
from .findings import Finding

OPACITY = 0.6


def lay_on_map(finding: Finding, database: str) -> QgsRasterLayer:
    """Adds the image of a finding with a heading to the project; its georeference lasts as long as QGIS runs.

    Label values get the colours of ``database``. Raises LabelMapError.
    """
    # Not at the top: the dock has to open, and say so, where OpenCV is missing.
    from ..processing.exchange.draped import write_draped

    target = QgsProcessingUtils.generateTempFilename("image.vrt")
    corners = [(point.x(), point.y()) for point in finding.outline.asPolygon()[0][:4]]
    write_draped(finding.image, target, wkt_for_gdal(finding.crs), corners)
    layer = QgsRasterLayer(target, finding.name, "gdal")
    if not layer.isValid():
        raise LabelMapError(tr("{image} can’t be shown on the map.").format(image=finding.image))
    if layer.bandCount() == 1:
        apply_overview_style(layer, database)
    layer.setOpacity(OPACITY)
    QgsProject.instance().addMapLayer(layer)
    return layer
