"""The models (.model3) of the plugin, in the groups of the algorithms and in the user's language."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsApplication,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingModelAlgorithm,
    QgsProcessingParameterDefinition,
)
from qgis.PyQt.QtGui import QIcon

from ..translation import tr
from ..version import algorithm_help_url
from .algorithm import ANNOTATION, ICON_PATH, REFERENCE_DATABASE, group_title, prints_help

MODELS = Path(__file__).resolve().parents[2] / "models"


@dataclass(frozen=True)
class ModelTexts:
    """Texts of a model.

    Attributes:
        helps: Help by parameter.
        names: Titles by parameter, where they differ from those of the algorithms.
    """

    title: str
    group: str
    summary: str
    helps: dict[str, str]
    names: dict[str, str] = field(default_factory=dict)


def model_texts(name: str) -> ModelTexts:
    """Return the texts of a model in the user's language; the model files contain the English ones."""
    return {
        "annotationtodatabase": _annotation_to_database,
        "orthophototodisagreements": _orthophoto_to_disagreements,
        "correctiontodatabase": _correction_to_database,
    }[name]()


def _annotation_to_database() -> ModelTexts:
    return ModelTexts(
        tr("Land-cover layer to reference database"),
        REFERENCE_DATABASE,
        tr(
            "Makes a reference database from a land-cover layer in one run, with “Rasterize land-cover layer” and "
            "“Build reference database”. Select a class table, or enter the reference classes."
        ),
        {
            "PIXEL_SIZE": tr(
                "Edge length of a pixel, for example 1. The smallest landmark should cover about 50 pixels."
            ),
            "REFERENCE_CLASSES": tr(
                "Classes that are landmarks: names or values separated by “;”, for example "
                "building;bare_land;water. If not set, the classes with the role “reference” in the class table of "
                "the map are used."
            ),
        },
    )


def _orthophoto_to_disagreements() -> ModelTexts:
    return ModelTexts(
        tr("Orthophoto to disagreements"),
        ANNOTATION,
        tr(
            "Finds where a new orthophoto contradicts the label map, with “Segment image” and “Compare label maps”. "
            "The disagreements are polygons, the largest first. Check them in the tab “Correct” of the dock, then run "
            "“Corrected land-cover layer to reference database”."
        ),
        {
            "IMAGE": tr("Photo or orthophoto in the CRS of the label map. Its pixel size may differ."),
            "MODEL": tr("Segmentation model with the classes of the label map, matched by name."),
            "LABELS": tr("Label map that the reference database was built from."),
            "MINIMUM_AREA": tr("Disagreements smaller than this area are left out."),
        },
    )


def _correction_to_database() -> ModelTexts:
    return ModelTexts(
        tr("Corrected land-cover layer to reference database"),
        REFERENCE_DATABASE,
        tr(
            "Updates a reference database after its land-cover layer was corrected. “Rasterize land-cover layer” uses "
            "the pixels, extent and CRS of the old label map; “Update reference database” computes only what changed."
        ),
        {
            "CLASS_TABLE": tr("Class table of the old label map."),
            "LABELS": tr("Label map that the reference database was built from."),
            "CHANGED": tr(
                "Polygons that contain all changes. Only blocks of 512 × 512 pixels that these polygons touch are "
                "compared, so changes outside are missed. If not set, the whole map is compared with the database, "
                "which takes longer."
            ),
        },
        {"LABELS": tr("Old label map")},
    )


class ShippedModel(QgsProcessingModelAlgorithm):
    """A model of the folder ``models``, read by ``load``."""

    def __init__(self) -> None:
        super().__init__()
        self._path = ""

    def load(self, path: str) -> bool:
        """Read the file; return whether this succeeded, which needs its algorithms to be registered."""
        self._path = path
        if not self.fromFile(path):
            return False
        self._translate()
        return True

    def _translate(self) -> None:
        model, texts, of_steps = self.toVariant(), model_texts(self.name()), self._parameters_of_steps()
        for name, definition in model["parameterDefinitions"].items():
            definition["description"] = texts.names.get(name) or tr(definition["description"])
            if name in of_steps:
                definition["metadata"] = of_steps[name].metadata()
        for child in model["children"].values():
            for output in child["outputs"].values():
                output["component_description"] = tr(output["component_description"])
        helps = {"ALG_DESC": texts.summary, **{name: one.help() for name, one in of_steps.items()}, **texts.helps}
        model["help"] = {**model["help"], **helps}
        self.loadVariant(model)

    def _parameters_of_steps(self) -> dict[str, QgsProcessingParameterDefinition]:
        """Return the algorithms' parameters that get a parameter of the model, by the name of the latter."""
        found: dict[str, QgsProcessingParameterDefinition] = {}
        registry = QgsApplication.processingRegistry()
        for child in self.childAlgorithms().values():
            algorithm = registry.algorithmById(child.algorithmId())
            for key, sources in child.parameterSources().items():
                definition = algorithm and algorithm.parameterDefinition(key)
                # Only a parameter of the model has a name.
                for name in (one.parameterName() for one in sources if definition):
                    if name:
                        found.setdefault(name, definition)
        return found

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

    def postProcessAlgorithm(self, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> dict[str, Any]:
        # QGIS names layers after the outputs, which are part of their keys and therefore in English.
        names = {name for child in self.childAlgorithms().values() for name in child.modelOutputs()}
        for destination, details in context.layersToLoadOnCompletion().items():
            if details.name in names:
                context.layerToLoadOnCompletionDetails(destination).name = tr(details.name)
        return super().postProcessAlgorithm(context, feedback)

    def displayName(self) -> str:
        return model_texts(self.name()).title

    def groupId(self) -> str:
        return model_texts(self.name()).group

    def group(self) -> str:
        return group_title(self.groupId())

    def shortDescription(self) -> str:
        return model_texts(self.name()).summary

    def shortHelpString(self) -> str:
        return self.shortDescription() if prints_help() else super().shortHelpString()

    def helpUrl(self) -> str:
        return algorithm_help_url(self.name())

    def icon(self) -> QIcon:
        return QIcon(str(ICON_PATH))

    def svgIconPath(self) -> str:
        return str(ICON_PATH)


def shipped_models() -> list[ShippedModel]:
    """Return the models that can be read."""
    models = []
    for path in sorted(MODELS.glob("*.model3")):
        model = ShippedModel()
        if model.load(str(path)):
            models.append(model)
    return models
