"""A reference database, or saved results, dropped on QGIS come with all their layers."""

from __future__ import annotations

from typing import Callable

from qgis.core import QgsProject
from qgis.gui import QgsCustomDropHandler

from ..core.errors import SemRefError
from ..processing.inspection.chosen import require_database
from ..processing.layers.database_layers import add_database_to_map
from .running.localization_run import named_results


class DatabaseDrop(QgsCustomDropHandler):
    """Otherwise QGIS would ask which of the tables it shall add, and add them without names and order."""

    def handleFileDrop(self, file):
        return file.lower().endswith(".gpkg") and (_did(_add_database, file) or _did(_add_results, file))


def _add_database(path: str) -> None:
    require_database(path)
    add_database_to_map(path, QgsProject.instance())


def _add_results(path: str) -> None:
    QgsProject.instance().addMapLayers([layer for layer in named_results(path) if layer is not None])


def _did(add: Callable[[str], None], path: str) -> bool:
    """Whether it is such a file; any other GeoPackage is QGIS's business."""
    try:
        add(path)
    except SemRefError:
        return False
    return True
