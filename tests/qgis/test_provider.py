"""Public names of the provider do not change, because scripts and models use them."""

import html
import json
from pathlib import Path

import pytest
from qgis.core import QgsApplication, QgsProcessingAlgorithm, QgsProcessingModelAlgorithm

pytestmark = pytest.mark.newer

GROUPS = {"annotation": "Land cover", "referencedatabase": "Reference database", "localization": "Localization"}
KEYS = Path(__file__).resolve().parents[1] / "data" / "public_keys.json"
MODELS = {"annotationtodatabase", "correctiontodatabase", "orthophototodisagreements"}
NAMES = sorted(set(json.loads(KEYS.read_text(encoding="utf-8"))) - MODELS)


@pytest.fixture
def provider(qgis_app):
    return QgsApplication.processingRegistry().providerById("semref")


def test_the_provider_has_id_name_icon_and_default_formats(provider):
    assert (provider.id(), provider.name()) == ("semref", "SemRef")
    assert not provider.icon().isNull()
    assert provider.svgIconPath().endswith("icon.svg")
    assert (provider.defaultVectorFileExtension(True), provider.defaultRasterFileExtension()) == ("gpkg", "tif")


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
