"""The parts of tools/bench that figures rest on: intervals, ratios, sections of a page, the plain computation."""

import importlib.util
import sys
from pathlib import Path

import numpy as np
import pytest

from semref.core.catalogue import CatalogueBuilder
from semref.core.label_source import ArrayLabels
from semref.core.rates import wilson
from semref.core.window_grid import WindowGrid
from semref.core.windows import describe_windows

BENCH = Path(__file__).parents[2] / "tools" / "bench"


def load(module):
    """A module of tools/bench by itself, without putting tools/ on sys.path."""
    spec = importlib.util.spec_from_file_location(f"semref_bench_{module}", BENCH / f"{module}.py")
    loaded = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = loaded  # dataclasses look their module up
    spec.loader.exec_module(loaded)
    return loaded


@pytest.fixture(scope="module")
def page():
    return load("page")


@pytest.mark.parametrize(
    ("successes", "trials", "low", "high"),
    [(0, 0, 0, 1), (0, 100, 0, 0.0370), (5, 100, 0.0215, 0.1118), (50, 100, 0.4038, 0.5962), (100, 100, 0.9630, 1)],
)
def test_wilson_interval_is_that_of_the_tables(successes, trials, low, high):
    assert wilson(successes, trials) == pytest.approx((low, high), abs=5e-5)


def test_ratio_is_taken_turn_by_turn():
    found = load("timing").ratios([1.0, 20.0, 3.0], [1.0, 10.0, 1.0])
    assert (found.median, found.least, found.most) == (2.0, 1.0, 3.0)


def test_candidates_take_turns_in_alternating_order():
    order = []
    candidates = {name: lambda name=name: order.append(name) for name in "ab"}
    seconds = load("timing").take_turns(candidates, 2)
    assert order == ["a", "b", "b", "a"] and [len(times) for times in seconds.values()] == [2, 2]


def test_new_section_is_added_at_the_end_of_the_page(page):
    assert page.with_section("", "x", "a") == "## x\n\n<!-- bench:x -->\n\na\n\n<!-- /bench:x -->\n"


def test_only_what_stands_between_the_markers_is_replaced(page):
    text = page.with_section("# Title\n", "x", "old") + "\nafter\n"
    assert page.with_section(text, "x", "new") == text.replace("old", "new")


def test_marker_without_its_partner_is_refused(page):
    with pytest.raises(ValueError, match="only one of the markers"):
        page.with_section("<!-- bench:x -->", "x", "a")


def test_plain_computation_and_core_give_the_same_vectors():
    rng = np.random.default_rng(7)
    labels = np.kron(rng.integers(0, 5, (60, 80)), np.ones((5, 5))).astype(np.uint8)
    labels[rng.random(labels.shape) < 0.01] = 0
    size, stride, classes, minimum_area = 100, 35, (1, 2, 4), 20.0
    catalogue = CatalogueBuilder(ArrayLabels(labels), classes, minimum_area)
    for step in (*catalogue.bands(), *catalogue.crossing()):
        assert step is not None
    grid = WindowGrid(labels.shape[1], labels.shape[0], size, stride)
    found = list(describe_windows(ArrayLabels(labels), grid, catalogue.objects, classes, minimum_area, 10))
    firsts = [first for windows in found for first in zip(windows.columns, windows.rows)]
    vectors, counts = load("plain_build").windows(labels, firsts, size, classes, minimum_area)
    np.testing.assert_array_equal(np.concatenate([windows.counts for windows in found]), counts)
    np.testing.assert_allclose(np.concatenate([windows.vectors for windows in found]), vectors, rtol=0, atol=2e-7)
