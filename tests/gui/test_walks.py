"""The ways of a newcomer through the real thing: desktop QGIS, its dialogs, its project, with mouse and with keys."""

from __future__ import annotations

from pathlib import Path

import pytest
from desktop_qgis import walk

pytestmark = pytest.mark.slow  # a QGIS of its own is started


@pytest.fixture(scope="module")
def walks(repository, display, tmp_path_factory) -> dict:
    """What walks_session.py saw."""
    return walk(repository, tmp_path_factory.mktemp("walks"), display, Path(__file__).with_name("walks_session.py"), {})


def test_no_walk_ends_in_a_python_error(walks):
    assert walks["messages"] == [] and "Traceback" not in walks["output"]


@pytest.mark.parametrize("way", ["build_mouse", "build_keys"])
def test_a_database_built_in_the_toolbox_is_on_the_map_and_in_the_dock_after_one_click(walks, way):
    built = walks[way]
    assert built["succeeded"] == [True] and built["clicks"] == 1
    assert built["groups"] == [["built", ["Landmarks", "Windows", "Overview"]]]
    assert built["in_the_dock"] and built["in_a_dialog"]


def test_batch_and_model_designer_offer_the_databases_at_hand(walks):
    assert walks["forms"] == {"in_batch": 1, "in_designer": 1}


@pytest.mark.parametrize("way", ["correct_mouse", "correct_keys"])
def test_a_check_is_gone_through_and_ends_in_the_updated_database(walks, way):
    walked = walks[way]
    assert walked["is_chosen"] and walked["has_undo"] and walked["left"] == 0
    # One to the first place, one for each of them, one for the update.
    assert walked["clicks"] == walked["places"] + 2
    assert walked["state"].startswith("The database is up to date")
