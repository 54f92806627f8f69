"""One made map and its onboard file, for the tests of reading, writing and the format."""

from __future__ import annotations

import pytest
from onboard_blobs import build_blobs, linear

from semref.core.geometry.lon_lat import fit_lon_lat
from semref.core.onboard.write import write_onboard


@pytest.fixture(scope="session")
def database():
    return build_blobs()


@pytest.fixture(scope="session")
def lon_lat(database):
    return fit_lon_lat(linear, database.parameters.extent)


@pytest.fixture(scope="session")
def written(database, lon_lat, tmp_path_factory):
    path = tmp_path_factory.mktemp("onboard") / "area.npz"
    write_onboard(str(path), database, lon_lat)
    return path
