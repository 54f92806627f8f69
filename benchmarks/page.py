"""Writes docs/benchmarks.md and the chart what_works.svg from benchmarks/results/*.json and page.toml."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from benchmarks import results
from benchmarks.picture import picture
from benchmarks.toml import read_toml

PAGE = results.ROOT / "docs" / "benchmarks.md"
PICTURE = results.ROOT / "docs" / "images" / "what_works.svg"
CONTENT = Path(__file__).with_name("page.toml")


def write() -> None:
    """Write the page and the chart."""
    content = read_toml(CONTENT)
    PAGE.write_text(page(content), encoding="utf-8")
    PICTURE.write_text(picture(content["bar"]), encoding="utf-8")


def page(content: dict[str, Any]) -> str:
    """Return the page in Markdown."""
    cells = [(one["figure"], one.get("goal") or results.cell(*one["goal_of"]), one["of"]) for one in content["summary"]]
    rows = [[figure, goal, results.cell(*of)] for figure, goal, of in cells]
    parts = [content["head"], results.markdown(["figure", "goal", "measured"], rows)]
    parts += [topic(one, content["words"]) for one in content["topic"]]
    shown = {name for one in content["topic"] for name, _ in one["from"]}
    return "\n\n".join(part.strip() for part in [*parts, others(shown)]) + "\n"


def topic(one: dict[str, Any], words: Sequence[Sequence[str]]) -> str:
    """Return heading, conditions, table, files and dates of a topic.

    Args:
        one: The topic in page.toml.
        words: Texts of the results, and what the page shows instead.
    """
    columns: list[str] = []
    rows: list[list[str]] = []
    for name, number in one["from"]:
        table = results.load(name)["tables"][number]
        columns = columns or one.get("columns", table["columns"])
        places = [table["columns"].index(column) if column in table["columns"] else None for column in columns]
        for row in results.rows_of(table, one.get("rows", ())):
            rows.append(["–" if place is None or place >= len(row) else row[place] for place in places])
    rows = rows[: one.get("most")]
    table_text = results.markdown(columns, rows)
    for text, shown in words:
        table_text = table_text.replace(text, shown)
    return "\n\n".join([f"## {one['title']}", one["text"], table_text, measured([name for name, _ in one["from"]])])


def measured(names: list[str]) -> str:
    """Return files, dates and commits of studies."""
    found = []
    for name in dict.fromkeys(names):
        run = results.load(name)["runs"][0]
        found.append(f"{name}.json, {run['date']}, {run['commit']}")
    return f"*{'; '.join(found)}*"


def others(shown: set[str]) -> str:
    """Return a table of the studies that the page does not show."""
    rows = []
    for name in results.names():
        if name not in shown:
            study = results.load(name)
            rows.append([study["title"], f"{name}.json", study["runs"][0]["date"] if study["runs"] else "–"])
    table = results.markdown(["study", "file", "date"], rows)
    return f"## Other studies\n\nThe results of these studies are only in their files.\n\n{table}"
