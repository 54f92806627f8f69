from dataclasses import replace

import numpy as np
import pytest
from made_flights import FEW, FRAME, errors_m, fly, link_between, own_fix, with_own
from made_labels import patches

from semref.core.errors import ParameterError
from semref.core.flight import flight, tracker
from semref.core.flight.evidence import SeenImage
from semref.core.flight.flight import FlightSolver, localize_flight
from semref.core.flight.model import PoseSource
from semref.core.flight.pool import NOWHERE, Past
from semref.core.flight.tracker import STATE_VERSION, FlightTracker
from semref.core.localization import LIKELY_RISK, Prior, Status
from semref.core.simulation.views import cut


@pytest.mark.slow
def test_image_by_image_the_flight_is_found_as_well_and_goes_on_after_a_restart(flown, localizer):
    whole, cut_short = FlightTracker(localizer, FEW), FlightTracker(localizer, FEW)
    links = [None, *flown.links]
    poses = [whole.add(*pair) for pair in zip(flown.images, links)]
    assert poses[-1].is_fix and not poses[0].is_fix
    for number, pair in enumerate(zip(flown.images, links)):
        if number in (2, 5):
            cut_short = FlightTracker.from_state(localizer, cut_short.state(), FEW)
        assert cut_short.add(*pair) == poses[number]


@pytest.mark.slow
def test_what_is_remembered_does_not_grow(flown, localizer):
    tracker = FlightTracker(localizer, replace(FEW, window=3))
    sizes = []
    for pair in zip(flown.images, [None, *flown.links]):
        tracker.add(*pair)
        sizes.append(len(tracker.state()))
    assert max(sizes[3:]) <= sizes[3] + 2


@pytest.mark.parametrize("counts", [[99, 0, 0, 0], [STATE_VERSION, 0, 0, 99]])
def test_a_state_of_another_version_or_other_settings_is_refused(localizer, counts):
    with pytest.raises(ParameterError, match="version"):
        FlightTracker.from_state(localizer, {**FlightTracker(localizer).state(), "counts": np.array(counts)})


@pytest.mark.slow
def test_a_track_that_the_images_contradict_is_lost_and_found_again_under_another_number(labels, flown, localizer):
    """The flight jumps to another place, and the link does not show the jump."""
    other = fly(labels, seed=3, start=(501_400.0, 5_198_700.0))
    tracker = FlightTracker(localizer, replace(FEW, window=4, recent=3))
    images = [*flown.images[:5], *other.images]
    links = [None, *flown.links[:4], flown.links[4], *other.links]
    poses = [tracker.add(*pair) for pair in zip(images, links)]
    assert poses[4].track == 1 and poses[4].is_fix
    assert not all(pose.is_fix for pose in poses[5:])
    assert poses[-1].is_fix and poses[-1].track == 2
    assert errors_m(poses[-1:], other.views[-1:]).max() < 20


@pytest.mark.slow
@pytest.mark.parametrize("is_apart", [False, True])
def test_the_motion_before_is_assumed_to_continue_unless_the_pixels_contradict_it(labels, flown, localizer, is_apart):
    other = fly(labels, seed=3, start=(501_400.0, 5_198_700.0))
    tracker = FlightTracker(localizer, FEW)
    before = [tracker.add(*pair) for pair in zip(flown.images[:5], [None, *flown.links])]
    jumped = tracker.add(replace(other.images[0], is_apart=is_apart))
    assert before[-1].is_fix and jumped.is_fix is not is_apart


@pytest.mark.slow
def test_over_ground_that_the_map_does_not_show_the_place_is_predicted_until_images_agree_again(labels, localizer):
    flown = fly(labels, seed=3, count=11, start=(500_300.0, 5_198_500.0), step=130.0)
    tracker, changed = FlightTracker(localizer, replace(FEW, window=5)), patches(6, FRAME.shape_hw, 700)
    images = [
        replace(image, labels_hw=cut(changed, FRAME, view)) if 3 <= number < 9 else image
        for number, (image, view) in enumerate(zip(flown.images, flown.views))
    ]
    poses = [tracker.add(*pair) for pair in zip(images, [None, *flown.links])]
    predicted = [number for number, pose in enumerate(poses) if pose.source is PoseSource.PREDICTED]
    assert predicted and not any(poses[number].is_fix for number in predicted)
    radii = [poses[number].error_95_m for number in predicted]
    assert radii == sorted(radii), "the radius grows while no image agrees"
    off = [np.hypot(*np.subtract(poses[n].place.position, flown.views[n].position)) for n in predicted]
    assert (np.array(off) <= radii).all()
    assert poses[-1].is_fix and poses[-1].track == 1, "the same track goes on"


