"""The walk with *Set up an area* to the first position, in desktop QGIS: what it takes, and that it gets there.

Instead of training, a small program returns the shipped model, so that the test takes a minute. If
SEMREF_TRAINING_PYTHON is a Python with torch, a real training of two minutes runs as well.
"""

import importlib.util
import os
import shutil
import sys
from pathlib import Path

import pytest
from desktop_qgis import make_package
from made_trainer import write_trainer

pytestmark = pytest.mark.slow  # a QGIS of its own is started

MINUTES = 2
FARTHEST_M = 10
"""For photos 640 m across. With a network of a few minutes the 95 % radius may be too small."""


@pytest.fixture(scope="module")
def tool(repository, display):
    if shutil.which("qgis") is None or shutil.which("xvfb-run") is None:
        pytest.skip("desktop QGIS or xvfb-run is not installed")
    folder = repository / "tools" / "docs"
    sys.path.append(str(folder))
    spec = importlib.util.spec_from_file_location("time_walk", folder / "time_walk.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    yield module
    sys.path.remove(str(folder))


@pytest.fixture(scope="module", params=["stand-in", "torch"])
def walk(request, tool, repository, tmp_path_factory) -> dict:
    home = tmp_path_factory.mktemp("walk")
    python = os.environ.get("SEMREF_TRAINING_PYTHON", "")
    if request.param == "stand-in":
        python = write_trainer(home / "python_that_trains", repository / "models" / "sample_area.onnx")
    elif not Path(python).is_file():
        pytest.skip("SEMREF_TRAINING_PYTHON names no Python with torch")
    package = home / "semref.zip"
    make_package(repository, package)
    return tool.walk(package, home / "home", None, str(python), MINUTES)


def test_every_step_is_gone_with_few_clicks(walk, tool):
    assert [name for name, *_ in walk["steps"]] == list(tool.STEPS)
    # A model of its own takes one more than a real place.
    assert sum(clicks for _, clicks, *_ in walk["steps"]) <= 10


def test_photos_are_found_where_they_were_taken(walk):
    assert walk["fixes"] > 0 and walk["photos"] == 12
    assert max(walk["off_m"]) < FARTHEST_M


def test_the_walk_becomes_a_table(walk, tool):
    table = tool.walk_table(walk, MINUTES)
    assert table.count("\n|") == len(tool.STEPS) + 2
    assert f"{walk['fixes']} of 12 photos have a position" in table and "of 10 photos" in table
