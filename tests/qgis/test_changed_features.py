"""Changed features of a land-cover layer since a database was updated from it."""

import pytest
from qgis.core import QgsRectangle

from semref.processing.inspection.correction import DrawnFeature, changed_bounds


def drawn(**digests):
    """Return features with these digests, each at its own place."""
    return {
        ord(name): DrawnFeature(digest, QgsRectangle(ord(name), digest, ord(name) + 1, digest + 1))
        for name, digest in digests.items()
    }


@pytest.mark.parametrize(
    ("now", "changed"),
    [
        ({"a": 1, "b": 1, "c": 1}, set()),
        ({"a": 1, "b": 2, "c": 1}, {("b", 1), ("b", 2)}),
        ({"a": 1, "c": 1}, {("b", 1)}),
        ({"a": 1, "b": 1, "c": 1, "d": 4}, {("d", 4)}),
        ({"c": 1, "a": 1, "b": 1}, {("a", 1), ("b", 1), ("c", 1)}),
        ({"d": 1, "b": 3, "c": 1}, {("a", 1), ("b", 1), ("b", 3), ("d", 1)}),
    ],
    ids=["nothing", "changed", "removed", "added", "moved to the bottom", "several"],
)
def test_old_and_new_places_of_all_that_differs_are_found(qgis_app, now, changed):
    found = changed_bounds(drawn(a=1, b=1, c=1), drawn(**now))
    assert {(chr(int(place.xMinimum())), int(place.yMinimum())) for place in found} == changed
