"""What others build on: ids, keys and defaults of the algorithms, the command line, sentences for bad input."""

from __future__ import annotations

from typing import Any

from .recorder import Recorder

ATTRIBUTES = (
    "options", "allowMultiple", "minimum", "maximum", "dataType", "dataTypes", "fileFilter", "createByDefault",
    "parentLayerParameterName",
)  # fmt: skip
"""What some kinds of parameters tell beside type, default and flags."""


def record(recorder: Recorder, places: dict[str, Any]) -> None:
    """Records every algorithm's parameters and outputs, the help of `python -m core`, and errors."""
    from qgis.core import QgsApplication

    provider = QgsApplication.processingRegistry().providerById("semref")
    for algorithm in sorted(provider.algorithms(), key=lambda found: found.name()):
        parameters, outputs = algorithm.parameterDefinitions(), algorithm.outputDefinitions()
        name = algorithm.name()
        recorder.put(f"{name}/parameters", {definition.name(): _parameter(definition) for definition in parameters})
        recorder.put(f"{name}/outputs", {definition.name(): definition.type() for definition in outputs})
        recorder.put(f"{name}/order", [definition.name() for definition in parameters])
        texts = {"title": algorithm.displayName(), "group": algorithm.group(), "summary": algorithm.shortHelpString()}
        texts.update(tags=list(algorithm.tags()), help=algorithm.helpUrl(), group_id=algorithm.groupId())
        texts["parameters"] = {definition.name(): [definition.description(), definition.help()]
                               for definition in parameters}  # fmt: skip
        recorder.put(f"{name}/texts", texts)
    for arguments in ([], ["info"], ["localize"], ["watch"]):
        recorder.put(f"command line/{' '.join(arguments)} help", recorder.command([*arguments, "--help"]))
    _refusals(recorder, places["sample"])


def _parameter(definition) -> dict[str, Any]:
    """Type, default, flags and, where a parameter has them, choices and limits."""
    found: dict[str, Any] = {"type": definition.type(), "default": definition.defaultValue()}
    found["flags"] = int(definition.flags())
    for name in ATTRIBUTES:
        value = getattr(definition, name, None)
        if callable(value):
            value = value()
            found[name] = [int(part) for part in value] if name == "dataTypes" else plain_number(value)
    return found


def plain_number(value: Any) -> Any:
    """Enumerations of Qt as numbers."""
    return value if value is None or isinstance(value, (bool, str, float, list)) else int(value)


def _refusals(recorder: Recorder, sample) -> None:
    """Record the messages for invalid input."""
    import processing
    from qgis.core import QgsProcessingException

    folder = recorder.path("sample")
    nowhere, output = recorder.path("nowhere.gpkg"), recorder.path("refused.gpkg")
    polygons = {"INPUT": f"{folder}/landcover.shp", "CLASS_FIELD": "class"}
    localize = {"DATABASE": sample.database, "IMAGES": [f"{folder}/photos"], "OUTPUT": output}
    built = {"LABELS": sample.labels, "DATABASE": output}
    tries = {
        "no such database": ("localizeimages", {**localize, "DATABASE": nowhere}),
        "no database": ("localizeimages", {**localize, "DATABASE": f"{folder}/landcover.shp"}),
        "no such image": ("localizeimages", {**localize, "IMAGES": [nowhere]}),
        "scales the wrong way round": ("localizeimages", {**localize, "SCALE_MINIMUM": 2, "SCALE_MAXIMUM": 1}),
        "no model": ("localizeimages", {**localize, "MODEL": sample.labels}),
        "stride above window": ("builddatabase", {**built, "WINDOW_SIZE": 100, "STRIDE": 200}),
        "window above map": ("builddatabase", {**built, "WINDOW_SIZE": 10_000, "STRIDE": 200}),
        "unknown class": ("builddatabase", {**built, "REFERENCE_CLASSES": "building;castle"}),
        "levels are no numbers": ("builddatabase", {**built, "LEVELS": "1;two"}),
        "no such field": ("rasterizeannotation", {**polygons, "CLASS_FIELD": "none", "OUTPUT": output}),
        "too fine": ("rasterizeannotation", {**polygons, "PIXEL_SIZE": 0.001, "OUTPUT": recorder.path("fine.tif")}),
        "folder is taken": (
            "exporttrainingtiles",
            {"IMAGE": f"{folder}/orthophoto.tif", "LABELS": sample.labels, "OUTPUT": str(recorder.work)},
        ),
        "export over a database": ("exportonboard", {"DATABASE": sample.database, "OUTPUT": sample.database}),
    }
    said = {}
    for what, (name, parameters) in tries.items():
        try:
            processing.run(f"semref:{name}", parameters)
            said[what] = "was not refused"
        except QgsProcessingException as error:
            said[what] = str(error)
    said["core: no such file"] = recorder.command(["info", nowhere])
    said["core: no onboard file"] = recorder.command(["info", sample.database])
    recorder.put("refusals", said)
