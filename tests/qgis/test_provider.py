"""The provider's public names: scripts and models depend on them, so they stay."""

from __future__ import annotations

import pytest
from qgis.core import (
    QgsApplication,
    QgsProcessingAlgorithm,
    QgsProcessingModelAlgorithm,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
)

PARAMETERS = {
    "rasterizeannotation": (
        "annotation",
        "INPUT CLASS_FIELD [PRIORITY_FIELD] [CLASS_TABLE] PIXEL_SIZE [EXTENT] [TARGET_CRS] OUTPUT",
        "OUTPUT CLASS_COUNT LABELED_FRACTION",
    ),
    "checkannotation": (
        "annotation",
        "INPUT CLASS_FIELD [PRIORITY_FIELD] [CLASS_TABLE] [MINIMUM_AREA] [PIXEL_SIZE] ISSUES [REPORT]",
        "ISSUES REPORT ISSUE_COUNT ERROR_COUNT",
    ),
    "repairannotation": (
        "annotation",
        "INPUT CLASS_FIELD [PRIORITY_FIELD] [CLASS_TABLE] [MAXIMUM_GAP] [MINIMUM_AREA] OUTPUT [CHANGES]",
        "OUTPUT CHANGES",
    ),
    "decodecolorlabels": ("annotation", "INPUT CLASS_TABLE METHOD OUTPUT", "OUTPUT"),
    "exporttrainingtiles": (
        "annotation",
        "IMAGE LABELS TILE_SIZE STRIDE [VALIDATION_FRACTION] [CLASS_TABLE] OUTPUT",
        "OUTPUT TILE_COUNT",
    ),
    "comparelabels": (
        "annotation",
        "REFERENCE PREDICTED [MINIMUM_AREA] DISAGREEMENTS [REPORT]",
        "DISAGREEMENTS REPORT MEAN_IOU OVERALL_ACCURACY",
    ),
    "segmentimage": ("annotation", "INPUT MODEL [OVERLAP] [RESOLUTION] OUTPUT", "OUTPUT"),
    "builddatabase": (
        "referencedatabase",
        "LABELS [REFERENCE_CLASSES] WINDOW_SIZE STRIDE [LEVELS] REFERENCES_PER_VECTOR MINIMUM_AREA DATABASE",
        "DATABASE WINDOW_COUNT REFERENCE_COUNT",
    ),
    "updatedatabase": ("referencedatabase", "DATABASE LABELS [CHANGED] OUTPUT", "OUTPUT"),
    "exportonboard": ("referencedatabase", "DATABASE [CLIP] DISTANCE OVERVIEW OUTPUT", "OUTPUT BYTES"),
    "makesample": ("referencedatabase", "OUTPUT SEED", "OUTPUT PHOTO_COUNT"),
    "describeimage": (
        "localization",
        "INPUT [DATABASE] REFERENCES [VECTOR]",
        "REFERENCES VECTOR REFERENCE_COUNT",
    ),
    "localizeimages": (
        "localization",
        "DATABASE IMAGES [MODEL] METHOD OUTPUT [FOOTPRINTS] [ALTERNATIVES]",
        "OUTPUT FOOTPRINTS ALTERNATIVES MATCHES LABELS FIX_COUNT",
    ),
    "evaluatelocalization": (
        "localization",
        "DATABASE LABELS METHODS TRIALS [SCALE] [ROTATION] [OFFSET] [MISSED] [INVENTED] [MISNAMED] [RAGGED] SEED "
        "OUTPUT [REPORT] [JSON]",
        "OUTPUT REPORT JSON SUCCESS_RATE MEDIAN_ERROR FALSE_ACCEPT_RATE",
    ),
    "assessdatabase": (
        "localization",
        "DATABASE [FOOTPRINT] [SPACING] TRIALS THRESHOLD MAP_CORRELATION MISSED INVENTED MISNAMED RAGGED SEED "
        "OUTPUT [REPORT]",
        "OUTPUT REPORT LOCALIZABLE_FRACTION",
    ),
    "assessroute": (
        "localization",
        "DATABASE ROUTE [SPACING] [FOOTPRINT] [SPEED] [SHIFT] TRIALS THRESHOLD MAP_CORRELATION MISSED INVENTED "
        "MISNAMED RAGGED SEED OUTPUT [REPORT]",
        "OUTPUT REPORT LONGEST_GAP LONGEST_GAP_SECONDS",
    ),
}
"""Group, parameters (optional ones in brackets) and outputs of each algorithm."""

GROUPS = {
    "annotation": "Annotation",
    "referencedatabase": "Reference database",
    "localization": "Localization",
}
NAMES = list(PARAMETERS)


