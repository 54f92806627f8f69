"""Update a database from a corrected land-cover layer in the background: rasterize, update, replace."""

from __future__ import annotations

import os
import traceback
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsGeometry,
    QgsProcessingUtils,
    QgsProject,
    QgsRectangle,
    QgsReferencedRectangle,
    QgsVectorLayer,
    QgsVectorLayerFeatureSource,
)
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...processing.translation import tr
from .algorithm_run import AlgorithmRun
from .background import Reader

if TYPE_CHECKING:
    from ...processing.inspection.correction import DrawnFeature, RasterizePlan
    from ...storage.atomic_output import Batch

RASTERIZE, UPDATE = "semref:rasterizeannotation", "semref:updatedatabase"

_RASTERIZED_PERCENT = 50
"""Share of rasterizing in the progress bar; the real share depends on the map."""


@dataclass(frozen=True)
class Correction:
    """Input of an update.

    Attributes:
        database: Path of the database.
        annotation: Corrected land-cover layer.
        class_field: Field with the class; may be empty.
        priority_field: Field that decides where polygons overlap; may be empty.
        class_of_all: Class of all polygons; empty if ``class_field`` has the classes.
        places: Layer of issues or disagreements; None without one.
    """

    database: str
    annotation: QgsVectorLayer
    class_field: str
    priority_field: str = ""
    class_of_all: str = ""
    places: QgsVectorLayer | None = None


@dataclass(frozen=True)
class _Known:
    """State of the last update, from which the next one finds what changed.

    Attributes:
        of: Database, layer, and how its classes are read.
        checksums: Checksums of the database; those of the updated one after the update.
        drawn: Features of the layer, as in ``RasterizePlan``.
        labels: Path of the label map.
    """

    of: tuple
    checksums: str | None
    drawn: dict[int, DrawnFeature] | None
    labels: str


