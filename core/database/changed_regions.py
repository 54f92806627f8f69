"""Places where a corrected label map differs from a database's, and the affected landmarks."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..labels.block_hashes import HASHED_BLOCK, blocks_shape
from ..labels.sources import LabelSource
from ..landmarks.landmarks import minimum_area_px, objects_from_rows, rows_array
from ..landmarks.regions import Bounds, ReachingRegions
from ..landmarks.tiles import measure_region
from ..steps import Shares, mapped, scaled
from .build import map_references
from .model import MapLandmarks, ReferenceDatabase


def changed_landmarks(
    source: LabelSource, database: ReferenceDatabase, places: Sequence[Bounds]
) -> Shares[tuple[np.ndarray, MapLandmarks]]:
    """Find removed and added landmarks.

    Landmarks without a changed pixel remain; the others are searched in the new map only.

    Args:
        source: The new map.
        database: Database of the old map, with the landmarks' bounds.
        places: Result of ``changed_places``.

    Returns:
        (K,) int64 indices of the removed landmarks of the database, in order, and the new or changed landmarks.
    """
    values, removed, added = database.class_table.reference_values, list[int](), list[tuple]()
    for n, value in enumerate(values):
        found = yield from scaled(_compare(source, database, places, value), n / len(values), (n + 1) / len(values))
        removed += found[0]
        added += found[1]
    return np.array(sorted(removed), np.int64), _landmarks(added, source, database)


def _landmarks(rows: list[tuple], source: LabelSource, database: ReferenceDatabase) -> MapLandmarks:
    return map_references(objects_from_rows(rows_array(rows), source.shape_hw), database.parameters.frame)


def _compare(
    source: LabelSource, database: ReferenceDatabase, places: Sequence[Bounds], value: int
) -> Shares[tuple[list[int], list[tuple]]]:
    """Return the indices of the removed landmarks of one class, and the rows of the added ones."""
    parameters, references = database.parameters, database.references
    minimum_area = minimum_area_px(parameters.minimum_area, parameters.frame.pixel_size)
    inside, regions = yield from mapped(ReachingRegions(source, value, places, minimum_area).steps(), lambda _: 0.3)
    rows = list(map(tuple, inside.tolist()))
    for n, region in enumerate(regions, start=1):
        row = measure_region(source, value, region, minimum_area)
        rows += [] if row is None else [row]
        yield 0.3 + 0.6 * n / len(regions)
    new = {_key(_landmarks([row], source, database), 0): row for row in rows}
    meeting = (references.classes == value) & _meets_any(references.required_bounds, places)
    # Unchanged landmarks inside a changed place remain.
    gone = [k for k in np.flatnonzero(meeting).tolist() if new.pop(_key(references, k), None) is None]
    # Of the others, those remain that meet a changed place without having a pixel in it. Their pixels outside the
    # places, and on the outermost lines of the places, are unchanged. So a landmark with pixels inside and outside
    # shares some with a new region that crosses the border of a place.
    outside = [b for b in (_bounds_of(references, k) for k in gone) if not any(_holds(place, b) for place in places)]
    doubtful = [bounds for bounds in outside if any(_meet(bounds, region.bounds) for region in regions)]
    # A region has a pixel in the first row of its bounds.
    tops = _joined([(left, top, right, top + 1) for left, top, right, _ in doubtful])
    _, others = yield from mapped(ReachingRegions(source, value, tops, minimum_area).steps(), lambda _: 0.9)
    # Two regions of one class can't have the same bounds: they would cross and be one region.
    remaining = {region.bounds for region in others - regions} | set(outside) - set(doubtful)
    return [k for k in gone if _bounds_of(references, k) not in remaining], list(new.values())


def _bounds_of(landmarks: MapLandmarks, k: int) -> Bounds:
    left, top, right, bottom = landmarks.required_bounds[k].tolist()
    return left, top, right, bottom


def _key(landmarks: MapLandmarks, k: int) -> tuple:
    """Return what identifies a landmark: bounds, position and area."""
    return (*landmarks.required_bounds[k].tolist(), *landmarks.positions[k].tolist(), float(landmarks.areas_m2[k]))


# --- places ---


def changed_places(before: Sequence[str], now: Sequence[str], shape_hw: tuple[int, int]) -> list[Bounds]:
    """Return disjoint rectangles that contain the changed blocks and a line of unchanged pixels around them.

    They contain whole blocks, even if only a corner of one was reported as changed, because its hash is for all of it.

    Args:
        before: Block hashes of the old map, row by row.
        now: Those of the new map.
        shape_hw: (height, width) of the maps.
    """
    height, width = shape_hw
    columns = blocks_shape(shape_hw)[1]
    found = []
    for i, (old, new) in enumerate(zip(before, now)):
        if old != new:
            left, top, right, bottom = block_bounds(divmod(i, columns), shape_hw)
            found.append(_common((left - 1, top - 1, right + 1, bottom + 1), (0, 0, width, height)))
    return _joined(found)


def blocks_of(area: Bounds, shape_hw: tuple[int, int]) -> set[tuple[int, int]]:
    """Return (row, column) of the hashed blocks that share a pixel with ``area``."""
    left, top, right, bottom = _common(area, (0, 0, shape_hw[1], shape_hw[0]))
    if left >= right or top >= bottom:
        return set()
    rows = range(top // HASHED_BLOCK, (bottom - 1) // HASHED_BLOCK + 1)
    columns = range(left // HASHED_BLOCK, (right - 1) // HASHED_BLOCK + 1)
    return {(row, column) for row in rows for column in columns}


def block_bounds(block: tuple[int, int], shape_hw: tuple[int, int]) -> Bounds:
    """Return the bounds of a hashed block (row, column) on a map of ``shape_hw`` pixels."""
    top, left = block[0] * HASHED_BLOCK, block[1] * HASHED_BLOCK
    return left, top, min(left + HASHED_BLOCK, shape_hw[1]), min(top + HASHED_BLOCK, shape_hw[0])


def _holds(outer: Bounds, inner: Bounds) -> bool:
    return outer[0] <= inner[0] and outer[1] <= inner[1] and outer[2] >= inner[2] and outer[3] >= inner[3]


def _meet(a: Bounds, b: Bounds) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def _meets_any(bounds: np.ndarray, places: Sequence[Bounds]) -> np.ndarray:
    """Return (N,) bool: which of the (N, 4) rectangles share a pixel with one of ``places``."""
    found = np.zeros(len(bounds), bool)
    for left, top, right, bottom in places:
        found |= (bounds[:, 0] < right) & (bounds[:, 2] > left) & (bounds[:, 1] < bottom) & (bounds[:, 3] > top)
    return found


def _common(a: Bounds, b: Bounds) -> Bounds:
    return max(a[0], b[0]), max(a[1], b[1]), min(a[2], b[2]), min(a[3], b[3])


def _joined(places: Sequence[Bounds]) -> list[Bounds]:
    """Return disjoint rectangles: overlapping ones are replaced by the one around both."""
    joined: list[Bounds] = []
    waiting = sorted(places)
    while waiting:
        place = waiting.pop()
        meeting = [other for other in joined if _meet(place, other)]
        if meeting:
            joined = [other for other in joined if not _meet(place, other)]
            lefts, tops, rights, bottoms = zip(place, *meeting)
            waiting.append((min(lefts), min(tops), max(rights), max(bottoms)))
        else:
            joined.append(place)
    return sorted(joined)
