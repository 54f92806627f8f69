from dataclasses import fields, replace
from functools import partial

import cv2
import numpy as np
import pytest
from made_labels import TABLE, blobs

from semref.core.database import changed_regions, update
from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.database.model import MapLandmarks, Windows
from semref.core.database.tasks import Threads
from semref.core.database.update import update_by_tasks
from semref.core.errors import DatabaseError, LabelMapError
from semref.core.geometry.frame import MapFrame
from semref.core.labels import block_hashes as map_hash_module
from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks.regions import ReachingRegions
from semref.core.steps import result_of

VALUES = (0, 2, 3, 5)
PIXEL = 0.7
FRAME = MapFrame("a metric CRS", (600000.3, PIXEL, 0.0, 5200000.1, 0.0, -PIXEL))
SETTINGS = BuildSettings(window_size=40 * PIXEL, stride=18 * PIXEL, minimum_area=8 * PIXEL**2, levels=(1.0, 1.5))
HEIGHT, WIDTH = 150, 190


@pytest.fixture(autouse=True)
def small_blocks(monkeypatch):
    """Use small blocks, so that a small map has many blocks and tiles."""
    monkeypatch.setattr(map_hash_module, "HASHED_BLOCK", 32)
    monkeypatch.setattr(update, "HASHED_BLOCK", 32)
    monkeypatch.setattr(changed_regions, "HASHED_BLOCK", 32)
    monkeypatch.setattr(changed_regions, "ReachingRegions", partial(ReachingRegions, tile_px=24))


