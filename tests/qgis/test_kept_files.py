"""Files of earlier versions open in every later version; tests/data/kept is never written again."""

import numpy as np
from edited_database import KEPT, kept_database
from onboard_area import CENTER, HERE

from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.core.onboard.read import read_onboard
from semref.storage.database.reader import read_database


def check(database):
    """Require the map of tests/data/onboard_area.py and the right position of an image."""
    assert (len(database.references), len(database.windows)) == (417, 36)
    result = Localizer(database).localize(HERE, Method.AUTOMATIC)
    assert result.is_fix and np.allclose(result.position, CENTER, atol=0.5)


def test_a_database_of_format_1_opens_and_localizes(tmp_path):
    check(read_database(kept_database(tmp_path / "database.gpkg"), with_overview=True))


def test_an_onboard_file_of_format_1_opens_and_localizes():
    check(read_onboard(str(KEPT / "onboard.npz")).database)
