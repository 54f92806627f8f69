"""Provide one made map for the tests of assessments: landmarks are in the west only."""

import numpy as np
import pytest
from made_labels import scattered_objects
from onboard_area import FRAME, TABLE

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.labels.sources import ArrayLabels
from semref.core.localizer.localizer import Localizer

HEIGHT, WIDTH, BUILT = 600, 1000, 600
"""Size of the map in pixels; landmarks are in its first BUILT columns."""


def made_map(count: int = 330, background: int = 4) -> np.ndarray:
    labels = np.full((HEIGHT, WIDTH), background, np.uint8)
    labels[:, :BUILT] = scattered_objects(HEIGHT, BUILT, count, 7, background)
    return labels


def built_from(labels: np.ndarray):
    return build_from_labels(ArrayLabels(labels), FRAME, TABLE, BuildSettings(250.0, 125.0, 30.0), "1.2.3")


@pytest.fixture(scope="session")
def map_labels():
    """(600, 1000) uint8: landmarks of classes 1 to 3 on fields (4), in the first 600 columns."""
    return made_map()


@pytest.fixture(scope="session")
def built():
    """`built(labels)` returns a database with its overview; its upper left corner is (600000, 5200000)."""
    return built_from


@pytest.fixture(scope="session")
def assessed_database(map_labels):
    return built_from(map_labels)


@pytest.fixture(scope="session")
def localizer(assessed_database):
    return Localizer(assessed_database)
