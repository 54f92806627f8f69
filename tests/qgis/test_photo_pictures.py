"""Photos in the dock: originals of drones are reduced to its size."""

import numpy as np
import pytest
from made_inputs import write_raster

from semref.processing.inspection.image import photo_rgba

HALVES = np.zeros((3, 300, 401), np.uint8)
HALVES[0, :, :200], HALVES[2, :, 200:] = 200, 100


@pytest.mark.parametrize(("longest", "shape"), [(1600, (300, 401)), (401, (300, 401)), (100, (60, 80)), (1, (1, 1))])
def test_a_photo_is_shown_no_larger_than_asked(qgis_app, tmp_path, longest, shape):
    shown = photo_rgba(str(write_raster(tmp_path / "a.png", HALVES, transform=None)), longest)
    assert shown.shape == (*shape, 4) and shown.dtype == np.uint8 and (shown[..., 3] == 255).all()
    if shape[1] > 1:
        height, width = shape
        assert shown[height // 2, width // 4].tolist() == [200, 0, 0, 255]
        assert shown[height // 2, 3 * width // 4].tolist() == [0, 0, 100, 255]


def test_a_photo_of_16_bits_is_shown_stretched_when_reduced(qgis_app, tmp_path):
    shown = photo_rgba(str(write_raster(tmp_path / "a.tif", HALVES.astype(np.uint16) * 20, transform=None)), 100)
    assert shown.shape == (60, 80, 4) and shown[30, 20, 0] > 200 and shown[30, 60, 0] < 50


@pytest.mark.real_data
def test_an_original_of_a_drone_is_shown(qgis_app, real_data):
    shown = photo_rgba(str(real_data("dji_brighton_beach/DJI_0018.JPG")), 1600)
    assert max(shown.shape[:2]) <= 1600 and shown[..., :3].std() > 10
