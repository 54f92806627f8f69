"""semref:comparelabels – where a prediction disagrees with the annotation, and how much."""

from __future__ import annotations

import numpy as np
from qgis.core import (
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
)

from ..compat import POLYGON, SOURCE_POLYGON
from ..framework.annotation import geometry_of
from ..framework.base import ANNOTATION, SemRefAlgorithm, check_canceled
from ..framework.sinks import Sink
from ..translation import tr

FIELDS = (
    ("rank", "integer"),
    ("annotated_class", "text"),
    ("predicted_class", "text"),
    ("area", "real"),
    ("annotated_value", "integer"),
    ("predicted_value", "integer"),
)


class CompareLabels(SemRefAlgorithm):
    ID = "comparelabels"
    GROUP = ANNOTATION
    TAGS = ("confusion matrix", "iou", "accuracy", "validation", "disagreement", "segmentation", "label map")

    REFERENCE = "REFERENCE"
    PREDICTED = "PREDICTED"
    MINIMUM_AREA = "MINIMUM_AREA"
    DISAGREEMENTS = "DISAGREEMENTS"
    REPORT = "REPORT"
    MEAN_IOU = "MEAN_IOU"
    OVERALL_ACCURACY = "OVERALL_ACCURACY"

    def title(self):
        return tr("Compare label maps")

    def summary(self):
        return tr(
            "Compares a predicted label map with an annotated one: confusion matrix, IoU of each class, overall "
            "accuracy, and the places where they disagree as polygons, the largest first.\n\n"
            "Classes are matched by name, or by value where the maps share no names. Maps of different pixel sizes are "
            "compared on the pixels of the annotated one. Pixels without annotation are left out; pixels without "
            "prediction count as wrong."
        )

    def initAlgorithm(self, config=None):
        self.offer(
            QgsProcessingParameterRasterLayer(self.REFERENCE, tr("Annotated label map")),
            tr("What is held to be true: single-band class values, for example from “Rasterize annotation”."),
        )
        self.offer(
            QgsProcessingParameterRasterLayer(self.PREDICTED, tr("Predicted label map")),
            tr("What is checked, for example from “Segment image”. It must be in the CRS of the annotated map."),
        )
        number = QgsProcessingParameterNumber
        self.offer(
            number(self.MINIMUM_AREA, tr("Minimum area"), number.Double, 10.0, True, minValue=0.0),
            tr("Smaller disagreements give no polygon; square map units, pixels without georeference."),
        )
        self.offer(
            QgsProcessingParameterFeatureSink(self.DISAGREEMENTS, tr("Disagreements"), SOURCE_POLYGON),
            tr("One polygon a connected place where the same two classes are confused, ranked by area."),
        )
        self.offer(
            QgsProcessingParameterFileDestination(
                self.REPORT, tr("Report"), tr("HTML files (*.html)"), optional=True, createByDefault=False
            ),
            tr("A page with the confusion matrix as a picture and the figures of each class."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.MEAN_IOU, tr("Mean IoU")))
        self.addOutput(QgsProcessingOutputNumber(self.OVERALL_ACCURACY, tr("Overall accuracy")))

    def read_layers(self, parameters, context, feedback):
        from ..exchange.layers import label_map_layer

        self._layers = [
            label_map_layer(self.parameterAsRasterLayer(parameters, key, context), key)
            for key in (self.REFERENCE, self.PREDICTED)
        ]

    def work(self, parameters, context, feedback):
        from ...core.labels.comparison import LabelComparison
        from ...storage.comparing import DisagreementMap, LabelMapPair
        from ..exchange.layers import require_one_crs

        require_one_crs(*self._layers)
        pair = LabelMapPair(*(layer.path for layer in self._layers))
        match = self._match(pair, feedback)
        with DisagreementMap(pair) as disagreements:
            feedback.setProgressText(tr("Comparing"))
            comparison = LabelComparison(self._count(pair, match, disagreements, feedback))
            feedback.setProgressText(tr("Outlining the disagreements"))
            polygons = self._polygons(parameters, context, disagreements, feedback)
        result = self._write_report(parameters, context, comparison, match)
        result[self.DISAGREEMENTS] = self._write(parameters, context, polygons, match, feedback)
        result[self.MEAN_IOU] = comparison.mean_iou
        result[self.OVERALL_ACCURACY] = comparison.overall_accuracy
        _say(comparison, match, feedback)
        return result

    def _match(self, pair, feedback):
        from ...core.labels.comparison import match_classes
        from ...storage.rasters import class_table_of_map

        maps = (pair.reference, pair.predicted)
        match = match_classes(*(class_table_of_map(labels, layer.file) for labels, layer in zip(maps, self._layers)))
        if not match.by_name:
            feedback.pushWarning(tr("The maps share no class names: classes are matched by their values."))
        elif match.only_predicted:
            text = tr("Classes that only the predicted map has: {names}.")
            feedback.pushWarning(text.format(names=", ".join(match.only_predicted)))
        return match

    def _count(self, pair, match, disagreements, feedback):
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

    def _polygons(self, parameters, context, disagreements, feedback):
        """[(code, area, outline as WKB)], the largest first; raises Canceled, also while they are being made."""

        def proceed(share):
            feedback.setProgress(40 + 40 * share)
            return not feedback.isCanceled()

        disagreements.outline(proceed)
        check_canceled(feedback)
        ranked = disagreements.ranked(self.parameterAsDouble(parameters, self.MINIMUM_AREA, context))
        found = []
        for number, area in ranked:
            check_canceled(feedback)
            code, outline = disagreements.polygon(number)
            found.append((code, area, outline))
            feedback.setProgress(80 + 16 * len(found) / len(ranked))
        check_canceled(feedback)
        return found

    def _write_report(self, parameters, context, comparison, match):
        """{REPORT: path}, nothing when no report is wanted."""
        from ...storage.files import written_beside
        from ..reports.comparison_report import comparison_html

        path = self.parameterAsFileOutput(parameters, self.REPORT, context)
        if not path:
            return {}
        names = [layer.path for layer in self._layers]
        with written_beside(path) as temporary, open(temporary, "w", encoding="utf-8") as file:
            file.write(comparison_html(comparison, match, *names))
        return {self.REPORT: path}

    def _write(self, parameters, context, polygons, match, feedback):
        from ...core.labels.comparison import decode_disagreement

        sink = Sink(self, parameters, self.DISAGREEMENTS, context, FIELDS, POLYGON, self._layers[0].crs)
        for rank, (code, area, outline) in enumerate(polygons, start=1):
            annotated, predicted = decode_disagreement(code)
            values = {
                "rank": rank,
                "annotated_class": match.name(annotated),
                "predicted_class": match.name(predicted),
                "area": area,
                "annotated_value": annotated,
                "predicted_value": predicted,
            }
            sink.add(geometry_of(outline), values)
        feedback.pushInfo(tr("{count} places disagree.").format(count=len(polygons)))
        return sink.close()


def _say(comparison, match, feedback) -> None:
    for value in comparison.values:
        if value:
            text = tr("{name}: IoU {iou:.1%}, {pixels} pixels annotated")
            pixels = int(comparison.annotated[value])
            feedback.pushInfo(text.format(name=match.name(value), iou=comparison.iou(value), pixels=pixels))
    text = tr("Mean IoU {iou:.1%}, overall accuracy {accuracy:.1%} of {pixels} pixels.")
    feedback.pushInfo(
        text.format(iou=comparison.mean_iou, accuracy=comparison.overall_accuracy, pixels=comparison.pixels)
    )
