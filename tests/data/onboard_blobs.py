"""A small map of blobs with its database, and onboard files with changed members."""

import io
import json
import zipfile

import numpy as np
from made_labels import blobs

from semref.core.database.build import BuildSettings, build_from_labels
from semref.core.database.model import ReferenceDatabase
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.onboard.format import digest

TABLE = ClassTable(
    (
        LandCoverClass(2, "building", "#ff0000", "reference"),
        LandCoverClass(3, "forêt", "#00ff00"),
        LandCoverClass(5, "water", "#0000ff", "reference"),
        LandCoverClass(7, "bare, dry", "#ffff00", "reference"),
    )
)
FRAME = MapFrame('PROJCS["a metric CRS"]', (600000.0, 2.0, 0.0, 5200000.0, 0.0, -2.0))
SETTINGS = BuildSettings(120.0, 40.0, minimum_area=28.0, levels=(1.0, 2.0))


def linear(points_xy):
    return 9 + (points_xy[:, 0] - 600000) / 80000, 47 + (points_xy[:, 1] - 5200000) / 111000


MAP = blobs(0, (320, 400), (0, 2, 3, 5, 7), 1.8)


def build_blobs() -> ReferenceDatabase:
    return build_from_labels(ArrayLabels(MAP), FRAME, TABLE, SETTINGS, "1.2.3")


def members(path) -> dict:
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def zipped(path, files: dict, compression: int = zipfile.ZIP_DEFLATED) -> str:
    with zipfile.ZipFile(path, "w", compression) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return str(path)


def npy(array) -> bytes:
    file = io.BytesIO()
    np.save(file, array)
    return file.getvalue()


def with_header(path, source, **changes) -> str:
    """Return a copy of a file with another header and the matching hash."""
    files = members(source)
    header = json.loads(np.load(io.BytesIO(files["header.npy"])).tobytes())
    header.update(changes)
    files["header.npy"] = npy(np.frombuffer(json.dumps(header).encode("utf-8"), np.uint8))
    return hashed(path, files)


def hashed(path, files: dict) -> str:
    """Write the members with the hash that matches them."""
    found = digest({name[:-4]: data for name, data in files.items()})
    return zipped(path, {**files, "content_hash.npy": npy(np.frombuffer(found, np.uint8))})
