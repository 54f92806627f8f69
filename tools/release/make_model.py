"""Write the shipped Processing models, models/*.model3.

Run it with QGIS's Python (``.venv/bin/python tools/release/make_model.py``) after parameters of the algorithms change.
Titles and help texts of the models come from processing/base/shipped_models.py.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from qgis_session import ROOT, qgis_session

TARGET = ROOT / "models"


class ModelMaker:
    """Build a model: first the parameters, then the steps in their order."""

    def __init__(self, name: str, parameters) -> None:
        from qgis.core import QgsProcessingModelAlgorithm, QgsProcessingModelParameter
        from qgis.PyQt.QtCore import QPointF

        from semref.processing.base.shipped_models import group_title, model_texts

        texts = model_texts(name)
        self.model = QgsProcessingModelAlgorithm(texts.title, group_title(texts.group), "")
        self.model.setName(name)
        self._names = {parameter.name() for parameter in parameters}
        self._row = 0
        for place, parameter in enumerate(parameters):
            component = QgsProcessingModelParameter(parameter.name())
            component.setPosition(QPointF(120 + 220 * (place % 5), 60 + 90 * (place // 5)))
            self.model.addModelParameter(parameter, component)
        self.model.setParameterOrder([parameter.name() for parameter in parameters])
        self.model.setHelpContent({"ALG_DESC": texts.summary, "ALG_VERSION": "1", **texts.helps})

    def step(self, child_id: str, algorithm: str, inputs: dict, outputs: dict) -> None:
        """Add a step.

        Args:
            inputs: By key: name of a model parameter, (step, output of this step), or a number.
            outputs: Title by key.
        """
        from qgis.core import (
            QgsProcessingModelChildAlgorithm,
            QgsProcessingModelChildParameterSource,
            QgsProcessingModelOutput,
        )
        from qgis.PyQt.QtCore import QPointF

        source = QgsProcessingModelChildParameterSource
        child = QgsProcessingModelChildAlgorithm(algorithm)
        child.setChildId(child_id)
        child.setDescription(child.algorithm().displayName())
        height = 300 + 120 * self._row
        self._row += 1
        child.setPosition(QPointF(320, height))
        for key, origin in inputs.items():
            if isinstance(origin, str) and origin not in self._names:
                raise ValueError(f"{child_id}: the model has no parameter {origin}")
            kinds = {str: source.fromModelParameter, int: source.fromStaticValue, bool: source.fromStaticValue}
            make = kinds.get(type(origin), lambda pair: source.fromChildOutput(*pair))
            child.addParameterSources(key, [make(origin)])
        results = {}
        for key, title in outputs.items():
            result = QgsProcessingModelOutput(title, title)
            result.setChildId(child_id)
            result.setChildOutputName(key)
            result.setPosition(QPointF(560, height))
            results[title] = result
        child.setModelOutputs(results)
        self.model.addChildAlgorithm(child)


def annotation_parameters() -> list:
    """Return the parameters of a land-cover layer that is rasterized."""
    from qgis.core import (
        QgsProcessing,
        QgsProcessingParameterFeatureSource,
        QgsProcessingParameterField,
        QgsProcessingParameterFile,
        QgsProcessingParameterString,
    )

    return [
        QgsProcessingParameterFeatureSource("INPUT", "Land-cover layer", [QgsProcessing.TypeVectorPolygon]),
        QgsProcessingParameterField("CLASS_FIELD", "Class field", parentLayerParameterName="INPUT", optional=True),
        QgsProcessingParameterString("CLASS", "All polygons are", optional=True),
        QgsProcessingParameterField(
            "PRIORITY_FIELD", "Priority field", parentLayerParameterName="INPUT", optional=True
        ),
        QgsProcessingParameterFile("CLASS_TABLE", "Class table", fileFilter="CSV files (*.csv)", optional=True),
    ]


def other_ground():
    """Add the parameter for ground without a polygon."""
    from qgis.core import QgsProcessingParameterBoolean

    return QgsProcessingParameterBoolean("OTHER_GROUND", "Treat ground without a polygon as class “other”", False)


def same(*names: str) -> dict:
    """Return inputs of a step with the same names as the model's parameters."""
    return {name: name for name in names}


