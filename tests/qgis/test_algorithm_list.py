"""The reference page lists every algorithm with its parameters, and the Help buttons open the right pages."""

import importlib
import sys

import pytest
from qgis.core import QgsApplication

from semref.processing import version
from semref.processing.version import algorithm_help_url, guide_url


@pytest.fixture
def provider(qgis_app):
    return QgsApplication.processingRegistry().providerById("semref")


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
    own = (tmp_path / "help" / "algorithms" / "builddatabase.html").as_uri()
    assert algorithm_help_url("builddatabase", tmp_path) == own
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
