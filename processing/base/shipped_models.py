"""Ready-made models (.model3) that stand beside the algorithms, in their groups and in the user's language."""

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
    """What a model says of itself. helps, names: by parameter; names of those that the algorithms call otherwise"""

    title: str
    group: str
    summary: str
    helps: dict[str, str]
    names: dict[str, str] = field(default_factory=dict)


def model_texts(name: str) -> ModelTexts:
    """The texts of a model, in the user's language; the model files have the English ones."""
    return {
        "annotationtodatabase": _annotation_to_database,
        "orthophototodisagreements": _orthophoto_to_disagreements,
        "correctiontodatabase": _correction_to_database,
    }[name]()


def _annotation_to_database() -> ModelTexts:
    return ModelTexts(
        tr("Annotation to reference database"),
        REFERENCE_DATABASE,
        tr(
            "From land-cover polygons to a reference database in one run: “Rasterize annotation”, then “Build "
            "reference database”. Give a class table, or name the reference classes."
        ),
        {
            "PIXEL_SIZE": tr("Edge length of a pixel in meters. The smallest landmark should cover some 50 pixels."),
            "REFERENCE_CLASSES": tr(
                "Classes whose regions are landmarks: names or values separated by “;”, for example "
                "building;bare_land;water. If left out, the classes with the role “reference” in the map’s class table."
            ),
        },
    )


def _orthophoto_to_disagreements() -> ModelTexts:
    return ModelTexts(
        tr("Orthophoto to disagreements"),
        ANNOTATION,
        tr(
            "Where does a new orthophoto contradict the annotation? “Segment image”, then “Compare label maps”: the "
            "disagreements as polygons, the largest first, to go through in the dock’s tab “Correct”. When the "
            "annotation is mended, “Corrected annotation to database” brings the reference database up to date."
        ),
        {
            "IMAGE": tr("It must be in the CRS of the label map; its pixels may be of another size."),
            "MODEL": tr("A segmentation network with the classes of the label map, which are matched by name."),
            "LABELS": tr("The label map that the reference database was built from."),
            "MINIMUM_AREA": tr("Smaller disagreements are left out."),
        },
    )


def _correction_to_database() -> ModelTexts:
    return ModelTexts(
        tr("Corrected annotation to database"),
        REFERENCE_DATABASE,
        tr(
            "From a corrected annotation to an updated reference database: “Rasterize annotation” with the pixels, "
            "the extent and the CRS of the old label map, then “Update reference database”. Only what the "
            "corrections reach is made anew."
        ),
        {
            "CLASS_TABLE": tr("The one that the old label map was made with."),
            "LABELS": tr("The label map that the reference database was built from."),
            "CHANGED": tr(
                "Polygons that hold everything that was changed, such as the places that were corrected: only the "
                "blocks of 512 × 512 pixels that they touch are looked at, and changes elsewhere are missed until an "
                "update without this. If left out, the whole map is compared with the database, which takes longer."
            ),
        },
        {"LABELS": tr("Old label map")},
    )


class ShippedModel(QgsProcessingModelAlgorithm):
    """A model of the folder ``models``; read it with ``load``."""

    def __init__(self) -> None:
        super().__init__()
        self._path = ""

    def load(self, path: str) -> bool:
        """Whether the file could be read: only where the algorithms in it are registered."""
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
        """The algorithms' parameters that the model hands its own on to, by the name of its own."""
        found: dict[str, QgsProcessingParameterDefinition] = {}
        registry = QgsApplication.processingRegistry()
        for child in self.childAlgorithms().values():
            algorithm = registry.algorithmById(child.algorithmId())
            for key, sources in child.parameterSources().items():
                definition = algorithm and algorithm.parameterDefinition(key)
                # Only what the model hands on from its own parameters names one.
                for name in (one.parameterName() for one in sources if definition):
                    if name:
                        found.setdefault(name, definition)
        return found

    # --- QgsProcessingAlgorithm ---

    def createInstance(self) -> ShippedModel:
        # QGIS's own copies know the name only, not the title.
        made = ShippedModel()
        made.load(self._path)
        return made

    def canExecute(self) -> tuple[bool, str]:
        # QGIS asks whether the steps are there, not whether they can do their work.
        find = QgsApplication.processingRegistry().algorithmById
        answers = (find(child.algorithmId()).canExecute() for child in self.childAlgorithms().values())
        return next((answer for answer in (super().canExecute(), *answers) if not answer[0]), (True, ""))

    def postProcessAlgorithm(self, context: QgsProcessingContext, feedback: QgsProcessingFeedback) -> dict[str, Any]:
        # QGIS calls layers by their outputs' names, which are part of their keys and so in English.
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
    """Those that can be read."""
    models = []
    for path in sorted(MODELS.glob("*.model3")):
        model = ShippedModel()
        if model.load(str(path)):
            models.append(model)
    return models
