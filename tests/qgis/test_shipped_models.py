"""Shipped models are as their maker writes them, and translated wherever QGIS shows them."""

import importlib.util
import sys

import pytest
from qgis.core import (
    QgsApplication,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingModelAlgorithm,
    QgsProject,
)

from semref.processing.base import shipped_models

FILES = ("annotation_to_database", "correction_to_database", "orthophoto_to_disagreements")
IDS = tuple(name.replace("_", "") for name in FILES)
each_id = pytest.mark.parametrize("name", IDS)


@pytest.fixture
def create(qgis_app):
    return lambda name: QgsApplication.processingRegistry().createAlgorithmById(f"semref:{name}")


@pytest.fixture(scope="module")
def maker(qgis_app, repository):
    tools = str(repository / "tools")
    sys.path.append(tools)
    try:
        spec = importlib.util.spec_from_file_location("make_model", repository / "tools" / "release" / "make_model.py")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    finally:
        sys.path.remove(tools)
    return module


def texts_of(algorithm) -> list:
    """Return the texts of a model that QGIS shows."""
    shown = [algorithm.displayName(), algorithm.group(), algorithm.shortDescription()]
    return shown + [definition.description() for definition in algorithm.parameterDefinitions()]


@each_id
def test_a_copy_has_title_group_and_help_of_the_model(create, name):
    algorithm = create(name)
    texts = shipped_models.model_texts(name)
    assert algorithm.displayName() == texts.title != name
    assert algorithm.groupId() == texts.group and algorithm.group() != algorithm.groupId()
    assert texts.summary in algorithm.shortHelpString() and not algorithm.icon().isNull()
    for text in texts.helps.values():
        assert text in algorithm.shortHelpString()


@each_id
def test_helps_are_of_parameters_that_there_are(create, name):
    algorithm = create(name)
    names = {definition.name() for definition in algorithm.parameterDefinitions()}
    assert set(shipped_models.model_texts(name).helps) <= names


@each_id
def test_all_texts_are_in_the_users_language(qgis_app, repository, monkeypatch, name):
    monkeypatch.setattr(shipped_models, "tr", lambda text: f"«{text}»")
    monkeypatch.setattr(shipped_models, "group_title", lambda group: f"«{group}»")
    path = repository / "models" / f"{FILES[IDS.index(name)]}.model3"
    model = shipped_models.ShippedModel()
    assert model.load(str(path))
    for text in texts_of(model.create()):
        assert text.startswith("«") and text.endswith("»"), text


@each_id
def test_layers_that_a_model_makes_have_names_in_the_users_language(qgis_app, repository, monkeypatch, name):
    monkeypatch.setattr(shipped_models, "tr", lambda text: f"«{text}»")
    model = shipped_models.ShippedModel()
    assert model.load(str(repository / "models" / f"{FILES[IDS.index(name)]}.model3"))
    context, project = QgsProcessingContext(), QgsProject()
    names = [output for child in model.childAlgorithms().values() for output in child.modelOutputs()]
    assert names
    # Names that QGIS gives to layers of models, and one of another algorithm.
    for one in (*names, "Houses"):
        context.addLayerToLoadOnCompletion(one, QgsProcessingContext.LayerDetails(one, project, "OUTPUT"))
    model.postProcessAlgorithm(context, QgsProcessingFeedback())
    shown = {path: details.name for path, details in context.layersToLoadOnCompletion().items()}
    assert shown == {**{one: f"«{one}»" for one in names}, "Houses": "Houses"}


@pytest.fixture(scope="module")
def translated_texts(repository):
    """Return all texts that have translations."""
    path = repository / "tools" / "release" / "update_translations.py"
    spec = importlib.util.spec_from_file_location("update_translations", path)
    tool = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(tool)
    return set(tool.all_texts())


@pytest.mark.slow
@each_id
def test_the_names_of_parameters_have_translations(create, translated_texts, name):
    algorithm = create(name)
    assert {definition.description() for definition in algorithm.parameterDefinitions()} <= translated_texts


@pytest.mark.parametrize("name", FILES)
def test_the_file_is_what_the_maker_writes(maker, repository, tmp_path, name):
    """Compare both as read by this QGIS, because each version writes other files."""
    path = tmp_path / f"{name}.model3"
    assert maker.MODELS[name]().toFile(str(path))
    made, shipped = QgsProcessingModelAlgorithm(), QgsProcessingModelAlgorithm()
    assert made.fromFile(str(path)) and shipped.fromFile(str(repository / "models" / f"{name}.model3"))
    assert content(made) == content(shipped)


def content(model) -> tuple:
    """Return parameters, and steps with inputs and outputs; newer QGIS names outputs of new models differently."""
    children = {
        child_id: (
            child.algorithmId(),
            {
                key: [(s.source(), s.parameterName(), s.outputChildId(), s.outputName()) for s in sources]
                for key, sources in child.parameterSources().items()
            },
            sorted(child.modelOutputs()),
        )
        for child_id, child in model.childAlgorithms().items()
    }
    parameters = [
        (p.name(), p.type(), p.description(), p.defaultValue(), int(p.flags()))
        for p in model.parameterDefinitions()
        if not p.isDestination()
    ]
    return model.name(), children, sorted(parameters, key=lambda parameter: parameter[0]), model.helpContent()


@each_id
def test_every_parameter_is_explained(create, name):
    model = create(name)
    asked = [p.name() for p in model.parameterDefinitions() if not p.isDestination() and p.name() != "VERBOSE_LOG"]
    assert [key for key in asked if not model.helpContent().get(key)] == []