def houses(seed):
    """Return labels of a few small objects; some windows have no objects."""
    rng = np.random.default_rng(seed)
    labels = np.full((HEIGHT, WIDTH), 3, np.uint8)
    for _ in range(120):
        row, column = rng.integers(0, HEIGHT), rng.integers(WIDTH // 3, WIDTH)
        labels[row : row + rng.integers(2, 9), column : column + rng.integers(2, 9)] = rng.choice((2, 5))
    return labels


def rivers(seed):
    """Return labels of long, thin objects across the whole map, some around others, with houses between them."""
    rng = np.random.default_rng(seed)
    labels = houses(seed)
    for _ in range(5):
        points = np.stack([rng.integers(-9, WIDTH + 9, 7), rng.integers(-9, HEIGHT + 9, 7)], axis=1).astype(np.int32)
        cv2.polylines(labels, [points], bool(rng.integers(2)), int(rng.choice((2, 5))), int(rng.integers(1, 4)))
    for inset in (20, 26, 34):
        cv2.rectangle(labels, (inset, inset), (WIDTH - inset, HEIGHT - inset), int(rng.choice((2, 5))), 2)
    return labels


MAPS = {"blobs": lambda seed: blobs(seed, (HEIGHT, WIDTH)), "houses": houses, "rivers": rivers}
MAPS["large blobs"] = lambda seed: blobs(seed, (HEIGHT, WIDTH), scale=5.0)


def built(labels, settings=SETTINGS):
    return build_from_labels(ArrayLabels(labels), FRAME, TABLE, settings, "1.2.3")


def steps_of(source, database, areas=None, frame=FRAME):
    return update_by_tasks(source, frame, database, areas, "1.2.3", Threads(source))


def updated(database, labels, areas=None, frame=FRAME):
    """Return (database, changes) after an update of the database ``before``."""
    changes, old = result_of(steps_of(ArrayLabels(labels), database, areas, frame)), database.references
    kept = np.delete(np.arange(len(old)), changes.removed)
    names = [item.name for item in fields(MapLandmarks)]
    references = {n: np.concatenate([getattr(old, n)[kept], getattr(changes.added, n)]) for n in names}
    overview = database.overview.copy()
    for column, row, piece in changes.overview:
        overview[row : row + piece.shape[0], column : column + piece.shape[1]] = piece
    landmarks = MapLandmarks(**references)
    return replace(
        database, windows=changes.windows, references=landmarks, parameters=changes.parameters, overview=overview
    ), changes


def in_order(references):
    columns = [references.positions, references.classes, references.areas_m2, references.touches_edge]
    rows = np.column_stack([*columns, references.bounds_px])
    return rows[np.lexsort(rows.T)]


def assert_is_the_rebuild(before, labels, areas=None):
    expected = built(labels)
    database, changes = updated(before, labels, areas)
    for item in fields(Windows):
        found, wanted = (getattr(one.windows, item.name) for one in (database, expected))
        np.testing.assert_array_equal(found, wanted, item.name)
    np.testing.assert_array_equal(in_order(database.references), in_order(expected.references))
    np.testing.assert_array_equal(database.overview, expected.overview)
    assert database.parameters == expected.parameters
    return changes


def random_edit(labels, rng):
    """Return (edited map, areas) after one to three random shapes, which may cross the border."""
    edited, areas = labels.copy(), []
    for _ in range(rng.integers(1, 4)):
        before = edited.copy()
        column, row = int(rng.integers(-5, WIDTH)), int(rng.integers(-5, HEIGHT))
        size, value = int(rng.integers(1, 25)), int(rng.choice(VALUES))
        if rng.integers(2):
            cv2.rectangle(edited, (column, row), (column + size, row + size // 2), value, -1)
        else:
            cv2.line(edited, (column, row), (column + size, row - size), value, int(rng.integers(1, 3)))
        rows, columns = np.nonzero(edited != before)
        if len(rows):
            slack = int(rng.integers(0, 4))
            areas.append((columns.min() - slack, rows.min() - slack, columns.max() + 1 + slack, rows.max() + 1 + slack))
    return edited, [tuple(map(int, area)) for area in areas]


@pytest.mark.slow
@pytest.mark.parametrize("kind", MAPS)
@pytest.mark.parametrize("seed", range(6))
def test_random_edits_give_the_rebuild(kind, seed):
    rng = np.random.default_rng(seed)
    labels = MAPS[kind](seed)
    before = built(labels)
    for _ in range(5):
        edited, areas = random_edit(labels, rng)
        assert_is_the_rebuild(before, edited, areas)
        assert_is_the_rebuild(before, edited)


def test_edits_far_apart_and_a_whole_new_map_give_the_rebuild():
    labels = rivers(3)
    edited = labels.copy()
    for row, column in ((0, 0), (HEIGHT - 3, WIDTH - 4), (70, 95), (72, 99)):
        edited[row : row + 3, column : column + 4] = 5
    before = built(labels)
    changes = assert_is_the_rebuild(before, edited)
    assert 0 < len(changes.touched) < len(before.windows)
    assert_is_the_rebuild(before, MAPS["blobs"](9))


def field_with(*shapes):
    labels = np.full((HEIGHT, WIDTH), 3, np.uint8)
    for row, column in np.ndindex(12, 3):
        labels[5 + 12 * row : 9 + 12 * row, 150 + 12 * column : 154 + 12 * column] = 2
    for row, column, height, width in shapes:
        labels[row : row + height, column : column + width] = 5
    return labels


RIVER, POND, U = (0, 90, HEIGHT, 4), (60, 60, 10, 10), ((20, 20, 100, 3), (20, 140, 100, 3), (117, 20, 3, 123))
CHANGES = {
    "pond new": ([], [POND], 0, 1),
    "pond gone": ([POND], [], 1, 0),
    "split": ([POND], [(60, 60, 10, 4), (60, 66, 10, 4)], 1, 2),
    "merged": ([(60, 60, 10, 4), (60, 66, 10, 4)], [POND], 2, 1),
    "river cut": ([RIVER], [(0, 90, 70, 4), (72, 90, HEIGHT - 72, 4)], 1, 2),
    "river joined": ([(0, 90, 70, 4), (72, 90, HEIGHT - 72, 4)], [RIVER], 2, 1),
    "beside the river": ([RIVER], [RIVER, (70, 96, 10, 10)], 0, 1),
    "inside a U": ([*U], [*U, POND], 0, 1),
    "gone inside a U": ([*U, POND], [*U], 1, 0),
    "grown inside a U": ([*U, POND], [*U, (60, 60, 10, 14)], 1, 1),
    "U closed": ([*U], [*U, (60, 20, 3, 123)], 1, 1),
    "river gone": ([RIVER], [], 1, 0),
}


@pytest.mark.slow
@pytest.mark.parametrize(("before", "after", "removed", "added"), CHANGES.values(), ids=CHANGES)
def test_changes_of_objects_are_counted(before, after, removed, added):
    labels, edited = field_with(*before), field_with(*after)
    rows, columns = np.nonzero(labels != edited)
    area = (int(columns.min()), int(rows.min()), int(columns.max()) + 1, int(rows.max()) + 1)
    for areas in ([area], None):
        changes = assert_is_the_rebuild(built(labels), edited, areas)
        assert (len(changes.removed), len(changes.added)) == (removed, added)


def test_windows_away_from_the_change_are_not_touched_unless_their_nearest_one_is():
    labels = rivers(4)
    edited = labels.copy()
    edited[70:80, 80:90] = 2
    before = built(labels)
    changes = assert_is_the_rebuild(before, edited, [(80, 70, 90, 80)])
    for i in changes.touched:
        column, row = before.windows.first_pixels[i]
        size = round(before.windows.sizes[i] / PIXEL)
        reached = column < 90 and column + size > 80 and row < 80 and row + size > 70
        assert reached or changes.windows.distinctiveness[i] != before.windows.distinctiveness[i]


def test_only_the_changed_areas_are_read():
    labels = houses(2)
    edited = labels.copy()
    edited[70:76, 80:86] = 2
    before = built(labels)

    seen = np.zeros(labels.shape, bool)

    class Watched(ArrayLabels):
        def read(self, column, row, width, height):
            seen[row : row + height, column : column + width] = True
            return super().read(column, row, width, height)

    result_of(steps_of(Watched(edited), before, [(80, 70, 86, 76)]))
    assert seen[70:76, 80:86].all() and seen.mean() < 0.6


def test_a_change_outside_the_areas_is_seen_in_a_block_they_touch_or_when_the_whole_map_is_compared():
    labels = houses(2)
    edited = labels.copy()
    edited[70:76, 80:86] = edited[90:94, 66:70] = 2
    assert_is_the_rebuild(built(labels), edited, [(80, 70, 86, 76), (-9, 0, -1, 9)])
    edited = labels.copy()
    edited[70:76, 80:86] = edited[10:16, 80:86] = 2
    half_way, _ = updated(built(labels), edited, [(80, 70, 86, 76)])
    assert half_way.parameters != built(edited).parameters
    assert_is_the_rebuild(half_way, edited)


def test_a_map_that_loses_its_last_reference_object_is_refused():
    labels = np.full((HEIGHT, WIDTH), 3, np.uint8)
    labels[50:60, 50:60] = 2
    before = built(labels)
    with pytest.raises(LabelMapError, match="^The corrected map has no landmark left"):
        updated(before, np.full_like(labels, 3))


@pytest.mark.parametrize(
    ("labels", "transform", "sentence"),
    [
        (houses(0)[1:], FRAME.geotransform, "190 × 149 pixels from 600000.3, 5200000.1, but the data"),
        (houses(0), (600001.0, PIXEL, 0, 5200000.1, 0, -PIXEL), "190 × 150 pixels from 600001, "),
        (houses(0), (600000.3, 1.0, 0, 5200000.1, 0, -1.0), "pixels of 1 m, but the database was built"),
        (houses(0) + 4 * (houses(0) == 3), FRAME.geotransform, "the value 7, which is not a class of the database"),
    ],
    ids=["size", "corner", "pixel size", "classes"],
)
def test_a_map_that_does_not_fit_is_refused(labels, transform, sentence):
    with pytest.raises(LabelMapError, match=f"^The label map has {sentence}"):
        updated(built(houses(0)), labels.astype(np.uint8), frame=MapFrame(FRAME.crs, transform))


def test_databases_without_hashes_or_bounds_or_windows_are_refused():
    database = built(houses(0))
    windows = Windows(*(getattr(database.windows, item.name)[1:] for item in fields(Windows)))
    unhashed = replace(database, parameters=replace(database.parameters, block_hashes=()))
    for lacking, sentence in (
        (unhashed, "built the database without block hashes"),
        (replace(database, references=replace(database.references, bounds_px=None)), "bounds of landmarks"),
        (replace(database, windows=windows), "windows of level 1, but its grid has"),
    ):
        with pytest.raises(DatabaseError, match=sentence):
            updated(lacking, houses(0))