def test_the_mirrored_opponent_is_searched_in_as_many_headings_as_the_flight():
    prior = Prior((500_000.0, 5_200_000.0), 100.0, 30.0, 10.0, (0.9, 1.1))
    opponent = Past(SeenImage(None, 96.0, (0.0, 1.0), prior), NOWHERE, 1.0).mirrored()
    assert opponent.seen.prior == Prior(None, None, 330.0, 10.0, (0.9, 1.1))


@pytest.mark.slow
@pytest.mark.parametrize("east", [-300.0, 1000.0])
def test_own_fixes_win_at_once_over_a_past_that_was_moved(labels, localizer, east):
    flown = fly(labels, seed=5, count=7)
    images, before = with_own(flown), FlightTracker(localizer, FEW)
    for pair in zip(images[:4], [None, *flown.links]):
        before.add(*pair)
    state = before.state()
    moved = {"held_mean": state["held_mean"] + np.eye(8)[0] * east}
    moved["pool_states"] = state["pool_states"] + np.eye(4)[0] * east
    tracker = FlightTracker.from_state(localizer, {**state, **moved}, FEW)
    poses = [tracker.add(*pair) for pair in zip(images[4:], flown.links[3:])]
    errors = errors_m(poses, flown.views[4:])
    assert not (errors > 20).any() and errors[-1] < 5
    assert (before.track, tracker.track) == (1, 2)


@pytest.mark.slow
@pytest.mark.parametrize(("step", "risk", "most"), [(80.0, 1e-6, 3), (180.0, 1e-6, 2), (180.0, 1e-4, 3)])
def test_own_fixes_in_a_row_win_over_a_long_past(labels, localizer, step, risk, most):
    """The flight jumps by a kilometer without a trace in the link, so ten earlier images are wrong."""
    first = fly(labels, seed=3, count=8)
    other = fly(labels, seed=3, count=4, start=(501_250.0, 5_198_700.0), step=step)
    tracker = FlightTracker(localizer, FEW)
    for pair in zip(with_own(first), [None, *first.links]):
        assert errors_m([tracker.add(*pair)], [first.views[tracker._number]])[0] < 20
    poses = [tracker.add(*pair) for pair in zip(with_own(other, risk=risk), [first.links[-1], *other.links])]
    errors = errors_m(poses, other.views)
    assert not (errors > 20).any(), "a wrong position was reported"
    assert np.flatnonzero(np.isfinite(errors))[0] < most and poses[-1].track == 2


@pytest.mark.slow
def test_a_likely_position_of_an_image_is_no_fix_for_the_flight(labels, localizer):
    """The last images contradict the track at one place; only fixes may do that."""
    flown = fly(labels, seed=3, count=8)
    images = with_own(flown)[:5] + [
        replace(image, own=own_fix(view, off=400.0)) for image, view in zip(flown.images[5:], flown.views[5:])
    ]

    def followed(status):
        tracker = FlightTracker(localizer, FEW)
        given = [replace(image, own=replace(image.own, status=status)) for image in images]
        return [tracker.add(*pair) for pair in zip(given, [None, *flown.links])], tracker.state()

    likely, state = followed(Status.LIKELY)
    refused, expected = followed(Status.NO_MATCH)
    assert [pose.source for pose in likely] == [PoseSource.FLIGHT] * 8
    assert [(pose.status, pose.place) for pose in likely] == [(pose.status, pose.place) for pose in refused]
    assert all(np.array_equal(state[name], expected[name]) for name in expected)


@pytest.mark.slow
def test_wrong_fixes_that_name_different_places_do_not_win(labels, localizer):
    flown, tracker = fly(labels, seed=3, count=8), FlightTracker(localizer, FEW)
    images = with_own(flown)
    for number, off in ((4, 400.0), (5, -300.0), (6, 700.0)):
        images[number] = replace(images[number], own=own_fix(flown.views[number], off=off))
    poses = [tracker.add(*pair) for pair in zip(images, [None, *flown.links])]
    assert not (errors_m(poses, flown.views) > 20).any()
    assert poses[-1].is_fix and tracker.track == 1


