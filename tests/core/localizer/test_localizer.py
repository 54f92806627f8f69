from dataclasses import replace

import numpy as np
import pytest
from made_labels import TABLE, blobs

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.errors import DatabaseError, LabelMapError
from semref.core.geometry.frame import MapFrame
from semref.core.labels.sources import ArrayLabels
from semref.core.localization import Status
from semref.core.localizer.localizer import Localizer, describe_image

FRAME = MapFrame("a metric CRS", (600000.0, 2.0, 0.0, 5200000.0, 0.0, -2.0))
SIZE, STRIDE = 60, 20
SETTINGS = BuildSettings(2.0 * SIZE, 2.0 * STRIDE, minimum_area=28.0)
MAP = blobs(0, (160, 200), scale=1.8)


def localizer_of(labels, settings=SETTINGS):
    database = replace(build_from_labels(ArrayLabels(labels), FRAME, TABLE, settings, "0"), overview=None)
    return Localizer(database), database.windows


def with_blocks(shape, *blocks):
    labels = np.zeros(shape, np.uint8)
    for column, row, size, value in blocks:
        labels[row : row + size, column : column + size] = value
    return labels


def cut(labels, name, size=SIZE):
    column, row = map(int, name.split("_"))
    return labels[row : row + size, column : column + size]


@pytest.fixture(scope="module")
def localizer_and_windows():
    return localizer_of(MAP)


@pytest.fixture(scope="module")
def localizer(localizer_and_windows):
    return localizer_and_windows[0]


@pytest.mark.parametrize(
    ("image", "reason"),
    [
        (with_blocks((60, 60)), "The image shows 0 landmarks; at least 3 more are needed."),
        (with_blocks((60, 60), (5, 5, 9, 3)), "The image shows 0 landmarks; at least 3 more are needed."),
        (with_blocks((60, 60), (5, 5, 9, 2)), "The image shows 1 landmark; at least 2 more are needed."),
        (with_blocks((60, 60), (5, 5, 9, 2), (25, 9, 9, 5)), "The image shows 2 landmarks; at least 1 more is needed."),
        (with_blocks((1, 1)), "The image shows 0 landmarks; at least 3 more are needed."),
        (np.full((1, 1), 2, np.uint8), "The image shows 0 landmarks; at least 3 more are needed."),
    ],
)
def test_an_image_with_too_few_references_has_no_position(localizer, image, reason):
    result = localizer.localize_by_topology_vector(image)
    assert result.status == Status.TOO_FEW_REFERENCES and f"shows {result.references} l" in str(result.reason) == reason
    assert (result.position, result.distance, result.window, result.confidence) == (None, None, None, None)


@pytest.mark.parametrize("shape", [(0, 0), (0, 20), (20, 0)])
def test_an_image_without_pixels_is_refused(localizer, shape):
    with pytest.raises(LabelMapError, match="^The image has no pixels.$"):
        localizer.localize_by_topology_vector(np.zeros(shape, np.uint8))


@pytest.mark.parametrize("quarter_turns", [0, 1, 2, 3])
def test_an_image_cut_on_a_window_is_found_however_it_is_turned_by_right_angles(localizer_and_windows, quarter_turns):
    localizer, windows = localizer_and_windows
    assert windows.described.sum() > 40
    for k in np.flatnonzero(windows.described):
        result = localizer.localize_by_topology_vector(np.rot90(cut(MAP, windows.names[k]), quarter_turns))
        assert (result.status, result.window, result.window_index) == (Status.FIX, windows.names[k], k)
        assert result.distance < 2e-5 and result.confidence > 0.99999
        expected = tuple(windows.centers[k]), windows.counts[k], None
        assert (result.position, result.references, result.reason) == expected


@pytest.mark.parametrize("factor", [2, 3, 5])
def test_an_image_of_finer_pixels_is_found(factor):
    """Plots of 5 to 12 pixels, each in its own cell, so that centers of gravity do not depend on the pixel size."""
    rng = np.random.default_rng(1)
    cells = [(column, row) for row in range(0, 160, 20) for column in range(0, 200, 20) if rng.random() < 0.9]
    plots = [
        (c + rng.integers(1, 8), r + rng.integers(1, 8), rng.integers(5, 13), rng.choice([2, 5])) for c, r in cells
    ]
    labels = with_blocks((160, 200), *plots)
    localizer, windows = localizer_of(labels)
    assert windows.described.all()
    for name in windows.names:
        result = localizer.localize_by_topology_vector(np.kron(cut(labels, name), np.ones((factor, factor), np.uint8)))
        assert result.window == name and result.distance < 2e-5


