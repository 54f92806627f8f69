"""Results of *Localize images* or *Localize flight* as one GeoPackage: positions, footprints, possible places, matches
and the track, each a table."""

from __future__ import annotations

from qgis.core import QgsCoordinateTransformContext, QgsMapLayerStyle, QgsVectorFileWriter, QgsVectorLayer

from ...core.errors import ParameterError
from ...storage.atomic_output import written_beside
from ...storage.vector_files import STYLE_OF_SEMREF, leave_wal

TABLES = ("positions", "footprints", "possible_places", "matches", "track")


def write_results(path: str, layers: tuple[QgsVectorLayer | None, ...]) -> None:
    """Writes them with their styles and what they tell about themselves.

    Args:
        path: Of the GeoPackage.
        layers: One for each of TABLES, None for one that there is not.

    Raises:
        ParameterError: It can't be written.
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
            _keep_style(f"{temporary}|layername={table}", layer)
        leave_wal(temporary)


def _keep_style(destination: str, layer: QgsVectorLayer) -> None:
    """Gives the written layer the style of the one it was written from, as its default."""
    written, style = QgsVectorLayer(destination, "written", "ogr"), QgsMapLayerStyle()
    style.readFromLayer(layer)
    style.writeToLayer(written)
    written.saveStyleToDatabase("SemRef", STYLE_OF_SEMREF, True, "")


def open_results(path: str) -> tuple[QgsVectorLayer | None, ...]:
    """The layers of TABLES, None for one that the file lacks. Raises ParameterError for a file without positions."""
    layers = [QgsVectorLayer(f"{path}|layername={table}", table, "ogr") for table in TABLES]
    found = tuple(layer if layer.isValid() else None for layer in layers)
    if found[0] is None or found[0].fields().lookupField("status") < 0:
        raise ParameterError("{path} holds no results of “Localize images”; localize the images again.", path=path)
    return found
