"""A small made-up map as an onboard file, and images of it."""

import shutil

import numpy as np
from made_labels import scattered_objects
from onboard_blobs import linear

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.geometry.frame import MapFrame
from semref.core.geometry.lon_lat import fit_lon_lat
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.onboard.write import write_onboard

TABLE = ClassTable(
    (
        LandCoverClass(1, "building", "#ff0000", "reference"),
        LandCoverClass(2, "water", "#0000ff", "reference"),
        LandCoverClass(3, "bare_land", "#ffff00", "reference"),
        LandCoverClass(4, "field", "#00ff00"),
    )
)
FRAME = MapFrame('PROJCS["a metric CRS"]', (600000.0, 1.0, 0.0, 5200000.0, 0.0, -1.0))
SIZE = 200
MAP = scattered_objects(700, 700, 420, seed=7)
HERE = np.ascontiguousarray(np.rot90(MAP[300 : 300 + SIZE, 150 : 150 + SIZE]))
CENTER = (600250.0, 5199600.0)
SMALL = np.ascontiguousarray(HERE[:110, :110])
LIKELY = ("--method", "constellation", "--risk", "1e-12")
"""A part of HERE, and the options with which it is a likely position: its error probability is about 5e-5."""
NOTHING = np.full((SIZE, SIZE), 4, np.uint8)


def write_area(path):
    database = build_from_labels(
        ArrayLabels(MAP), FRAME, TABLE, BuildSettings(200.0, 100.0, minimum_area=30.0), "1.2.3"
    )
    lon_lat = fit_lon_lat(linear, database.parameters.extent)
    write_onboard(path, database, lon_lat)


def copy_core(repository, folder):
    shutil.copytree(repository / "core", folder / "core", ignore=shutil.ignore_patterns("__pycache__"))
