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


def test_the_help_of_every_algorithm_leads_to_its_heading_in_the_guide(provider, tool):
    from semref.processing.version import guide_url

    page = tool.PAGE.read_text(encoding="utf-8")
    # As forges make a heading an anchor.
    anchors = {heading.replace(":", "").lower() for heading in tool.sections(page)}
    for algorithm in provider.algorithms():
        address, _, anchor = algorithm.helpUrl().partition("#")
        assert address == guide_url("guide/toolbox.md")
        assert anchor in anchors, f"{algorithm.id()}: run tools/docs/list_algorithms.py"
