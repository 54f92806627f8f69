"""The README's picture is drawn from what was measured, and from nothing else."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def what_works():
    sys.path.append(str(ROOT / "tools"))
    return importlib.import_module("bench.what_works")


def test_the_picture_is_what_the_benchmarks_say(what_works):
    drawn = what_works.picture(what_works.BENCHMARKS.read_text(encoding="utf-8"))
    assert what_works.PICTURE.read_text(encoding="utf-8") == drawn, "run tools/bench/what_works.py"


def test_every_bar_has_its_figures_and_no_figure_is_left_out(what_works):
    bars = what_works.figures(what_works.BENCHMARKS.read_text(encoding="utf-8"))
    assert [images for images, right, _ in bars if right is None and "none is to be found" not in images] == []
    assert [images for images, _, _ in bars] == [shown.images for shown in what_works.SHOWN]


def test_what_is_not_measured_has_no_bar(what_works):
    assert what_works.figures("") == []


@pytest.mark.parametrize(
    ("cell", "count"),
    [
        ("34/40, 85 % (71–93)", (34, 40, 71, 93)),
        ("143/150 = 95.3 % (90.7–97.7)", (143, 150, 90.7, 97.7)),
        ("0/200 (0–1.9), median error 0.7 m", (0, 200, 0, 1.9)),
        ("1/2", (1, 2, 50, 50)),
        ("–", None),
    ],
)
def test_counts_are_read_as_benches_write_them(what_works, cell, count):
    assert what_works.count_in(cell) == count


def test_of_flights_wrong_positions_are_no_right_ones(what_works):
    text = (
        "<!-- bench:flights -->\n| flights | flights, images | placed | wrong |\n|---|---|---|---|\n"
        "| 640 m, drift 5 % | 6, 180 | 179/180, 99 % (97–100) | 14/180, 8 % (5–13) |\n<!-- /bench:flights -->"
    )
    right, wrong = next((right, wrong) for images, right, wrong in what_works.figures(text) if "drifts" in images)
    assert (right.count, wrong.count) == (165, 14)


def test_a_cell_may_tell_right_and_wrong_ones(what_works):
    right = what_works.count_in("139/306, 45 % (40–51); 2 wrong")
    assert what_works.wrong_in("139/306, 45 % (40–51); 2 wrong", right).count == 2
