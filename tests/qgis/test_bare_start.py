"""The plugin starts in a QGIS without the packages of SemRef; a process hides them."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.newer

DATA = Path(__file__).resolve().parents[1] / "data"
TIMEOUT_S = 120


@pytest.fixture(scope="module")
def start() -> dict:
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": str(DATA / "bare")}
    command = [sys.executable, str(DATA / "bare_start.py")]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=TIMEOUT_S, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


def test_nothing_that_starts_with_qgis_imports_numpy_or_a_package_that_qgis_may_lack(start):
    assert start["errors"] == [] and not start["loads_numpy"]


def test_dock_and_sample_project_name_missing_packages_and_the_dock_opens_the_installer(start):
    assert "OpenCV, Pillow, Shapely, ONNX Runtime" in start["notice"]
    assert start["options"] == ["SemRefOptions"]
    assert [text for text in start["bar"] if "The sample project needs OpenCV, Pillow" in text]


def test_each_algorithm_but_that_of_openstreetmap_names_the_missing_package_and_the_installer(start):
    assert {name for name, sentences in start["refusals"].items() if not sentences} == {"classifyopenstreetmap"}
    assert start["classified"] == 2
    for name, sentences in start["refusals"].items():
        assert all("Settings ▸ Options ▸ SemRef" in sentence for sentence in sentences), (name, sentences)
        assert len(set(sentences)) <= 1, (name, sentences)
