"""semref:classtable – a class table of an annotation layer, with colors and roles."""

from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsProcessingOutputNumber, QgsProcessingParameterEnum, QgsProcessingParameterFileDestination

from ...core.errors import ClassTableError, ParameterError
from ..base import parameters
from ..base.algorithm import Declared, check_canceled
from ..base.annotation import PRESETS, AnnotationAlgorithm
from ..base.parameters import with_help
from ..translation import tr

if TYPE_CHECKING:
    from qgis.core import QgsProcessingFeedback

    from ...core.labels.class_table import ClassTable
    from ..base.outputs import Outputs
    from ..base.values import Values


class MakeClassTable(AnnotationAlgorithm):
    ID = "classtable"
    TAGS = ("class table", "classes", "legend", "colors", "csv", "nomenclature", "openstreetmap", "corine", "lcdb")

    REFERENCE_CLASSES = parameters.REFERENCE_CLASSES
    OUTPUT = "OUTPUT"
    PRESET = "PRESET"
    CLASS_COUNT = "CLASS_COUNT"

    def title(self) -> str:
        return tr("Make class table")

    def summary(self) -> str:
        return tr(
            "Writes the class table of an annotation layer: a value, a color and a role for each class that it has.\n\n"
            "Colors are those of the layer’s categorized style, else of the nomenclature, else what the class is known "
            "by: water is blue, forest green. Look through the file before it is used: it can be edited wherever a "
            "class table is asked for, or in any spreadsheet."
        )

    def parameters(self) -> tuple[Declared, ...]:
        return (
            *parameters.annotation()[:3],
            parameters.reference_classes(
                tr(
                    "Names or values of the classes whose regions are landmarks, separated by “;”. If left out, those "
                    "that usually are compact and stay where they are: buildings, water, bare land, orchards."
                )
            ),
            with_help(
                QgsProcessingParameterFileDestination(
                    self.OUTPUT, tr("Class table"), fileFilter=tr("CSV files (*.csv)")
                ),
                tr("CSV with the columns value, name, color, role, draw_order, hsv_min, hsv_max."),
            ),
            with_help(
                QgsProcessingParameterEnum(
                    self.PRESET,
                    tr("Nomenclature"),
                    options=(tr("None"), *PRESETS),
                    defaultValue=0,
                ),
                tr(
                    "Whose values, colors and roles the classes get. The class field may hold the names, or the codes "
                    "that names begin with; classes that the nomenclature lacks come behind its own."
                ),
                advanced=True,
            ),
            QgsProcessingOutputNumber(self.CLASS_COUNT, tr("Number of classes")),
        )

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.labels.class_proposal import proposed_table
        from ...storage.text_tables import read_class_table
        from ..layers.annotation import class_texts

        found = class_texts(self._source, feedback.isCanceled)
        check_canceled(feedback)
        preset = ("", *PRESETS.values())[values.choice(self.PRESET)]
        table = proposed_table(found, read_class_table(preset) if preset else None)
        chosen = values.parts(self.REFERENCE_CLASSES)
        try:
            table = table.with_references(chosen) if chosen else table
        except ClassTableError as error:
            raise ParameterError("{where}: {fault}", where=self.REFERENCE_CLASSES, fault=error.sentence) from None
        outputs.text(self.OUTPUT, table.to_csv())
        _log(table, feedback)
        return {self.CLASS_COUNT: len(table)}


def _log(table: ClassTable, feedback: QgsProcessingFeedback) -> None:
    for one in table:
        role = tr("landmarks") if one.is_reference else tr("background")
        feedback.pushInfo(f"{one.value} {one.name}: {one.color}, {role}")
    if not table.references:
        feedback.pushWarning(tr("No class is a landmark: name some in REFERENCE_CLASSES, or edit the roles."))
