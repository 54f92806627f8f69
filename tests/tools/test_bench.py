"""The parts of tools/bench that figures rest on: intervals, ratios, sections of a page, the plain computation, how
results of localization are judged and counted."""

import importlib
import importlib.util
import signal
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from semref.core.database.build import BuildSettings
from semref.core.evaluation.rates import wilson
from semref.core.evaluation.trial import Query, judge
from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks.catalogue import CatalogueBuilder
from semref.core.localization import Localization, Method, Place, Status
from semref.core.simulation.views import View
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
    monkeypatch.syspath_prepend(str(BENCH.parent))  # for qgis_session
    return lambda name: importlib.import_module(f"bench.{name}")


def trial(status=Status.FIX, error=1.0, landmarks=30, within=10.0, **view):
    """A judged image, 1,000 m across, whose fix is so far off."""
    query = Query(View(0.0, 0.0, 0.0, 1.0, 1000, 1000, **view))
    ellipse = SimpleNamespace(semi_major=20.0, semi_minor=20.0, orientation_deg=0.0)
    found = Localization(
        status,
        Method.CONSTELLATION,
        landmarks,
        best=Place((error, 0.0), 0.1, 1.001),
        covariance=SimpleNamespace(ellipse_95=ellipse),
    )
    return judge(query, Method.CONSTELLATION, found, within, landmarks, 0.05)


def test_a_row_counts_right_wrong_and_refused(bench):
    ground = bench("ground")
    found = [trial(error=error) for error in (1, 9.9, 10.1)] + [trial(Status.NO_MATCH)]
    cells = dict(zip(ground.COLUMNS, ground.cells(found, "x")))
    counts = [cells[name].split(",")[0] for name in ("right fixes", "wrong fixes", "in the 95 % radius")]
    assert counts == ["2/4", "1/4", "2/2"] and cells["no fix"] == "1 no_match"
    assert cells["ms median, p95"] == "50, 50" and cells["median error, heading, scale"].startswith("5.45 m (0.545 %)")


def test_of_mirrored_images_nothing_is_right(bench):
    ground = bench("ground")
    cells = dict(zip(ground.COLUMNS, ground.cells([trial(is_mirrored=True)], "x")))
    assert cells["right fixes"] == "–" and cells["wrong fixes"].startswith("1/1")


def test_a_method_without_heading_is_told_by_its_position_alone(bench):
    ground = bench("ground")
    found = Localization(Status.FIX, Method.TOPOLOGY_VECTOR, best=Place((20.0, 0.0)))
    told = judge(Query(View(0.0, 0.0, 0.0, 1.0, 1000, 1000)), Method.TOPOLOGY_VECTOR, found)
    assert ground.accuracy([]) == ("–", "–") and ground.accuracy([told]) == ("20.00 m (2.000 %)", "–")


@pytest.fixture
def strip(bench):
    """A map of two rows of houses, 400 pixels wide and high, with a database of it."""
    labels = np.full((400, 400), 2, np.uint8)
    rng = np.random.default_rng(4)
    for column, row in rng.integers(10, 380, (80, 2)):
        labels[row : row + rng.integers(6, 12), column : column + rng.integers(6, 12)] = 1
    table = "value,name,color,role\n1,building,#ff0000,reference\n2,grass,#00ff00,background\n"
    return bench("ground").memory_ground(labels, table, BuildSettings(200, 50, 9))


def test_images_come_from_their_half_and_the_other_half_is_all_that_a_known_elsewhere_map_has(bench, strip):
    ground = bench("ground")
    south = ground.Ground(strip.labels_hw, strip.database, "south")
    image = south.draw(ground.Wanted(landmarks=(5, 10**9)), np.random.default_rng(1))
    assert image.view.y <= south.middle and image.landmarks >= 5 and image.query.can_be_right
    ground.REACH_PX = 20
    other = south.known_elsewhere()
    assert other.extent == south.extent and 0 < len(other.database.references) < len(south.database.references)
    assert (other.database.references.positions[:, 1] > south.middle + 20).all()
    assert other.database.overview[:40].any() and not other.database.overview[55:].any()


def test_a_clean_image_of_the_map_is_found_where_it_was_cut(bench, strip):
    ground = bench("ground")
    case = ground.Case("x", wanted=ground.Wanted((1.0, 1.0)), right_within=2.0)
    found = strip.attempt(case, np.random.default_rng(2))
    assert found.is_right and found.error < 2 and found.landmarks >= 20


