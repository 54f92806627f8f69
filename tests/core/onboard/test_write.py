import zipfile
from dataclasses import fields, replace

import numpy as np
import pytest
from onboard_blobs import FRAME, TABLE

from semref.core import limits
from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.database.model import Windows
from semref.core.errors import DatabaseError
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.onboard.area import area_mask, clip_database
from semref.core.onboard.read import read_onboard
from semref.core.onboard.write import write_onboard


def test_everything_is_read_within_the_errors_that_the_file_states(database, written):
    found = read_onboard(str(written))
    mine, theirs = database.windows, found.database.windows
    assert found.database.parameters == replace(database.parameters, block_hashes=())
    assert found.database.class_table == TABLE
    for name in ("first_pixels", "names", "levels", "sizes", "counts", "described"):
        np.testing.assert_array_equal(getattr(theirs, name), getattr(mine, name))
    np.testing.assert_array_equal(theirs.centers, mine.centers)
    assert np.abs(theirs.vectors - mine.vectors).max() <= found.vector_error * 1.0001
    np.testing.assert_array_equal(theirs.vectors[:, 20:], mine.vectors[:, 20:])
    mine, theirs = database.references, found.database.references
    np.testing.assert_array_equal(theirs.classes, mine.classes)
    np.testing.assert_array_equal(theirs.touches_edge, mine.touches_edge)
    assert found.position_error == pytest.approx(0.1)
    assert 0 < np.abs(theirs.positions - mine.positions).max() <= found.position_error * 1.0001
    assert 0 < np.abs(theirs.areas_m2 / mine.areas_m2 - 1).max() <= found.area_error
    np.testing.assert_array_equal(found.database.overview, database.overview)


def test_a_database_of_no_windows_and_no_overview_comes_back(database, tmp_path):
    path = str(tmp_path / "bare.npz")
    arrays = {item.name: getattr(database.windows, item.name) for item in fields(Windows)}
    windows = Windows(**{name: array if array is None else array[:0] for name, array in arrays.items()})
    write_onboard(path, replace(database, windows=windows, overview=None), None)
    found = read_onboard(path)
    assert (len(found.database.windows), found.database.overview, found.lon_lat) == (0, None, None)
    assert len(found.database.references) == len(database.references)


def test_windows_and_references_keep_to_their_budget(database, written):
    with zipfile.ZipFile(written) as archive:
        size = {info.filename: info.compress_size for info in archive.infolist()}
    windows, references = (
        sum(bytes_ for name, bytes_ in size.items() if name.startswith(kind)) for kind in ("windows", "references")
    )
    assert windows <= 40 * len(database.windows)
    assert references <= 20 * len(database.references)


def test_a_class_table_that_was_changed_after_the_build_is_not_exported(database, tmp_path):
    table = ClassTable((*TABLE.classes, LandCoverClass(9, "new", "#123456")))
    with pytest.raises(DatabaseError, match="was changed after the build"):
        write_onboard(str(tmp_path / "changed.npz"), replace(database, class_table=table), None)


@pytest.mark.parametrize("precision", [1e-9, 0.0, -1.0, float("nan"), float("inf")])
def test_a_precision_that_is_too_fine_or_no_length_is_refused(database, tmp_path, precision):
    with pytest.raises(DatabaseError, match="too fine" if precision == 1e-9 else "it must be more than 0 m"):
        write_onboard(str(tmp_path / "odd.npz"), database, None, precision=precision)


def landmarks_of(database, **changes):
    return replace(database, references=replace(database.references, **changes))


def test_what_the_format_can_not_hold_is_refused(database, tmp_path, monkeypatch):
    nothing = {item.name: getattr(database.references, item.name)[:0] for item in fields(database.references)}
    areas = np.append(database.references.areas_m2[:-1], 0.0)
    sizes = database.windows.sizes.copy()
    sizes[0] *= 1.5
    misfit = replace(database, windows=replace(database.windows, sizes=sizes))
    for odd, said in (
        (landmarks_of(database, **nothing), "no landmark to export"),
        (landmarks_of(database, areas_m2=areas), "A landmark has no area"),
        (misfit, "The windows have other sizes than their levels"),
        (database, "The header of the onboard file has"),
    ):
        if odd is database:
            monkeypatch.setattr(limits, "HEADER_BYTES", 100)
        with pytest.raises(DatabaseError, match=said):
            write_onboard(str(tmp_path / "odd.npz"), odd, None)
    assert not list(tmp_path.iterdir())


OVERVIEW_PIXEL = 8.0
RING = np.array([(600200, 5199900), (600500, 5199900), (600500, 5199600), (600200, 5199600), (600200, 5199900)])


@pytest.fixture(scope="module")
def squared():
    """Return a database of 800 × 640 m with a square landmark every 20 m."""
    labels = np.zeros((320, 400), np.uint8)
    for row in range(2, 316, 10):
        for column in range(2, 396, 10):
            labels[row : row + 4, column : column + 4] = 2
    return build_from_labels(ArrayLabels(labels), FRAME, TABLE, BuildSettings(120.0, 40.0, 28.0), "1.2.3")


def within(points_xy, margin):
    low, high = RING.min(axis=0) - margin, RING.max(axis=0) + margin
    return ((points_xy >= low) & (points_xy <= high)).all(axis=1)


def test_the_mask_is_the_area_to_a_pixel_of_the_overview_and_a_ring_within_another_is_a_hole(squared):
    mask = area_mask([RING], squared.parameters)
    assert mask.shape == squared.overview.shape
    assert mask[14:49, 26:62].all()
    assert mask.sum() == mask[12:51, 24:64].sum()
    hole = RING.mean(axis=0) + (RING - RING.mean(axis=0)) / 3
    mask = area_mask([RING, hole], squared.parameters)
    assert mask[15, 30] and not mask[31, 43]


def test_only_the_content_of_the_area_is_kept_and_an_area_without_landmarks_is_refused(squared):
    part = clip_database(squared, area_mask([RING], squared.parameters))
    assert within(part.references.positions, OVERVIEW_PIXEL).all()
    assert within(part.windows.centers, OVERVIEW_PIXEL).all()
    least, most = (within(squared.references.positions, margin).sum() for margin in (-OVERVIEW_PIXEL, OVERVIEW_PIXEL))
    assert 0 < least <= len(part.references) <= most
    assert part.overview.shape == squared.overview.shape
    assert not part.overview[:, : 200 // 8 - 1].any() and part.overview[20:40, 30:60].any()
    with pytest.raises(DatabaseError, match="area contains no landmark"):
        clip_database(squared, np.zeros(squared.overview.shape, bool))
