"""Features laid on each other: what is seen from above, and what was wrong on the way."""

from __future__ import annotations

import pytest
from made_annotation import feature, numbered, square

from semref.core.annotation.findings import NOTHING, OVERLAP
from semref.core.annotation.polygons import AnnotatedPolygons
from semref.core.annotation.surface import laid_polygons


def laid(features, ranks_of=AnnotatedPolygons.drawn_ranks):
    """The surface, its findings, and the steps that were told."""
    findings, told = [], []
    steps = laid_polygons(numbered(features), ranks_of, findings)
    while True:
        try:
            told.append(next(steps))
        except StopIteration as stopped:
            return stopped.value, findings, told


@pytest.mark.parametrize(
    ("ranks_of", "seen"), [(AnnotatedPolygons.drawn_ranks, 9.0), (AnnotatedPolygons.repair_ranks, 5.0)]
)
def test_what_lies_on_top_is_as_asked(ranks_of, seen):
    surface, findings, _ = laid([feature(square(0, 0, 2), 1), feature(square(0, 0, 3), 2)], ranks_of)
    assert surface.partition.areas[surface.classes == 2].sum() == pytest.approx(seen)
    assert OVERLAP in {f.kind for f in findings}


def test_a_hole_is_seen_as_nothing():
    surface, _, _ = laid([feature(square(0, 0, 9).difference(square(3, 3, 2)))])
    assert surface.partition.areas[surface.classes == NOTHING].tolist() == pytest.approx([4])
    assert surface.top[surface.classes == NOTHING].tolist() == [-1]


def test_progress_only_grows():
    shares = [share for _, share in laid([feature(square(0, 0, 5))])[2]]
    assert shares == sorted(shares)
    assert 0 <= shares[0] < shares[-1] < 1
