"""Results of *Localize images* or *Localize flight* as one GeoPackage with a table for each layer."""

from __future__ import annotations

from qgis.core import QgsVectorLayer

from ...core.errors import ParameterError
from ...storage.atomic_output import written_beside
from ...storage.vector_files import copy_database, leave_wal

TABLES = ("positions", "footprints", "possible_places", "matches", "track")


def table_output(file: str, table: str) -> str:
    """Return a table of a results file as an algorithm's output. ``table``: one of TABLES."""
    if table not in TABLES:
        raise ValueError(table)
    return f"ogr:dbname='{file}' table=\"{table}\" (geom)"


def save_results(file: str, path: str) -> None:
    """Copy a file of results with styles and metadata. Raises ParameterError."""
    open_results(file)
    with written_beside(path, ".gpkg", TABLES) as temporary:
        copy_database(file, temporary)
        leave_wal(temporary)


def open_results(path: str) -> tuple[QgsVectorLayer | None, ...]:
    """Return the layers of TABLES, None for a missing one. Raises ParameterError for a file without positions."""
    layers = [QgsVectorLayer(f"{path}|layername={table}", table, "ogr") for table in TABLES]
    found = tuple(layer if layer.isValid() else None for layer in layers)
    if found[0] is None or found[0].fields().lookupField("status") < 0:
        raise ParameterError("{path} has no results of “Localize images”. Localize the images again.", path=path)
    return found
