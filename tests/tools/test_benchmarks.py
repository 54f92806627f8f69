import importlib
import json
import re
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
MOST_WORDS = 5_000


@pytest.fixture(scope="module")
def benchmarks():
    sys.path.append(str(ROOT / "tools"))
    importlib.import_module("plugin_package").load_plugin_package()
    return lambda name: importlib.import_module(f"benchmarks.{name}")


def test_the_page_and_the_picture_are_made_from_the_results(benchmarks):
    page = benchmarks("page")
    content = benchmarks("toml").read_toml(page.CONTENT)
    written = page.PAGE.read_text(encoding="utf-8")
    assert written == page.page(content), "run: python -m benchmarks page"
    assert page.PICTURE.read_text(encoding="utf-8") == page.picture(content["bar"]), "run: python -m benchmarks page"
    assert len(written.split()) <= MOST_WORDS


def test_every_figure_of_the_page_is_in_a_result(benchmarks):
    page, results = benchmarks("page"), benchmarks("results")
    content = benchmarks("toml").read_toml(page.CONTENT)
    assert [line["figure"] for line in content["summary"] if results.cell(*line["of"]) == "–"] == []
    assert len(benchmarks("picture").figures(content["bar"])) == len(content["bar"])
    for topic in content["topic"]:
        tables = [results.load(name)["tables"][number] for name, number in topic["from"]]
        for expression in topic.get("rows", ()):
            assert any(results.rows_of(table, [expression]) for table in tables), (topic["title"], expression)
        assert set(topic.get("columns", ())) <= {column for table in tables for column in table["columns"]}


@pytest.mark.parametrize("path", sorted((ROOT / "benchmarks" / "results").glob("*.json")), ids=lambda path: path.stem)
def test_a_result_states_its_command_date_and_code(benchmarks, path):
    study = json.loads(path.read_text(encoding="utf-8"))
    for run in study["runs"]:
        assert run["command"] and re.fullmatch(r"\d{4}-\d\d-\d\d", run["date"])
        assert re.match(r"[0-9a-f]{7}", run["commit"])
    is_new = study["runs"][0]["command"].startswith("python -m benchmarks run")
    assert is_new or re.search(r"removed; the last commit with it: [0-9a-f]{7}", study["code"])
    assert study.get("scenario") in {None, *benchmarks("__main__").scenarios()} and (not is_new or "scenario" in study)


def test_scenarios_have_rows_that_a_runner_takes(benchmarks):
    accuracy, flights, timing = (benchmarks(name) for name in ("accuracy", "flights", "timing"))
    maps = benchmarks("maps").MAPS
    for name, scenario in benchmarks("__main__").scenarios().items():
        rows = []
        if scenario["runner"] in ("accuracy", "assessment"):
            rows = accuracy.rows_of(scenario)
            assert set(scenario.get("columns", ())) <= set(accuracy.COLUMNS), name
            assert {row.noise for row in rows} <= set(accuracy.NOISES), name
            kinds = {"", "mirrored", "other half", *benchmarks("foreign").KINDS}
            assert {row.foreign for row in rows} <= kinds, name
        elif scenario["runner"] == "flights":
            rows = [flights.Row(**{**scenario.get("defaults", {}), **row}) for row in scenario["row"]]
        else:
            assert scenario["measure"] in timing.MEASUREMENTS, name
        assert len({row.name for row in rows}) == len(rows), name
        assert {one for row in rows for one in (row.database, row.images) if one} <= set(maps), name


def test_the_page_of_settings_names_scenarios_that_exist(benchmarks):
    sys.path.append(str(ROOT / "tools" / "docs"))
    commands = " ".join(importlib.import_module("list_settings").COMMANDS.values())
    known = benchmarks("__main__").scenarios()
    named = set(re.findall(r"benchmarks (?:run|fit) ([\w.]+)", commands))
    assert [one for one in named if not any(name == one or name.startswith(f"{one}.") for name in known)] == []
    assert len(named) > 5


def test_the_plain_loop_gives_the_vectors_of_the_paper(benchmarks):
    plain = benchmarks("plain_build")
    centers = np.array([[8.0, 5.0], [5.0, 9.0], [1.0, 5.0]])
    vector = plain.vector(centers, np.array([1, 2, 3]), (5, 5), 3)
    assert np.allclose(vector[:3], [1, 0.75, 1.0], atol=1) and vector.shape == (30,)
    assert plain.vector(centers[:2], np.array([1, 2]), (5, 5), 3) is None


def test_stated_risks_are_compared_with_what_was_right(benchmarks):
    accuracy = benchmarks("accuracy")
    some = [{"risk": 0.05, "best_right": n < 9} for n in range(10)] + [{"risk": None, "best_right": False}]
    rows = accuracy.curve(some)["rows"]
    assert [row[0] for row in rows] == ["0.0–0.1", "0.9–1.0", "expected calibration error"]
    assert rows[-1][1] == f"{10 / 11 * 0.05:.3f}"
    assert accuracy.by_risk(some)["rows"][0][0] == "0.5–1"


def test_places_left_out_cover_all_that_is_trained_on(benchmarks):
    places = benchmarks("places")
    photos = [photo for place in places.PLACES for photo in place.photos]
    assert len({photo.name for photo in photos}) == len(photos) == 13
    table = places.class_table(places.BUILDINGS).splitlines()
    assert [row.split(",")[:2] for row in table] == [["value", "name"], ["1", "building"]]
