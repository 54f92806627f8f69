"""Public names of the provider do not change, because scripts and models use them."""

import html

import pytest
from qgis.core import QgsApplication, QgsProcessingAlgorithm, QgsProcessingModelAlgorithm

pytestmark = pytest.mark.newer

GROUPS = {"annotation": "Land cover", "referencedatabase": "Reference database", "localization": "Localization"}
NAMES = (
    "rasterizeannotation",
    "classifyopenstreetmap",
    "checkannotation",
    "repairannotation",
    "decodecolorlabels",
    "exporttrainingtiles",
    "trainmodel",
    "addmodel",
    "comparelabels",
    "segmentimage",
    "builddatabase",
    "updatedatabase",
    "exportonboard",
    "describeimage",
    "setuparea",
    "localizeimages",
    "localizeflight",
    "georeferenceimages",
    "evaluatelocalization",
    "assessdatabase",
    "assessroute",
    "classtable",
)


@pytest.fixture
def provider(qgis_app):
    return QgsApplication.processingRegistry().providerById("semref")


@pytest.fixture
def create(qgis_app):
    # Keep the algorithm: its parameters and outputs are deleted with it.
    return lambda name: QgsApplication.processingRegistry().createAlgorithmById(f"semref:{name}")


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
    assert algorithm.group() == GROUPS[algorithm.groupId()]


@pytest.mark.parametrize("name", NAMES)
def test_every_parameter_has_a_title_and_help(create, name):
    algorithm = create(name)
    for parameter in algorithm.parameterDefinitions():
        assert parameter.description() and parameter.description() != parameter.name()
        assert len(parameter.help()) > 20, parameter.name()


@pytest.mark.parametrize("name", NAMES)
def test_the_help_shows_the_summary_and_every_parameter(create, name):
    algorithm = create(name)
    text = html.unescape(algorithm.shortHelpString())
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
