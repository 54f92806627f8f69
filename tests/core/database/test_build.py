import math
import re
import threading
import time

import numpy as np
import pytest
from made_labels import TABLE, blobs

from semref.core.database.build import BuildSettings, build_by_tasks, build_from_labels, level_grids
from semref.core.database.tasks import Threads
from semref.core.errors import ClassTableError, LabelMapError, WindowError
from semref.core.geometry.frame import MapFrame
from semref.core.labels.overview import HeldOverview, most_frequent_labels
from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks.landmarks import extract_landmarks
from semref.core.windows.topology_vector import topology_vector

PIXEL = 2.0
FRAME = MapFrame("a metric CRS", (600000.0, PIXEL, 0.0, 5200000.0, 0.0, -PIXEL))
SETTINGS = BuildSettings(window_size=80.0, stride=36.0, minimum_area=20.0)


def steps_of(labels, settings=SETTINGS, table=TABLE, threads=1):
    frame = FRAME.of_shape(labels.shape)
    overview = HeldOverview(frame.reduced(settings.overview_factor).shape_hw)
    return build_by_tasks(frame, table, settings, "1.2.3", Threads(ArrayLabels(labels), threads), overview.put)


def built(labels, settings=SETTINGS, table=TABLE, frame=FRAME):
    return build_from_labels(ArrayLabels(labels), frame, table, settings, "1.2.3")


def refuses(error, sentence):
    return pytest.raises(error, match=f"^{re.escape(sentence)}$")


@pytest.fixture(scope="module")
def labels():
    return blobs(0, (90, 110))


@pytest.fixture(scope="module")
def database(labels):
    return built(labels)


@pytest.mark.parametrize(
    ("made", "area"), [(np.zeros((90, 110), np.uint8), 20.0), (np.full((90, 110), 3, np.uint8), 20.0), (None, math.inf)]
)
def test_a_map_without_landmarks_is_refused(labels, made, area):
    with pytest.raises(LabelMapError, match=f"^The map has no region of building, water with at least {area:g} m²;"):
        built(labels if made is None else made, BuildSettings(80.0, 36.0, area))


def test_a_table_without_reference_classes_is_refused_before_any_work(labels):
    with pytest.raises(ClassTableError, match="^No class is a reference class. Choose at least one of 2 building"):
        next(steps_of(labels, table=TABLE.with_references([])))


@pytest.mark.parametrize("area", [0.0, -1.0, float("nan")])
def test_a_minimum_area_of_nothing_is_refused(area):
    with refuses(WindowError, f"The minimum area is {area:g} m²; it must be more than 0."):
        BuildSettings(80.0, 36.0, area)


@pytest.mark.parametrize("count", [0, 2])
def test_a_vector_too_short_for_three_references_is_refused(count):
    with refuses(WindowError, f"A vector of {count} landmarks is too short; use at least 3."):
        BuildSettings(80.0, 36.0, 20.0, references_per_vector=count)


@pytest.mark.parametrize("levels", [(), (0.0,), (1.0, -2.0), (float("nan"),), (float("inf"),)])
def test_levels_that_are_no_multipliers_are_refused(levels):
    with refuses(WindowError, "The levels must be positive multipliers of the window size, for example 1;2."):
        BuildSettings(80.0, 36.0, 20.0, levels=levels)


@pytest.mark.parametrize(
    ("window_size", "stride", "levels", "sentence"),
    [
        (0.0, 0.0, (1.0,), "Window size (0 px) and stride (0 px) must be at least one pixel"),
        (182.0, 36.0, (1.0,), "The window (91 px) is larger than the map (110 × 90 px)"),
        (100.0, 36.0, (1.0, 2.0), "The window (100 px) is larger than the map (110 × 90 px)"),
        (80.0, 82.0, (1.0,), "The stride (41 px) is larger than the window (40 px)"),
        (80.0, 36.0, (0.01,), "Window size (0 px) and stride (0 px) must be at least one pixel"),
    ],
)
def test_windows_that_do_not_fit_the_map_are_refused_before_any_work(labels, window_size, stride, levels, sentence):
    with pytest.raises(WindowError, match=f"^{re.escape(sentence)}"):
        next(steps_of(labels, BuildSettings(window_size, stride, 20.0, levels)))


def test_windows_are_at_the_place_of_their_name(database):
    windows = database.windows
    assert len(windows) == 3 * 4
    assert set(windows.names) == {f"{c}_{r}" for c in (0, 18, 36, 54) for r in (0, 18, 36)}
    for name, center in zip(windows.names, windows.centers):
        column, row = map(int, name.split("_"))
        assert center.tolist() == [600000 + (column + 20) * PIXEL, 5200000 - (row + 20) * PIXEL]
    assert set(windows.sizes) == {80.0} and set(windows.levels) == {1}


def test_every_window_has_the_vector_of_the_image_cut_there(labels, database):
    windows = database.windows
    for k, name in enumerate(windows.names):
        column, row = map(int, name.split("_"))
        objects = extract_landmarks(labels[row : row + 40, column : column + 40], (2, 5), 20 / PIXEL**2)
        vector = topology_vector(objects.centers_xy, objects.classes, (20, 20), (2, 5))
        assert windows.counts[k] == len(objects)
        assert windows.described[k] == (vector is not None)
        np.testing.assert_allclose(windows.vectors[k], vector, rtol=0, atol=2e-6)


