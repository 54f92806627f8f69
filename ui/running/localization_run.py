"""semref:localizeimages in the background."""

from __future__ import annotations

from typing import List

from qgis.core import QgsProcessingContext
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...processing.translation import tr
from ..findings import ResultLayers
from .algorithm_run import AlgorithmRun

ALGORITHM = "semref:localizeimages"


class LocalizationRun(AlgorithmRun):
    """An AlgorithmRun that says ``found`` when it is done.

    found: the ResultLayers, in memory, the receiver's.
    """

    found = pyqtSignal(object)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.done.connect(self._take_layers)

    def start(self, database: str, images: List[str], method: int, settings: dict) -> bool:
        """``method``: METHOD of the algorithm; ``settings``: others of its parameters.

        False when it can't even begin; then ``failed`` has said why.
        """
        parameters = {
            "DATABASE": database,
            "IMAGES": images,
            "METHOD": method,
            **settings,
            "OUTPUT": "memory:" + tr("SemRef positions"),
            "FOOTPRINTS": "memory:" + tr("SemRef footprints"),
            "ALTERNATIVES": "memory:" + tr("SemRef possible places"),
        }
        return self.start_algorithm(ALGORITHM, parameters, tr("Localizing images"))

    def _take_layers(self, results: dict, context: QgsProcessingContext) -> None:
        layers = [context.takeResultLayer(results.get(key, "")) for key in ("OUTPUT", "FOOTPRINTS", "ALTERNATIVES")]
        self.found.emit(ResultLayers(*layers))
