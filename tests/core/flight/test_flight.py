"""Whole flights over a made map have the right positions or no position."""

from dataclasses import replace

import numpy as np
import pytest
from made_flights import FEW, errors_m, link_between, own_fix, with_own

from semref.core.errors import ParameterError
from semref.core.flight.flight import FlightSolver, localize_flight
from semref.core.flight.model import PoseSource
from semref.core.localization import Status


@pytest.fixture(scope="module")
def poses(flown, localizer):
    return localize_flight(flown.images, flown.links, localizer, FEW)


@pytest.mark.slow
def test_a_flight_is_placed_from_its_first_image_on(poses, flown):
    assert [pose.status for pose in poses] == [Status.FIX] * len(flown.images)
    assert {pose.track for pose in poses} == {1}
    assert errors_m(poses, flown.views).max() < 12


def test_headings_and_pixel_sizes_are_those_of_the_images(poses, flown):
    for pose, view in zip(poses, flown.views):
        heading, size = pose.place.oriented
        assert abs((heading - view.heading_deg + 180) % 360 - 180) < 3
        assert size == pytest.approx(view.pixel_size, rel=0.03)


def test_the_radius_contains_most_errors_and_is_no_larger_than_an_image(poses, flown):
    radii = np.array([pose.error_95_m for pose in poses])
    assert (errors_m(poses, flown.views) <= radii).mean() > 0.8
    assert radii.max() < 60


@pytest.mark.slow
def test_a_mirrored_flight_is_nowhere(flown, localizer):
    other = flown.mirrored()
    poses = localize_flight(other.images, other.links, localizer, FEW)
    assert not any(pose.is_fix for pose in poses)


@pytest.mark.slow
def test_a_missing_link_is_bridged(flown, localizer):
    links = [link for link in flown.links if link.second != 5]
    poses = localize_flight(flown.images, links, localizer, FEW)
    assert all(pose.is_fix for pose in poses)
    assert errors_m(poses, flown.views).max() < 20


def test_a_link_of_a_missing_image_is_refused(flown, localizer):
    with pytest.raises(ParameterError, match="9"):
        localize_flight(flown.images[:2], [link_between(8, *flown.views[:2])], localizer)


def test_steps_report_their_progress(flown, localizer):
    solver = FlightSolver(localizer, FEW)
    assert list(solver.steps(flown.images[:2], flown.links[:1])) == [(1, 2), (2, 2)]
    assert len(solver.poses) == 2


def test_a_wrong_fix_of_one_image_is_outvoted_and_marked(flown, localizer):
    images = with_own(flown)
    images[4] = replace(flown.images[4], own=own_fix(flown.views[4], off=400.0))
    poses = localize_flight(images, flown.links, localizer, FEW)
    assert [pose.is_outvoted for pose in poses] == [number == 4 for number in range(len(poses))]
    assert [pose.source is PoseSource.OWN for pose in poses] == [number != 4 for number in range(len(poses))]
    assert errors_m(poses, flown.views).max() < 8
