"""Files of earlier versions open in every later version; tests/data/kept is never written again."""

import gzip
from pathlib import Path

import numpy as np
from onboard_area import HERE

from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.core.onboard.read import read_onboard
from semref.storage.database.reader import read_database

KEPT = Path(__file__).resolve().parents[1] / "data" / "kept" / "v1"
CENTER = (600250.0, 5199600.0)


def check(database):
    """Require the map of tests/data/onboard_area.py and the right position of an image."""
    assert (len(database.references), len(database.windows)) == (417, 36)
    result = Localizer(database).localize(HERE, Method.AUTOMATIC)
    assert result.is_fix and np.allclose(result.position, CENTER, atol=0.5)


def test_a_database_of_format_1_opens_and_localizes(tmp_path):
    path = tmp_path / "database.gpkg"
    path.write_bytes(gzip.decompress((KEPT / "database.gpkg.gz").read_bytes()))
    check(read_database(str(path), with_overview=True))


def test_an_onboard_file_of_format_1_opens_and_localizes():
    check(read_onboard(str(KEPT / "onboard.npz")).database)
