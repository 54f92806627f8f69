"""The parts of tools/bench that figures rest on: intervals, ratios, sections of a page, the plain computation, how
results of localization are judged and counted."""

import importlib
import importlib.util
import signal
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from semref.core.evaluation.rates import wilson
from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks.catalogue import CatalogueBuilder
from semref.core.windows.describe import describe_windows
from semref.core.windows.grid import WindowGrid

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


@pytest.fixture
def bench(monkeypatch):
    """`bench("localization")` gives that module of tools/bench, which imports others of it."""
    places = [str(BENCH)]
    spec = importlib.util.spec_from_file_location("bench", BENCH / "__init__.py", submodule_search_locations=places)
    monkeypatch.setitem(sys.modules, "bench", importlib.util.module_from_spec(spec))
    return lambda name: importlib.import_module(f"bench.{name}")


def outcome(bench, status="fix", error_m=1.0, objects=30):
    return bench("localization_trials").Outcome(status, objects, objects, 0.05, 1000.0, error_m, 0.1, 0.001, 0.5)


@pytest.mark.parametrize(("pixel", "heading_deg"), [(1.0, 350.0), (10.0, 10.0)])
def test_errors_are_those_from_the_truth_in_map_units(bench, pixel, heading_deg):
    trials = bench("localization_trials")
    area = trials.QueryMap.__new__(trials.QueryMap)
    area.origin, area.pixel_size = (5000.0, 9000.0), pixel
    view = SimpleNamespace(x=100.0, y=-50.0, heading_deg=heading_deg, pixel_size=1.25, width_px=640)
    x, y = 5000 + 100 * pixel + 3, 9000 - 50 * pixel - 4
    ellipse = SimpleNamespace(semi_major=10.0, semi_minor=10.0, orientation_deg=0.0)
    place = SimpleNamespace(position=(x, y), heading_deg=0.0, pixel_size_m=1.25 * pixel * 1.01)
    found = SimpleNamespace(status="fix", references=7, covariance=SimpleNamespace(ellipse_95=ellipse))
    judged = area.judge(view, found, place, 12, 0.1)
    assert judged.error_m == pytest.approx(5) and judged.ratio == pytest.approx(0.5)
    assert judged.heading_deg == pytest.approx(10) and judged.scale == pytest.approx(0.01)
    assert (judged.objects, judged.references, judged.footprint_m) == (12, 7, 800 * pixel)


def test_without_a_fix_there_is_no_error_and_nothing_right(bench):
    trials = bench("localization_trials")
    area = trials.QueryMap.__new__(trials.QueryMap)
    area.pixel_size = 1.0
    view = SimpleNamespace(x=0.0, y=0.0, heading_deg=0.0, pixel_size=1.0, width_px=10)
    judged = area.judge(view, SimpleNamespace(status="no_match", references=7), None, 12, 0.1)
    assert np.isnan(judged.error_m) and not judged.is_right(np.inf)


def test_a_row_of_localization_counts_right_wrong_and_refused(bench):
    localization = bench("localization")
    found = [outcome(bench, error_m=e) for e in (1, 9.9, 10.1)] + [outcome(bench, "no_match", np.nan)]
    cells = localization.row(localization.Case("x"), found)
    assert [cell.split(",")[0] for cell in cells[2:4]] == ["2/4", "1/4"] and cells[-1] == "1 no_match"
    tilted = localization.Case("x", wanted=localization.Wanted(tilt_deg=5.0))
    assert localization.row(tilted, found)[2].startswith("3/4")


def test_a_method_without_heading_is_told_by_its_position_alone(bench):
    trials = bench("localization_trials")
    told = trials.Outcome("fix", 9, 9, 0.1, 1000.0, 20.0)
    assert trials.accuracy([]) == ("–", "–") and trials.accuracy([told]) == ("20.00 m (2.000 %)", "–")


def test_results_of_two_dates_are_grouped_by_the_objects_in_view(bench):
    two_dates = bench("two_dates")
    found = [outcome(bench, objects=5), outcome(bench, objects=20), outcome(bench, error_m=500.0, objects=39)]
    rows = two_dates._by_objects({"constellation": found}).splitlines()[2:]
    assert [row.split("|")[2].split(",")[0].strip() for row in rows] == ["1/1", "–", "1/2", "–"]
    assert "; 1 wrong" in rows[2]


def test_images_from_elsewhere_come_in_parts(bench):
    parts = bench("elsewhere").parts
    assert parts(0) == [] and parts(500) == [500] and parts(1200) == [500, 500, 200]


def test_astroalign_is_judged_by_the_place_of_the_center(bench):
    astroalign = bench("astroalign")
    query = astroalign.Query(SimpleNamespace(position=(100.0, -50.0)), None)
    places = [(100 - 50j, False), (106 - 58j, False), (300 - 50j, False), (None, False), (None, True)]
    answers = [astroalign.Answer(place, 1.0, late) for place, late in places]
    cells = astroalign.judged([query] * 5, answers)
    assert [cell.split(",")[0] for cell in cells] == ["2/5", "1/5", "1", "1", "1"]


@pytest.mark.skipif(not hasattr(signal, "SIGPROF"), reason="no timer of processor time on this system")
def test_an_answer_that_takes_too_long_is_stopped(bench):
    def endless():
        while True:
            pass

    in_time = bench("astroalign").in_time
    assert in_time(5.0, lambda: 3) == 3
    with pytest.raises(TimeoutError):
        in_time(0.05, endless)