def test_a_map_without_such_images_is_left_out_of_the_table(bench, strip, monkeypatch, capsys):
    ground, inputs = bench("ground"), bench("inputs")
    monkeypatch.setattr(ground, "LARGEST_TRIES", 3)
    run = inputs.Run(None, BENCH, BENCH, 1, True, only=("none",))
    cases = [ground.Case("none such", wanted=ground.Wanted(landmarks=(10**6, 10**7))), ground.Case("unwanted")]
    assert list(ground.tried(run, strip, cases, 1, 1)) == []
    assert "none such: not measured" in capsys.readouterr().err


def test_results_of_two_dates_are_grouped_by_the_landmarks_in_view(bench):
    two_dates = bench("two_dates")
    found = [trial(landmarks=5), trial(landmarks=20), trial(error=500.0, landmarks=39)]
    rows = two_dates._by_landmarks({"constellation": found}).splitlines()[2:]
    assert [row.split("|")[2].split(",")[0].strip() for row in rows] == ["1/1", "–", "1/2", "–"]
    assert "; 1 wrong" in rows[2]


def test_cases_are_chosen_and_left_out_by_parts_of_their_names(bench):
    def wants(*only):
        run = bench("inputs").Run(None, BENCH, BENCH, 1, True, only=only)
        return [case for case in ("Tilt 5°", "Tilt 5°, told", "lens") if run.wants(case)]

    assert wants("tilt") == ["Tilt 5°", "Tilt 5°, told"] and wants("-told") == ["Tilt 5°", "lens"]
    assert wants("tilt", "-Told") == ["Tilt 5°"] and len(wants()) == 3


def test_images_of_a_row_come_in_parts(bench):
    parts = bench("kept").parts
    assert parts(0, 250) == [] and parts(250, 250) == [250] and parts(600, 250) == [250, 250, 100]


def test_a_row_goes_on_where_the_same_code_left_it_and_other_code_starts_anew(bench, tmp_path, monkeypatch):
    kept, tried = bench("kept"), []

    def measured(number, size):
        tried.append(number)
        return [number] * size

    def row(sizes):
        run = SimpleNamespace(work=tmp_path / "work", half="south", is_kept=False)
        return list(kept.row(run, "table", "tilt 5°", sizes, measured, ("one",)))

    state, core = kept.state, tmp_path / "core"
    (core / "one").mkdir(parents=True)
    (tmp_path / "work").mkdir()
    (core / "one" / "code.py").write_text("1")
    monkeypatch.setattr(kept, "state", lambda packages: state.__wrapped__(packages, core))
    assert row([2]) == [0, 0] and row([2, 1]) == [0, 0, 1] and tried == [0, 1]
    (core / "other.py").write_text("of another package")
    assert row([2, 1]) == [0, 0, 1] and tried == [0, 1]
    (core / "one" / "code.py").write_text("2")
    assert row([2]) == [0, 0] and tried == [0, 1, 0]


def test_the_state_is_that_of_what_runs_and_of_what_it_imports_from_packages_for_everybody(bench, tmp_path):
    kept = bench("kept")
    files = {
        "one/code.py": "from ..labels.used import f\n",
        "labels/used.py": "from .deeper import g\n",
        "labels/deeper.py": "g = 1\n",
        "labels/other.py": "1\n",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)

    def state():
        return kept.state.__wrapped__(("one", "labels"), tmp_path)

    before = state()
    (tmp_path / "labels" / "other.py").write_text("2\n")
    (tmp_path / "labels" / "new.py").write_text("3\n")
    (tmp_path / "one" / "code.py").write_text('"""Told."""\n# why\nfrom ..labels.used import f\n')
    assert state() == before
    (tmp_path / "labels" / "deeper.py").write_text("g = 2\n")
    assert state() != before


def test_trials_of_a_row_are_kept_in_parts(bench, tmp_path):
    kept, tried = bench("kept"), []

    def measured(number, size):
        tried.append((number, size))
        return [trial(error=float(number))] * size

    run = SimpleNamespace(work=tmp_path, half="south", is_kept=False)
    assert len(kept.trials(run, "table", "row", 10, measured, ("windows",))) == 10
    found = kept.trials(run, "table", "row", 12, measured, ("windows",))
    assert tried == [(0, 10), (1, 2)] and [t.error for t in found] == [0.0] * 10 + [1.0] * 2
    run.is_kept = True
    assert len(kept.trials(run, "table", "row", 50, measured, ("windows",))) == 12 and len(tried) == 2
    assert kept.trials(run, "table", "other", 50, measured, ("windows",)) == []


