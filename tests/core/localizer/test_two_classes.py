"""A map of buildings and other ground works with every method."""

import numpy as np
import pytest
from made_town import town

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.localization import Method, Status
from semref.core.localizer.localizer import Localizer
from semref.core.simulation.views import PIXELS, View, cut

ORIGIN = 500_000.0, 5_200_000.0
SIZE = 600
BUILDING = LandCoverClass(1, "building", "#ff0000", "reference")


@pytest.fixture(scope="module", params=["other", "unlabeled"])
def labels(request):
    """Return (2000, 2000) uint8 of buildings; other ground has a class or no label."""
    return np.where(town(7, 2000, 1200) == 1, 1, 2 if request.param == "other" else 0).astype(np.uint8)


@pytest.fixture(scope="module")
def localizer(labels):
    table = ClassTable((BUILDING, LandCoverClass(2, "other", "#808080"))[: int(labels.max())])
    frame = MapFrame("a metric CRS", (ORIGIN[0], 1.0, 0.0, ORIGIN[1], 0.0, -1.0))
    return Localizer(build_from_labels(ArrayLabels(labels), frame, table, BuildSettings(SIZE, 300, 60.0), "0"))


def view(labels, heading=0.0):
    return cut(labels, PIXELS, View(900.0, -1200.0, heading, 1.0, SIZE, SIZE))


@pytest.mark.parametrize("method", [Method.AUTOMATIC, Method.CONSTELLATION, Method.MAP_CORRELATION])
def test_an_image_is_found_at_any_heading(labels, localizer, method):
    found = localizer.localize(view(labels, 40.0), method)
    assert found.status is Status.FIX, found.reason
    assert np.hypot(found.position[0] - ORIGIN[0] - 900, ORIGIN[1] - found.position[1] - 1200) < 4


def test_the_published_method_finds_the_window(labels, localizer):
    found = localizer.localize(view(labels), Method.TOPOLOGY_VECTOR)
    assert found.status is Status.FIX, found.reason
    assert found.position == (ORIGIN[0] + 900, ORIGIN[1] - 1200)


def test_the_mirrored_image_is_found_by_no_method(labels, localizer):
    image = np.ascontiguousarray(view(labels, 40.0)[:, ::-1])
    for method in (Method.AUTOMATIC, Method.CONSTELLATION, Method.MAP_CORRELATION):
        assert not localizer.localize(image, method).is_fix
