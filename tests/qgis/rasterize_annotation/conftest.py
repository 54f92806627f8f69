import pytest
from made_inputs import read_pixels
from qgis.core import QgsProject
from rasterized import RASTERIZE


@pytest.fixture
def rasterize(runner, tmp_path):
    """`rasterize(layer, **parameters)` returns the results; the label map is tmp_path/labels.tif."""
    return runner(RASTERIZE, "INPUT", CLASS_FIELD="class", PIXEL_SIZE=1, OUTPUT=tmp_path / "labels.tif")


@pytest.fixture
def labels(rasterize):
    """`labels(layer, **parameters)` returns the pixels of the label map."""
    return lambda layer, **parameters: read_pixels(rasterize(layer, **parameters)["OUTPUT"])


@pytest.fixture
def project():
    yield QgsProject.instance()
    QgsProject.instance().clear()
