import contextlib
import sqlite3

import pytest
from built_database import BUILD, MINIMUM_AREA, SIZE, STRIDE, map_labels
from made_inputs import NAMES, write_raster


@pytest.fixture(scope="session")
def build(run_algorithm, tmp_path_factory):
    """`build(labels_path, **parameters)` returns the results; DATABASE is a path."""

    def run(labels, **parameters):
        defaults = {
            "REFERENCE_CLASSES": "building;water;bare_land",
            "WINDOW_SIZE": SIZE,
            "STRIDE": STRIDE,
            "MINIMUM_AREA": MINIMUM_AREA,
            "DATABASE": tmp_path_factory.mktemp("built") / "area.gpkg",
        }
        return run_algorithm(BUILD, {"LABELS": labels, **defaults, **parameters})

    return run


@pytest.fixture(scope="session")
def label_map(tmp_path_factory):
    return write_raster(tmp_path_factory.mktemp("map") / "labels.tif", map_labels(), names=NAMES)


@pytest.fixture(scope="session")
def built(build, label_map):
    return build(label_map)


@pytest.fixture(scope="session")
def database(built):
    return built["DATABASE"]


@pytest.fixture
def query(database):
    with contextlib.closing(sqlite3.connect(f"file:{database}?mode=ro", uri=True)) as connection:
        yield lambda sql: connection.execute(sql).fetchall()
