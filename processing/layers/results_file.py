"""Results of *Localize images* or *Localize flight* as one GeoPackage with a table for each layer."""

from __future__ import annotations

from qgis.core import QgsProviderRegistry, QgsVectorLayer

from ...core.errors import ParameterError
from ...storage.atomic_output import written_beside
from ...storage.vector_files import copy_geopackage, leave_wal

OUTPUTS = {
    "OUTPUT": "positions",
    "FOOTPRINTS": "footprints",
    "ALTERNATIVES": "possible_places",
    "MATCHES": "matches",
    "TRACK": "track",
}
"""Tables by the outputs of the algorithms: images have no track, a flight has no possible places."""

TABLES = tuple(OUTPUTS.values())

LABELS_FOLDER = "labels"
"""Folder of the photos' label images beside the file."""

GEOTIFF, WORLD_FILE, CONTROL_POINTS, MOSAIC = range(4)
"""Formats of *Georeference images*."""

MOSAIC_FILE = "mosaic.tif"


def table_outputs(file: str, is_flight: bool = False) -> dict[str, str]:
    """Return the outputs of an algorithm that write to tables of a results file."""
    left_out = "ALTERNATIVES" if is_flight else "TRACK"
    tables = {key: table for key, table in OUTPUTS.items() if key != left_out}
    return {key: f"ogr:dbname='{file}' table=\"{table}\" (geom)" for key, table in tables.items()}


def save_results(file: str, path: str) -> None:
    """Copy a file of results with styles and metadata. Raises ParameterError."""
    open_results(file)
    with written_beside(path, ".gpkg", TABLES) as temporary:
        copy_geopackage(file, temporary)
        leave_wal(temporary)


def open_results(path: str) -> tuple[QgsVectorLayer | None, ...]:
    """Return the layers of TABLES, None for a missing one. Raises ParameterError for a file without positions."""
    # QGIS warns in its log about a layer of a missing table.
    tables = {one.name() for one in QgsProviderRegistry.instance().querySublayers(path)}
    layers = [QgsVectorLayer(f"{path}|layername={one}", one, "ogr") if one in tables else None for one in TABLES]
    found = tuple(layer if layer and layer.isValid() else None for layer in layers)
    if found[0] is None or found[0].fields().lookupField("status") < 0:
        raise ParameterError("{path} has no results of “Localize images”. Localize the images again.", path=path)
    return found
