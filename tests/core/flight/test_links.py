"""Links between neighbors, derived from links that leave out an image."""

import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.flight.links import links_by_image, rest
from semref.core.flight.motion import Link, as_rows

KNOWN = as_rows(np.diag([1.0, 2.0, 1e-4, 1e-4]))


def link(first, second, translation, turn=0.1, log_scale=0.02, in_meters=False):
    return Link(first, second, translation, turn, log_scale, KNOWN, in_meters=in_meters)


def joined(*links):
    center, turn = 0j, 1 + 0j
    for one in links:
        center, turn = one.after(center, turn)
    return center, turn


@pytest.mark.parametrize("in_meters", [False, True])
def test_what_is_left_of_a_link_over_an_image_ends_where_that_link_does(in_meters):
    earlier, over = link(0, 1, (30.0, -80.0), 0.3, 0.05, in_meters), link(0, 2, (50.0, -170.0), -0.2, 0.1, in_meters)
    later = rest(over, earlier)
    assert (later.first, later.second) == (1, 2)
    assert joined(earlier, later) == pytest.approx(joined(over))
    assert np.linalg.eigvalsh(np.array(later.covariance)).min() > 1e-5


def test_a_link_over_an_image_counts_only_if_neighbors_are_not_linked():
    first, second, over = link(0, 1, (0.0, -80.0)), link(1, 2, (0.0, -80.0)), link(0, 2, (0.0, -150.0))
    assert links_by_image([over, second, first], 3) == {1: first, 2: second}
    assert links_by_image([over, first], 3) == {1: first, 2: rest(over, first)}
    assert set(links_by_image([over], 3)) == {1, 2}
    assert links_by_image([link(0, 3, (0.0, -240.0))], 4) == {}


def test_a_link_to_an_unknown_image_is_refused():
    with pytest.raises(ParameterError, match="has 2 images"):
        links_by_image([link(0, 2, (0.0, -150.0))], 2)
