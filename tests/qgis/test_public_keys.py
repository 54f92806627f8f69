"""Ids, keys, types, defaults and limits of all algorithms are public: scripts and models use them.

``tests/data/public_keys.json`` holds them. What is added on purpose is recorded there with
``SEMREF_RECORD=1 python -m pytest tests/qgis/test_public_keys.py``; what is there already never changes.
"""

import html
import json
import os
from pathlib import Path

import pytest
from qgis.core import (
    QgsApplication,
    QgsProcessingAlgorithm,
    QgsProcessingDestinationParameter,
    QgsProcessingModelAlgorithm,
    QgsProcessingParameterDefinition,
)

pytestmark = pytest.mark.newer

LIMITS = (
    *("data_type", "min", "max", "allow_multiple", "parent_layer"),
    *("data_types", "behavior", "extension", "layer_type"),
)

"""Entries of a parameter's variant map that are the same in all supported versions of QGIS."""


@pytest.fixture(scope="module")
def algorithms(qgis_app):
    provider = QgsApplication.processingRegistry().providerById("semref")
    return {algorithm.name(): algorithm for algorithm in provider.algorithms()}


def described(parameter) -> dict:
    flags, stored = parameter.flags(), parameter.toVariantMap()
    public = {
        "type": parameter.type(),
        "optional": bool(flags & QgsProcessingParameterDefinition.FlagOptional),
        "advanced": bool(flags & QgsProcessingParameterDefinition.FlagAdvanced),
        "default": parameter.defaultValue(),
        **{name: stored[name] for name in LIMITS if name in stored},
    }
    if "options" in stored:
        public["options"] = len(stored["options"])
    if isinstance(parameter, QgsProcessingDestinationParameter):
        public["by_default"] = parameter.createByDefault()
    return public


def without_null(parameter: dict) -> dict:
    """A file without a suffix has None, NULL or nothing, depending on the version of QGIS."""
    return {**parameter, "extension": parameter.get("extension") or ""}


def recorded(algorithms) -> dict:
    return {
        name: {
            "group": algorithm.groupId(),
            "parameters": {p.name(): described(p) for p in algorithm.parameterDefinitions()},
            "outputs": {output.name(): output.type() for output in algorithm.outputDefinitions()},
        }
        for name, algorithm in sorted(algorithms.items())
    }


def as_text(recorded: dict) -> str:
    """Return JSON with one line per parameter, so that a change is easy to read."""
    algorithms = []
    for name, algorithm in recorded.items():
        keys = ",\n".join(f"   {json.dumps(key)}: {json.dumps(p)}" for key, p in algorithm["parameters"].items())
        head, outputs = json.dumps(algorithm["group"]), json.dumps(algorithm["outputs"])
        algorithms.append(f' {json.dumps(name)}: {{\n  "group": {head},\n  "parameters": {{\n{keys}\n  }},\n')
        algorithms[-1] += f'  "outputs": {outputs}\n }}'
    return "{\n" + ",\n".join(algorithms) + "\n}\n"


def test_every_recorded_key_is_there_as_it_was(algorithms, repository):
    file = repository / "tests" / "data" / "public_keys.json"
    # Values that JSON does not support are NULLs of Qt.
    now = json.loads(json.dumps(recorded(algorithms), default=lambda null: None))
    if os.environ.get("SEMREF_RECORD"):
        file.write_text(as_text(now), encoding="utf-8")
    before = json.loads(file.read_text(encoding="utf-8"))
    assert list(now) == list(before)
    for name, algorithm in before.items():
        added = f"{name}: if you added a parameter, record it with SEMREF_RECORD=1 (CONTRIBUTING.md)"
        assert list(now[name]["parameters"]) == list(algorithm["parameters"]), added
        for key, parameter in algorithm["parameters"].items():
            assert without_null(now[name]["parameters"][key]) == without_null(parameter), (name, key)
        assert (now[name]["group"], now[name]["outputs"]) == (algorithm["group"], algorithm["outputs"]), name


GROUPS = {"annotation": "Land cover", "referencedatabase": "Reference database", "localization": "Localization"}
KEYS = Path(__file__).resolve().parents[1] / "data" / "public_keys.json"
MODELS = {"annotationtodatabase", "correctiontodatabase", "orthophototodisagreements"}
NAMES = sorted(set(json.loads(KEYS.read_text(encoding="utf-8"))) - MODELS)


def test_the_provider_has_id_name_icon_and_default_formats(provider):
    assert (provider.id(), provider.name()) == ("semref", "SemRef")
    assert not provider.icon().isNull()
    assert provider.svgIconPath().endswith("icon.svg")
    assert (provider.defaultVectorFileExtension(True), provider.defaultRasterFileExtension()) == ("gpkg", "tif")
    assert provider.supportedOutputRasterLayerExtensions() == ["tif", "tiff"]


def test_the_models_that_ship_have_no_error_in_the_model_designer(provider):
    models = [one for one in provider.algorithms() if isinstance(one, QgsProcessingModelAlgorithm)]
    assert models
    assert [(model.name(), model.validate()) for model in models] == [(model.name(), (True, [])) for model in models]


@pytest.mark.parametrize("name", NAMES)
def test_algorithms_have_group_tags_title_and_icon_and_all_of_it_in_their_help(create, name):
    algorithm = create(name)
    assert isinstance(algorithm, QgsProcessingAlgorithm)
    assert algorithm.id() == algorithm.create().id() == f"semref:{name}"
    assert algorithm.group() == GROUPS[algorithm.groupId()]
    assert len(algorithm.tags()) >= 4 and "semref" in algorithm.tags()
    assert algorithm.displayName() != algorithm.name() and not algorithm.icon().isNull()
    assert algorithm.canExecute() == (True, "")
    text = html.unescape(algorithm.shortHelpString())
    assert algorithm.shortDescription() in text
    for parameter in algorithm.parameterDefinitions():
        assert parameter.description() and parameter.description() != parameter.name()
        assert len(parameter.help()) > 20 and parameter.help() in text, parameter.name()
        # The model designer cannot fold away outputs: “Show advanced parameters” ends with an error at the first.
        is_advanced = parameter.flags() & QgsProcessingParameterDefinition.FlagAdvanced
        assert not (parameter.isDestination() and is_advanced), parameter.name()