@pytest.fixture
def provider(qgis_app):
    return QgsApplication.processingRegistry().providerById("semref")


@pytest.fixture
def create(qgis_app):
    # Keep what it gives: parameters and outputs die with their algorithm.
    return lambda name: QgsApplication.processingRegistry().createAlgorithmById(f"semref:{name}")


def is_optional(parameter) -> bool:
    return bool(parameter.flags() & QgsProcessingParameterDefinition.FlagOptional)


def test_the_provider_has_id_name_icon_and_default_formats(provider):
    assert (provider.id(), provider.name()) == ("semref", "SemRef")
    assert not provider.icon().isNull()
    assert provider.svgIconPath().endswith("icon.svg")
    assert (provider.defaultVectorFileExtension(True), provider.defaultRasterFileExtension()) == ("gpkg", "tif")


def test_the_provider_has_the_algorithms(provider):
    assert set(NAMES) <= {algorithm.name() for algorithm in provider.algorithms()}


def test_the_models_that_ship_have_no_error_in_the_model_designer(provider):
    models = [one for one in provider.algorithms() if isinstance(one, QgsProcessingModelAlgorithm)]
    assert models
    assert [(model.name(), model.validate()) for model in models] == [(model.name(), (True, [])) for model in models]


@pytest.mark.parametrize("name", NAMES)
def test_every_algorithm_can_be_created_and_created_again(create, name):
    algorithm = create(name)
    assert isinstance(algorithm, QgsProcessingAlgorithm)
    assert algorithm.id() == f"semref:{name}"
    assert algorithm.create().id() == f"semref:{name}"


@pytest.mark.parametrize("name", NAMES)
def test_algorithms_are_in_their_groups(create, name):
    algorithm = create(name)
    assert algorithm.groupId() == PARAMETERS[name][0]
    assert algorithm.group() == GROUPS[algorithm.groupId()]


@pytest.mark.parametrize("name", NAMES)
def test_the_parameters_have_their_frozen_keys(create, name):
    algorithm = create(name)
    definitions = {p.name(): p for p in algorithm.parameterDefinitions()}
    for key in PARAMETERS[name][1].split():
        assert key.strip("[]") in definitions
        assert is_optional(definitions[key.strip("[]")]) == key.startswith("["), key
    required = {key for key in PARAMETERS[name][1].split() if not key.startswith("[")}
    for key, definition in definitions.items():
        # More keys may come, but none that older scripts lack.
        assert key in required or is_optional(definition) or definition.defaultValue() is not None, key


@pytest.mark.parametrize("name", NAMES)
def test_the_outputs_have_their_frozen_keys(create, name):
    algorithm = create(name)
    assert {output.name() for output in algorithm.outputDefinitions()} == set(PARAMETERS[name][2].split())


def test_the_values_of_the_choices_are_frozen(create):
    for name, key, count in (("decodecolorlabels", "METHOD", 2), ("localizeimages", "METHOD", 4)):
        algorithm = create(name)
        parameter = algorithm.parameterDefinition(key)
        assert isinstance(parameter, QgsProcessingParameterEnum)
        assert len(parameter.options()) == count
        assert not parameter.usesStaticStrings()


def test_the_defaults_are_those_of_the_paper(create):
    algorithm = create("builddatabase")
    defaults = {p.name(): p.defaultValue() for p in algorithm.parameterDefinitions()}
    assert (defaults["WINDOW_SIZE"], defaults["STRIDE"], defaults["REFERENCES_PER_VECTOR"]) == (1280, 350, 10)


@pytest.mark.parametrize("name", NAMES)
def test_every_parameter_has_a_title_and_help(create, name):
    algorithm = create(name)
    for parameter in algorithm.parameterDefinitions():
        assert parameter.description() and parameter.description() != parameter.name()
        assert len(parameter.help()) > 20, parameter.name()


@pytest.mark.parametrize("name", NAMES)
def test_the_help_shows_the_summary_and_every_parameter(create, name):
    algorithm = create(name)
    text = algorithm.shortHelpString()
    assert algorithm.shortDescription() in text
    for parameter in algorithm.parameterDefinitions():
        assert parameter.help() in text


@pytest.mark.parametrize("name", NAMES)
def test_algorithms_have_tags_title_and_icon(create, name):
    algorithm = create(name)
    assert len(algorithm.tags()) >= 4 and "semref" in algorithm.tags()
    assert algorithm.displayName() != algorithm.name()
    assert not algorithm.icon().isNull()
    assert algorithm.canExecute() == (True, "")
