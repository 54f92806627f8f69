"""What a part of a label map needs of the polygons to burn."""

import numpy as np

from semref.core.annotation.job import BurnJob
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable


def job(outlines, bounds):
    return BurnJob(
        MapFrame("", (0.0, 1.0, 0.0, 9.0, 0.0, -1.0), (9, 9)),
        ClassTable(()),
        np.arange(1, len(outlines) + 1).astype(np.uint8),
        np.array(bounds, float).reshape(-1, 4),
        np.cumsum([len(outline) for outline in outlines], dtype=np.int64),
        np.frombuffer(b"".join(outlines), np.uint8),
    )


def test_a_part_gets_the_polygons_that_reach_into_it_in_their_order():
    made = job([b"abc", b"de", b"", b"fghi"], [(0, 0, 1, 1), (5, 5, 6, 6), (1, 1, 2, 2), (2, 0, 9, 0.5)])
    values, ends, outlines = made.within((0.5, 0.0, 2.0, 1.0))
    assert values.tolist() == [1, 3, 4] and ends.tolist() == [3, 3, 7] and outlines.tobytes() == b"abcfghi"
    values, ends, outlines = made.within((20.0, 20.0, 30.0, 30.0))
    assert len(values) == len(ends) == len(outlines) == 0


def test_no_polygon_is_no_trouble():
    values, ends, outlines = job([], []).within((0.0, 0.0, 1.0, 1.0))
    assert len(values) == len(ends) == len(outlines) == 0
