"""Databases in parts: read together they are the database of the whole map, and the newest tells the ground."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from semref.core.database.build import BuildSettings, DatabaseBuilder
from semref.core.database.joined import cut_landmarks, joined_database, joined_overview, joined_parameters
from semref.core.errors import DatabaseError
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels

TABLE = ClassTable(
    (
        LandCoverClass(2, "building", "#ff0000", "reference"),
        LandCoverClass(3, "forest", "#00ff00"),
        LandCoverClass(5, "water", "#0000ff", "reference"),
    )
)
PIXEL = 0.5
FRAME = MapFrame("a metric CRS", (600000.0, PIXEL, 0.0, 5200000.0, 0.0, -PIXEL))
SETTINGS = BuildSettings(window_size=40.0, stride=20.0, minimum_area=2.0, levels=(1.0, 2.0), overview_factor=8)
HEIGHT, WIDTH = 403, 485
MARGIN = 80


def landscape(seed=0):
    noise = np.random.default_rng(seed).random((3, HEIGHT, WIDTH)).astype(np.float32)
    smooth = np.stack([cv2.GaussianBlur(layer, (0, 0), 2.5) for layer in noise])
    smooth[1] += 0.03
    return np.array((2, 3, 5), np.uint8)[smooth.argmax(axis=0)]


LABELS = landscape()


def built(labels, column=0, row=0, settings=SETTINGS, table=TABLE, name="whole"):
    frame = FRAME.part(column, row, labels.shape)
    builder = DatabaseBuilder(ArrayLabels(labels), frame, table, settings, "1.2.3")
    for steps in (builder.steps(), builder.compare_windows()):
        for _ in steps:
            pass
    return replace(builder.database, overview=builder.overview, source=name)


def sheet(labels, left, top, right, bottom, **more):
    return built(np.ascontiguousarray(labels[top:bottom, left:right]), left, top, **more)


def four(labels=LABELS, margin=MARGIN):
    middle_x, middle_y = 240, 240
    ends = {"w": (0, middle_x + margin), "e": (middle_x - margin, WIDTH)}
    sides = {"n": (0, middle_y + margin), "s": (middle_y - margin, HEIGHT)}
    return [
        sheet(labels, left, top, right, bottom, name=f"{north}{west}.gpkg")
        for north, (top, bottom) in sides.items()
        for west, (left, right) in ends.items()
    ]


def joined(parts):
    found = joined_database(parts, "set")
    parameters = [part.parameters for part in parts]
    return replace(found, overview=joined_overview(parameters, [part.overview for part in parts], found.parameters))


def rows_of(landmarks):
    columns = landmarks.positions, landmarks.classes, landmarks.areas_m2, landmarks.touches_edge, landmarks.bounds_px
    return {tuple(row) for row in np.column_stack(columns).tolist()}


def assert_landmarks_equal(one, other):
    for name, value in vars(one).items():
        np.testing.assert_array_equal(value, getattr(other, name), err_msg=name)


def test_sheets_with_a_margin_are_the_whole_map():
    whole, together = built(LABELS), joined(four())
    assert len(whole.references) > 300 and whole.references.touches_edge.any()
    assert_landmarks_equal(together.references, whole.references)
    np.testing.assert_array_equal(together.overview, whole.overview)
    np.testing.assert_array_equal(np.unique(together.references.classes), (2, 5))
    hidden = {"map_hash": "", "block_hashes": ()}
    assert replace(together.parameters, **hidden) == replace(whole.parameters, **hidden)
    assert cut_landmarks(together, [part.parameters for part in four()]) == 0


def test_windows_are_those_of_the_whole_map_where_sheets_begin_at_its_strides():
    whole, together = built(LABELS).windows, joined(four()).windows
    order = np.lexsort((*whole.first_pixels.T, whole.levels))
    for name in ("first_pixels", "levels", "sizes", "centers", "counts", "vectors", "described"):
        np.testing.assert_array_equal(getattr(together, name), getattr(whole, name)[order], err_msg=name)
    assert together.distinctiveness is None and len(together) > 100


def test_the_order_of_the_parts_does_not_matter_where_their_maps_agree():
    parts = four()
    assert_landmarks_equal(joined(parts[::-1]).references, joined(parts).references)
    np.testing.assert_array_equal(joined(parts[::-1]).overview, joined(parts).overview)


def test_a_newer_part_tells_the_ground_that_both_show():
    changed = LABELS.copy()
    changed[150:230, 200:290] = 3
    changed[180:190, 230:250] = 2
    newer, older = sheet(changed, 120, 80, WIDTH, HEIGHT, name="new.gpkg"), four()
    truth, together = built(changed), joined([*older, newer])
    assert rows_of(together.references) == rows_of(truth.references)
    np.testing.assert_array_equal(together.overview, truth.overview)
    # As the oldest it tells nothing that the others show.
    assert rows_of(joined([newer, *older]).references) == rows_of(built(LABELS).references)


def test_a_small_new_part_within_a_large_old_one_changes_its_ground_alone():
    changed = LABELS.copy()
    changed[160:240, 160:240] = 3
    changed[190:200, 190:220] = 5
    patch = sheet(changed, 120, 120, 280, 280, name="patch.gpkg")
    together = joined([built(LABELS), patch])
    kept = rows_of(together.references)
    # What crosses the patch's edge is whole in the old part alone.
    lost = rows_of(built(changed).references) ^ kept
    assert all(row[5] < 160 + 80 and row[7] > 160 and row[6] < 240 and row[8] > 160 for row in lost) or not lost
    assert (5, 190, 190, 220, 200) in {(row[2], *row[5:]) for row in kept}
    assert not together.references.touches_edge[
        (together.references.bounds_px[:, :2] >= 130).all(axis=1)
        & (together.references.bounds_px[:, 2:] <= 270).all(axis=1)
    ].any()


def test_a_landmark_that_no_sheet_has_whole_stays_a_landmark_of_the_edge():
    labels = np.full((HEIGHT, WIDTH), 3, np.uint8)
    labels[90:110, 20 : WIDTH - 20] = 5
    labels[20:30, 20:40] = labels[300:320, 400:430] = labels[300:320, 30:60] = labels[30:50, 400:420] = 2
    parts = four(labels)
    together = joined(parts)
    cut = together.references.touches_edge
    assert together.references.classes[cut].tolist() == [5, 5] and len(together.references) == 6
    assert cut_landmarks(together, [part.parameters for part in parts]) == 2
    assert rows_of(together.references) - rows_of(built(labels).references) == {
        row for row in rows_of(together.references) if row[4]
    }


def test_sheets_without_a_margin_have_all_landmarks_but_those_on_their_seams():
    whole, parts = built(LABELS), four(margin=0)
    together = joined(parts)
    missing = rows_of(whole.references) - rows_of(together.references)
    assert missing and all((row[5] <= 240 <= row[7]) or (row[6] <= 240 <= row[8]) for row in missing)
    bounds = together.references.bounds_px[together.references.touches_edge]
    assert len(bounds) > whole.references.touches_edge.sum()
    np.testing.assert_array_equal(together.overview, whole.overview)


def test_a_landmark_that_touches_a_corner_only_is_cut_where_the_part_beyond_goes_on():
    labels = np.full((160, 160), 3, np.uint8)
    labels[60:80, 60:80] = labels[80:100, 80:100] = 5
    labels[10:20, 10:20] = labels[10:20, 140:150] = labels[140:150, 10:20] = 2
    boxes = [(0, 0, 80, 80), (80, 0, 160, 80), (0, 80, 80, 160), (80, 80, 160, 160)]
    small = replace(SETTINGS, levels=(1.0,))
    together = joined([sheet(labels, *box, settings=small, name=f"{n}.gpkg") for n, box in enumerate(boxes)])
    assert together.references.touches_edge[together.references.classes == 5].tolist() == [True, True]
    assert not together.references.touches_edge[together.references.classes == 2].any()


def test_ground_that_no_part_has_is_unlabeled():
    apart = [sheet(LABELS, 0, 0, 160, 160, name="a"), sheet(LABELS, 240, 200, WIDTH, HEIGHT, name="b")]
    together = joined(apart)
    assert together.overview.shape == built(LABELS).overview.shape
    assert not together.overview[:20, 30:].any() and together.overview[:20, :20].all()


def test_one_part_is_itself():
    whole = built(LABELS)
    assert_landmarks_equal(joined([whole]).references, whole.references)
    np.testing.assert_array_equal(joined([whole]).overview, whole.overview)


def test_the_hash_is_another_after_each_change_and_order():
    parts = [part.parameters for part in four()]
    named = [(f"{n}", part) for n, part in enumerate(parts)]
    known = joined_parameters(named).map_hash
    changed = [*named[:3], ("3", replace(parts[3], map_hash="another"))]
    hashes = {known, joined_parameters(changed).map_hash, joined_parameters(named[::-1]).map_hash}
    assert len(hashes) == 3 and joined_parameters(named).map_hash == known


def test_the_least_accurate_map_counts():
    parts = [part.parameters for part in four()[:2]]
    worse = [("a", replace(parts[0], map_accuracy=3.0)), ("b", replace(parts[1], map_accuracy=0.5))]
    assert joined_parameters(worse).map_accuracy == 3.0


OTHERS = {
    "database.parts_other_setting": replace(SETTINGS, minimum_area=3.0),
    "levels": replace(SETTINGS, levels=(1.0,)),
    "stride": replace(SETTINGS, stride=10.0),
}


@pytest.mark.parametrize("settings", OTHERS.values(), ids=OTHERS)
def test_parts_that_were_built_otherwise_are_named(settings):
    parts = [
        sheet(LABELS, 0, 0, 160, 160, name="a.gpkg"),
        sheet(LABELS, 160, 0, 320, 160, settings=settings, name="b.gpkg"),
    ]
    with pytest.raises(DatabaseError, match=r"b\.gpkg was built with another .* than a\.gpkg"):
        joined_database(parts, "set")


def test_another_pixel_size_is_named():
    parts = four()[:2]
    other = replace(
        parts[1],
        parameters=replace(
            parts[1].parameters, pixel_size=0.6, geotransform=(600000.0, 0.6, 0.0, 5200000.0, 0.0, -0.6)
        ),
    )
    with pytest.raises(DatabaseError, match=r"ne\.gpkg has pixels of 0\.6 m and nw\.gpkg of 0\.5 m"):
        joined_database([parts[0], other], "set")


@pytest.mark.parametrize("column", (161, 164))
def test_parts_off_the_overviews_grid_are_named(column):
    parts = [sheet(LABELS, 0, 0, 160, 160, name="a.gpkg"), sheet(LABELS, column, 0, column + 160, 160, name="b.gpkg")]
    with pytest.raises(DatabaseError, match=rf"b\.gpkg begins {column} pixels .* multiples of 8 pixels \(4 m\)"):
        joined_database(parts, "set")


def test_other_classes_are_named():
    table = ClassTable(tuple(replace(c, name="house") if c.value == 2 else c for c in TABLE))
    parts = [sheet(LABELS, 0, 0, 160, 160, name="a.gpkg"), sheet(LABELS, 160, 0, 320, 160, table=table, name="b.gpkg")]
    with pytest.raises(DatabaseError, match=r"b\.gpkg has another class table than a\.gpkg"):
        joined_database(parts, "set")


def test_parts_that_would_make_a_map_beyond_all_memory_are_refused():
    near = sheet(LABELS, 0, 0, 160, 160, name="a.gpkg").parameters
    far = replace(near, geotransform=(600000.0 + 4e6, PIXEL, 0.0, 5200000.0 - 4e6, 0.0, -PIXEL))
    with pytest.raises(DatabaseError, match="lie so far apart"):
        joined_parameters([("a.gpkg", near), ("b.gpkg", far)])


def test_a_part_without_bounds_is_named():
    parts = four()[:2]
    old = replace(parts[1], references=replace(parts[1].references, bounds_px=None))
    with pytest.raises(DatabaseError, match=r"ne\.gpkg was made by SemRef 1\.2\.3, which kept no bounds"):
        joined_database([parts[0], old], "set")