def annotation_to_database():
    from qgis.core import QgsProcessingParameterNumber, QgsProcessingParameterString

    number = QgsProcessingParameterNumber
    maker = ModelMaker(
        "annotationtodatabase",
        [
            *annotation_parameters(),
            number("PIXEL_SIZE", "Pixel size (m)", number.Double, 1.0, minValue=0.001),
            QgsProcessingParameterString("REFERENCE_CLASSES", "Reference classes", optional=True),
            number("WINDOW_SIZE", "Window size (m)", number.Double, 1280.0, minValue=0.001),
            number("STRIDE", "Stride (m)", number.Double, 350.0, minValue=0.001),
            number("MINIMUM_AREA", "Minimum area (m²)", number.Double, 100.0, minValue=0.0),
            other_ground(),
        ],
    )
    rasterized = same("INPUT", "CLASS_FIELD", "CLASS", "PRIORITY_FIELD", "CLASS_TABLE", "PIXEL_SIZE", "OTHER_GROUND")
    maker.step("rasterize", "semref:rasterizeannotation", rasterized, {"OUTPUT": "Label map"})
    built = same("REFERENCE_CLASSES", "WINDOW_SIZE", "STRIDE", "MINIMUM_AREA")
    # The model designer reports an error if a required parameter has only its default.
    built.update(LABELS=("rasterize", "OUTPUT"), REFERENCES_PER_VECTOR=10, OPEN_OUTPUT=True)
    maker.step("build", "semref:builddatabase", built, {"DATABASE": "Reference database"})
    return maker.model


def orthophoto_to_disagreements():
    from qgis.core import (
        QgsProcessingParameterFile,
        QgsProcessingParameterNumber,
        QgsProcessingParameterRasterLayer,
    )

    number = QgsProcessingParameterNumber
    maker = ModelMaker(
        "orthophototodisagreements",
        [
            QgsProcessingParameterRasterLayer("IMAGE", "Photo or orthophoto"),
            QgsProcessingParameterFile("MODEL", "Model", fileFilter="ONNX models (*.onnx)"),
            QgsProcessingParameterRasterLayer("LABELS", "Annotated label map"),
            number("MINIMUM_AREA", "Minimum area (m²)", number.Double, 10.0, minValue=0.0),
        ],
    )
    segmented = {"INPUT": "IMAGE", "MODEL": "MODEL"}
    maker.step("segment", "semref:segmentimage", segmented, {"OUTPUT": "Predicted label map"})
    compared = {"REFERENCE": "LABELS", "PREDICTED": ("segment", "OUTPUT"), "MINIMUM_AREA": "MINIMUM_AREA"}
    results = {"DISAGREEMENTS": "Disagreements", "REPORT": "Report"}
    maker.step("compare", "semref:comparelabels", compared, results)
    return maker.model


def correction_to_database():
    from qgis.core import (
        QgsProcessing,
        QgsProcessingParameterFeatureSource,
        QgsProcessingParameterFile,
        QgsProcessingParameterRasterLayer,
    )

    from semref.processing.base.shipped_models import model_texts

    polygons = [QgsProcessing.TypeVectorPolygon]
    maker = ModelMaker(
        "correctiontodatabase",
        [
            *annotation_parameters(),
            QgsProcessingParameterRasterLayer("LABELS", model_texts("correctiontodatabase").names["LABELS"]),
            QgsProcessingParameterFile("DATABASE", "Reference database", extension="gpkg"),
            QgsProcessingParameterFeatureSource("CHANGED", "Changed areas", polygons, optional=True),
            other_ground(),
        ],
    )
    maker.step("pixels", "native:rasterlayerproperties", {"INPUT": "LABELS"}, {})
    # A layer gives its extent and its CRS.
    grid = {"PIXEL_SIZE": ("pixels", "PIXEL_WIDTH"), "EXTENT": "LABELS", "TARGET_CRS": "LABELS"}
    rasterized = {**same("INPUT", "CLASS_FIELD", "CLASS", "PRIORITY_FIELD", "CLASS_TABLE", "OTHER_GROUND"), **grid}
    maker.step("rasterize", "semref:rasterizeannotation", rasterized, {"OUTPUT": "Corrected label map"})
    updated = {**same("DATABASE", "CHANGED"), "LABELS": ("rasterize", "OUTPUT"), "OPEN_OUTPUT": True}
    maker.step("update", "semref:updatedatabase", updated, {"OUTPUT": "Updated database"})
    return maker.model


MODELS = {
    "annotation_to_database": annotation_to_database,
    "orthophoto_to_disagreements": orthophoto_to_disagreements,
    "correction_to_database": correction_to_database,
}
"""Models by file name."""


def write(model, path: Path) -> bool:
    """Write a model and return whether that worked. Attributes are sorted; Qt's order changes from run to run."""
    if not model.toFile(str(path)):
        return False

    def ordered(tag: re.Match) -> str:
        return tag[1] + " ".join(sorted(re.findall(r'\w+="[^"]*"', tag[2]))) + tag[3]

    text = path.read_text(encoding="utf-8")
    path.write_text(re.sub(r"(<Option )([^<>]*?)(/?>)", ordered, text), encoding="utf-8")
    return True


def main() -> None:
    with qgis_session():
        TARGET.mkdir(exist_ok=True)
        for name, make in MODELS.items():
            path = TARGET / f"{name}.model3"
            if not write(make(), path):
                sys.exit(f"{path} could not be written.")
            print(f"Wrote {path}")


if __name__ == "__main__":
    main()
