"""What a tracker remembers, written as arrays and read again."""

import numpy as np

from semref.core.correlation.class_pyramid import EvidenceLevel
from semref.core.flight.evidence import SeenImage
from semref.core.flight.memory import Past, mirrored, packed, unpacked
from semref.core.flight.motion import Link, LinkSource, as_rows
from semref.core.localization import Prior

LINK = Link(3, 4, (20.0, -100.0), 0.2, 0.1, as_rows(np.diag([4.0, 4.0, 0.01, 0.0004])), LinkSource.LOG, True)
LEVEL = EvidenceLevel(np.arange(24, dtype=np.float32).reshape(3, 4, 2), np.ones((3, 4), np.float32), (8.0, 8.0))


def test_an_image_of_the_window_comes_back_as_it_was():
    prior = Prior((1.0, 2.0), 30.0, 45.0, 10.0, (0.9, 1.1))
    whole = Past(SeenImage(LEVEL, 640.0, (0.01, 0.1), prior, np.arange(4.0), 3.5), LINK, 0.4)
    again = unpacked(packed(whole), 2)
    assert (again.link, again.weight, again.seen.prior) == (LINK, 0.4, prior)
    assert (again.seen.edge_px, again.seen.chance, again.seen.own_odds) == (640.0, (0.01, 0.1), 3.5)
    assert (again.seen.evidence.evidence == LEVEL.evidence).all() and again.seen.evidence.pixel == LEVEL.pixel
    assert (again.seen.own_state == np.arange(4.0)).all()


def test_a_mirrored_image_has_left_and_right_exchanged_and_no_heading():
    prior = Prior(heading_deg=30.0, heading_range_deg=5.0, pixel_size_range=(0.9, 1.1))
    other = mirrored(SeenImage(LEVEL, 640.0, (0.0, 0.1), prior, np.arange(4.0), 3.5))
    assert (other.evidence.evidence == LEVEL.evidence[:, ::-1]).all()
    assert other.prior == Prior(pixel_size_range=(0.9, 1.1)) and other.own_state is None