@pytest.mark.slow
def test_what_own_fixes_contest_outlives_a_restart(labels, localizer):
    flown, tracker = fly(labels, seed=3, count=6), FlightTracker(localizer, FEW)
    other = fly(labels, seed=3, count=2, start=(501_250.0, 5_198_700.0))
    for pair in zip(with_own(flown), [None, *flown.links]):
        tracker.add(*pair)
    assert not tracker.add(with_own(other)[0], flown.links[-1]).is_fix
    again = FlightTracker.from_state(localizer, tracker.state(), FEW)
    blank = replace(other.images[1], labels_hw=np.zeros_like(other.images[1].labels_hw))
    assert not again.add(blank, other.links[0]).is_fix


@pytest.fixture(scope="module")
def poses(flown, localizer):
    return localize_flight(flown.images, flown.links, localizer, FEW)


@pytest.mark.slow
def test_a_flight_is_placed_from_its_first_image_on(poses, flown):
    assert [pose.status for pose in poses] == [Status.FIX] * len(flown.images)
    assert {pose.track for pose in poses} == {1}
    assert errors_m(poses, flown.views).max() < 12


def test_headings_and_pixel_sizes_are_those_of_the_images_and_radii_contain_most_errors(poses, flown):
    for pose, view in zip(poses, flown.views):
        heading, size = pose.place.oriented
        assert abs((heading - view.heading_deg + 180) % 360 - 180) < 3
        assert size == pytest.approx(view.pixel_size, rel=0.03)
    radii = np.array([pose.error_95_m for pose in poses])
    assert (errors_m(poses, flown.views) <= radii).mean() > 0.8 and radii.max() < 60


@pytest.mark.slow
def test_a_mirrored_flight_is_nowhere(flown, localizer):
    other = flown.mirrored()
    assert not any(pose.is_shown for pose in localize_flight(other.images, other.links, localizer, FEW))


def test_a_track_that_is_not_certain_enough_gives_likely_positions(flown, localizer):
    strict = replace(FEW, allowed_risk=0.0)
    poses = localize_flight(flown.images, flown.links, localizer, strict)
    found = [pose.localization() for pose in poses]
    assert [pose.status for pose in poses] == [Status.LIKELY] * len(poses)
    assert all(strict.allowed_risk < one.risk <= LIKELY_RISK and one.fix is None and one.reason for one in found)
    assert all(pose.track == 0 and pose.error_95_m > 0 for pose in poses)
    offs = [np.hypot(*np.subtract(one.position, view.position)) for one, view in zip(found, flown.views)]
    assert max(offs) < 20


@pytest.mark.slow
def test_a_missing_link_is_bridged(flown, localizer):
    poses = localize_flight(flown.images, [link for link in flown.links if link.second != 5], localizer, FEW)
    assert all(pose.is_fix for pose in poses)
    assert errors_m(poses, flown.views).max() < 20


def test_a_track_without_any_other_hypothesis_is_followed(flown, localizer):
    lonely = replace(FEW, hypotheses=1)
    poses = localize_flight(flown.images[:4], flown.links[:3], localizer, lonely)
    assert [pose.status for pose in poses] == [Status.FIX] * 4


def test_a_link_of_a_missing_image_is_refused(flown, localizer):
    with pytest.raises(ParameterError, match="9"):
        localize_flight(flown.images[:2], [link_between(8, *flown.views[:2])], localizer)


def test_steps_report_their_progress_even_if_no_image_can_be_measured(flown, localizer, monkeypatch):
    for module in (flight, tracker):
        monkeypatch.setattr(module, "measure_near", lambda *_: None)
    solver, count = FlightSolver(localizer, FEW), len(flown.images)
    assert list(dict.fromkeys(solver.steps(flown.images, flown.links))) == [(n + 1, count) for n in range(count)]
    assert {(pose.is_fix, pose.source) for pose in solver.poses} == {(False, PoseSource.PREDICTED)}


def test_a_wrong_fix_of_one_image_is_outvoted_and_marked(flown, localizer):
    images = with_own(flown)
    images[4] = replace(flown.images[4], own=own_fix(flown.views[4], off=400.0))
    poses = localize_flight(images, flown.links, localizer, FEW)
    assert [pose.is_outvoted for pose in poses] == [number == 4 for number in range(len(poses))]
    assert [pose.source is PoseSource.OWN for pose in poses] == [number != 4 for number in range(len(poses))]
    assert errors_m(poses, flown.views).max() < 8
