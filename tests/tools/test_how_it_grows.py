"""The picture of docs/scale.md is drawn from what was measured, and from nothing else."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def how_it_grows():
    sys.path.append(str(ROOT / "tools"))
    return importlib.import_module("bench.how_it_grows")


def test_the_picture_is_what_the_benchmarks_say(how_it_grows):
    drawn = how_it_grows.picture(how_it_grows.BENCHMARKS.read_text(encoding="utf-8"))
    assert how_it_grows.PICTURE.read_text(encoding="utf-8") == drawn, "run tools/bench/how_it_grows.py"


def test_every_line_has_its_points(how_it_grows):
    text = how_it_grows.BENCHMARKS.read_text(encoding="utf-8")
    lines = [line for panel in how_it_grows.PANELS for line in panel.lines]
    assert [line.words for line in lines if len(how_it_grows.points(text, line)) < 3] == []


def test_what_is_not_measured_has_no_line(how_it_grows):
    assert "path" not in how_it_grows.picture("")


def test_rows_are_chosen_by_their_words_and_told_in_seconds(how_it_grows):
    text = (
        "<!-- bench:catalogue sizes -->\n| landmarks | beside | images | p95 |\n|---:|---|---|---:|\n"
        "| 10,000 | other ground | 20 / 20 / 5 % | 145 |\n| 10,000 | altered copies | 20 / 20 / 5 % | 999 |\n"
        "| 1,000 | other ground | 20 / 20 / 5 % | 80 |\n| 1,000 | other ground | 40 / 40 / 10 % | 999 |\n"
        "<!-- /bench:catalogue sizes -->"
    )
    drawn = next(line for line in how_it_grows.PANELS[0].lines if line.y == "p95")
    assert how_it_grows.points(text, drawn) == [(1000, pytest.approx(0.08)), (10000, pytest.approx(0.145))]


@pytest.mark.parametrize(
    ("cell", "number"),
    [("10,000,000", 1e7), ("1.0e+08", 1e8), ("1.33 GB", 1.33), ("495.3 MB", 0.4953), ("", None), ("–", None)],
)
def test_numbers_are_read_as_benches_write_them(how_it_grows, cell, number):
    assert how_it_grows.number_in(cell) == (None if number is None else pytest.approx(number))
