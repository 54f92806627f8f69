"""A made catalogue of landmarks, and error-free images of it."""

from types import SimpleNamespace

import numpy as np
import pytest

from semref.core.constellation.hypotheses import SeenLandmarks
from semref.core.constellation.index import build_index
from semref.core.database.model import MapLandmarks
from semref.core.geometry.pose import Pose, turn_of

ORIGIN = (500_000.0, 5_200_000.0)
EXTENT = 2000.0
EDGE = 640


@pytest.fixture(scope="package")
def catalogue():
    rng = np.random.default_rng(11)
    positions = rng.uniform(0, EXTENT, (600, 2)) + ORIGIN
    classes = rng.choice(np.array([1, 2, 5], np.uint8), 600)
    return MapLandmarks(positions, classes, np.exp(rng.uniform(4.5, 7.0, 600)), np.zeros(600, bool))


@pytest.fixture(scope="package")
def index(catalogue):
    return build_index(catalogue, 1.0)


@pytest.fixture(scope="package")
def cut(index):
    """Return a function that cuts an image: query, true pose and the catalogue's objects in it."""

    def at(east, north, heading_deg=0.0, pixel_size=1.0):
        center = complex(ORIGIN[0] + east, ORIGIN[1] + north) - index.origin
        pose = Pose(center, turn_of(heading_deg, pixel_size))
        seen = pose.in_image(index.points)
        objects = np.flatnonzero((np.abs(seen.real) < EDGE / 2) & (np.abs(seen.imag) < EDGE / 2))
        log_areas = index.log_areas[objects] - 2 * np.log(pixel_size)
        whole = np.ones(len(objects), bool)
        query = SeenLandmarks(seen[objects], index.ranks[objects], log_areas, whole, EDGE * np.sqrt(2))
        return SimpleNamespace(query=query, pose=pose, objects=objects)

    return at
