"""Shipped models have help and translations, the reference page lists all, and the Help buttons open it."""

import importlib
import sys

import pytest
from qgis.core import (
    QgsApplication,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingModelAlgorithm,
    QgsProcessingMultiStepFeedback,
    QgsProject,
)

from semref.processing import version
from semref.processing.base import shipped_models
from semref.processing.version import algorithm_help_url, guide_url

FILES = ("annotation_to_database", "correction_to_database", "orthophoto_to_disagreements")
IDS = tuple(name.replace("_", "") for name in FILES)
each_id = pytest.mark.parametrize("name", IDS)


def texts_of(algorithm) -> list:
    shown = [algorithm.displayName(), algorithm.group(), algorithm.shortDescription()]
    return shown + [definition.description() for definition in algorithm.parameterDefinitions()]


@each_id
def test_a_copy_has_title_group_and_help_of_the_model_and_every_parameter(create, repository, name):
    algorithm, file = create(name), QgsProcessingModelAlgorithm()
    assert file.fromFile(str(repository / "models" / f"{FILES[IDS.index(name)]}.model3"))
    texts = {key: text for key, text in file.helpContent().items() if key != "ALG_VERSION"}
    assert algorithm.displayName() != name and algorithm.shortDescription() == texts.pop("ALG_DESC")
    assert algorithm.group() == file.group() and algorithm.groupId() in ("annotation", "referencedatabase")
    assert algorithm.shortDescription() in algorithm.shortHelpString() and not algorithm.icon().isNull()
    assert f'run("semref:{name}"' in algorithm.asPythonCommand({}, QgsProcessingContext())
    assert texts and [text for text in texts.values() if text not in algorithm.shortHelpString()] == []
    definitions = {definition.name(): definition for definition in algorithm.parameterDefinitions()}
    assert set(texts) <= set(definitions)
    asked = [key for key, one in definitions.items() if not one.isDestination() and key != "VERBOSE_LOG"]
    assert [key for key in asked if not algorithm.helpContent().get(key)] == []


@each_id
def test_all_texts_and_names_of_layers_are_in_the_users_language(qgis_app, repository, monkeypatch, name):
    monkeypatch.setattr(shipped_models, "tr", lambda text: f"«{text}»")
    monkeypatch.setattr(shipped_models, "group_title", lambda group: f"«{group}»")
    model, logged = shipped_models.ShippedModel(), []
    received = QgsApplication.messageLog().messageReceived[str, str, "Qgis::MessageLevel"]
    received.connect(lambda text, *_: logged.append(text))
    assert model.load(str(repository / "models" / f"{FILES[IDS.index(name)]}.model3"))
    assert logged == []
    assert [text for text in texts_of(model.create()) if not (text.startswith("«") and text.endswith("»"))] == []
    context, project = QgsProcessingContext(), QgsProject()
    names = [output for child in model.childAlgorithms().values() for output in child.modelOutputs()]
    assert names
    # Names that QGIS gives to layers of models, and one of another algorithm.
    for one in (*names, "Houses"):
        context.addLayerToLoadOnCompletion(one, QgsProcessingContext.LayerDetails(one, project, "OUTPUT"))
    model.postProcessAlgorithm(context, QgsProcessingFeedback())
    shown = {path: details.name for path, details in context.layersToLoadOnCompletion().items()}
    assert shown == {**{one: f"«{one}»" for one in names}, "Houses": "Houses"}


def test_a_row_of_a_batch_does_not_replace_the_database_of_an_earlier_row(create, feedback, tmp_path):
    rows = type("BatchFeedback", (QgsProcessingMultiStepFeedback,), {})(2, feedback)
    asked, context = {"build:Reference database": str(tmp_path / "area.gpkg")}, QgsProcessingContext()
    assert [create("annotationtodatabase").prepare(asked, context, rows) for _ in range(2)] == [True, False]
    assert "is also in an earlier row" in feedback.textLog()


@pytest.mark.slow
def test_help_and_names_of_parameters_have_translations(create, repository, monkeypatch):
    monkeypatch.syspath_prepend(repository / "tools" / "release")
    texts = set(importlib.import_module("update_translations").all_texts())
    models = [create(name) for name in IDS]
    assert {definition.description() for model in models for definition in model.parameterDefinitions()} <= texts
    helps = {text for model in models for key, text in model.helpContent().items() if key != "ALG_VERSION"}
    assert helps <= texts


def test_the_reference_page_has_every_algorithm_and_parameter(provider, repository, monkeypatch):
    monkeypatch.setattr(sys, "path", [*sys.path, str(repository / "tools" / "docs")])
    list_algorithms = importlib.import_module("list_algorithms")
    page = list_algorithms.page(provider)
    assert sorted(list_algorithms.ids(page)) == sorted(algorithm.id() for algorithm in provider.algorithms())
    for algorithm in provider.algorithms():
        entry = list_algorithms.entry(algorithm)
        assert entry in page and algorithm.displayName() in entry
        for parameter in algorithm.parameterDefinitions():
            assert f"\n{list_algorithms.parameter_row(parameter)}\n" in entry
        rows = [line for line in entry.splitlines() if line.startswith("| ")]
        assert {line.count("|") for line in rows} == {4}


def test_help_opens_pages_that_come_with_the_plugin(provider, tmp_path):
    for name in ("index.html", "reference/networks.html", "algorithms/builddatabase.html"):
        (tmp_path / "help" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "help" / name).write_text("", encoding="utf-8")
    assert guide_url(root=tmp_path) == (tmp_path / "help" / "index.html").as_uri()
    assert guide_url("reference/networks.md", tmp_path) == (tmp_path / "help" / "reference" / "networks.html").as_uri()
    page = tmp_path / "help" / "algorithms" / "builddatabase.html"
    assert algorithm_help_url("builddatabase", tmp_path) == page.as_uri()
    for algorithm in provider.algorithms():
        assert algorithm.helpUrl() == algorithm_help_url(algorithm.name())


def test_without_built_pages_help_opens_the_index_as_text_or_the_web_page(tmp_path, monkeypatch):
    text = tmp_path / "docs" / "README.md"
    text.parent.mkdir()
    text.write_text("", encoding="utf-8")
    assert version.guide_url(root=tmp_path) == version.algorithm_help_url("builddatabase", tmp_path) == text.as_uri()
    text.unlink()
    monkeypatch.setattr(version, "_metadata", lambda: {"homepage": "https://forge.net/semref"})
    assert version.guide_url(root=tmp_path) == "https://forge.net/semref/blob/main/docs/README.md"
