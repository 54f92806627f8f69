"""Writes the tables of settings into docs/calibration.md: python tools/docs/list_settings.py.

A table follows each line of the page that begins with a class and its file. Meaning, data and command of a field come
from the class's docstring: "meaning [data; command]".
"""

from __future__ import annotations

import ast
import inspect
import re
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "calibration.md"

_TABLE = re.compile(r"^`(\w+)`, `(core/[\w/]+\.py)`(?:.+\n)+\n(?P<rows>(?:\|.*\n)*)", re.MULTILINE)
_ENTRY = re.compile(r"^    (\w+): (.*?)(?=^    \w+: |\Z)", re.MULTILINE | re.DOTALL)
_IN_BRACKETS = re.compile(r" \[([^]]*)\]\.?$")
_COMMAND = re.compile(r"^\| ([^|]+) \| (?:`|removed|\*)", re.MULTILINE)


class Field(NamedTuple):
    """A row of a table, in Markdown."""

    name: str
    value: str
    meaning: str
    data: str
    command: str


def fields(path: Path, name: str, commands: set[str]) -> list[Field]:
    """The fields of a settings class in order; ``commands`` are the names of the page's commands."""
    source = path.read_text(encoding="utf-8")
    found = next(node for node in ast.parse(source).body if isinstance(node, ast.ClassDef) and node.name == name)
    told = {entry: " ".join(text.split()) for entry, text in _ENTRY.findall(inspect.cleandoc(ast.get_docstring(found)))}
    rows = []
    for node in found.body:
        if isinstance(node, ast.AnnAssign):
            text = told[node.target.id].replace("``", "`")
            *data, command = _IN_BRACKETS.search(text)[1].split("; ")
            if command not in commands or not data:
                data, command = [*data, command], command if command in commands else "–"
            meaning = _IN_BRACKETS.sub("." if text.endswith(".") else "", text)
            value = ast.get_source_segment(source, node.value)
            rows.append(Field(node.target.id, value, meaning, "; ".join(data), command))
    return rows


def commands_of(page: str) -> set[str]:
    """Names in the table of commands."""
    return set(_COMMAND.findall(page.partition("## Commands\n")[2].partition("\n## ")[0]))


def with_tables(page: str) -> str:
    """The page with its tables of settings as the classes have them now."""
    commands = commands_of(page)

    def table(found: re.Match) -> str:
        rows = [
            f"| `{row.name}` | `{row.value}` | {' | '.join(row[2:])} |\n"
            for row in fields(ROOT / found[2], found[1], commands)
        ]
        before = found[0][: found.start("rows") - found.start()]
        return before + "".join(["| field | value | meaning | data | command |\n", "|---|---|---|---|---|\n", *rows])

    return _TABLE.sub(table, page)


if __name__ == "__main__":
    PAGE.write_text(with_tables(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