@pytest.mark.parametrize(("size", "side"), [(30, 5), (40, 7), (60, 20), (44, 25)])
def test_objects_of_exactly_the_minimum_area_count_in_the_map_and_in_the_image(size, side):
    """In these sizes, a fraction of the window's area ends a rounding error above the area."""
    labels = np.zeros((size, size), np.uint8)
    for row in (4, 12, 20):
        labels[row : row + 2, : side + 1] = 2
    localizer, windows = localizer_of(labels, BuildSettings(2.0 * size, 2.0 * size, minimum_area=4.0 * side))
    assert windows.counts.tolist() == [3]
    assert localizer.localize_by_topology_vector(labels).references == 3


def test_an_image_that_no_vector_is_near_to_is_no_match():
    """Every window has ten plots around its middle, but the image has three: seven vector columns differ."""
    around = [(28 + round(20 * np.cos(a)), 28 + round(20 * np.sin(a)), 5, 5) for a in np.arange(10) * np.pi / 5]
    localizer, _ = localizer_of(with_blocks((60, 60), *around))
    image = with_blocks((60, 60), (5, 28, 5, 2), (28, 5, 5, 2), (50, 40, 5, 2))
    result = localizer.localize_by_topology_vector(image)
    assert result.status == Status.NO_MATCH and result.distance > 2
    said = f"The most similar window has the distance {result.distance:.3f}; at most 2 is accepted."
    assert str(result.reason) == said
    assert (result.position, result.window, result.confidence, result.references) == (None, None, None, 3)


@pytest.mark.parametrize(("above", "left"), [(0, 0), (9, 0), (0, 14), (1, 0)])
def test_an_image_that_is_not_square_is_described_in_its_centered_square(localizer, above, left):
    square = cut(MAP, "40_60")
    framed = np.pad(square, ((above, above), (left, left)), constant_values=2)
    result = localizer.localize_by_topology_vector(framed)
    assert result.window == "40_60"
    described = describe_image(framed, TABLE.reference_values, 7 / 3600, 10)
    alone = describe_image(square, TABLE.reference_values, 7 / 3600, 10)
    assert (described.first_xy, described.size) == ((left, above), 60)
    assert (described.vector == alone.vector).all()
    assert described.objects.centers_xy.tolist() == alone.objects.centers_xy.tolist()


def test_the_smallest_object_is_a_fraction_of_the_square():
    image = with_blocks((50, 80), (20, 5, 6, 2), (30, 20, 11, 2))  # areas 25 and 100 of 2500
    counts = [len(describe_image(image, (2,), fraction, 10).objects) for fraction in (0.01, 0.0101, 0.04, 0.041)]
    assert counts == [2, 1, 1, 0]


def test_with_several_levels_images_of_each_window_size_are_found():
    localizer, windows = localizer_of(MAP, BuildSettings(80.0, 40.0, 28.0, levels=(1.0, 1.5, 2.0)))
    found = []
    for k in np.flatnonzero(windows.described):
        image = cut(MAP, windows.names[k], int(windows.sizes[k] / 2))
        result = localizer.localize_by_topology_vector(image)
        assert result.status == Status.FIX and result.distance < 2e-5
        found.append(result.window_index == k)
    assert set(windows.levels[windows.described]) == {1, 2, 3}
    assert np.mean(found) > 0.99


def test_too_few_references_are_counted_only_where_windows_can_be_matched():
    """Only small windows have vectors here; for large windows the image has a third object."""
    plots = [(42, 2, 4, 2), (52, 4, 4, 5), (46, 12, 4, 2)]
    localizer, windows = localizer_of(with_blocks((40, 60), *plots), BuildSettings(40.0, 40.0, 16.0, levels=(1.0, 2.0)))
    assert windows.names[windows.described].tolist() == ["40_0"]
    image = with_blocks((40, 40), (2, 2, 6, 2), (20, 20, 6, 2), (30, 5, 4, 2))
    result = localizer.localize_by_topology_vector(image)
    assert str(result.reason) == "The image shows 2 landmarks; at least 1 more is needed."
    assert (result.status, result.references) == (Status.TOO_FEW_REFERENCES, 2)


def test_a_database_without_any_vector_is_refused():
    localizer, _ = localizer_of(with_blocks((60, 60), (5, 5, 9, 2), (25, 25, 9, 5)))
    with pytest.raises(DatabaseError, match="No window of the database has the 3 landmarks a topology vector needs"):
        localizer.check("topology vector")


def test_copies_of_a_localizer_share_its_indexes(localizer):
    other = localizer.with_risk(0.5).with_view(np.array([-9 + 9j, 9 + 9j, 9 - 9j, -9 - 9j]))
    assert other.index is localizer.index and other.settings.allowed_risk == 0.5 != localizer.settings.allowed_risk
