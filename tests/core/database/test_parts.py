"""A build cut into tasks gives the database of one process, whatever the order in which they are done."""

import cv2
import numpy as np
import pytest

from semref.core.database import parts
from semref.core.database.build import BuildSettings, DatabaseBuilder
from semref.core.database.parts import TASKS, PartsBuilder, tile_boxes, window_boxes
from semref.core.errors import LabelMapError
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.windows import describe
from semref.core.windows.grid import WindowGrid

TABLE = ClassTable(
    (LandCoverClass(2, "building", "#ff0000", "reference"), LandCoverClass(5, "water", "#0000ff", "reference"))
)
FRAME = MapFrame("a metric CRS", (600000.0, 2.0, 0.0, 5200000.0, 0.0, -2.0))
SETTINGS = BuildSettings(window_size=200.0, stride=74.0, minimum_area=20.0, levels=(1.0, 2.5))


def landscape(height=1300, width=1150, seed=0):
    noise = np.random.default_rng(seed).random((3, height, width)).astype(np.float32)
    smooth = np.stack([cv2.GaussianBlur(layer, (0, 0), 9) for layer in noise])
    return np.array((0, 2, 5), np.uint8)[smooth.argmax(axis=0)]


LABELS = landscape()


class Loop:
    """Does the tasks here, the last first, as machines of unequal speed might."""

    def __init__(self, labels):
        self._source = ArrayLabels(labels)
        self.done = []

    def __call__(self, task, calls, shared=()):
        self.done.append(task)
        for number, arguments in list(enumerate(calls))[::-1]:
            yield number, TASKS[task](self._source, *shared, *arguments)


def in_parts(labels, settings=SETTINGS):
    frame = FRAME.of_shape(labels.shape)
    overview = np.zeros(frame.reduced(settings.overview_factor).shape_hw, np.uint8)

    def put(column, row, piece):
        overview[row : row + piece.shape[0], column : column + piece.shape[1]] = piece

    builder = PartsBuilder(frame, TABLE, settings, "1.2.3", Loop(labels), put)
    shares = [share for _, share in builder.steps()]
    assert shares == sorted(shares) and shares[-1] == pytest.approx(1)
    return builder.database, overview


def in_one(labels, settings=SETTINGS):
    builder = DatabaseBuilder(ArrayLabels(labels), FRAME, TABLE, settings, "1.2.3")
    for steps in (builder.steps(), builder.compare_windows()):
        for _ in steps:
            pass
    return builder.database, builder.overview


@pytest.fixture
def small_pieces(monkeypatch):
    monkeypatch.setattr(parts, "TILE_WIDTH", 512)
    monkeypatch.setattr(parts, "TILE_PIXELS", 512 * 512)
    monkeypatch.setattr(parts, "PART_PIXELS", 90_000)
    monkeypatch.setattr(parts, "REGIONS_A_TASK", 3)
    monkeypatch.setattr(parts, "COMPARED_A_TASK", 7)


def assert_equal(one, other):
    for group in ("windows", "references"):
        for name, value in vars(getattr(one, group)).items():
            np.testing.assert_array_equal(value, getattr(getattr(other, group), name), err_msg=name)
    assert one.parameters == other.parameters and one.class_table == other.class_table


@pytest.mark.usefixtures("small_pieces")
def test_a_build_in_parts_is_that_of_one_process_to_the_last_bit():
    (database, overview), (expected, whole) = in_parts(LABELS), in_one(LABELS)
    assert len(expected.windows) > 200 and len(expected.references) > 100
    assert_equal(database, expected)
    np.testing.assert_array_equal(overview, whole)


@pytest.mark.usefixtures("small_pieces")
def test_windows_keep_the_order_of_wide_maps(monkeypatch):
    """There one process takes blocks of columns, one after the other."""
    monkeypatch.setattr(describe.column_blocks, "__defaults__", (30_000,))
    monkeypatch.setattr(describe.describe_windows, "__defaults__", (1, 30_000))
    assert_equal(in_parts(LABELS)[0], in_one(LABELS)[0])


def test_a_map_of_one_piece_is_built_as_well():
    labels = LABELS[:300, :400]
    settings = BuildSettings(window_size=200.0, stride=74.0, minimum_area=20.0)
    assert_equal(in_parts(labels, settings)[0], in_one(labels, settings)[0])


def test_a_map_without_landmarks_is_refused():
    with pytest.raises(LabelMapError, match="no landmark|No region"):
        in_parts(np.zeros((600, 600), np.uint8))


@pytest.mark.parametrize("shape", [(300, 200), (1300, 1150), (5000, 20_000)])
@pytest.mark.parametrize("factor", [1, 3, 4])
def test_tiles_cover_the_map_once_and_begin_with_whole_blocks(shape, factor):
    covered = np.zeros((shape[0] // 10, shape[1] // 10), int)
    for column, row, width, height in tile_boxes(shape, factor):
        assert column % 512 == row % 512 == column % factor == row % factor == 0
        covered[-(-row // 10) : -(-(row + height) // 10), -(-column // 10) : -(-(column + width) // 10)] += 1
    assert (covered == 1).all()


@pytest.mark.usefixtures("small_pieces")
def test_each_window_belongs_to_one_part():
    grid = WindowGrid(1150, 1300, 100, 37)
    found = [
        (x, y)
        for column, row, width, height in window_boxes(grid)
        for x in (column + WindowGrid(width, height, 100, 37).columns).tolist()
        for y in (row + WindowGrid(width, height, 100, 37).rows).tolist()
    ]
    assert sorted(found) == sorted((x, y) for x in grid.columns.tolist() for y in grid.rows.tolist())
