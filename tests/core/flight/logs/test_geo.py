"""Reading OpenDroneMap's geo.txt."""

import numpy as np

from semref.core.flight.logs.texts import is_geo, read_geo

TEXT = "EPSG:4326\na.jpg 7.1 46.2 400 35.5 0 0 1 1\nb.jpg 7.2 46.3 401\n# no\nc.jpg 7.2 46.3 401 x\n"


def test_yaw_is_the_heading_of_the_image():
    log = read_geo(TEXT)
    assert log.images == ("a", "c")
    assert log.values[0, 0] == 35.5
    assert np.isnan(log.values[0, 1:]).all() and np.isnan(log.values[1]).all()


def test_it_begins_with_a_reference_system():
    assert is_geo(TEXT) and is_geo("\n+proj=utm +zone=32\n") and not is_geo("image,a\n")
