"""semref:localizeimages in the background."""

from __future__ import annotations

from typing import List

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...processing.translation import tr
from .algorithm_run import AlgorithmRun

ALGORITHM = "semref:localizeimages"


class LocalizationRun(AlgorithmRun):
    """An AlgorithmRun that says ``found`` when it is done.

    found: positions, footprints and possible places (QgsVectorLayer in memory, the receiver's; the last two may be
    None).
    """

    found = pyqtSignal(object, object, object)

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

    def _take_layers(self, results: dict, context) -> None:
        layers = [context.takeResultLayer(results.get(key, "")) for key in ("OUTPUT", "FOOTPRINTS", "ALTERNATIVES")]
        self.found.emit(*layers)
