"""semref:trainmodel: train a segmentation network on an orthophoto and a land-cover layer."""

from __future__ import annotations

import json
import os
import time
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
)

from ...core.errors import ImageError, ParameterError
from ..base import parameters
from ..base.algorithm import Canceled, Declared, follow
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import DOUBLE, INTEGER
from ..jobs.annotation import AnnotationAlgorithm
from ..jobs.photo_source import PhotoSource
from ..translation import tr

if TYPE_CHECKING:
    from ...storage.label_maps import RasterFile
    from ...training.job import Job
    from ..jobs.training_run import TrainingRun
    from ..layers.training_ground import TrainingGround
    from ..reports.training_report import TrainingReport

CUT, TRAINED = 1.0, 100.0
"""Progress in percent after the tiles are cut (too little for an estimate), and after the model is written."""

SHORTEST_SHARE = 0.2
"""Share of the time limit that the training gets, however long reading and cutting take."""

LITE0_NETWORK, SMALL_NETWORK = range(2)
UNKNOWN, SOMETHING_ELSE = range(2)

LIGHT = 1.5
"""Variation of light and color during training: photos come from other cameras and days than the orthophoto
(tools/training/train_dubai.py)."""


class TrainModel(AnnotationAlgorithm):
    ID = "trainmodel"
    TITLE = "Train model"
    TAGS = ("training", "segmentation", "network", "deep learning", "onnx", "torch", "fine-tune", "land cover")
    SUMMARY = (
        "Trains a segmentation model (ONNX) on an orthophoto and a land-cover layer or label map of the same ground. "
        "Part of the ground is set aside to test the model.\n\nTraining needs the training environment: install it "
        "under Settings ▸ Options ▸ SemRef. To continue a canceled run, run it again with the same output."
    )

    IMAGE = "IMAGE"
    UNLABELED = "UNLABELED"
    BASE_MODEL = "BASE_MODEL"
    MINUTES = "MINUTES"
    EPOCHS = "EPOCHS"
    PATIENCE = "PATIENCE"
    NETWORK = "NETWORK"
    RESUME = "RESUME"
    SEED = "SEED"
    MEAN_IOU = "MEAN_IOU"

    _has_single_class = False

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterRasterLayer(self.IMAGE, "Orthophoto"),
                "Georeferenced aerial image with 8 or 16 bits. Red, green and blue are used. QGIS draws map tiles "
                "and web maps; they need an extent and a resolution.",
                widget="PhotoWidget",
            ),
            *parameters.annotation(optional=True),
            parameters.label_map(
                "Raster of class values for the same ground, instead of a land-cover layer; 0 where the class is "
                "unknown.",
                optional=True,
            ),
            with_help(
                QgsProcessingParameterEnum(
                    self.UNLABELED,
                    "Ground without a label",
                    options=(tr("is unknown"), tr("is class “other”")),
                    defaultValue=UNKNOWN,
                ),
                "“is unknown” excludes this ground from training. Select the second choice only if all areas of "
                "the classes were drawn, and set an extent without undrawn ground. SemRef always uses class "
                "“other” for a layer with a single class, such as buildings.",
            ),
            with_help(
                QgsProcessingParameterFile(
                    self.BASE_MODEL,
                    "Base model",
                    fileFilter=tr("Models that SemRef trained (*.onnx *.pt)"),
                    optional=True,
                ),
                "Model that was trained with SemRef and is trained further. Its classes are matched by name.",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.MINUTES, "Time limit (minutes)", DOUBLE, 30, optional=True, minValue=0
                ),
                "Time from the start until the model is written. 10 minutes are enough for a test, 60 minutes "
                "give a better model. 0 means no limit.",
            ),
            parameters.resolution(
                "Pixel size for training, if it differs from the image. The smallest buildings should be about 14 "
                "pixels wide. Larger pixels train faster.",
                advanced=False,
            ),
            parameters.extent(),
            with_help(
                QgsProcessingParameterNumber(self.EPOCHS, "Epochs", INTEGER, 200, minValue=1),
                "Maximum number of passes over the training tiles. The time limit may end training earlier.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterNumber(self.PATIENCE, "Patience (epochs)", INTEGER, 30, minValue=0),
                "Training stops if the result on the ground set aside has not improved for this number of epochs. "
                "0 means never.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterEnum(
                    self.NETWORK,
                    "Network",
                    options=(tr("EfficientNet-Lite0, pretrained on photos"), tr("Small, not pretrained")),
                    defaultValue=LITE0_NETWORK,
                ),
                "Network that is trained if there is no base model. The small network trains faster, but has "
                "learned nothing before.",
                advanced=True,
            ),
            parameters.validation_fraction(advanced=True),
            with_help(
                QgsProcessingParameterBoolean(self.RESUME, "Continue a canceled run", defaultValue=True),
                "A canceled run with the same output and settings is continued. Otherwise training starts from "
                "the beginning.",
                advanced=True,
            ),
            parameters.python_of_training(),
            parameters.seed(default=1671),
            with_help(
                QgsProcessingParameterFileDestination(self.OUTPUT, "Model", fileFilter=tr("ONNX models (*.onnx)")),
                "ONNX file. During training a folder beside it contains the state that a canceled run needs to "
                "continue.",
            ),
            parameters.report("Page with the IoU of each class, confusion matrix, learning curves and examples."),
            QgsProcessingOutputNumber(self.MEAN_IOU, "Mean IoU"),
            parameters.mask(),
        )

    # --- before any work ---

    def check(self, values: Values) -> None:
        from ..packages.training_environment import training_python

        if values.has(self.INPUT) == values.has(self.LABELS):
            raise ParameterError("Select either a land-cover layer or a label map.")
        super().check(values)
        training_python(values.file(self.PYTHON))

    def read_layers(self, values: Values) -> None:
        from ..layers.areas import drawn_area
        from ..layers.rendering import needs_drawing
        from ..layers.training_ground import named_layer, require_common_ground

        image = values.raster(self.IMAGE)
        self._area = drawn_area(values.source(self.MASK))
        self._photo = PhotoSource(values, self.IMAGE, self.EXTENT, self._area) if needs_drawing(image) else None
        if self._photo is not None and not values.has(self.RESOLUTION):
            raise ImageError("“{layer}” has no resolution of its own. Enter a resolution.", layer=image.name())
        self._image = values.image(self.IMAGE) if self._photo is None else named_layer(image)
        self._image_extent, self._labels = image.extent(), None
        if values.has(self.INPUT):
            super().read_layers(values)
            other = self._source.name, self._source.extent, self._source.crs
        else:
            self._labels, labels = values.label_map(self.LABELS), values.raster(self.LABELS)
            other = labels.name(), labels.extent(), labels.crs()
        require_common_ground(image, *other, values.transform_context)

    # --- work ---

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, float]:
        from ..jobs.training_process import require_training
        from ..jobs.training_run import CanceledKeeping, TrainingRun
        from ..packages.training_environment import training_python

        began = time.monotonic()
        python = training_python(values.file(self.PYTHON))
        self._count_classes(values, feedback)
        feedback.setProgressText(tr("Starting the training environment"))
        ready = require_training(python, feedback)
        text = tr("{python}: torch {version} on {device}")
        feedback.pushInfo(text.format(python=python, version=ready["torch"], device=ready["device"]))
        with outputs.file(self.OUTPUT) as temporary:
            self._training = run = TrainingRun(values.target(self.OUTPUT), values.switch(self.RESUME))
            try:
                report = self._train(values, python, temporary, run, began, feedback)
            except Canceled:
                if run.can_go_on:
                    raise CanceledKeeping(run.folder) from None
                raise
        if values.has(self.REPORT):
            outputs.text(self.REPORT, report.html())
        return {} if report.mean_iou is None else {self.MEAN_IOU: report.mean_iou}

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        self._training: TrainingRun | None = None
        try:
            results = super().processAlgorithm(parameters, context, feedback)
            # Remove the run only when the model is in its place: if it cannot be moved there, the training is not lost.
            self._training.clear()
            return results
        finally:
            # Not before: a full disk is recognized while it is full.
            if self._training is not None:
                self._training.close()

    def _count_classes(self, values: Values, feedback: QgsProcessingFeedback) -> None:
        """Make ground without a polygon class “other” in a layer with a single class, as in “Rasterize land-cover
        layer”.
        """
        if self._labels is not None or not self._is_rest_unknown(values):
            return
        if sum(bool(one.value) for one in self.classes(values, feedback).table) == 1:
            feedback.pushInfo(tr("The layer has a single class. Ground without a polygon becomes class “other”."))
            self._has_single_class = True

    def _is_rest_unknown(self, values: Values) -> bool:
        """Return whether ground without a label is excluded from training."""
        return values.choice(self.UNLABELED) == UNKNOWN and not self._has_single_class

    def _train(
        self, values: Values, python: str, target: str, run: TrainingRun, began: float, feedback: QgsProcessingFeedback
    ) -> TrainingReport:
        """Cut the tiles, train, write the model, and return the report."""
        from ...training.job import EXAMPLES, JOB, RESULT
        from ..jobs.training_process import ended_silently, run_training
        from ..reports.training_report import TrainingReport

        job = self._job(values, target, run)
        job = run.begin(job)
        if not run.tiles.is_dir():
            ground = self._ground(values, feedback)
            image = ground.image(run.folder)
            self._cut(values, image, ground, run, feedback)
            base = {"base_model": os.path.basename(job.base_model)} if job.base_model else {}
            job = replace(job, ground={**ground.metadata(image), **base})
        passed = (time.monotonic() - began) / (60 * job.minutes) if job.minutes else 0.0
        job = replace(job, minutes=job.minutes * max(1 - passed, SHORTEST_SHARE))
        job.write(run.folder / JOB)
        begun = max(CUT, TRAINED * min(passed, 1 - SHORTEST_SHARE))
        run_training(python, [str(run.folder / JOB)], feedback, begun, TRAINED)
        try:
            result = json.loads((run.folder / RESULT).read_text(encoding="utf-8"))
        except (OSError, ValueError) as error:
            raise ended_silently(python, error) from None
        examples = [path.read_bytes() for path in sorted((run.folder / EXAMPLES).glob("*.png"))]
        return TrainingReport(os.path.basename(values.target(self.OUTPUT)), result, job.ground, examples)

    def _job(self, values: Values, target: str, run: TrainingRun) -> Job:
        from ...training.job import LITE0, PACKAGED, SMALL, Job

        is_small = values.choice(self.NETWORK) == SMALL_NETWORK
        return Job(
            (str(run.tiles),),
            target,
            str(run.folder),
            values.file(self.BASE_MODEL),
            encoder=SMALL if is_small else LITE0,
            encoder_weights="" if is_small else PACKAGED,
            learn_unlabeled=not self._is_rest_unknown(values),
            epochs=values.integer(self.EPOCHS),
            light=LIGHT,
            patience=values.integer(self.PATIENCE),
            minutes=values.optional_number(self.MINUTES) or 0.0,
            seed=values.integer(self.SEED),
            resume=True,
            fingerprint=self._fingerprint(values),
        )

    def _fingerprint(self, values: Values) -> dict:
        """Return what identifies the ground and settings of a canceled run."""
        from ...storage.file_states import state

        extent, table = values.extent(self.EXTENT, self._image.crs), values.file(self.CLASS_TABLE)
        found = {
            "image": [self._image.path, *state(self._image.path)],
            "extent": "" if extent.isEmpty() else extent.toString(3),
            "resolution": values.optional_number(self.RESOLUTION),
            "validation": values.number(self.VALIDATION_FRACTION),
            "table": [table, *state(table)],
        }
        if self._area is not None:
            found["mask"] = self._area.fingerprint
        if self._labels is not None:
            return {**found, "labels": [self._labels.path, *state(self._labels.path)]}
        source = self._source
        # The priority field counts only if it is set, so that runs that were canceled before it existed continue.
        fields = filter(None, (values.text(key) for key in (self.CLASS_FIELD, self.PRIORITY_FIELD, self.CLASS)))
        return {**found, "labels": [source.name, source.count, source.extent.toString(3), *fields]}

    def _ground(self, values: Values, feedback: QgsProcessingFeedback) -> TrainingGround:
        """Return the part of the image to train on; a layer that is not a file is drawn first."""
        from ..layers.training_ground import TrainingGround, open_drawing

        layer, extent = self._image, self._image_extent
        resolution_cm = values.optional_number(self.RESOLUTION)
        resolution_m = None if resolution_cm is None else resolution_cm / 100
        if self._photo is not None:
            layer, extent = open_drawing(self._photo.file(resolution_m, feedback))
            resolution_m = None
        drawn = None
        if self._labels is None and not self._is_rest_unknown(values):
            # Outside the drawn polygons it is unknown whether the ground is class “other”.
            drawn = self._source.extent, self._source.crs
        labels = self._source.name if self._labels is None else os.path.basename(self._labels.path)
        return TrainingGround(
            layer,
            extent,
            os.path.basename(self._image.path),
            labels,
            resolution_m,
            values.extent(self.EXTENT, layer.crs),
            drawn,
            values.transform_context,
            self._area,
        )

    def _cut(
        self,
        values: Values,
        image: RasterFile,
        ground: TrainingGround,
        run: TrainingRun,
        feedback: QgsProcessingFeedback,
    ) -> None:
        from ...core.labels.training_tiles import TRAIN, VALIDATION, fitting_tiles
        from ...storage.rasterize import burn_label_map
        from ...storage.training_ground import frame_of
        from ...storage.training_tiles import ImageBands, TileExport
        from ..layers.training_ground import require_two_classes

        table = values.class_table(self.CLASS_TABLE)
        if self._labels is None:
            frame = frame_of(image)
            polygons, table = self.burn_polygons(values, feedback, ground.crs, CUT / 4)
            burnt = str(run.folder / "labels.tif")
            follow(burn_label_map(burnt, frame, table, polygons), feedback, CUT / 4, CUT / 2)
        labels = replace(image, path=burnt) if self._labels is None else self._labels.file
        size, stride = fitting_tiles(ImageBands(image.path).shape_hw)
        fraction = values.number(self.VALIDATION_FRACTION)
        is_unknown = self._is_rest_unknown(values)
        require = require_two_classes if is_unknown else None
        export = TileExport(image, labels, size, stride, fraction, ground.mask(image), not is_unknown, require)
        with run.new_tiles() as folder:
            counts = follow(export.write(folder, table), feedback, CUT / 2, CUT)
        text = tr("{training} training tiles, {validation} validation tiles")
        feedback.pushInfo(text.format(training=counts[TRAIN], validation=counts[VALIDATION]))
