"""Changed areas between a corrected label map and a database."""

from __future__ import annotations

import pytest

from semref.core.database import changed_regions
from semref.core.database.changed_regions import blocks_of, changed_places
from semref.core.labels import block_hashes

SHAPE_HW = (70, 90)
"""Blocks of a map of 3 × 3 blocks; the last ones are smaller."""


@pytest.fixture(autouse=True)
def small_blocks(monkeypatch):
    for module in (block_hashes, changed_regions):
        monkeypatch.setattr(module, "HASHED_BLOCK", 32)


def places_of(*changed):
    now = ["new" if block in changed else "old" for block in range(9)]
    return changed_places(["old"] * 9, now, SHAPE_HW)


@pytest.mark.parametrize(
    ("block", "place"), [(0, (0, 0, 33, 33)), (4, (31, 31, 65, 65)), (8, (63, 63, 90, 70))], ids=str
)
def test_a_changed_block_is_a_place_with_a_line_around_it_on_the_map(block, place):
    assert places_of(block) == [place]


def test_neighboring_blocks_are_one_place_and_blocks_apart_are_two():
    assert places_of(0, 1) == [(0, 0, 65, 33)]
    assert places_of(0, 2) == [(0, 0, 33, 33), (63, 0, 90, 33)]


@pytest.mark.parametrize(
    ("area", "blocks"),
    [
        ((0, 0, 1, 1), {(0, 0)}),
        ((31, 0, 33, 1), {(0, 0), (0, 1)}),
        ((0, 32, 32, 64), {(1, 0)}),
        ((-50, -50, 200, 10), {(0, 0), (0, 1), (0, 2)}),
        ((5, 5, 5, 9), set()),
        ((90, 0, 120, 10), set()),
    ],
)
def test_an_area_touches_the_blocks_it_shares_a_pixel_with(area, blocks):
    assert blocks_of(area, SHAPE_HW) == blocks
