"""Writes docs/benchmarks.md and the README's picture from benchmarks/results/*.json, as page.toml says."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from benchmarks import results
from benchmarks.picture import picture
from benchmarks.toml import read_toml

PAGE = results.ROOT / "docs" / "benchmarks.md"
PICTURE = results.ROOT / "docs" / "images" / "what_works.svg"
CONTENT = Path(__file__).with_name("page.toml")

HEAD = """\
# Benchmarks

Written from `benchmarks/results/*.json` by `python -m benchmarks page`; do not edit it. Each file has all rows of a
study, its command, date, commit and machine. `python -m benchmarks run NAME` measures a scenario again
([how to](development.md#benchmarks)). Times are ratios within one run; machines were shared with other work. Shares
have their 95 % interval in parentheses.
"""


def write() -> None:
    """Writes the page and the picture."""
    content = read_toml(CONTENT)
    PAGE.write_text(page(content), encoding="utf-8")
    PICTURE.write_text(picture(content["bar"]), encoding="utf-8")


def page(content: dict[str, Any]) -> str:
    """The page's Markdown."""
    rows = [[line["figure"], line["goal"], results.cell(*line["of"])] for line in content["summary"]]
    parts = [HEAD, results.markdown(["figure", "goal", "measured"], rows)]
    parts += [topic(one) for one in content["topic"]]
    shown = {name for one in content["topic"] for name, _ in one["from"]}
    return "\n\n".join(part.strip() for part in [*parts, others(shown)]) + "\n"


def topic(one: dict[str, Any]) -> str:
    """A heading, a sentence, a table, and when it was measured."""
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
    return (
        f"## {one['title']}\n\n{one.get('text', '')}\n\n{table_text}\n\n{measured([name for name, _ in one['from']])}"
    )


def measured(names: list[str]) -> str:
    """Files, dates and commits of studies."""
    found = []
    for name in dict.fromkeys(names):
        run = results.load(name)["runs"][0]
        found.append(f"{name}.json, {run['date']}, {run['commit']}")
    return f"*{'; '.join(found)}*"


def others(shown: set[str]) -> str:
    """Studies that only their file has, and whose code may be gone."""
    rows = []
    for name in results.names():
        if name not in shown:
            study = results.load(name)
            rows.append([study["title"], f"{name}.json", study["runs"][0]["date"] if study["runs"] else "–"])
    return f"## Other studies\n\nThese are kept as files only.\n\n{results.markdown(['study', 'file', 'date'], rows)}"
