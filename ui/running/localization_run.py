"""semref:localizeimages in the background."""

from __future__ import annotations

from qgis.core import QgsProcessingContext, QgsProcessingUtils
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...processing.translation import tr
from ..findings import ResultLayers
from .algorithm_run import AlgorithmRun

ALGORITHM = "semref:localizeimages"


class LocalizationRun(AlgorithmRun):
    """An AlgorithmRun that says ``found`` when it is done.

    found: the ResultLayers, in memory, the receiver's; the folder of the photos' label images, empty without photos,
    which lasts as long as QGIS runs. ``pace``: a sentence on what ran the network and how fast; empty without one.
    """

    found = pyqtSignal(object, str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.done.connect(self._take_layers)
        self.pace = ""

    def start(self, database: str, images: list[str], method: int, settings: dict) -> bool:
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
            "MATCHES": "memory:" + tr("SemRef matches"),
        }
        if settings.get("MODEL"):
            parameters["LABELS"] = QgsProcessingUtils.generateTempFilename("labels")
        return self.start_algorithm(ALGORITHM, parameters, tr("Localizing images"))

    def _take_layers(self, results: dict, context: QgsProcessingContext) -> None:
        keys = "OUTPUT", "FOOTPRINTS", "ALTERNATIVES", "MATCHES"
        self.pace = ""
        if results.get("DEVICE"):
            text = tr("{device}, {rate:.3g} tiles a second.")
            self.pace = text.format(device=results["DEVICE"], rate=results["TILES_PER_SECOND"])
        layers = [context.takeResultLayer(results.get(key, "")) for key in keys]
        self.found.emit(ResultLayers(*layers), results.get("LABELS", ""))