def test_images_from_elsewhere_for_automatic_can_not_be_right(bench, strip):
    elsewhere = bench("elsewhere_automatic")
    source, rng = elsewhere.Source(strip, strip.known_elsewhere(), ()), np.random.default_rng(3)
    makes = [make for make in elsewhere.KINDS.values() if make not in (elsewhere._landscape, elsewhere._aerial)]
    for make in makes:
        known, image = make(source, rng, 1)
        assert known in (source.ground, source.known) and image.labels_hw.any() and not image.query.can_be_right


def test_coverage_counts_right_fixes_alone_and_tells_wrong_ones(bench):
    coverage = bench("coverage")
    held, wide = (
        coverage.Told(True, False, 0.9, 3.0, 1.0, True, True),
        coverage.Told(True, False, 1.1, 5.0, 3.0, False, True),
    )
    row = coverage.cells("a row", [held, held, wide, coverage.Told(False, True), coverage.Told(False, False)])
    assert row[1].startswith("3/5, ") and row[1].endswith("; 1")
    assert [cell.split(",")[0] for cell in row[2:5]] == ["0/3", "2/3", "3/3"]
    assert row[5:] == ["3.00 m, 1.00 m", "67%, 100%"]


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


def told(bench, risk, is_right, kind="of the map", is_sound=True):
    reliability = bench("reliability")
    return reliability.Told(kind, "clean", 640, 30.0, 0.0, risk, is_right, is_sound, is_sound, "")


def test_the_told_probability_is_compared_with_how_often_it_was_right(bench):
    reliability = bench("reliability")
    trials = [told(bench, 0.04, True)] * 19 + [told(bench, 0.04, False)] + [told(bench, 0.96, False)] * 4
    text = reliability.curve(trials)
    assert "0.9–1.0 | 0.960 | 19/20" in text.replace("  ", " ") and "0.0–0.1 | 0.040 | 0/4" in text
    error = (20 * abs(0.96 - 0.95) + 4 * 0.04) / 24
    assert f"Expected calibration error: {error:.3f}" in text


def test_a_smaller_risk_costs_right_fixes_and_wrong_ones_are_counted(bench):
    trials = [
        told(bench, 1e-7, True),
        told(bench, 1e-3, True),
        told(bench, 0.3, False),
        told(bench, 1e-9, True, is_sound=False),
    ]
    table = bench("reliability").costs([*trials, told(bench, 1e-5, False, "mirrored")])
    (row,) = [line for line in table.splitlines() if line.startswith("| all")]
    assert [cell.split(",")[0].strip() for cell in row.split("|")[2:-1]] == ["2/4", "2/4", "1/4", "1/4"]
    assert "; 1 wrong" in row and "1/1" in table.splitlines()[-1]


def test_images_of_two_places_are_told_apart_by_whether_both_sides_could_tell(bench):
    reliability = bench("reliability")
    fix, few = (replace(told(bench, 1e-9, False), smaller_side=number) for number in (7, 1))
    said = replace(fix, is_fix=False, reason="localization.one_side_elsewhere")
    text = reliability.of_two_places([fix, replace(few, reason=reliability.REMARKS[0]), few, said])
    assert "such 1/4, 25 %" in text and "places 3/4" in text and "such 1/2" in text and "places 1/2" in text
    assert "1 of which say" in text and "0 of which say" in text


def test_right_fixes_that_say_what_they_do_not_hold_for_are_counted(bench):
    right = told(bench, 1e-9, True)
    reliability = bench("reliability")
    said = replace(right, reason=reliability.REMARKS[1])
    refused = replace(right, is_fix=False, reason="localization.one_side_elsewhere")
    text = reliability.remarked([right, right, said, refused, replace(said, is_right=False)])
    assert "1/3" in text and "of two places: 1." in text


def test_an_image_without_its_place_and_the_mirrored_one_are_judged_as_wrong_ones(bench):
    area = bench("area_reliability")
    own = [(0.8, 20.0, 0.001, True, 0.01), (0.3, 1.0, 5.0, True, None)]
    decoys = [(0.25, 1.0, 3.0, True, None), (0.24, 1.5, 0.4, True, None)]
    told = list(area.judged(area.Places("of the map", "clean", own, decoys)))
    assert [one.kind for one in told] == ["of the map", "without its place", "mirrored"]
    assert [one.is_right for one in told] == [True, False, False]
    assert told[0].risk < 1e-4 and min(one.risk for one in told[1:]) > 0.9
    # A mirrored image's place on the image's own ground is none of the wrong ones.
    of_own = list(area.judged(area.Places("of the map", "clean", own, decoys[1:])))
    assert [one.kind for one in of_own] == ["of the map", "without its place"]
    strange = list(area.judged(area.Places("landscape", "", own[1:], decoys)))
    assert [one.kind for one in strange] == ["landscape", "mirrored"] and not any(one.is_right for one in strange)
