import cv2
import numpy as np
import pytest
from made_labels import blobs

from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks.landmarks import extract_landmarks, rows_from_objects
from semref.core.landmarks.regions import ReachingRegions
from semref.core.landmarks.tiles import measure_region
from semref.core.steps import result_of

PLACES = [(20, 10, 55, 41), (90, 50, 121, 75), (0, 100, 30, 120), (140, 0, 150, 1)]


def winding():
    labels = np.zeros((120, 150), np.uint8)
    cv2.polylines(labels, [np.array([(0, 5), (140, 20), (10, 60), (149, 110)], np.int32)], False, 5, 2)
    cv2.circle(labels, (40, 95), 12, 5, 2)
    labels[60, 120] = 5
    # The line reaches the last row: with tiles of 12 and 16 the map ends where a tile ends.
    labels[100:, 149] = 5
    return labels


YS, XS = np.indices((120, 150))
MAPS = {
    "winding": winding(),
    "blobs": blobs(3, (120, 150), (0, 5), 2.0),
    "crumbs": blobs(3, (120, 150), (0, 5), 0.7),
    "corners": np.where((YS // 2 + XS // 2) % 4 == 0, 5, 0).astype(np.uint8),
}


def found_in(labels, places, tile, source=None):
    return result_of(ReachingRegions(source or ArrayLabels(labels), 5, places, 1.0, tile).steps())


@pytest.mark.parametrize("tile", [7, 12, 16, 30, 1000])
@pytest.mark.parametrize("name", MAPS)
def test_what_has_a_pixel_in_a_place_is_found_whole(name, tile):
    labels = MAPS[name]
    rows, regions = found_in(labels, PLACES, tile)
    source = ArrayLabels(labels)
    measured = [measure_region(source, 5, region, 1.0) for region in regions]
    found = {tuple(row) for row in rows.tolist()} | {row for row in measured if row}
    _, parts = cv2.connectedComponents((labels == 5).astype(np.uint8), connectivity=8)
    touched = {n for left, top, right, bottom in PLACES for n in np.unique(parts[top:bottom, left:right]).tolist()}
    kept = np.where(np.isin(parts, list(touched - {0})), 5, 0).astype(np.uint8)
    assert found == {tuple(row) for row in rows_from_objects(extract_landmarks(kept, (5,), 1.0)).tolist()}
    assert len(found) > 1


def test_only_tiles_that_a_region_goes_on_to_are_read():
    labels = np.zeros((120, 150), np.uint8)
    labels[30:40, 30:40] = labels[35, 40:70] = 5
    seen = np.zeros(labels.shape, int)

    class Watched(ArrayLabels):
        def read(self, column, row, width, height):
            seen[row : row + height, column : column + width] += 1
            return super().read(column, row, width, height)

    found_in(labels, [(28, 28, 45, 45)], 16, Watched(labels))
    assert seen[28:45, 28:45].min() == seen.max() == 1 and seen[35, :71].sum() >= 40
    assert not seen[:20].any() and not seen[60:].any() and not seen[:, 90:].any()
