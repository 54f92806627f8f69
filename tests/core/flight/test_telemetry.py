import math

import numpy as np
import pytest

from semref.core.flight.motion import LinkSource
from semref.core.flight.telemetry import ZONE_S, log_cameras, log_links, telemetry

NAN = math.nan


def row(heading=NAN, roll=NAN, pitch=NAN, height=NAN, east=NAN, north=NAN):
    return [heading, roll, pitch, height, east, north]


def test_values_between_entries_are_interpolated_headings_across_north():
    log = telemetry([0, 1], [row(heading=350, height=10), row(heading=10, height=20)])
    assert log.at([0.25, 0.5])[:, 0] == pytest.approx([355, 0])
    assert log.at([0.25])[0, 3] == pytest.approx(12.5)


def test_nothing_is_known_outside_and_in_gaps():
    log = telemetry([0, 1, 9, 10], [row(height=5)] * 4)
    assert np.isfinite(log.at([-1, 0, 0.5, 5, 9, 10, 11, NAN])[:, 3]).tolist() == [
        *(False, True, True, False, True, True, False, False)
    ]


def test_each_field_is_taken_from_the_entries_that_have_it():
    log = telemetry([0, 0.5, 1], [row(heading=10), row(height=7), row(heading=20)])
    assert log.at([0.5])[0, [0, 3]].tolist() == [15, 7]


def test_impossible_values_of_an_aircraft_are_ignored():
    log = telemetry([2, NAN, 1], [row(height=1e9, heading=5), row(heading=1), row(east=5000.0, north=3)])
    assert log.times_s.tolist() == [1, 2]
    assert np.isnan(log.values[1, 3]) and np.isnan(log.values[0, 4]) and log.values[0, 5] == 3


def test_ways_are_integrated_from_velocities():
    log = telemetry([0, 1, 2], [row(east=0, north=10), row(east=2, north=10), row(east=4, north=10)])
    assert log.way(0, 2) == pytest.approx(4 + 20j)
    assert log.way(0.5, 1.5) == pytest.approx(2 + 10j)
    assert log.way(1, 3) is None


def test_a_camera_has_the_log_heading_and_its_height_above_takeoff():
    log = telemetry([0, 1], [row(heading=90, height=50), row(heading=90, height=60)])
    first, unknown = log_cameras(log, ["a", "b"], [0.5, None])
    assert (first.heading_deg, first.height.meters, first.attitude) == (pytest.approx(90), pytest.approx(55), None)
    assert (unknown.heading_deg, unknown.height) == (None, None)


def test_a_gimbal_gives_the_attitude_unless_it_sees_the_horizon():
    log = telemetry([0, 1], [row(roll=0, pitch=-80), row(roll=0, pitch=10)], is_gimbal=True)
    cameras = log_cameras(log, ["a", "b"], [0, 1])
    assert cameras[0].attitude.pitch_deg == pytest.approx(10)
    assert cameras[1].attitude is None


def test_links_follow_from_velocity_and_heading():
    log = telemetry([0, 10 / 9], [row(heading=90, east=9, north=0)] * 2)
    (link,) = log_links(log, ["a", "b"], [0, 1])
    assert (link.first, link.second, link.source) == (0, 1, LinkSource.LOG)
    # The flight and the top of the image point east: motion is towards the top.
    assert link.translation == pytest.approx((0, -9), abs=1e-9)
    deviations = np.sqrt(np.diag(link.covariance))
    assert deviations[0] == pytest.approx(math.hypot(0.3, 0.27, math.radians(5) * 9), rel=1e-6)
    assert deviations[1] == pytest.approx(math.hypot(0.3, 0.27), rel=1e-6)


def test_no_link_where_the_log_has_a_gap_or_an_image_no_time():
    log = telemetry([0, 1, 8, 9], [row(heading=0, east=1, north=1)] * 4)
    assert [(link.first, link.second) for link in log_links(log, list("abcd"), [0, 1, 8, None])] == [(0, 1)]


def test_a_camera_clock_of_another_zone_is_brought_to_the_log():
    start = 1.6e9
    log = telemetry([start, start + 100], [row(heading=1)] * 2, is_clock=True)
    hours = 2 * 4 * ZONE_S
    assert log.zone([start + 10 + hours, start + 20 + hours]) == -hours
    assert log.zone([start + 10]) == 0
    assert telemetry([0, 100], [row(heading=1)] * 2).zone([start]) == 0


def test_entries_of_images_are_found_by_name():
    log = telemetry([0, 1], [row(heading=10), row(heading=20)], images=["x", "y"])
    assert [camera.heading_deg for camera in log_cameras(log, ["y", "z", "x"], [None] * 3)] == [20, None, 10]
