"""Missing or old Python packages are reported with their installation."""

from __future__ import annotations

import importlib.util

import pytest
from bad_input import OUTPUT_NAMES, RASTERIZE
from qgis.core import QgsApplication

from semref.processing.packages import components


def test_a_missing_opencv_is_reported_and_the_algorithms_stay_listed(qgis_app, monkeypatch):
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name, *a: None if name == "cv2" else find_spec(name, *a))
    registry = QgsApplication.processingRegistry()
    listed = [algorithm.id() for algorithm in registry.providerById("semref").algorithms()]
    for algorithm_id in OUTPUT_NAMES:
        assert algorithm_id in listed
        possible, reason = registry.createAlgorithmById(algorithm_id).canExecute()
        assert not possible
        assert "pip install" in reason and "opencv-python-headless>=" in reason


@pytest.mark.parametrize("name", ["is_missing", "is_too_old"])
@pytest.mark.parametrize("algorithm", ["semref:checkannotation", "semref:repairannotation"])
def test_a_missing_or_old_shapely_is_reported_by_its_algorithms(qgis_app, monkeypatch, name, algorithm):
    monkeypatch.setattr(components, name, lambda package: package is components.SHAPELY)
    registry = QgsApplication.processingRegistry()
    needy = registry.createAlgorithmById(algorithm)
    possible, reason = needy.canExecute()
    assert not possible
    assert '"shapely>=2' in reason
    rasterize = registry.createAlgorithmById(RASTERIZE)
    assert rasterize.canExecute()[0]
