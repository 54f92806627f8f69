"""Results of *Localize images* or *Localize flight* as one GeoPackage: positions, footprints, possible places, matches
and the track, each a table."""

from __future__ import annotations

from qgis.core import QgsCoordinateTransformContext, QgsVectorFileWriter, QgsVectorLayer

from ...core.errors import ParameterError
from ...storage.files import written_beside

TABLES = ("positions", "footprints", "possible_places", "matches", "track")


def write_results(path: str, layers: tuple[QgsVectorLayer | None, ...]) -> None:
    """``layers``: one for each of TABLES, None for one that there is not. Raises ParameterError."""
    with written_beside(path) as temporary:
        action = QgsVectorFileWriter.CreateOrOverwriteFile
        for table, layer in zip(TABLES, layers):
            if layer is None:
                continue
            options = QgsVectorFileWriter.SaveVectorOptions()
            options.driverName, options.layerName, options.actionOnExistingFile = "GPKG", table, action
            context = QgsCoordinateTransformContext()
            code, reason, *_ = QgsVectorFileWriter.writeAsVectorFormatV3(layer, temporary, context, options)
            if code != QgsVectorFileWriter.NoError:
                raise ParameterError("storage.unwritable", path=path, reason=reason.rstrip("."))
            action = QgsVectorFileWriter.CreateOrOverwriteLayer


def open_results(path: str) -> tuple[QgsVectorLayer | None, ...]:
    """The layers of TABLES, None for one that the file lacks. Raises ParameterError for a file without positions."""
    layers = [QgsVectorLayer(f"{path}|layername={table}", table, "ogr") for table in TABLES]
    found = tuple(layer if layer.isValid() else None for layer in layers)
    if found[0] is None or found[0].fields().lookupField("status") < 0:
        raise ParameterError("exchange.no_results", path=path)
    return found
