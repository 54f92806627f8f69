import threading
import time
from dataclasses import replace

import numpy as np
import pytest
from made_labels import TABLE, blobs

from semref.core.database import build
from semref.core.database.build import BuildSettings, build_by_tasks, tile_boxes
from semref.core.database.tasks import TASKS, Threads
from semref.core.geometry.frame import MapFrame
from semref.core.labels.overview import HeldOverview
from semref.core.labels.sources import ArrayLabels
from semref.core.steps import advance

FRAME = MapFrame("a metric CRS", (600000.0, 2.0, 0.0, 5200000.0, 0.0, -2.0))
SETTINGS = BuildSettings(window_size=200.0, stride=74.0, minimum_area=20.0, levels=(1.0, 2.5))
LABELS = blobs(0, (1300, 1150), (0, 2, 5), 9)


def wait_until(holds):
    until = time.monotonic() + 20
    while not holds() and time.monotonic() < until:
        time.sleep(0.01)
    assert holds()


class Loop:
    """Run the tasks in this process."""

    def __init__(self, labels):
        self._source = ArrayLabels(labels)
        self.done = []

    def __call__(self, task, calls, shared=()):
        self.done.append(task)
        for arguments in calls:
            yield TASKS[task](self._source, *shared, *arguments)


def built(run, labels, settings=SETTINGS):
    frame = FRAME.of_shape(labels.shape)
    overview = HeldOverview(frame.reduced(settings.overview_factor).shape_hw)
    steps, shares = build_by_tasks(frame, TABLE, settings, "1.2.3", run, overview.put), []
    step, database = advance(steps)
    while step is not None:
        shares.append(step[1])
        step, database = advance(steps)
    assert shares == sorted(shares) and shares[-1] == pytest.approx(1)
    return replace(database, overview=overview.labels)


@pytest.fixture
def whole():
    return built(Threads(ArrayLabels(LABELS)), LABELS)


@pytest.fixture
def small_pieces(monkeypatch, whole):
    monkeypatch.setattr(build, "TILE_WIDTH", 512)
    monkeypatch.setattr(build, "TILE_PIXELS", 512 * 512)
    monkeypatch.setattr(build, "SHARED_HEIGHT", 0.0)
    monkeypatch.setattr(build, "REGIONS_A_TASK", 3)
    monkeypatch.setattr(build, "COMPARED_A_TASK", 7)


def assert_equal(one, other):
    for group in ("windows", "references"):
        for name, value in vars(getattr(one, group)).items():
            np.testing.assert_array_equal(value, getattr(getattr(other, group), name), err_msg=name)
    assert one.parameters == other.parameters and one.class_table == other.class_table
    np.testing.assert_array_equal(one.overview, other.overview)


@pytest.mark.slow
@pytest.mark.usefixtures("small_pieces")
@pytest.mark.parametrize("runner", [Loop, lambda labels: Threads(ArrayLabels(labels), 3)], ids=["loop", "threads"])
def test_a_build_in_small_pieces_by_any_runner_is_that_of_large_ones_to_the_last_bit(whole, runner):
    assert len(whole.windows) > 200 and len(whole.references) > 100
    assert_equal(built(runner(LABELS), LABELS), whole)


@pytest.mark.slow
def test_wide_maps_have_blocks_of_columns_one_after_the_other(monkeypatch):
    settings = replace(SETTINGS, levels=(1.0,))
    narrow = built(Loop(LABELS), LABELS, settings).windows
    monkeypatch.setattr(build, "STRIP_PIXELS", 30_000)
    wide = built(Loop(LABELS), LABELS, settings).windows
    columns, rows = wide.first_pixels.T.tolist()
    block = np.cumsum(np.diff(rows, prepend=0) < 0)
    assert block[-1] > 2 and np.array_equal(np.lexsort((columns, rows, block)), np.arange(len(wide)))
    order = [wide.names.tolist().index(name) for name in narrow.names.tolist()]
    np.testing.assert_array_equal(wide.vectors[order], narrow.vectors)
    np.testing.assert_array_equal(wide.distinctiveness[order], narrow.distinctiveness)


def test_what_a_check_raises_ends_threads_that_are_in_the_midst_of_a_task(monkeypatch):
    started, ended = threading.Event(), []

    def endless(source):
        started.set()
        try:
            while True:
                source.read(0, 0, 1, 1)
        finally:
            ended.append(True)

    def check():
        if started.is_set():
            raise KeyError("canceled")

    monkeypatch.setitem(TASKS, "scan", endless)
    with pytest.raises(KeyError, match="canceled"):
        list(Threads(ArrayLabels(LABELS), 2, check)("scan", [()] * 5))
    wait_until(lambda: ended)
    assert len(ended) < 5


@pytest.mark.parametrize("shape", [(300, 200), (1300, 1150), (5000, 20_000)])
@pytest.mark.parametrize("factor", [1, 3, 4])
def test_tiles_cover_the_map_once_and_begin_with_whole_blocks(shape, factor):
    covered = np.zeros((shape[0] // 10, shape[1] // 10), int)
    for column, row, width, height in tile_boxes(shape, factor):
        assert column % 512 == row % 512 == column % factor == row % factor == 0
        covered[-(-row // 10) : -(-(row + height) // 10), -(-column // 10) : -(-(column + width) // 10)] += 1
    assert (covered == 1).all()
