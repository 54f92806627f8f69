"""Update a database from a corrected land-cover layer in the background: rasterize, update, replace."""

from __future__ import annotations

import os
import traceback
from collections.abc import Generator
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Callable

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

from ...core.errors import SemRefError
from ...processing.translation import tr
from ...storage.atomic_output import Batch
from ..widgets.messages import bug_sentence
from .algorithm_run import AlgorithmRun
from .background import Reader

if TYPE_CHECKING:
    from ...processing.inspection.correction import DrawnFeature, RasterizePlan

RASTERIZE, UPDATE = "semref:rasterizeannotation", "semref:updatedatabase"

_RASTERIZED_PERCENT = 50
"""Share of rasterizing in the progress bar; the real share depends on the map."""


@dataclass(frozen=True)
class Correction:
    """Input of an update.

    Attributes:
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

    @property
    def parameters(self) -> dict[str, Any]:
        """Layer and classes as parameters of an algorithm; an id, because QGIS crashes at a layer that was removed."""
        given = {"INPUT": self.annotation.id(), "CLASS_FIELD": self.class_field, "CLASS": self.class_of_all}
        return {**given, "PRIORITY_FIELD": self.priority_field} if self.priority_field else given


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

    One update at a time. It ends with exactly one of ``done``, ``failed`` and ``canceled``.

    Attributes:
        rasterizing: Parameters of *Rasterize land-cover layer* in the last update.
        asked: Parameters of *Update reference database* in the last update.

    textChanged: current step; progressed: percent; done: path of the database; failed: a sentence for the user.
    """

    textChanged = pyqtSignal(str)
    progressed = pyqtSignal(float)
    done = pyqtSignal(str)
    failed = pyqtSignal(str)
    canceled = pyqtSignal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.running = False
        self._is_replacing = False
        self._steps: Generator[Callable, Any, str] | None = None
        self._workplace: Batch | None = None
        self._first_percent = 0
        self.rasterizing: dict[str, Any] = {}
        self.asked: dict[str, Any] = {}
        self._known: _Known | None = None
        self._reader = Reader(self)
        self._reader.answered.connect(self._go_on)
        self._run = AlgorithmRun(self)
        self._run.done.connect(lambda results, _context: self._go_on(results))
        self._run.textChanged.connect(self.textChanged)
        self._run.progressed.connect(self._show_progress)
        for part in (self._reader, self._run):
            part.failed.connect(partial(self._end_early, self.failed))
        self._run.canceled.connect(partial(self._end_early, self.canceled))

    def shut_down(self) -> None:
        """Cancel, and wait until the background thread has ended."""
        self._reader.shut_down()
        self._run.shut_down()
        self._stop()

    def start(self, wanted: Correction) -> None:
        """Start an update. The layer may be edited or removed as soon as rasterizing runs."""
        self.running = True
        self.textChanged.emit(tr("Reading the database"))
        self._steps = self._update(wanted)
        self._go_on(None)

    def cancel(self) -> None:
        """Cancel; the database does not change. While it is being replaced, it is too late."""
        if self._run.running:
            self._run.cancel()
        elif self.running and not self._is_replacing:
            self._reader.forget()
            self._end_early(self.canceled)

    def _go_on(self, answer: object) -> None:
        """Start the next step with the answer of the previous one. A bug in it ends the run."""
        try:
            begin = self._steps.send(answer)
        except StopIteration as end:
            self._stop()
            self.done.emit(end.value)
        except Exception:
            self._end_early(self.failed, bug_sentence(traceback.format_exc()))
        else:
            begin()

    def _update(self, wanted: Correction) -> Generator[Callable, Any, str]:
        """Yield functions that start the steps, and take the answers. Returns the path of the database."""
        # Imported here because they read databases, which would delay the opening of the dock.
        from ...processing.inspection.correction import LayerGround, plan_rasterizing
        from ...storage.database.undo import replace_keeping
        from ...storage.label_map_file import paste_labels

        layer, database = wanted.annotation, wanted.database
        folder = QgsProcessingUtils.generateTempFilename("correction")
        layers = [one for one in (layer, wanted.places) if one is not None and one.featureCount()]
        grounds = [LayerGround(one.name(), one.extent(), one.crs()) for one in layers]
        fields = [layer.fields().indexOf(name) for name in (wanted.class_field, wanted.priority_field)]
        features = QgsVectorLayerFeatureSource(layer), [index for index in fields if index >= 0]
        of = database, layer.id(), layer.crs(), wanted.class_field, wanted.priority_field, wanted.class_of_all
        parameters = wanted.parameters
        where = database, grounds, folder, QgsProject.instance().transformContext()
        plan = yield partial(self._reader.read, tr("Reading the database"), plan_rasterizing, *where, *features)

        part, changed = self._changed_part(plan, of)
        labels = os.path.join(folder, "labels.tif")
        self.rasterizing = {**parameters, "OUTPUT": labels, **plan.grid}
        title, self._first_percent = tr("Rasterizing the corrected layer"), 0
        parameters = self.rasterizing if part is None else {**self.rasterizing, "EXTENT": part}
        yield partial(self._run.start_algorithm, RASTERIZE, parameters, title)
        if part is not None:
            labels, rasterized = self._known.labels, labels
            yield partial(self._reader.read, title, paste_labels, labels, rasterized)
        self._known = _Known(of, plan.checksums, plan.drawn, labels)

        title, self._first_percent = tr("Updating the database"), _RASTERIZED_PERCENT
        updated = self._beside(database) or os.path.join(folder, "updated.gpkg")
        self.asked = {"DATABASE": database, "LABELS": labels, "OUTPUT": updated}
        if changed is not None:
            self.asked["CHANGED"] = changed
        yield partial(self._run.start_algorithm, UPDATE, self.asked, title)
        self._is_replacing = True
        checksums = yield partial(self._reader.read, title, replace_keeping, database, updated, plan.checksums)
        self._known = replace(self._known, checksums=checksums)
        return database

    def _changed_part(
        self, plan: RasterizePlan, of: tuple
    ) -> tuple[QgsReferencedRectangle, QgsVectorLayer] | tuple[None, None]:
        """Return the part of the map with changes since the last update, and their bounds; None for the whole map."""
        from ...processing.inspection.correction import changed_bounds, part_to_rasterize

        known, crs = self._known, of[2]
        if known is None or known.of != of or known.checksums is None or known.checksums != plan.checksums:
            return None, None
        if known.drawn is None or plan.drawn is None:
            return None, None
        changed = changed_bounds(known.drawn, plan.drawn)
        if not changed or not os.path.isfile(known.labels):
            return None, None
        part = part_to_rasterize(plan.grid, changed, crs, QgsProject.instance().transformContext())
        return (None, None) if part is None else (part, _layer_of(changed, crs))

    def _beside(self, database: str) -> str:
        """Return a path in a private folder next to the database, from where moving needs no copy; may be empty."""
        from ...storage.database.schema import TABLES

        self._workplace = Batch()
        try:
            return self._workplace.file(database, tables=TABLES)
        except SemRefError:
            # Replacing the database raises and shows the same error.
            return ""

    def _stop(self) -> None:
        self.running = self._is_replacing = False
        # The steps hold a source of the layer's features, which may keep its file open.
        self._steps = None
        if self._workplace is not None:
            self._workplace.close()

    def _end_early(self, signal, *arguments) -> None:
        self._known = None
        self._stop()
        signal.emit(*arguments)

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