class CorrectionRun(QObject):
    """Updates a database from a layer. After the first update, only changed areas are rasterized and compared.

    One update at a time. It ends with exactly one of ``done``, ``failed``, ``broke`` and ``canceled``. Call
    ``shut_down`` before deleting it.

    Attributes:
        rasterizing: Parameters of *Rasterize land-cover layer* in the last update.
        asked: Parameters of *Update reference database* in the last update.

    textChanged: current step; progressed: percent; done: path of the database; failed: a sentence for the user; broke:
    a bug's traceback.
    """

    textChanged = pyqtSignal(str)
    progressed = pyqtSignal(float)
    logged = pyqtSignal(str)
    done = pyqtSignal(str)
    failed = pyqtSignal(str)
    broke = pyqtSignal(str)
    canceled = pyqtSignal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.running = False
        self._wanted: Correction | None = None
        self._folder = self._updated = ""
        self._workplace: Batch | None = None
        self._first_percent = 0
        self.rasterizing: dict[str, Any] = {}
        self.asked: dict[str, Any] = {}
        self._known: _Known | None = None
        self._changed: QgsVectorLayer | None = None
        self._next = self._rasterize
        self._reader = Reader(self)
        self._reader.answered.connect(self._go_on)
        self._run = AlgorithmRun(self)
        self._run.done.connect(lambda results, _context: self._go_on(results))
        self._run.textChanged.connect(self.textChanged)
        self._run.logged.connect(self.logged)
        self._run.progressed.connect(self._show_progress)
        for part in (self._reader, self._run):
            part.failed.connect(self._fail)
            part.broke.connect(self._break)
        self._run.canceled.connect(self._cancel)

    @property
    def title(self) -> str:
        """Title of the last task in QGIS's task manager."""
        return self._run.title

    def shut_down(self) -> None:
        """Cancel, and wait until the background thread has ended."""
        self._reader.shut_down()
        self._run.abandon()
        self._stop()

    def start(self, wanted: Correction) -> None:
        """Start an update. The layer may be edited or removed as soon as rasterizing runs."""
        # Imported here because it reads databases, which would delay the opening of the dock.
        from ...processing.inspection.correction import LayerGround, plan_rasterizing

        self.running, self._wanted = True, wanted
        self._folder = QgsProcessingUtils.generateTempFilename("correction")
        layers = [layer for layer in (wanted.annotation, wanted.places) if layer is not None and layer.featureCount()]
        grounds = [LayerGround(layer.name(), layer.extent(), layer.crs()) for layer in layers]
        context = QgsProject.instance().transformContext()
        self._next = self._rasterize
        self.textChanged.emit(tr("Reading the database"))
        text = tr("Reading the database")
        fields = [wanted.annotation.fields().indexOf(name) for name in (wanted.class_field, wanted.priority_field)]
        read = QgsVectorLayerFeatureSource(wanted.annotation), [index for index in fields if index >= 0]
        self._reader.read(text, plan_rasterizing, wanted.database, grounds, self._folder, context, *read)

    def cancel(self) -> None:
        """Cancel; the database does not change."""
        if self._run.running:
            self._run.cancel()
        elif self.running:
            self._reader.forget()
            self._cancel()

    # --- steps ---

    def _go_on(self, answer: object) -> None:
        """Run the next step. A bug in it ends the run."""
        try:
            self._next(answer)
        except Exception:
            self._break(traceback.format_exc())

    def _rasterize(self, plan: RasterizePlan) -> None:
        wanted, grid = self._wanted, plan.grid
        self._next, self._first_percent = self._update, 0
        self.rasterizing = {
            "INPUT": wanted.annotation,
            "CLASS_FIELD": wanted.class_field,
            "OUTPUT": os.path.join(self._folder, "labels.tif"),
            "CLASS": wanted.class_of_all,
            **({"PRIORITY_FIELD": wanted.priority_field} if wanted.priority_field else {}),
            **grid,
        }
        layer = wanted.annotation
        of = wanted.database, layer.id(), layer.crs(), wanted.class_field, wanted.priority_field, wanted.class_of_all
        part = self._part(plan, of)
        labels = self._known.labels if part is not None and self._known else self.rasterizing["OUTPUT"]
        self._known = _Known(of, plan.checksums, plan.drawn, labels)
        asked = self.rasterizing
        if part is not None:
            self._next, asked = self._paste, {**asked, "EXTENT": part}
        self._run.start_algorithm(RASTERIZE, asked, tr("Rasterizing the corrected layer"))

    def _part(self, plan: RasterizePlan, of: tuple) -> QgsReferencedRectangle | None:
        """Return the part of the map where features changed since the last update; None for the whole map."""
        from ...processing.inspection.correction import changed_bounds, part_to_rasterize

        known, self._changed = self._known, None
        if known is None or known.of != of or known.checksums is None or known.checksums != plan.checksums:
            return None
        if known.drawn is None or plan.drawn is None:
            return None
        changed = changed_bounds(known.drawn, plan.drawn)
        if not changed or not os.path.isfile(known.labels):
            return None
        context = QgsProject.instance().transformContext()
        # The layer may be deleted before the database is updated.
        crs = self._wanted.annotation.crs()
        part = part_to_rasterize(plan.grid, changed, crs, context)
        self._changed = None if part is None else _layer_of(changed, crs)
        return part

    def _paste(self, rasterized: dict) -> None:
        from ...storage.label_map_file import paste_labels

        self._next = lambda _nothing: self._update({"OUTPUT": self._known.labels})
        text = tr("Rasterizing the corrected layer")
        self._reader.read(text, paste_labels, self._known.labels, rasterized["OUTPUT"])

    def _update(self, rasterized: dict) -> None:
        self._next, self._first_percent = self._replace, _RASTERIZED_PERCENT
        self._updated = self._beside(self._wanted.database) or os.path.join(self._folder, "updated.gpkg")
        self.asked = {"DATABASE": self._wanted.database, "LABELS": rasterized["OUTPUT"], "OUTPUT": self._updated}
        if self._changed is not None:
            self.asked["CHANGED"] = self._changed
        self._run.start_algorithm(UPDATE, self.asked, tr("Updating the database"))

    def _replace(self, _updated: dict) -> None:
        from ...storage.database.undo import replace_keeping

        self._next = self._end
        title, of = tr("Updating the database"), self._known.checksums
        self._reader.read(title, replace_keeping, self._wanted.database, self._updated, of)

    def _beside(self, database: str) -> str:
        """Return a path in a private folder next to the database, from where moving needs no copy; may be empty."""
        from ...core.errors import SemRefError
        from ...storage.atomic_output import Batch
        from ...storage.database.schema import TABLES

        self._workplace = Batch()
        try:
            return self._workplace.file(database, tables=TABLES)
        except SemRefError:
            # Replacing the database raises and shows the same error.
            return ""

    def _stop(self) -> None:
        self.running = False
        if self._workplace is not None:
            self._workplace.close()

    def _end(self, checksums: str | None) -> None:
        self._known = replace(self._known, checksums=checksums)
        self._stop()
        self.done.emit(self._wanted.database)

    # --- early end ---

    def _fail(self, sentence: str) -> None:
        self._known = None
        self._stop()
        self.failed.emit(sentence)

    def _break(self, report: str) -> None:
        self._known = None
        self._stop()
        self.broke.emit(report)

    def _cancel(self) -> None:
        self._known = None
        self._stop()
        self.canceled.emit()

    def _show_progress(self, percent: float) -> None:
        self.progressed.emit(self._first_percent + percent * _RASTERIZED_PERCENT / 100)


def _layer_of(places: list[QgsRectangle], crs: QgsCoordinateReferenceSystem) -> QgsVectorLayer:
    layer = QgsVectorLayer("Polygon", "changed", "memory")
    layer.setCrs(crs)
    features = []
    for place in places:
        feature = QgsFeature()
        feature.setGeometry(QgsGeometry.fromRect(place))
        features.append(feature)
    layer.dataProvider().addFeatures(features)
    return layer
