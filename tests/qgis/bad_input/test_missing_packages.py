"""Missing or old Python packages are told with how to install them."""

from __future__ import annotations

import importlib.util
import subprocess
import sys

import pytest
from bad_input import (
    OUTPUT_NAMES,
    RASTERIZE,
)
from qgis.core import (
    QgsApplication,
)

from semref.processing.packages import components


def test_a_missing_opencv_is_told_with_how_to_install_it_and_the_algorithms_stay_listed(qgis_app, monkeypatch):
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name, *a: None if name == "cv2" else find_spec(name, *a))
    registry = QgsApplication.processingRegistry()
    listed = [algorithm.id() for algorithm in registry.providerById("semref").algorithms()]
    for algorithm_id in OUTPUT_NAMES:
        assert algorithm_id in listed
        possible, reason = registry.createAlgorithmById(algorithm_id).canExecute()
        assert not possible
        assert "opencv-python-headless" in reason and "python3-opencv" in reason


@pytest.mark.parametrize("name", ["is_missing", "is_too_old"])
@pytest.mark.parametrize("algorithm", ["semref:checkannotation", "semref:repairannotation"])
def test_a_missing_or_old_shapely_is_told_where_it_is_needed(qgis_app, monkeypatch, name, algorithm):
    monkeypatch.setattr(components, name, lambda package: package is components.SHAPELY)
    registry = QgsApplication.processingRegistry()
    needy = registry.createAlgorithmById(algorithm)
    possible, reason = needy.canExecute()
    assert not possible
    assert '"shapely>=2' in reason or "install python3-shapely" in reason
    rasterize = registry.createAlgorithmById(RASTERIZE)
    assert rasterize.canExecute()[0]


@pytest.mark.slow
def test_provider_and_dock_can_be_made_without_opencv_shapely_and_onnxruntime(repository):
    code = (
        "import sys, importlib.util\n"
        "sys.modules.update(cv2=None, shapely=None, onnxruntime=None)\n"
        f"spec = importlib.util.spec_from_file_location('semref', {str(repository / '__init__.py')!r},"
        f" submodule_search_locations=[{str(repository)!r}])\n"
        "package = importlib.util.module_from_spec(spec)\n"
        "sys.modules['semref'] = package\n"
        "spec.loader.exec_module(package)\n"
        "from qgis.core import QgsApplication\n"
        "application = QgsApplication([], False)\n"
        "application.initQgis()\n"
        "import semref.ui.entry\n"
        "from semref.processing.provider import SemRefProvider\n"
        "provider = SemRefProvider()\n"
        "QgsApplication.processingRegistry().addProvider(provider)\n"
        "print(sorted(a.name() for a in provider.algorithms()))\n"
        "sys.stdout.flush()\n"
        "import os\n"
        "os._exit(0)\n"
    )
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=600, check=False)
    assert answer.returncode == 0, answer.stderr
    assert "'checkannotation', 'classifyopenstreetmap', 'classtable', 'combinedatabases'" in answer.stdout
