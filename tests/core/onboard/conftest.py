"""Two made maps and their onboard files: `written` for reading and writing, `area` for images of it."""

import pytest
from onboard_area import write_area
from onboard_blobs import build_blobs, linear

from semref.core.geometry.lon_lat import fit_lon_lat
from semref.core.onboard import growing_log, tables
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


@pytest.fixture(scope="session")
def area(tmp_path_factory) -> str:
    path = str(tmp_path_factory.mktemp("onboard") / "area.npz")
    write_area(path)
    return path


@pytest.fixture
def never_late(monkeypatch):
    for module in (growing_log, tables):
        monkeypatch.setattr(module, "ROW_WITHIN_S", 0.0)


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "incoming").mkdir()
    return tmp_path / "incoming"
