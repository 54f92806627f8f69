"""One made map of patches, and a flight over it, for all tests of flights."""

import pytest
from made_flights import FRAME, TABLE, fly
from made_labels import patches

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.labels.sources import ArrayLabels
from semref.core.localizer.localizer import Localizer


@pytest.fixture(scope="package")
def labels():
    return patches(21, FRAME.shape_hw, 700)


@pytest.fixture(scope="package")
def localizer(labels):
    database = build_from_labels(ArrayLabels(labels), FRAME, TABLE, BuildSettings(288.0, 144.0, 400.0), "0")
    return Localizer(database)


@pytest.fixture(scope="package")
def flown(labels):
    return fly(labels)
