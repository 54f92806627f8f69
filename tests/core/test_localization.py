"""Localization results: fixes and likely positions have a position; statuses and methods are texts of files."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from semref.core.localization import Localization, Matches, Method, Place, Status
from semref.core.localizer.combined import show_likely

FIX = Localization(Status.FIX, Method.CONSTELLATION, best=Place((1.0, 2.0), heading_deg=30.0, pixel_size_m=0.5))


def test_a_fix_has_the_position_of_the_image():
    assert (FIX.is_fix, FIX.position, FIX.heading_deg, FIX.pixel_size_m) == (True, (1.0, 2.0), 30.0, 0.5)


@pytest.mark.parametrize("status", [status for status in Status if status not in (Status.FIX, Status.LIKELY)])
def test_the_best_place_is_kept_without_a_fix_but_is_no_position(status):
    found = replace(FIX, status=status)
    assert found.best == FIX.best
    assert (found.is_fix, found.place, found.position, found.heading_deg, found.pixel_size_m) == (False, *[None] * 4)


def test_a_place_without_heading_or_pixel_size_has_no_orientation():
    assert Place((0.0, 0.0), 30.0, 0.5).oriented == (30.0, 0.5)
    for place in (Place((0.0, 0.0), heading_deg=30.0), Place((0.0, 0.0), pixel_size_m=0.5)):
        with pytest.raises(ValueError, match="no heading and pixel size"):
            _ = place.oriented


def test_methods_and_states_are_their_keys_and_methods_keep_their_numbers():
    assert [f"{method}" for method in Method] == ["automatic", "topology vector", "constellation", "map correlation"]
    assert [Method.of_number(number) for number in range(4)] == list(Method)
    assert [method.number for method in Method] == [0, 1, 2, 3]
    assert Status("no_match") is Status.NO_MATCH == "no_match"


def test_what_explains_a_result_is_no_part_of_a_comparison():
    matches = Matches(np.arange(3), np.zeros((3, 2)), np.zeros((3, 2)), np.zeros(3))
    explained = replace(FIX, matches=matches, footprint=np.zeros((4, 2)))
    assert (len(matches), explained == FIX) == (3, True)
    assert replace(FIX, references=1) != FIX


@pytest.mark.parametrize(("risk", "expected"), [(0.19, Status.LIKELY), (0.21, Status.NO_MATCH)])
def test_a_doubted_candidate_is_a_likely_position_up_to_a_fifth(risk: float, expected: Status) -> None:
    doubted = Localization(Status.NO_MATCH, Method.CONSTELLATION, best=Place((1.0, 2.0)), risk=risk, is_doubted=True)

    found = show_likely(doubted)

    assert found.status is expected
    assert (found.position == (1.0, 2.0)) == found.is_likely
    assert found.fix is None


def test_an_inaccurate_candidate_is_no_likely_position() -> None:
    flawed = Localization(Status.AMBIGUOUS, Method.CONSTELLATION, best=Place((1.0, 2.0)), risk=0.01)

    assert show_likely(flawed) == flawed
