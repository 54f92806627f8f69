"""The reference page of the solvers' settings, from their classes.

heads/settings.md has the introduction and the commands of the trials. The docstring of a class describes each field as
"meaning [what it was set on; trials]".
"""

import ast
import inspect
import re
from collections.abc import Iterator
from dataclasses import is_dataclass
from pathlib import Path

HEAD = Path(__file__).with_name("heads").joinpath("settings.md").read_text(encoding="utf-8")
COMMANDS = dict(re.findall(r"^\| (.+) \| (.+) \|$", HEAD, re.MULTILINE)[1:])
"""The command that repeats each group of trials, by the name that docstrings use."""

_ENTRY = re.compile(r"^    (\w+): (.*?)(?=^    \w+: |\Z)", re.MULTILINE | re.DOTALL)
_IN_BRACKETS = re.compile(r" \[([^]]*)\]\.?$")
_CITED = re.compile(r"docs/([\w/-]+\.md(?:#[\w-]+)?)")


def classes() -> list[type]:
    """The settings classes of the localizer and of flights, each after the class that holds it."""
    from semref.core.flight.settings import FLIGHT
    from semref.core.localizer.settings import LOCALIZER

    def parts(settings: object) -> Iterator[type]:
        yield type(settings)
        for value in vars(settings).values():
            if is_dataclass(value):
                yield from parts(value)

    return [*parts(LOCALIZER), *parts(FLIGHT)]


def page() -> str:
    """Return the whole page."""
    return HEAD + "\n".join(map(section, classes())) + "\n"


def section(settings: type) -> str:
    """Return heading, file and table of a settings class."""
    title = re.sub(r"(?<!^)([A-Z])", lambda found: f" {found[1].lower()}", settings.__name__)
    about = " ".join(inspect.getdoc(settings).partition("\n\n")[0].split())
    file = settings.__module__.partition(".")[2].replace(".", "/")
    head = ["| field | value | meaning | data | trials |", "|---|---|---|---|---|"]
    rows = [f"| {' | '.join(row)} |" for row in rows_of(settings)]
    return "\n".join([f"\n## {title}\n\n`{settings.__name__}` in `{file}.py`. {_linked(about)}\n", *head, *rows])


def rows_of(settings: type) -> list[list[str]]:
    """Return name, value as in the source, meaning, data and trials of each field, in Markdown."""
    source = inspect.getsource(settings)
    entries = {name: " ".join(text.split()) for name, text in _ENTRY.findall(inspect.getdoc(settings))}
    rows = []
    for node in ast.parse(source).body[0].body:
        if isinstance(node, ast.AnnAssign):
            entry = entries.get(node.target.id, "")
            if not _IN_BRACKETS.search(entry):
                form = "NAME: Meaning [what it was set on; trials]."
                raise ValueError(f"{settings.__name__}.{node.target.id} needs an entry in the docstring: {form}")
            text = _linked(entry.replace("``", "`").replace("|", "\\|"))
            *data, trials = _IN_BRACKETS.search(text)[1].split("; ")
            if trials not in COMMANDS or not data:
                data, trials = [*data, trials], trials if trials in COMMANDS else "–"
            meaning = _IN_BRACKETS.sub("." if text.endswith(".") else "", text)
            value = ast.get_source_segment(source, node.value)
            rows.append([f"`{node.target.id}`", f"`{value}`", meaning, "; ".join(data), trials])
    return rows


def _linked(text: str) -> str:
    return _CITED.sub(r"[\1](../\1)", text)
