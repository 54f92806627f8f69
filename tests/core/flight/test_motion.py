import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.flight.motion import Link, as_rows, links_by_image, rest
from semref.core.flight.pool import move_states
from semref.core.geometry.pose import heading_of, turn_of
from semref.core.simulation.views import View, image_coordinates

SMALL = tuple(tuple(row) for row in np.eye(4) * 1e-4)
NEGATIVE = tuple(tuple(row) for row in -np.eye(4))
KNOWN = as_rows(np.diag([1.0, 2.0, 1e-4, 1e-4]))


def moved(link, center, turn, back=False):
    """Center and turn of the second image of a link from those of the first, or the other way round."""
    state = np.array([[center.real, center.imag, -np.angle(turn), np.log(abs(turn))]])
    x, y, heading, size = move_states(state, link, back)[0]
    return complex(x, y), complex(np.exp(size - 1j * heading))


def test_a_link_takes_pixels_of_the_second_image_to_pixels_of_the_first():
    first = View(1000.0, 2000.0, 30.0, 2.0, 640, 480)
    second = View(1150.0, 2080.0, 75.0, 2.4, 640, 480)
    seen = image_coordinates(first, np.array([second.position]))[0] - (320, 240)
    link = Link(0, 1, tuple(seen), np.radians(45), np.log(1.2), SMALL)
    center, turn = moved(link, complex(*first.position), turn_of(30.0, 2.0))
    assert (center.real, center.imag) == pytest.approx(second.position)
    assert (heading_of(turn), abs(turn)) == pytest.approx((75.0, 2.4))


def test_going_back_undoes_going_forth():
    for in_meters in (False, True):
        link = Link(0, 1, (31.0, -170.0), 0.3, -0.05, SMALL, in_meters=in_meters)
        start = 5 + 7j, turn_of(211.0, 1.3)
        assert moved(link, *moved(link, *start), back=True) == pytest.approx(start)


def test_meters_are_meters_whatever_the_pixel_size():
    link = Link.of_odometry(0, 1, 30.0, 100.0, 0.0, 1.0, 1.0)
    for size in (0.5, 4.0):
        center, _ = moved(link, 0j, turn_of(90.0, size))
        assert center == pytest.approx(100 - 30j)


def test_motion_along_the_axes_of_the_map_is_turned_by_the_heading():
    link = Link.of_odometry(0, 1, 100.0, 0.0, 5.0, (3.0, 1.0), 1.0, heading_deg=90.0)
    center, turn = moved(link, 0j, turn_of(90.0, 1.0))
    assert center == pytest.approx(100 + 0j)
    assert heading_of(turn) == pytest.approx(95.0)
    # East is up in an image that heads east.
    assert np.sqrt(np.diag(np.array(link.covariance)))[:2] == pytest.approx((1.0, 3.0))


def test_an_unsure_heading_makes_motion_along_the_map_unsure_across():
    link = Link.of_odometry(0, 1, 0.0, 100.0, 0.0, 1.0, 1.0, heading_deg=0.0, sigma_map_heading_deg=3.0)
    right, down = np.sqrt(np.diag(np.array(link.covariance)))[:2]
    assert right == pytest.approx(np.hypot(1.0, 100 * np.radians(3.0)))
    assert down == pytest.approx(1.0)


def test_a_mirrored_link_moves_a_mirrored_image():
    link = Link(0, 1, (31.0, -170.0), 0.3, -0.05, SMALL)
    center, turn = moved(link, 0j, turn_of(20.0, 1.0))
    mirrored_center, mirrored_turn = moved(link.mirrored(), 0j, turn_of(-20.0, 1.0))
    assert mirrored_center == pytest.approx(-center.conjugate())
    assert mirrored_turn == pytest.approx(turn.conjugate())
    assert link.mirrored().mirrored() == link


@pytest.mark.parametrize(
    "wrong", [{"first": 1}, {"turn": float("nan")}, {"covariance": ((1.0,),)}, {"covariance": NEGATIVE}]
)
def test_an_impossible_link_is_refused(wrong):
    values = {"first": 0, "second": 1, "translation": (1.0, 2.0), "turn": 0.0, "log_scale": 0.0, "covariance": SMALL}
    with pytest.raises(ParameterError):
        Link(**{**values, **wrong})


def link(first, second, translation, turn=0.1, log_scale=0.02, in_meters=False):
    return Link(first, second, translation, turn, log_scale, KNOWN, in_meters=in_meters)


def joined(*links):
    center, turn = 0j, 1 + 0j
    for one in links:
        center, turn = moved(one, center, turn)
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
