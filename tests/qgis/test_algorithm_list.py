"""The guide lists every algorithm with its keys, and the Help buttons of their dialogs lead there."""

from __future__ import annotations

import importlib.util

import pytest
from qgis.core import QgsApplication


@pytest.fixture
def provider(qgis_app):
    return QgsApplication.processingRegistry().providerById("semref")


@pytest.fixture
def tool(repository):
    spec = importlib.util.spec_from_file_location(
        "list_algorithms", repository / "tools" / "docs" / "list_algorithms.py"
    )
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_list_of_algorithms_in_the_guide_is_up_to_date(provider, tool):
    page = tool.PAGE.read_text(encoding="utf-8")
    assert page == tool.with_listing(page, tool.listing(provider)), "run tools/docs/list_algorithms.py"


def test_the_help_of_every_algorithm_leads_to_its_heading_in_the_guide(provider, tool, tmp_path):
    from semref.processing.version import algorithm_help_url, guide_url

    page = tool.PAGE.read_text(encoding="utf-8")
    # As forges make a heading an anchor.
    anchors = {heading.replace(":", "").lower() for heading in tool.sections(page)}
    for algorithm in provider.algorithms():
        assert algorithm.helpUrl() == algorithm_help_url(algorithm.name())
        address, _, anchor = algorithm_help_url(algorithm.name(), tmp_path).partition("#")
        assert address == guide_url("how-to/toolbox.md", tmp_path)
        assert anchor in anchors, f"{algorithm.id()}: run tools/docs/list_algorithms.py"


def test_help_opens_pages_that_come_with_the_plugin_and_needs_no_network(provider, tmp_path):
    from semref.processing.version import algorithm_help_url, guide_url

    for name in ("user_guide.html", "index.html", "algorithms/builddatabase.html"):
        (tmp_path / "help" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "help" / name).write_text("", encoding="utf-8")
    assert guide_url(root=tmp_path) == (tmp_path / "help" / "user_guide.html").as_uri()
    assert guide_url("README.md", tmp_path) == (tmp_path / "help" / "index.html").as_uri()
    own = (tmp_path / "help" / "algorithms" / "builddatabase.html").as_uri()
    assert algorithm_help_url("builddatabase", tmp_path) == own


def test_where_no_pages_were_made_help_opens_their_text_while_nobody_has_said_where_the_web_has_them(tmp_path):
    from semref.processing import version

    text = tmp_path / "docs" / "user_guide.md"
    text.parent.mkdir()
    text.write_text("", encoding="utf-8")
    assert version.guide_url(root=tmp_path) == text.as_uri()


def test_where_no_pages_were_made_help_opens_the_web_when_there_is_one(tmp_path, monkeypatch):
    from semref.processing import version

    monkeypatch.setattr(version, "_metadata", lambda: {"homepage": "https://forge.net/semref"})
    assert version.guide_url(root=tmp_path) == "https://forge.net/semref/blob/main/docs/user_guide.md"
