import numpy as np
import pytest

from semref.core.database.look_alikes import describe_window, window_at
from semref.core.database.model import MapLandmarks, ReferenceDatabase, Windows, first_pixels_of
from semref.core.database.parameters import BuildParameters
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable, LandCoverClass


@pytest.fixture
def database():
    """Return five windows of 100 m, 50 m apart, at vector distances 0, 0.1, 0.2, 0.9 and 0.4 from the first."""
    centers = np.column_stack([np.arange(5) * 50.0 + 50, np.full(5, 50.0)])
    vectors = np.zeros((5, 30), np.float32)
    vectors[:, 0] = (0.0, 0.1, 0.2, 0.9, 0.4)
    corners, sizes = np.column_stack([np.arange(5) * 50, np.zeros(5, int)]), np.full(5, 100.0)
    windows = Windows(corners, np.ones(5, int), sizes, centers, np.full(5, 3), vectors, np.ones(5, bool))
    positions = np.array([[40.0, 50.0], [50.0, 80.0], [90.0, 50.0], [260.0, 50.0]])
    references = MapLandmarks(positions, np.array([1, 2, 1, 1], np.uint8), np.full(4, 200.0), np.zeros(4, bool))
    house = LandCoverClass(1, "house", "#ff0000", "reference")
    table = ClassTable((house, LandCoverClass(2, "water", "#0000ff", "reference")))
    parameters = BuildParameters("", (0, 1, 0, 100, 0, -1), 300, 100, 1.0, 100, 50.0, (1.0,), 10, 100.0, 4, "", "", "")
    return ReferenceDatabase(windows, references, table, parameters)


def test_similar_windows_do_not_overlap(database):
    found = describe_window(database, 0)
    # 50_0 overlaps the window. Of 100_0 (0.2), 200_0 (0.4) and 150_0 (0.9), the last overlaps both others.
    assert database.windows.names[found.look_alikes].tolist() == ["100_0", "200_0"]
    assert found.distances == pytest.approx([0.2, 0.4])


def test_the_landmarks_of_a_window_come_in_the_order_of_its_vector(database):
    # From (50, 50), the landmark 40 m to the right is the farthest and first. Then clockwise: left, then up.
    assert describe_window(database, 0).objects.tolist() == [2, 0, 1]


def test_a_window_without_a_vector_has_no_similar_windows(database):
    database.windows.described[0] = False
    found = describe_window(database, 0)
    assert len(found.objects) == len(found.look_alikes) == 0


@pytest.mark.parametrize(("x", "index"), [(10, 0), (70, 0), (80, 1), (249, 4), (301, -1)])
def test_the_window_at_a_place_is_the_one_with_the_nearest_center(database, x, index):
    assert window_at(database.windows, x, 50) == index


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
