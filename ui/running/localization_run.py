"""Run semref:localizeimages or semref:localizeflight in the background."""

from __future__ import annotations

from qgis.core import QgsProcessingContext, QgsProcessingUtils, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...core.errors import ParameterError
from ...processing.layers.results_file import TABLES, open_results
from ...processing.messages.numbers import LocalTemplate
from ...processing.messages.sentences import worded
from ...processing.translation import tr
from ..findings import ResultLayers
from .algorithm_run import AlgorithmRun
from .run_history import RunRecord, begin_run, destination, labels_folder

ALGORITHM, FLIGHT_ALGORITHM = "semref:localizeimages", "semref:localizeflight"

RISK = 0.01
"""Maximum error probability in the dock, where a person looks at each result. The algorithms have a lower default."""

_KEYS = "OUTPUT", "FOOTPRINTS", "ALTERNATIVES", "MATCHES", "TRACK"
"""Outputs, in the order of TABLES."""


class LocalizationRun(AlgorithmRun):
    """AlgorithmRun that emits ``found`` when it is done.

    found: ResultLayers, which the receiver owns, and the folder of the photos' label images, empty without photos.

    Attributes:
        file: GeoPackage of the results; empty for layers in memory.
        pace: Sentence on device and speed of the model; empty without a model.
    """

    found = pyqtSignal(object, str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.done.connect(self._take_layers)
        self._kept: RunRecord | None = None
        self.pace = self.file = ""

    def start(self, database: str, images: list[str], method: int, settings: dict, is_flight: bool = False) -> bool:
        """Start a run. Returns False after emitting ``failed`` if it can't start.

        Args:
            method: METHOD of the algorithm.
            settings: Further parameters.
            is_flight: Whether the images are one flight.
        """
        run = begin_run(database, settings.get("MODEL", ""), len(images))
        # QGIS can't write tables to a file with an apostrophe in its path.
        self._kept = None if run is None or "'" in run.folder else run
        left_out = "ALTERNATIVES" if is_flight else "TRACK"
        outputs = {
            key: f"memory:{title}" if self._kept is None else destination(self._kept, table)
            for key, table, title in zip(_KEYS, TABLES, _titles())
            if key != left_out
        }
        parameters = {"DATABASE": database, "IMAGES": images, "METHOD": method, "RISK": RISK, **settings, **outputs}
        if settings.get("MODEL"):
            kept = self._kept
            parameters["LABELS"] = (
                QgsProcessingUtils.generateTempFilename("labels") if kept is None else labels_folder(kept)
            )
        if is_flight:
            return self.start_algorithm(FLIGHT_ALGORITHM, parameters, tr("Localizing a flight"))
        return self.start_algorithm(ALGORITHM, parameters, tr("Localizing images"))

    def _take_layers(self, results: dict, context: QgsProcessingContext) -> None:
        self.pace, self.file = "", "" if self._kept is None else self._kept.file
        if results.get("DEVICE"):
            text = tr("{device}, {rate:.3g} tiles per second.")
            self.pace = LocalTemplate(text).format(device=results["DEVICE"], rate=results["TILES_PER_SECOND"])
        if self._kept is None:
            layers = [context.takeResultLayer(results.get(key, "")) for key in _KEYS]
        else:
            try:
                layers = named_results(self.file)
            except ParameterError as error:
                # Another program removed the file.
                self.failed.emit(worded(error))
                return
        self.found.emit(ResultLayers(*layers), results.get("LABELS", ""))


def named_results(file: str) -> list[QgsVectorLayer | None]:
    """Open the layers of a results file, with names for the user. Raises ParameterError."""
    layers = list(open_results(file))
    for layer, title in zip(layers, _titles()):
        if layer is not None:
            layer.setName(title)
    return layers


def _titles() -> list[str]:
    """Return the names of the layers, in the order of TABLES."""
    return [
        tr("SemRef positions"),
        tr("SemRef footprints"),
        tr("SemRef possible places"),
        tr("SemRef matches"),
        tr("SemRef track"),
    ]
