"""Provide one made map for the tests of assessments: landmarks are in the west only."""

from __future__ import annotations

import numpy as np
import pytest

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.localizer.localizer import Localizer

TABLE = ClassTable(
    (
        LandCoverClass(1, "building", "#ff0000", "reference"),
        LandCoverClass(2, "water", "#0000ff", "reference"),
        LandCoverClass(4, "field", "#00ff00"),
    )
)
FRAME = MapFrame('PROJCS["a metric CRS"]', (600000.0, 1.0, 0.0, 5200000.0, 0.0, -1.0))
HEIGHT, WIDTH, BUILT = 600, 1000, 600
"""Size of the map in pixels; landmarks are in its first BUILT columns."""


def made_map(count: int = 330, background: int = 4) -> np.ndarray:
    random = np.random.default_rng(7)
    labels = np.full((HEIGHT, WIDTH), background, np.uint8)
    for _ in range(40 * count):
        h, w = random.integers(6, 16, 2)
        row, column = random.integers(1, HEIGHT - h - 1), random.integers(1, BUILT - w - 1)
        around = labels[row - 1 : row + h + 1, column - 1 : column + w + 1]
        if count and (around == background).all():
            labels[row : row + h, column : column + w] = random.integers(1, 3)
            count -= 1
    return labels


def built_from(labels: np.ndarray):
    return build_from_labels(ArrayLabels(labels), FRAME, TABLE, BuildSettings(250.0, 125.0, 30.0), "1.2.3")


@pytest.fixture(scope="session")
def map_labels():
    """(600, 1000) uint8: landmarks of classes 1 and 2 on fields (4), in the first 600 columns."""
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
