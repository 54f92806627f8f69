"""Triangles of a cut of a made catalogue."""

import numpy as np

from semref.core.constellation.hypotheses import query_triangles
from semref.core.constellation.settings import CONSTELLATION

TRUE = (900.0, 1100.0, 70.0, 1.1)
"""East and north of the origin, heading and pixel size of the cut."""


def test_objects_that_are_cut_or_of_unknown_class_make_no_triangles(cut):
    query = cut(*TRUE).query
    query.whole[::4] = False
    query.ranks[1::4] = -1
    triangles = query_triangles(query, CONSTELLATION)
    assert len(triangles) == len(triangles.numbers) == len(triangles.tolerances) > 50
    assert set(np.unique(triangles.members % 4)) == {2, 3}
