"""Writes models/annotation_to_database.model3: polygons to reference database in one run.

Run with QGIS's Python (``.venv/bin/python tools/make_model.py``) after a change of the algorithms' parameters.
"""

from __future__ import annotations

import sys

from qgis_session import ROOT, qgis_session

TARGET = ROOT / "models" / "annotation_to_database.model3"


def annotation_to_database():
    from qgis.core import (
        QgsProcessing,
        QgsProcessingModelAlgorithm,
        QgsProcessingModelChildAlgorithm,
        QgsProcessingModelChildParameterSource,
        QgsProcessingModelOutput,
        QgsProcessingModelParameter,
        QgsProcessingParameterFeatureSource,
        QgsProcessingParameterField,
        QgsProcessingParameterFile,
        QgsProcessingParameterNumber,
        QgsProcessingParameterString,
    )
    from qgis.PyQt.QtCore import QPointF

    model = QgsProcessingModelAlgorithm("Annotation to reference database", "Reference database", "")
    model.setName("annotationtodatabase")
    number = QgsProcessingParameterNumber
    source = QgsProcessingModelChildParameterSource
    parameters = (
        QgsProcessingParameterFeatureSource("INPUT", "Annotation layer", [QgsProcessing.TypeVectorPolygon]),
        QgsProcessingParameterField("CLASS_FIELD", "Class field", parentLayerParameterName="INPUT"),
        QgsProcessingParameterField(
            "PRIORITY_FIELD", "Priority field", parentLayerParameterName="INPUT", optional=True
        ),
        QgsProcessingParameterFile("CLASS_TABLE", "Class table", fileFilter="CSV files (*.csv)", optional=True),
        number("PIXEL_SIZE", "Pixel size (m)", number.Double, 1.0, minValue=0.001),
        QgsProcessingParameterString("REFERENCE_CLASSES", "Reference classes", optional=True),
        number("WINDOW_SIZE", "Window size (map units)", number.Double, 1280.0, minValue=0.001),
        number("STRIDE", "Stride (map units)", number.Double, 350.0, minValue=0.001),
        number("MINIMUM_AREA", "Minimum area (m²)", number.Double, 100.0, minValue=0.0),
    )
    for place, parameter in enumerate(parameters):
        component = QgsProcessingModelParameter(parameter.name())
        component.setPosition(QPointF(120 + 220 * (place % 5), 60 + 90 * (place // 5)))
        model.addModelParameter(parameter, component)

    def child(child_id, algorithm, names, place):
        step = QgsProcessingModelChildAlgorithm(algorithm)
        step.setChildId(child_id)
        step.setDescription(step.algorithm().displayName())
        step.setPosition(QPointF(*place))
        for name in names:
            step.addParameterSources(name, [source.fromModelParameter(name)])
        return step

    def output(name, child_id, child_output, place):
        result = QgsProcessingModelOutput(name, name)
        result.setChildId(child_id)
        result.setChildOutputName(child_output)
        result.setPosition(QPointF(*place))
        return result

    model.setParameterOrder([parameter.name() for parameter in parameters])

    rasterize = child(
        "rasterize",
        "semref:rasterizeannotation",
        ("INPUT", "CLASS_FIELD", "PRIORITY_FIELD", "CLASS_TABLE", "PIXEL_SIZE"),
        (320, 300),
    )
    rasterize.setModelOutputs({"Label map": output("Label map", "rasterize", "OUTPUT", (560, 300))})
    model.addChildAlgorithm(rasterize)
    build = child(
        "build",
        "semref:builddatabase",
        ("REFERENCE_CLASSES", "WINDOW_SIZE", "STRIDE", "MINIMUM_AREA"),
        (320, 420),
    )
    build.addParameterSources("LABELS", [source.fromChildOutput("rasterize", "OUTPUT")])
    build.setModelOutputs({"Reference database": output("Reference database", "build", "DATABASE", (560, 420))})
    model.addChildAlgorithm(build)
    model.setHelpContent(
        {
            "ALG_DESC": "From land-cover polygons to a reference database in one run: “Rasterize annotation”, then "
            "“Build reference database”. Give a class table, or name the reference classes.",
            "ALG_VERSION": "1",
        }
    )
    return model


def main() -> None:
    with qgis_session():
        TARGET.parent.mkdir(exist_ok=True)
        if not annotation_to_database().toFile(str(TARGET)):
            sys.exit(f"{TARGET} could not be written.")
    print(f"Wrote {TARGET}")


if __name__ == "__main__":
    main()
