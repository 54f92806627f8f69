"""docs/benchmarks.md holds what tools/bench wrote: figures between markers, each with its command and commit."""

from __future__ import annotations

import ast
import importlib.util
import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
BENCH = ROOT / "tools" / "bench"
PAGES = {name: (ROOT / "docs" / name).read_text(encoding="utf-8") for name in ("benchmarks.md", "published_method.md")}
SECTION = re.compile(r"<!-- bench:([^>]+) -->(.*?)<!-- /bench:\1 -->", re.DOTALL)
SECTIONS = {name: body for text in PAGES.values() for name, body in SECTION.findall(text)}
SUMMARY = "summary"


def written() -> set[str]:
    """Names of sections that the benches give to `measure`'s caller: keys of what it returns."""
    found = set()
    for path in BENCH.glob("*.py"):
        for function in ast.parse(path.read_text(encoding="utf-8")).body:
            if not isinstance(function, ast.FunctionDef) or function.name != "measure":
                continue
            keys = [key for node in ast.walk(function) if isinstance(node, ast.Dict) for key in node.keys]
            keys += [
                node.targets[0].slice
                for node in ast.walk(function)
                if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Subscript)
            ]
            found |= {key.value for key in keys if isinstance(key, ast.Constant)}
    return found


@pytest.fixture
def summary(monkeypatch):
    places = [str(BENCH)]
    spec = importlib.util.spec_from_file_location("bench", BENCH / "__init__.py", submodule_search_locations=places)
    monkeypatch.setitem(sys.modules, "bench", importlib.util.module_from_spec(spec))
    return importlib.import_module("bench.summary")


def test_no_table_of_figures_stands_outside_the_markers():
    rest = SECTION.sub("", PAGES["benchmarks.md"])
    assert [line for line in rest.splitlines() if line.startswith("|")] == []


def test_each_section_is_one_that_some_bench_writes():
    assert sorted(set(SECTIONS) - written() - {SUMMARY}) == []


@pytest.mark.parametrize("name", sorted(set(SECTIONS) - {SUMMARY}))
def test_each_section_tells_its_command_commit_and_versions(name):
    assert re.search(r"\*[^|]*`[^|]*commit [0-9a-f]{7}[^|]*\*", SECTIONS[name].replace("\n", " "))


def test_the_page_begins_with_the_summary_of_its_sections(summary):
    text = PAGES["benchmarks.md"]
    assert text.index(f"<!-- bench:{SUMMARY} -->") < text.index("##")
    assert SECTIONS[SUMMARY].strip() == summary.summary(text)


def test_each_line_of_the_summary_is_of_a_bench_and_its_section(summary):
    names = {path.stem for path in BENCH.glob("*.py")}
    assert {line.section for line in summary.LINES} <= written() and {
        line.command.split()[-1] for line in summary.LINES
    } <= names


def test_the_summary_reads_the_cell_it_means(summary):
    section = "| images | right | wrong |\n|---|---|---|\n| a, good | 1 | 0 |\n| a, poor | **2** | 5 |\n"
    line = summary.Line("", "", "x", "a|poor", "right", "x")
    assert summary.measured(section, line) == "2"
    assert summary.measured("", line) == "–"


def test_the_longest_is_that_of_all_rows_and_columns(summary):
    section = "| step | first (ms) | work | again (ms) |\n|---|---|---|---|\n| a | 7 | 200 | 90 |\n| b | 21 | 3 | |\n"
    assert summary.measured(section, summary.Line("", "", "x", "", "(ms)", largest=True)) == "90"
