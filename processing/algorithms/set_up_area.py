"""semref:setuparea: from a map and photos to a reference database, a model and the photos' positions."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingFeedback,
    QgsProcessingMultiStepFeedback,
    QgsProcessingOutputFile,
    QgsProcessingOutputHtml,
    QgsProcessingOutputVectorLayer,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsProcessingUtils,
    QgsRasterLayer,
    QgsVectorLayer,
)

from ...core.errors import ModelError, ParameterError
from ...core.localization import Status
from ...storage.atomic_output import make_folder
from ..base import parameters
from ..base.algorithm import LOCALIZATION, Declared, SemRefAlgorithm, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.shipped_models import PHOTO_MODEL
from ..base.values import Values
from ..compat import DOUBLE, SOURCE_FILE, SOURCE_LINE, SOURCE_POLYGON
from ..jobs.area_steps import (
    CAMERAS_FILE,
    DATABASE_FILE,
    EXPECTED_FILE,
    GEOREFERENCE,
    MODEL_FILE,
    POSITIONS_FILE,
    RULES_FILE,
    TRAIN,
    AreaRun,
    steps_of,
)
from ..jobs.chain import Record, Step
from ..jobs.photo_source import drawn_file
from ..layers.results_file import TABLES
from ..translation import tr
from .classify_openstreetmap import LINES_OF_OSM, POLYGONS_OF_OSM, RULES_PATH

if TYPE_CHECKING:
    from ...core.segmentation.model_card import ModelCard
    from ..jobs.area_setup import AreaSetup

REPORT_FILE = "report.html"

LEAST_PLACED = 3
"""Photos with a position that can be the imagery of a training."""


class SetUpArea(SemRefAlgorithm):
    ID = "setuparea"
    TITLE = "Set up an area"
    GROUP = LOCALIZATION
    TAGS = ("start", "wizard", "assistant", "photos", "drone", "openstreetmap", "train", "database", "positions")
    SUMMARY = (
        "Finds the positions of photos on a map in one run: it builds a reference database, optionally trains the "
        "model on imagery of the area, assesses how many photos can be expected to get a position, and localizes "
        "the photos.\n\nSemRef derives pixel size, window size, "
        "stride and minimum area from the map and the photos, and shows them in the log before it starts. Each "
        "file in the folder is usable by itself. To continue a canceled run, run it again with the same values."
    )

    ANNOTATION = "ANNOTATION"
    LINES = "LINES"
    PHOTOS = "PHOTOS"
    PHOTO_WIDTH = "PHOTO_WIDTH"
    FLIGHT = "FLIGHT"
    IMAGERY = "IMAGERY"
    MINUTES = "MINUTES"
    FOLDER = "FOLDER"
    TRAINED_MODEL = "TRAINED_MODEL"
    POSITIONS = "POSITIONS"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterMultipleLayers(self.PHOTOS, "Photos", layerType=SOURCE_FILE, optional=True),
                "Photos, or folders with photos. Without photos, only the database and the model are made.",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.PHOTO_WIDTH, "Ground width of a photo (m)", DOUBLE, optional=True, minValue=1.0
                ),
                "Width of the ground that a typical photo shows, for example 150. If not set, height and focal "
                "length of the camera give it, or the pixels of the imagery.",
            ),
            with_help(
                QgsProcessingParameterBoolean(self.FLIGHT, "These images are one flight", False),
                "Compute all positions together, in the order of the images’ times, or of their names if there are no "
                "times. Images without a position of their own get one from the flight.",
            ),
            with_help(
                QgsProcessingParameterFeatureSource(self.ANNOTATION, "Map", types=[SOURCE_POLYGON]),
                "Polygon layer: land cover, OpenStreetMap (layer with tags, or an extract such as .osm.pbf), or "
                "buildings only.",
            ),
            with_help(
                QgsProcessingParameterField(
                    self.CLASS_FIELD, "Class field", parentLayerParameterName=self.ANNOTATION, optional=True
                ),
                "Field with the class of each polygon. If not set, SemRef guesses it, or uses the tags of "
                "OpenStreetMap. In a layer without either, all polygons are buildings.",
            ),
            with_help(
                QgsProcessingParameterFeatureSource(
                    self.LINES, "OpenStreetMap lines", types=[SOURCE_LINE], optional=True
                ),
                "Roads, railways, rivers and streams as lines: layer with OpenStreetMap tags, or the extract. Only "
                "models with a class road or water use them.",
            ),
            with_help(
                QgsProcessingParameterRasterLayer(self.IMAGERY, "Imagery", optional=True),
                "Orthophoto, or layer of map tiles, on which the model is trained. The license of map tiles must "
                "allow this. If not set, the model is trained on the photos that get a position.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.MINUTES, "Training (minutes)", DOUBLE, 0.0, minValue=0.0),
                "Duration of the training. 0 means that the model is used as it is.",
            ),
            parameters.model(
                "Model to use as it is, or to start the training from. If not set, the one of SemRef.", True
            ),
            with_help(
                QgsProcessingParameterExtent(self.EXTENT, "Extent", optional=True),
                "Ground of the database. If not set, the ground around the photos’ GPS positions, or the whole map.",
            ),
            with_help(
                QgsProcessingParameterFile(
                    self.FOLDER, "Folder for the results", behavior=QgsProcessingParameterFile.Folder
                ),
                "Folder for all files. Existing files that this algorithm did not make are never replaced.",
            ),
            QgsProcessingOutputFile(self.DATABASE, "Reference database"),
            QgsProcessingOutputFile(self.TRAINED_MODEL, "Model"),
            QgsProcessingOutputVectorLayer(self.POSITIONS, "Positions"),
            (QgsProcessingOutputFile if self._reports_as_files else QgsProcessingOutputHtml)(self.REPORT, tr("Report")),
        )

    def check(self, values: Values) -> None:
        from ..packages.training_environment import training_python

        if self._trains(values):
            if not (values.has(self.IMAGERY) or values.files(self.PHOTOS)):
                raise ParameterError(
                    "Training needs imagery or photos. Select one of them, or set the training to 0 minutes."
                )
            training_python()
        if not (self._model(values) or self._trains_on_imagery(values)):
            raise ModelError("SemRef has no model for this. Select a model, or train one on imagery.")

    def _trains(self, values: Values) -> bool:
        return values.number(self.MINUTES) > 0

    def _trains_on_imagery(self, values: Values) -> bool:
        """Return whether the model is trained on imagery; otherwise it must localize photos first."""
        return self._trains(values) and values.has(self.IMAGERY)

    def _model(self, values: Values) -> str:
        """Return the model of the user or of SemRef; empty without one."""
        return values.file(self.MODEL) or (str(PHOTO_MODEL) if PHOTO_MODEL.is_file() else "")

    # --- before any work ---

    def read_layers(self, values: Values) -> None:
        from ...storage.training_ground import frame_of
        from ...storage.training_tiles import ImageBands
        from ..jobs.area_map import AreaMap
        from ..layers.rendering import drawable, needs_drawing
        from ..layers.training_ground import require_common_ground

        polygons = self._layer(values, self.ANNOTATION, POLYGONS_OF_OSM)
        self._map = AreaMap(polygons, values.raw(self.ANNOTATION), values.text(self.CLASS_FIELD))
        if values.has(self.LINES):
            lines = self._layer(values, self.LINES, LINES_OF_OSM)
            self._map.add_lines(lines, values.raw(self.LINES), values.transform_context)
        self._imagery, self._imagery_pixel_m, self._drawn = "", None, None
        imagery = values.raster(self.IMAGERY) if values.has(self.IMAGERY) else None
        if values.has(self.IMAGERY) and imagery is None:
            raise ParameterError("The imagery can't be read. Choose an orthophoto or a layer of map tiles.")
        if imagery is None:
            return
        self._imagery = imagery.source()
        if needs_drawing(imagery):
            self._drawn = drawable(imagery) if self._trains(values) else None
            return
        if self._trains(values):
            # Here, because the training begins when the database is built.
            ImageBands(self._imagery)
            frame_of(values.image(self.IMAGERY).file)
        self._imagery_pixel_m = _pixel_m(imagery)
        require_common_ground(imagery, self._map.name, self._map.extent, self._map.crs, values.transform_context)

    def _layer(self, values: Values, key: str, layer_of_osm: str) -> QgsVectorLayer | None:
        """Return a layer of polygons or lines; of an OpenStreetMap extract, its layer with this name."""
        path = values.raw(key)
        layer = layer_of_extract(path, layer_of_osm) if isinstance(path, str) else None
        return layer or values.vector(key)

    def read(self, values: Values, feedback: QgsProcessingFeedback) -> AreaSetup:
        """Return what the map and the photos need, after ``read_layers``; for any thread. Raises SemRefError."""
        from ...storage.text_tables import read_rules
        from ..jobs.area_setup import read_area, read_photos
        from ..layers.rendering import plan_drawing

        feedback.setProgressText(tr("Reading the photos and the map"))
        width_m = values.optional_number(self.PHOTO_WIDTH)
        context, imagery_m = values.transform_context, self._imagery_pixel_m
        whole_map = self._map.degrees(context)
        photos = read_photos(values.files(self.PHOTOS), width_m, imagery_m, whole_map, feedback)
        given = values.extent_as_given(self.EXTENT)
        rules, known = read_rules(str(RULES_PATH)), self._known(values)
        of_lines = {name.casefold() for name in rules.for_lines.classes}
        if self._map.lines is not None and known and of_lines.isdisjoint(known):
            raise ParameterError(
                "The model has none of the classes of lines, {classes}. Choose another model, or leave out the lines.",
                classes=sorted(of_lines),
            )
        pixel_m = None
        if self._trains(values):
            pixel_m = imagery_m if values.has(self.IMAGERY) else photos.pixel_m
        area = read_area(self._map, photos, given, rules, known, pixel_m, context, feedback)
        if self._drawn is not None:
            # Refuses imagery with too many pixels before any work.
            plan_drawing(self._drawn, area.extent, area.crs, _resolution_m(area), context)
            terms = tr("“{layer}” is drawn for the training. Check that its provider permits this use.")
            area = replace(area, warnings=(*area.warnings, terms.format(layer=self._drawn.name())))
        if self._trains(values) and not values.has(self.IMAGERY):
            text = tr("The model is trained on the photos that get a position.")
            area = replace(area, warnings=(*area.warnings, text))
        return area

    def _card(self, values: Values) -> ModelCard | None:
        """Return the card of the model; None without a model, or if it is neither used as it is nor to start from."""
        from ...core.segmentation.model_card import read_card

        path = self._model(values)
        card = read_card(path) if path else None
        if card is None or (self._trains_on_imagery(values) and not card.can_be_base):
            return None
        if card.fault is not None:
            raise ModelError(card.fault)
        return card

    def _known(self, values: Values) -> list[str]:
        """Return the classes that the map is limited to: those of the model; empty for all classes of the map."""
        card = self._card(values)
        is_limited = card is not None and (self._map.has_tags or not self._trains_on_imagery(values))
        return [name.casefold() for name in card.classes] if is_limited else []

    # --- work ---

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, Any]:
        area = self.read(values, feedback)
        feedback.pushInfo(area.summary(values.number(self.MINUTES)))
        for warning in area.warnings:
            feedback.pushWarning(warning)
        folder = Path(values.file(self.FOLDER)).absolute()
        if values.file(self.FOLDER) == QgsProcessing.TEMPORARY_OUTPUT:
            folder = Path(QgsProcessingUtils.generateTempFilename("area"))
        make_folder(folder)
        steps = steps_of(self._area_run(values, area, folder))
        with Record(folder, self._inputs(values, area)) as record:
            for step in steps:
                record.require_free(step)
                if not record.has(step):
                    step.require_possible(values.context)
            record.require_own(REPORT_FILE)
            progress = QgsProcessingMultiStepFeedback(len(steps), feedback)
            for number, step in enumerate(steps):
                check_canceled(feedback)
                progress.setCurrentStep(number)
                if record.has(step):
                    feedback.pushInfo(tr("{file} is complete and is used again.").format(file=folder / step.files[0]))
                    continue
                feedback.setProgressText(step.text)
                step.run(self._prepare(values, area, step, record, feedback), values.context, progress)
                record.add(step)
            return self._report(values, area, folder, record, feedback)

    def _area_run(self, values: Values, area: AreaSetup, folder: Path) -> AreaRun:
        base, known = self._card(values), self._known(values)
        classes = {name.casefold() for name in area.classes}
        is_fitting = base is not None and base.can_be_base and (known or classes <= {*map(str.casefold, base.classes)})
        return AreaRun(
            self._map,
            area,
            folder,
            known,
            self._model(values),
            base.file if is_fitting else None,
            self._imagery,
            values.number(self.MINUTES),
            values.switch(self.FLIGHT),
        )

    def _prepare(
        self, values: Values, area: AreaSetup, step: Step, record: Record, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        """Write the small files that a step reads, and draw imagery that is not a file; return values to replace.

        Raises:
            ParameterError: Too few photos have a position for the training.
        """
        from ..jobs.area_setup import camera_table

        if step.values.get("RULES"):
            record.write(RULES_FILE, rules_of(self._known(values)))
        if step.values.get("ATTITUDE"):
            record.write(CAMERAS_FILE, camera_table(area.photos))
        if step.algorithm == GEOREFERENCE:
            rows = QgsVectorLayer(step.values["POSITIONS"], "", "ogr").getFeatures()
            count = sum(row["status"] == Status.FIX for row in rows)
            if count < LEAST_PLACED:
                raise ParameterError(
                    "{count} of {all} photos have a position, too few to train on. Select imagery, or set the training "
                    "to 0 minutes.",
                    count=count,
                    all=len(area.photos.files),
                )
        if step.algorithm != TRAIN or self._drawn is None:
            return {}
        ground, context = (area.extent, area.crs), values.transform_context
        return {"IMAGE": drawn_file(self._drawn, ground, _resolution_m(area), context, feedback)[0], "RESOLUTION": None}

    def _inputs(self, values: Values, area: AreaSetup) -> list[Any]:
        """Return what identifies the user's files; a file counts as changed if its size or time changed."""
        from ...storage.file_states import state

        files = [self._imagery, self._model(values), *area.photos.files]
        # The resolution of the training is a parameter of its steps; the other files are the same without training.
        plan = str(replace(area.plan, resolution_cm=None))
        return [area.digest, area.extent.toString(3), plan, [(path, *state(path)) for path in files if path]]

    def _report(
        self, values: Values, area: AreaSetup, folder: Path, record: Record, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        from ..reports.setup_report import PhotoRow, expectation_of, setup_html

        squares = QgsVectorLayer(str(folder / EXPECTED_FILE), "", "ogr").getFeatures()
        expected = expectation_of([(one["success"], one["objects"], one["reason"] or "") for one in squares])
        feedback.pushInfo(expected.sentence())
        rows, positions = [], f"{folder / POSITIONS_FILE}|layername={TABLES[0]}"
        if area.photos.files:
            for one in QgsVectorLayer(positions, "", "ogr").getFeatures():
                texts = (str(one[name] or "") for name in ("image", "status", "reason"))
                rows.append(PhotoRow(*texts, None if not one["error_95"] else float(one["error_95"])))
        summary = area.summary(values.number(self.MINUTES))
        record.write(REPORT_FILE, setup_html(summary, area.warnings, expected, rows))
        results = {self.DATABASE: str(folder / DATABASE_FILE), self.REPORT: str(folder / REPORT_FILE)}
        results[self.TRAINED_MODEL] = str(folder / MODEL_FILE) if self._trains(values) else self._model(values)
        return {**results, **({self.POSITIONS: positions} if rows else {})}


def layer_of_extract(path: str, layer_of_osm: str) -> QgsVectorLayer | None:
    """Return the layer of an OpenStreetMap extract with this name; None for other files."""
    layer = QgsVectorLayer(f"{path}|layername={layer_of_osm}", Path(path).stem, "ogr") if os.path.isfile(path) else None
    return layer if layer is not None and layer.isValid() else None


def rules_of(known: Sequence[str]) -> str:
    """Return the rules of OpenStreetMap for these classes only; other ground becomes class “other”."""
    header, *lines = RULES_PATH.read_text(encoding="utf-8").splitlines()
    kept = [line for line in lines if not line.split(",")[2] or line.split(",")[2].casefold() in known]
    return "\n".join([header, *kept, ""])


def _resolution_m(area: AreaSetup) -> float:
    """Return the pixel size of imagery that is drawn for the training."""
    return (area.plan.resolution_cm or 100 * area.plan.pixel_size_m) / 100


def _pixel_m(layer: QgsRasterLayer) -> float | None:
    """Return the pixel size of a raster file in m; None without a georeference."""
    from ..layers.layer_inputs import stated_pixel_size_m

    found = stated_pixel_size_m(layer.source())
    return None if found is None else found[0]