def test_references_are_the_objects_of_the_map_in_map_units(labels, database):
    objects = extract_landmarks(labels, (2, 5), 20 / PIXEL**2)
    references = database.references
    assert len(references) == len(objects) > 20
    np.testing.assert_allclose(references.positions[:, 0], 600000 + PIXEL * objects.centers_xy[:, 0], rtol=1e-12)
    np.testing.assert_allclose(references.positions[:, 1], 5200000 - PIXEL * objects.centers_xy[:, 1], rtol=1e-12)
    np.testing.assert_allclose(references.areas_m2, PIXEL**2 * objects.areas_px)
    assert references.classes.tolist() == objects.classes.tolist()
    assert references.touches_edge.tolist() == objects.touches_edge.tolist()
    assert references.areas_m2.min() >= 20


def test_windows_with_too_few_references_are_kept_without_a_vector():
    labels = np.zeros((90, 110), np.uint8)
    for column in (2, 12, 22):
        labels[5:9, column : column + 4] = 2
    windows = built(labels).windows
    described = dict(zip(windows.names.tolist(), windows.described.tolist()))
    assert described.pop("0_0") and not any(described.values())
    counts = dict(zip(windows.names.tolist(), windows.counts.tolist()))
    assert (counts["0_0"], counts["18_0"], counts["54_36"]) == (3, 1, 0)
    assert not windows.vectors[~windows.described].any()


@pytest.mark.parametrize("levels", [(1.0,), (1.0, 2.0), (0.5, 1.0, 1.5)])
def test_each_level_has_a_grid_whose_window_and_stride_grow_together(labels, levels):
    settings = BuildSettings(80.0, 36.0, 20.0, levels)
    windows = built(labels, settings).windows
    assert sorted(set(windows.levels.tolist())) == list(range(1, len(levels) + 1))
    for number, (level, grid) in enumerate(zip(levels, level_grids(labels.shape, PIXEL, settings)), start=1):
        assert (grid.size, grid.stride) == (40 * level, 18 * level)
        assert (windows.levels == number).sum() == len(grid)
        assert set(windows.sizes[windows.levels == number]) == {80.0 * level}


def test_parameters_show_how_the_database_was_built(database):
    parameters = database.parameters
    assert (parameters.crs, parameters.geotransform) == (FRAME.crs, FRAME.geotransform)
    assert (parameters.map_width_px, parameters.map_height_px, parameters.pixel_size) == (110, 90, PIXEL)
    assert (parameters.window_size, parameters.stride, parameters.minimum_area) == (80.0, 36.0, 20.0)
    assert (parameters.levels, parameters.references_per_vector, parameters.overview_factor) == ((1.0,), 10, 4)
    assert (parameters.plugin_version, parameters.format_version) == ("1.2.3", 1)
    assert parameters.class_table_hash == TABLE.digest()


def test_the_map_hash_changes_with_one_pixel(labels, database):
    changed = labels.copy()
    changed[89, 109] = 3 if labels[89, 109] != 3 else 0
    hashes = {built(piece).parameters.map_hash for piece in (labels, labels.copy(), changed)}
    assert len(hashes) == 2 and database.parameters.map_hash in hashes


@pytest.mark.parametrize("factor", [1, 3, 4, 16])
def test_the_overview_is_the_map_reduced(labels, factor):
    database = built(labels, BuildSettings(80.0, 36.0, 20.0, overview_factor=factor))
    assert (database.overview == most_frequent_labels(labels, factor)).all()


@pytest.mark.slow
@pytest.mark.parametrize("steps_taken", [0, 1, 3, 6])
@pytest.mark.parametrize("threads", [1, 3])
def test_stopping_half_way_leaves_no_thread(labels, steps_taken, threads):
    before = threading.active_count()
    steps = steps_of(labels, BuildSettings(40.0, 4.0, 20.0), threads=threads)
    for _ in range(steps_taken):
        next(steps)
    steps.close()
    until = time.monotonic() + 20
    while threading.active_count() > before and time.monotonic() < until:
        time.sleep(0.01)
    # Threads of earlier tests may have ended meanwhile.
    assert threading.active_count() <= before


def test_distinctiveness_is_the_distance_to_the_nearest_window_elsewhere(labels):
    windows = built(labels, BuildSettings(40.0, 20.0, 20.0)).windows
    found = windows.distinctiveness
    for k in np.flatnonzero(windows.described):
        apart = np.abs(windows.centers - windows.centers[k]).max(axis=1) >= 40.0
        vectors = windows.vectors[apart & windows.described].astype(float)
        expected = np.linalg.norm(vectors - windows.vectors[k], axis=1).min()
        assert found[k] == pytest.approx(expected, abs=2e-3)
    assert np.isnan(found[~windows.described]).all()


def test_a_window_without_others_or_without_vector_has_no_distinctiveness():
    labels = np.zeros((90, 110), np.uint8)
    labels[5:9, 2:6] = 2
    assert np.isnan(built(labels).windows.distinctiveness).all()
    one = built(blobs(0, (90, 110)), BuildSettings(180.0, 180.0, 20.0)).windows.distinctiveness
    assert len(one) == 1 and np.isnan(one).all()
