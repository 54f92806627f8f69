import math

import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.flight.motion import LinkSource
from semref.core.flight.odometry import odometry_links, read_odometry

HEADER = "image,dx_m,dy_m,dheading_deg"


def table(tmp_path, *lines, header=HEADER):
    path = tmp_path / "odometry.csv"
    path.write_text("\n".join([header, *lines]) + "\n", encoding="utf-8")
    return str(path)


def links(tmp_path, lines, names, header=HEADER):
    return odometry_links(read_odometry(table(tmp_path, *lines, header=header)), names)


def test_a_row_gives_the_motion_since_the_previous_row_up_and_right_in_a_view_to_the_north(tmp_path):
    (link,) = links(tmp_path, ["a.jpg,,,", "b.jpg,3,200,-10"], ["a.png", "/x/b.tif"])
    assert (link.first, link.second, link.source, link.in_meters) == (0, 1, LinkSource.ODOMETRY, True)
    assert link.translation == pytest.approx((3, -200))
    assert link.turn == pytest.approx(math.radians(-10))
    assert link.step == pytest.approx(3 + 200j)
    assert math.degrees(math.atan2(link.ratio.imag, link.ratio.real)) == pytest.approx(10)


def test_spreads_are_those_of_the_table_or_a_share_of_the_way(tmp_path):
    header = HEADER + ",sigma_m,sigma_heading_deg,scale,sigma_scale"
    lines = ["a,,,,,,,", "b,0,100,0,2,3,1.1,0.05", "c,0,100,0,,,,"]
    told, usual = links(tmp_path, lines, ["a", "b", "c"], header)
    assert np.sqrt(np.diag(told.covariance)) == pytest.approx([2, 2, math.radians(3), 0.05])
    assert told.log_scale == pytest.approx(math.log(1.1))
    assert np.sqrt(np.diag(usual.covariance)) == pytest.approx([3, 3, math.radians(1), 0.02])


def test_steps_of_images_that_the_flight_lacks_are_put_together(tmp_path):
    (link,) = links(tmp_path, ["a,,,", "b,0,100,90", "c,0,50,0"], ["a", "c"])
    assert link.translation == pytest.approx((50, -100))
    assert link.turn == pytest.approx(math.pi / 2)
    one = links(tmp_path, ["a,,,", "b,0,100,90"], ["a", "b"])[0]
    assert link.covariance[0][0] > one.covariance[0][0]


def test_a_table_in_the_other_order_is_turned_round(tmp_path):
    (there,) = links(tmp_path, ["a,,,", "b,3,200,-30"], ["b", "a"])
    (back,) = links(tmp_path, ["a,,,", "b,3,200,-30"], ["a", "b"])
    assert back.ratio * there.ratio == pytest.approx(1)
    assert back.step + back.ratio / abs(back.ratio) * there.step == pytest.approx(0)


@pytest.mark.parametrize(
    ("row", "said"),
    [
        *(("b,x,0,0", "dx_m is “x”"), ("b,1,,0", "dy_m is “”"), ("b,nan,0,0", ""), ("b,1e9,0,0", "dx_m is 1e.09")),
        *(("b,1,2,720", "dheading_deg is 720"), ("a,1,2,3", "the image a"), (",1,2,3", "the image is missing")),
    ],
)
def test_a_bad_row_is_reported_with_its_line(tmp_path, row, said):
    with pytest.raises(ParameterError, match=f"odometry.csv, line 3: {said}"):
        read_odometry(table(tmp_path, "a,,,", row))


@pytest.mark.parametrize("scale", [0.1, 10])
@pytest.mark.parametrize("names", [["a", "b"], ["b", "a"]])
def test_sizes_that_no_flight_has_are_refused_however_many_rows_make_them(tmp_path, scale, names):
    between = [f"x{number},0,0,0,{scale}" for number in range(400)]
    path = table(tmp_path, "a,,,", *between, f"b,0,0,0,{scale}", header="image,dx_m,dy_m,dheading_deg,scale")
    with pytest.raises(ParameterError, match="has numbers that are not finite or too large"):
        odometry_links(read_odometry(path), names)
