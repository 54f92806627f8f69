"""Results of *Localize images* or *Localize flight* as one GeoPackage with a table for each layer."""

from __future__ import annotations

from qgis.core import QgsCoordinateTransformContext, QgsMapLayerStyle, QgsVectorFileWriter, QgsVectorLayer

from ...core.errors import ParameterError
from ...storage.atomic_output import written_beside
from ...storage.vector_files import STYLE_OF_SEMREF, leave_wal

TABLES = ("positions", "footprints", "possible_places", "matches", "track")


def write_results(path: str, layers: tuple[QgsVectorLayer | None, ...]) -> None:
    """Write layers with their styles and metadata.

    Args:
        path: The GeoPackage.
        layers: A layer or None for each of TABLES.

    Raises:
        ParameterError: The GeoPackage can't be written.
    """
    with written_beside(path, ".gpkg", TABLES) as temporary:
        action = QgsVectorFileWriter.CreateOrOverwriteFile
        for table, layer in zip(TABLES, layers):
            if layer is None:
                continue
            options = QgsVectorFileWriter.SaveVectorOptions()
            options.saveMetadata, options.layerMetadata = True, layer.metadata()
            options.driverName, options.layerName, options.actionOnExistingFile = "GPKG", table, action
            context = QgsCoordinateTransformContext()
            code, reason, *_ = QgsVectorFileWriter.writeAsVectorFormatV3(layer, temporary, context, options)
            if code != QgsVectorFileWriter.NoError:
                raise ParameterError("{path} can't be written: {reason}.", path=path, reason=reason.rstrip("."))
            action = QgsVectorFileWriter.CreateOrOverwriteLayer
            _save_style(f"{temporary}|layername={table}", layer)
        leave_wal(temporary)


def _save_style(destination: str, layer: QgsVectorLayer) -> None:
    """Save the style of ``layer`` as the default style of the written layer."""
    written, style = QgsVectorLayer(destination, "written", "ogr"), QgsMapLayerStyle()
    style.readFromLayer(layer)
    style.writeToLayer(written)
    written.saveStyleToDatabase("SemRef", STYLE_OF_SEMREF, True, "")


def open_results(path: str) -> tuple[QgsVectorLayer | None, ...]:
    """Return the layers of TABLES, None for a missing one. Raises ParameterError for a file without positions."""
    layers = [QgsVectorLayer(f"{path}|layername={table}", table, "ogr") for table in TABLES]
    found = tuple(layer if layer.isValid() else None for layer in layers)
    if found[0] is None or found[0].fields().lookupField("status") < 0:
        raise ParameterError("{path} has no results of “Localize images”. Localize the images again.", path=path)
    return found
