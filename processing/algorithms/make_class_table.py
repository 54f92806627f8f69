"""semref:classtable: make a class table for a land-cover layer, with colors and roles."""

from __future__ import annotations

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFileDestination,
)

from ...core.labels.class_table import ClassTable
from ..base import parameters
from ..base.algorithm import Declared, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..jobs.annotation import PRESETS, AnnotationAlgorithm
from ..translation import tr


class MakeClassTable(AnnotationAlgorithm):
    ID = "classtable"
    TITLE = "Make class table"
    TAGS = ("class table", "classes", "legend", "colors", "csv", "nomenclature", "openstreetmap", "corine", "lcdb")
    SUMMARY = (
        "Makes a class table for a land-cover layer, with a value, a color and a role for each class of the "
        "layer.\n\nColors come from the style of the layer, otherwise from the nomenclature, otherwise from "
        "typical colors: blue for water, green for forest. Check the table before you use it; it can be edited in "
        "SemRef or a spreadsheet."
    )

    PRESET = "PRESET"
    CLASS_COUNT = "CLASS_COUNT"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            *parameters.annotation()[:3],
            parameters.reference_classes(
                "Names or values of the classes that are landmarks, separated by “;”. If not set, classes that "
                "are usually compact and permanent are used: buildings, water, bare land, orchards."
            ),
            with_help(
                QgsProcessingParameterFileDestination(self.OUTPUT, "Class table", fileFilter=tr("CSV files (*.csv)")),
                "CSV file with the columns value, name, color, role, draw_order, hsv_min, hsv_max.",
            ),
            with_help(
                QgsProcessingParameterEnum(self.PRESET, "Nomenclature", options=(tr("None"), *PRESETS), defaultValue=0),
                "Nomenclature that gives values, colors and roles to the classes. The class field may contain its "
                "class names or the codes at the start of these names. Other classes are added after those of the "
                "nomenclature.",
                advanced=True,
            ),
            QgsProcessingOutputNumber(self.CLASS_COUNT, "Number of classes"),
        )

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.labels.class_proposal import proposed_table
        from ...storage.text_tables import read_class_table
        from ..layers.annotation import class_texts

        found = class_texts(self._source, feedback.isCanceled)
        check_canceled(feedback)
        preset = ("", *PRESETS.values())[values.choice(self.PRESET)]
        table = proposed_table(found, read_class_table(preset) if preset else None)
        table = values.with_references(self.REFERENCE_CLASSES, table, needed=False)
        outputs.text(self.OUTPUT, table.to_csv())
        _log(table, feedback)
        return {self.CLASS_COUNT: len(table)}


def _log(table: ClassTable, feedback: QgsProcessingFeedback) -> None:
    for one in table:
        role = tr("landmarks") if one.is_reference else tr("background")
        feedback.pushInfo(f"{one.value} {one.name}: {one.color}, {role}")
    if not table.references:
        feedback.pushWarning(tr("No class is a landmark. Enter reference classes, or edit the roles in the table."))
