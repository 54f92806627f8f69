"""Windows have their pixels on the label map and the name of their first pixel."""

import numpy as np
import pytest

from semref.core.database.model import Windows, first_pixels_of
from semref.core.geometry.frame import MapFrame

FRAME = MapFrame.at((600000.3, 5200000.1), 0.7, (900, 1200))
PIXELS = np.array([[0, 0], [18, 36], [1011, 0]])
SIZES = np.array([40, 61, 40]) * 0.7
CENTERS = FRAME.to_map(PIXELS + np.array([[20], [30.5], [20]]))


def test_first_pixels_come_back_from_the_places_of_windows():
    np.testing.assert_array_equal(first_pixels_of(CENTERS, SIZES, FRAME), PIXELS)
    assert first_pixels_of(CENTERS[:0], SIZES[:0], FRAME).shape == (0, 2)


@pytest.mark.parametrize("moved", [(0.1, 0), (0, 0.3), (-0.7, 0)], ids=["right", "up", "off the map"])
def test_a_window_beside_the_pixels_or_the_map_is_refused(moved):
    with pytest.raises(ValueError, match="is not aligned with the label map's pixels"):
        first_pixels_of(CENTERS + moved, SIZES, FRAME)


def test_a_window_is_named_after_its_first_pixel():
    empty = np.zeros(3)
    windows = Windows(PIXELS, empty, SIZES, CENTERS, empty, np.zeros((3, 30), np.float32), empty > 0)
    assert windows.names.tolist() == ["0_0", "18_36", "1011_0"] == [windows.name(k) for k in range(len(windows))]
