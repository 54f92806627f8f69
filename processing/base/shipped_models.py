"""The models (.model3) of the plugin, in the groups of the algorithms and in the user's language."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import (
    QgsApplication,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingModelAlgorithm,
    QgsProcessingParameterDefinition,
)

from ...core.errors import SemRefError
from ..messages.sentences import worded
from ..translation import tr
from ..version import algorithm_help_url
from .algorithm import ANNOTATION, REFERENCE_DATABASE, WithIcon, group_title, prints_help
from .destinations import require_rows_apart

SHIPPED = Path(__file__).resolve().parents[2] / "models"

PHOTO_MODEL = SHIPPED / "buildings.onnx"
"""The plugin's model for real photos: buildings."""

_GROUPS = {"Land cover": ANNOTATION, "Reference database": REFERENCE_DATABASE}
"""Groups by their titles in the model files."""


def _titles() -> dict[str, str]:
    """Return the titles by name; the model files contain all other texts in English."""
    return {
        "annotationtodatabase": tr("Land-cover layer to reference database"),
        "orthophototodisagreements": tr("Orthophoto to disagreements"),
        "correctiontodatabase": tr("Corrected land-cover layer to reference database"),
    }


class ShippedModel(WithIcon, QgsProcessingModelAlgorithm):
    """A model of the folder ``models``, read by ``load``."""

    def __init__(self) -> None:
        super().__init__()
        self._path = ""

    def load(self, path: str) -> bool:
        """Read the file; return whether this succeeded, which needs its algorithms to be registered."""
        self._path = path
        model = QgsProcessingModelAlgorithm()
        # A model that is loaded twice logs “Duplicate output” in each run.
        return model.fromFile(path) and self.loadVariant(_translated(model))

    # --- QgsProcessingAlgorithm ---

    def createInstance(self) -> ShippedModel:
        # QGIS copies only the name of a model, not its title.
        made = ShippedModel()
        made.load(self._path)
        return made

    def canExecute(self) -> tuple[bool, str]:
        # QGIS checks whether the steps exist, not whether they can run.
        find = QgsApplication.processingRegistry().algorithmById
        answers = (find(child.algorithmId()).canExecute() for child in self.childAlgorithms().values())
        return next((answer for answer in (super().canExecute(), *answers) if not answer[0]), (True, ""))

    def prepareAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> bool:
        # The steps do not see that they run in a batch.
        try:
            require_rows_apart(self, parameters, context, {}, feedback)
        except SemRefError as error:
            feedback.reportError(worded(error), True)
            return False
        return super().prepareAlgorithm(parameters, context, feedback)

    def postProcessAlgorithm(self, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> dict[str, Any]:
        # QGIS names layers after the outputs, which are part of their keys and therefore in English.
        names = {name for child in self.childAlgorithms().values() for name in child.modelOutputs()}
        for destination, details in context.layersToLoadOnCompletion().items():
            if details.name in names:
                context.layerToLoadOnCompletionDetails(destination).name = tr(details.name)
        return super().postProcessAlgorithm(context, feedback)

    def asPythonCommand(self, parameters: dict[str, Any], context: QgsProcessingContext) -> str:
        # QGIS has no command, and no entry in the history, for a model without a file that it may overwrite.
        return QgsProcessingAlgorithm.asPythonCommand(self, parameters, context)

    def displayName(self) -> str:
        return _titles()[self.name()]

    def groupId(self) -> str:
        return _GROUPS[super().group()]

    def group(self) -> str:
        return group_title(self.groupId())

    def shortDescription(self) -> str:
        return self.helpContent()["ALG_DESC"]

    def shortHelpString(self) -> str:
        return self.shortDescription() if prints_help() else super().shortHelpString()

    def helpUrl(self) -> str:
        return algorithm_help_url(self.name())


def _translated(loaded: QgsProcessingModelAlgorithm) -> dict[str, Any]:
    """Return a model in QGIS's form, with the user's texts and with the widgets and helps of its steps."""
    model, of_steps = loaded.toVariant(), _parameters_of_steps(loaded)
    for name, definition in model["parameterDefinitions"].items():
        definition["description"] = tr(definition["description"])
        if name in of_steps:
            definition["metadata"] = of_steps[name].metadata()
    for child in model["children"].values():
        for output in child["outputs"].values():
            output["component_description"] = tr(output["component_description"])
    helps = {name: one.help() for name, one in of_steps.items()}
    model["help"] = {**helps, **{name: tr(text) for name, text in model["help"].items()}}
    return model


def _parameters_of_steps(model: QgsProcessingModelAlgorithm) -> dict[str, QgsProcessingParameterDefinition]:
    """Return the algorithms' parameters that get a parameter of the model, by the name of the latter."""
    found: dict[str, QgsProcessingParameterDefinition] = {}
    registry = QgsApplication.processingRegistry()
    for child in model.childAlgorithms().values():
        algorithm = registry.algorithmById(child.algorithmId())
        for key, sources in child.parameterSources().items():
            definition = algorithm and algorithm.parameterDefinition(key)
            # Only a parameter of the model has a name.
            for name in (one.parameterName() for one in sources if definition):
                if name:
                    found.setdefault(name, definition)
    return found


def shipped_models() -> list[ShippedModel]:
    """Return the models that can be read."""
    models = []
    for path in sorted(SHIPPED.glob("*.model3")):
        model = ShippedModel()
        if model.load(str(path)):
            models.append(model)
    return models
