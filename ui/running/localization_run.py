"""semref:localizeimages or semref:localizeflight in the background."""

from __future__ import annotations

from qgis.core import QgsProcessingContext, QgsProcessingUtils
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...processing.translation import tr
from ..findings import ResultLayers
from .algorithm_run import AlgorithmRun

ALGORITHM, FLIGHT_ALGORITHM = "semref:localizeimages", "semref:localizeflight"

_KEYS = "OUTPUT", "FOOTPRINTS", "ALTERNATIVES", "MATCHES", "TRACK"


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

    def start(self, database: str, images: list[str], method: int, settings: dict, is_flight: bool = False) -> bool:
        """``method``: METHOD of the algorithm; ``settings``: others of its parameters; ``is_flight``: of one flight.

        False when it can't even begin; then ``failed`` has said why.
        """
        parameters = {
            "DATABASE": database,
            "IMAGES": images,
            "METHOD": method,
            **settings,
            "OUTPUT": "memory:" + tr("SemRef positions"),
            "FOOTPRINTS": "memory:" + tr("SemRef footprints"),
            "MATCHES": "memory:" + tr("SemRef matches"),
        }
        if is_flight:
            parameters["TRACK"] = "memory:" + tr("SemRef track")
        else:
            parameters["ALTERNATIVES"] = "memory:" + tr("SemRef possible places")
        if settings.get("MODEL"):
            parameters["LABELS"] = QgsProcessingUtils.generateTempFilename("labels")
        if is_flight:
            return self.start_algorithm(FLIGHT_ALGORITHM, parameters, tr("Localizing a flight"))
        return self.start_algorithm(ALGORITHM, parameters, tr("Localizing images"))

    def _take_layers(self, results: dict, context: QgsProcessingContext) -> None:
        self.pace = ""
        if results.get("DEVICE"):
            text = tr("{device}, {rate:.3g} tiles a second.")
            self.pace = text.format(device=results["DEVICE"], rate=results["TILES_PER_SECOND"])
        layers = [context.takeResultLayer(results.get(key, "")) for key in _KEYS]
        self.found.emit(ResultLayers(*layers), results.get("LABELS", ""))
