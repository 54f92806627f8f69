"""Run semref:rasterizeannotation."""

from pathlib import Path

import pytest
from made_inputs import read_pixels
from qgis.core import QgsProject
from rasterized import RASTERIZE


@pytest.fixture
def rasterize(run_algorithm, feedback, tmp_path):
    """`rasterize(layer, **parameters)` returns the results; the label map is tmp_path/labels.tif."""

    def run(layer, **parameters):
        source = str(layer) if isinstance(layer, Path) else layer
        defaults = {"CLASS_FIELD": "class", "PIXEL_SIZE": 1, "OUTPUT": str(tmp_path / "labels.tif")}
        return run_algorithm(RASTERIZE, {"INPUT": source, **defaults, **parameters}, feedback)

    return run


@pytest.fixture
def labels(rasterize):
    """`labels(layer, **parameters)` returns the pixels of the label map."""
    return lambda layer, **parameters: read_pixels(rasterize(layer, **parameters)["OUTPUT"])


@pytest.fixture
def project():
    yield QgsProject.instance()
    QgsProject.instance().clear()
