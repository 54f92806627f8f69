"""semref:comparelabels: compare a predicted label map with an annotated one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
)

from ...core.errors import ParameterError
from ...core.values import schema
from ..base import parameters
from ..base.algorithm import ANNOTATION, Declared, SemRefAlgorithm, check_canceled, follow
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import DOUBLE, POLYGON, SOURCE_POLYGON
from ..jobs.annotation import geometry_of
from ..translation import tr

if TYPE_CHECKING:
    import numpy as np

    from ...core.labels.comparison import ClassMatch, LabelComparison
    from ...storage.label_comparison import DisagreementMap, LabelMapPair
    from ..reports.comparison_report import MeasuredShifts

FIELDS = schema(
    "rank integer, annotated_class text, predicted_class text, area real, annotated_value integer, "
    "predicted_value integer"
)


class CompareLabels(SemRefAlgorithm):
    ID = "comparelabels"
    TITLE = "Compare label maps"
    GROUP = ANNOTATION
    TAGS = ("confusion matrix", "iou", "accuracy", "validation", "disagreement", "segmentation", "label map")
    SUMMARY = (
        "Compares a predicted label map with an annotated one: confusion matrix, IoU of each class, overall "
        "accuracy, and polygons of the disagreements.\n\nClasses are matched by name, otherwise by value. Pixels "
        "without prediction count as wrong. The class offset (the distance by which the model shows a class off "
        "its position) can be saved in a copy of the model.\n\nFor label maps of two dates, the log and the report "
        "show how far landmarks moved: the map accuracy for “Build reference database”."
    )

    REFERENCE = "REFERENCE"
    PREDICTED = "PREDICTED"
    DISAGREEMENTS = "DISAGREEMENTS"
    SUN_DIRECTION, MODEL_OUTPUT = parameters.SUN_DIRECTION, "MODEL_OUTPUT"
    MEAN_IOU = "MEAN_IOU"
    OVERALL_ACCURACY = "OVERALL_ACCURACY"
    MAP_ACCURACY = "MAP_ACCURACY"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterRasterLayer(self.REFERENCE, "Annotated label map"),
                "Label map that is correct, for example from “Rasterize land-cover layer”.",
            ),
            with_help(
                QgsProcessingParameterRasterLayer(self.PREDICTED, "Predicted label map"),
                "Label map to check, for example from “Segment image”. It must have the CRS of the annotated map.",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.MINIMUM_AREA, "Minimum area", DOUBLE, 10.0, optional=True, minValue=0.0
                ),
                "Disagreements and landmarks smaller than this area are not counted, in square map units (square "
                "pixels without a georeference).",
            ),
            with_help(
                QgsProcessingParameterFeatureSink(self.DISAGREEMENTS, "Disagreements", type=SOURCE_POLYGON),
                "One polygon for each connected area where the same two classes are confused, ranked by area.",
            ),
            parameters.report(
                "Page with the confusion matrix, the accuracy of each class, and the missed, spurious and mislabeled "
                "landmarks. “Assess reference database”, “Assess route” and “Evaluate localization” can read it.",
                by_default=False,
            ),
            parameters.model(
                "Model that made the predicted map. Select it to save the class offset in a copy of the model.",
                optional=True,
            ),
            parameters.sun_direction(
                "Azimuth of the sun when the predicted image was taken, in degrees clockwise from grid north. A "
                "class offset that shadows cause turns with the sun. If not set, the offset is the same for all "
                "directions of the sun."
            ),
            with_help(
                QgsProcessingParameterFileDestination(
                    self.MODEL_OUTPUT,
                    "Model with class offset",
                    fileFilter=tr("ONNX models (*.onnx)"),
                    optional=True,
                    createByDefault=False,
                ),
                "Copy of the model with the class offset, in meters, in its metadata.",
            ),
            QgsProcessingOutputNumber(self.MEAN_IOU, "Mean IoU"),
            QgsProcessingOutputNumber(self.OVERALL_ACCURACY, "Overall accuracy"),
            QgsProcessingOutputNumber(self.MAP_ACCURACY, "Map accuracy"),
        )

    def read_layers(self, values: Values) -> None:
        self._layers = [values.label_map(key) for key in (self.REFERENCE, self.PREDICTED)]

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, float]:
        from ...core.labels.comparison import LabelComparison
        from ...storage.label_comparison import DisagreementMap, LabelMapPair
        from ..jobs.compared_landmarks import log_shifts, measure_errors, measure_shifts
        from ..layers.layer_inputs import require_one_crs
        from ..reports.comparison_report import comparison_html

        require_one_crs(*self._layers)
        if values.has(self.MODEL_OUTPUT) and not values.file(self.MODEL):
            raise ParameterError("“Model with class offset” is a copy of the model. Select the model as well.")
        paths = [layer.path for layer in self._layers]
        pair = LabelMapPair(*paths)
        match = self._match(pair, feedback)
        with DisagreementMap(pair) as disagreements:
            feedback.setProgressText(tr("Comparing"))
            comparison = LabelComparison(self._count(pair, match, disagreements, feedback))
            polygons = follow(disagreements.polygons(values.number(self.MINIMUM_AREA)), feedback, 40, 96)
        feedback.setProgressText(tr("Comparing landmarks"))
        shifts = measure_shifts(pair, match, comparison, self._layers[0].crs, feedback)
        if values.has(self.REPORT):
            errors = measure_errors(pair, match, comparison, shifts, values.number(self.MINIMUM_AREA), feedback)
            outputs.text(self.REPORT, comparison_html(comparison, match, shifts, errors, *paths))
        self._write_model(values, outputs, shifts)
        self._write(outputs, polygons, match)
        feedback.pushInfo(tr("{count} areas disagree.").format(count=len(polygons)))
        _log(comparison, match, feedback)
        log_shifts(shifts, feedback)
        figures = {self.MEAN_IOU: comparison.mean_iou, self.OVERALL_ACCURACY: comparison.overall_accuracy}
        if shifts.displacement is not None:
            figures[self.MAP_ACCURACY] = shifts.displacement.deviation
        return figures

    def _write_model(self, values: Values, outputs: Outputs, shifts: MeasuredShifts) -> None:
        from ..jobs.compared_landmarks import model_with_biases

        if values.has(self.MODEL_OUTPUT):
            sun_deg = values.optional_number(self.SUN_DIRECTION)
            content = model_with_biases(values.file(self.MODEL), shifts, sun_deg)
            with outputs.file(self.MODEL_OUTPUT) as temporary, open(temporary, "wb") as file:
                file.write(content)

    def _match(self, pair: LabelMapPair, feedback: QgsProcessingFeedback) -> ClassMatch:
        from ...core.labels.comparison import match_classes
        from ...storage.label_maps import class_table_of_map

        maps = (pair.reference, pair.predicted)
        match = match_classes(*(class_table_of_map(labels, layer.file) for labels, layer in zip(maps, self._layers)))
        if not match.by_name:
            feedback.pushWarning(tr("The maps share no class names. Classes are matched by their values."))
        elif match.only_predicted:
            text = tr("Classes in the predicted map only: {names}.")
            feedback.pushWarning(text.format(names=", ".join(match.only_predicted)))
        return match

    def _count(
        self, pair: LabelMapPair, match: ClassMatch, disagreements: DisagreementMap, feedback: QgsProcessingFeedback
    ) -> np.ndarray:
        """Return (256, 256) counts of pixels for each pair of classes, and draw where they disagree."""
        import numpy as np

        from ...core.labels.comparison import count_pairs, disagreement_codes

        counts = np.zeros((256, 256), np.int64)
        height = pair.shape_hw[0]
        for first, annotated, predicted in pair.blocks():
            check_canceled(feedback)
            predicted = match.values[predicted]
            counts += count_pairs(annotated, predicted)
            disagreements.write_rows(first, disagreement_codes(annotated, predicted))
            feedback.setProgress(40 * (first + len(annotated)) / height)
        return counts

    def _write(self, outputs: Outputs, polygons: list[tuple[int, float, bytes]], match: ClassMatch) -> None:
        from ...core.labels.comparison import decode_disagreement

        with outputs.layer(self.DISAGREEMENTS, FIELDS, POLYGON, self._layers[0].crs, "disagreements") as sink:
            for rank, (code, area, outline) in enumerate(polygons, start=1):
                annotated, predicted = decode_disagreement(code)
                row = rank, match.name(annotated), match.name(predicted), area, annotated, predicted
                sink.add_row(geometry_of(outline), row)


def _log(comparison: LabelComparison, match: ClassMatch, feedback: QgsProcessingFeedback) -> None:
    for value in comparison.values:
        if value:
            text = tr("{name}: IoU {iou:.1%}, {pixels} annotated pixels")
            pixels = int(comparison.annotated[value])
            feedback.pushInfo(text.format(name=match.name(value), iou=comparison.iou(value), pixels=pixels))
    text = tr("Mean IoU {iou:.1%}, overall accuracy {accuracy:.1%}, {pixels} pixels.")
    feedback.pushInfo(
        text.format(iou=comparison.mean_iou, accuracy=comparison.overall_accuracy, pixels=comparison.pixels)
    )
