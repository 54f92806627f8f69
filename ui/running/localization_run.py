"""Run semref:localizeimages or semref:localizeflight in the background."""

from __future__ import annotations

from qgis.core import QgsProcessingContext, QgsVectorLayer
from qgis.PyQt.QtCore import QObject

from ...core.localization import SHOWN_RISK
from ...processing.layers.results_file import open_results, table_outputs
from ...processing.messages.numbers import LocalTemplate
from ...processing.translation import tr
from .algorithm_run import AlgorithmRun
from .run_history import RunRecord, begin_run

ALGORITHM, FLIGHT_ALGORITHM = "semref:localizeimages", "semref:localizeflight"


class LocalizationRun(AlgorithmRun):
    """AlgorithmRun that writes all results to one file.

    Attributes:
        record: The last run.
        pace: Sentence on device and speed of the model; empty without a model.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.done.connect(self._take_pace)
        self.record: RunRecord | None = None
        self.pace = ""

    def start(self, database: str, images: list[str], method: int, settings: dict, is_flight: bool = False) -> bool:
        """Start a run. Returns False after emitting ``failed`` if it can't start."""
        run = self.record = begin_run(database, settings.get("MODEL", ""), len(images))
        parameters = {"DATABASE": database, "IMAGES": images, "METHOD": method, "RISK": SHOWN_RISK}
        parameters |= {**settings, **table_outputs(run.file, is_flight)}
        if settings.get("MODEL"):
            parameters["LABELS"] = run.labels
        if is_flight:
            return self.start_algorithm(FLIGHT_ALGORITHM, parameters, tr("Localizing a flight"))
        return self.start_algorithm(ALGORITHM, parameters, tr("Localizing images"))

    def _take_pace(self, results: dict, _context: QgsProcessingContext) -> None:
        self.pace = ""
        if results.get("DEVICE"):
            text = tr("{device}, {rate:.3g} tiles per second.")
            self.pace = LocalTemplate(text).format(device=results["DEVICE"], rate=results["TILES_PER_SECOND"])


def named_results(file: str, run: str = "") -> list[QgsVectorLayer | None]:
    """Open the layers of a results file, with names for the user. Raises ParameterError.

    Args:
        run: Name of the results, which distinguishes their layers from those of others; empty without one.
    """
    layers = list(open_results(file))
    titles = (
        tr("SemRef positions"),
        tr("SemRef footprints"),
        tr("SemRef possible places"),
        tr("SemRef matches"),
        tr("SemRef track"),
    )
    for layer, title in zip(layers, titles):
        if layer is not None:
            layer.setName(f"{run} · {title}" if run else title)
    return layers
