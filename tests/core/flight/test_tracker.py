"""A flight image by image: what is known until then, restarts, bounded memory."""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.flight.tracker import FlightTracker

sys.path.insert(0, str(Path(__file__).parent))
from conftest import FEW, errors_m, fly

sys.path.pop(0)


def test_image_by_image_the_flight_is_found_as_well_and_goes_on_after_a_restart(flown, localizer):
    whole, cut_short = FlightTracker(localizer, FEW), FlightTracker(localizer, FEW)
    links = [None, *flown.links]
    poses = [whole.add(*pair) for pair in zip(flown.images, links)]
    assert poses[-1].is_fix and not poses[0].is_fix
    for number, pair in enumerate(zip(flown.images, links)):
        if number in (2, 5):
            cut_short = FlightTracker.from_state(localizer, cut_short.state(), FEW)
        assert cut_short.add(*pair) == poses[number]


def test_what_is_remembered_does_not_grow(flown, localizer):
    tracker = FlightTracker(localizer, replace(FEW, window=3))
    sizes = []
    for pair in zip(flown.images, [None, *flown.links]):
        tracker.add(*pair)
        sizes.append(len(tracker.state()))
    assert max(sizes[3:]) <= sizes[3] + 2


@pytest.mark.parametrize("broken", [{}, {"counts": np.array([99, 0, 0, 0])}, {"counts": np.array([1.0, 2.0])}])
def test_a_broken_state_is_refused(localizer, broken):
    state = {**FlightTracker(localizer).state(), **broken} if broken else {}
    with pytest.raises(ParameterError):
        FlightTracker.from_state(localizer, state)


@pytest.fixture(scope="module")
def kept(flown, localizer):
    """What a flight of a few images leaves."""
    tracker = FlightTracker(localizer, FEW)
    for number, image in enumerate(flown.images[:4]):
        tracker.add(image, flown.links[number - 1] if number else None)
    return tracker.state()


@pytest.mark.parametrize(
    "change",
    [
        lambda array: array[..., None],
        lambda array: np.full(array.shape, np.nan),
        lambda array: np.full(array.shape, 1e308),
        lambda array: np.full(array.shape, "x"),
    ],
)
def test_no_array_of_a_state_is_taken_that_is_none(kept, localizer, change):
    assert FlightTracker.from_state(localizer, kept, FEW).state().keys() == kept.keys()
    for name, array in kept.items():
        if array.size:
            with pytest.raises(ParameterError):
                FlightTracker.from_state(localizer, {**kept, name: change(array)}, FEW)


def test_a_track_that_the_images_contradict_is_lost_and_found_again_under_another_number(labels, flown, localizer):
    """The flight jumps to another place in between; the link says that it went on."""
    other = fly(labels, seed=3, start=(501_400.0, 5_198_700.0))
    tracker = FlightTracker(localizer, replace(FEW, window=4, recent=3))
    images = [*flown.images[:5], *other.images]
    links = [None, *flown.links[:4], flown.links[4], *other.links]
    poses = [tracker.add(*pair) for pair in zip(images, links)]
    assert poses[4].track == 1 and poses[4].is_fix
    assert not all(pose.is_fix for pose in poses[5:])
    assert poses[-1].is_fix and poses[-1].track == 2
    assert errors_m(poses[-1:], other.views[-1:]).max() < 20
