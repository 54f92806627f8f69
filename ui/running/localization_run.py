"""semref:localizeimages or semref:localizeflight in the background."""

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
from .run_history import KeptRun, begin_run, destination, labels_folder

ALGORITHM, FLIGHT_ALGORITHM = "semref:localizeimages", "semref:localizeflight"

_KEYS = "OUTPUT", "FOOTPRINTS", "ALTERNATIVES", "MATCHES", "TRACK"
"""As the tables of results are."""


class LocalizationRun(AlgorithmRun):
    """An AlgorithmRun that says ``found`` when it is done.

    found: the ResultLayers, the receiver's; the folder of the photos' label images, empty without photos. ``file``: the
    GeoPackage that holds them, empty where they are in memory only. ``pace``: a sentence on what ran the network and
    how fast; empty without one.
    """

    found = pyqtSignal(object, str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.done.connect(self._take_layers)
        self._kept: KeptRun | None = None
        self.pace = self.file = ""

    def start(self, database: str, images: list[str], method: int, settings: dict, is_flight: bool = False) -> bool:
        """``method``: METHOD of the algorithm; ``settings``: others of its parameters; ``is_flight``: of one flight.

        False when it can't even begin; then ``failed`` has said why.
        """
        run = begin_run(database, settings.get("MODEL", ""), len(images))
        # QGIS can't name a table of a file with an apostrophe in its path.
        self._kept = None if run is None or "'" in run.folder else run
        left_out = "ALTERNATIVES" if is_flight else "TRACK"
        outputs = {
            key: f"memory:{title}" if self._kept is None else destination(self._kept, table)
            for key, table, title in zip(_KEYS, TABLES, _titles())
            if key != left_out
        }
        parameters = {"DATABASE": database, "IMAGES": images, "METHOD": method, **settings, **outputs}
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
            text = tr("{device}, {rate:.3g} tiles a second.")
            self.pace = LocalTemplate(text).format(device=results["DEVICE"], rate=results["TILES_PER_SECOND"])
        if self._kept is None:
            layers = [context.takeResultLayer(results.get(key, "")) for key in _KEYS]
        else:
            try:
                layers = named_results(self.file)
            except ParameterError as error:
                # Somebody was quicker, and removed it.
                self.failed.emit(worded(error))
                return
        self.found.emit(ResultLayers(*layers), results.get("LABELS", ""))


def named_results(file: str) -> list[QgsVectorLayer | None]:
    """The layers of results, with names for the user. Raises ParameterError."""
    layers = list(open_results(file))
    for layer, title in zip(layers, _titles()):
        if layer is not None:
            layer.setName(title)
    return layers


def _titles() -> list[str]:
    """What the layers are called, as TABLES are."""
    return [
        tr("SemRef positions"),
        tr("SemRef footprints"),
        tr("SemRef possible places"),
        tr("SemRef matches"),
        tr("SemRef track"),
    ]
