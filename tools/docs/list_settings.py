"""The reference page of the solvers' settings, from their classes.

The docstring of a class describes each field as "meaning [what it was set on; trials]".
"""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Iterator
from dataclasses import is_dataclass

COMMANDS = {
    "constellation trials, north": "`benchmarks run localization`, `benchmarks fit localization`",
    "tilted trials": "`benchmarks run cameras`",
    "images from elsewhere": "`benchmarks run elsewhere`",
    "catalogue sizes": "`benchmarks run timing.fix`",
    "correlation trials, north, and fit": "`benchmarks run label_noise`, `benchmarks fit label_noise`",
    "correlation times": "`benchmarks run timing.correlation`",
    "large maps": "removed",
    "areas": "`benchmarks run reliability`, `benchmarks fit reliability`",
    "radius": "`benchmarks run coverage`, `benchmarks fit coverage`",
    "covariance": "`benchmarks run coverage` and `dates` with other settings",
    "biases": "*Compare label maps*",
    "probability": "`benchmarks run reliability`, `benchmarks fit reliability`",
    "footprint trials": "`benchmarks run footprints`",
    "parts": "removed",
    "flights": "`benchmarks run flights`",
    "flight measurements": "removed",
    "automatic, north, with evidence": "`benchmarks run label_noise`",
}
"""The command that repeats each group of trials, by the name that docstrings use."""

HEAD = """# Solver settings

The values below were chosen; they do not follow from an equation. Each class is a frozen dataclass. Create another
one with `dataclasses.replace` and pass it to `Localizer(database, settings)`. A changed value changes results, so
repeat its trials and the [benchmarks](../benchmarks.md).

The column *data* shows what a value was set on:

- *Liechtenstein, north*: trials on the northern half of Liechtenstein 2021. Published figures come from the southern
  half, which decided nothing.
- *three places, north*: the northern halves of Liechtenstein and of Christchurch (a map of 1996, images of 2018), and
  tiles 1 to 3 of Dubai's label maps. Published figures come from the southern halves, from tiles 4 to 6, and from
  places on which no value was calibrated.
- *by hand*: judgment when the method was written. The named trials ran with this value; no record shows that another
  value was tested.
- *reasoning*: follows from the text in the column *meaning*.

## Commands

Measure with `.venv/bin/python -m benchmarks run NAME --data FOLDER --work FOLDER --count N`. Then `.venv/bin/python
-m benchmarks fit NAME --work FOLDER` prints the curve of the error probability and the factor of the radius that fit
these images. Fit on one place or pair of dates, and test on another. Set `half = "north"` in a scenario's file to
calibrate on the northern half.

The values were set with older scripts (`tools/calibration`, `tools/bench`), which drew other images of the same
kinds. Commit c1d78b5 is the last one that has them.
"""

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
    commands = [f"| {name} | {command} |" for name, command in COMMANDS.items()]
    return "\n".join([HEAD, "| trials | command |", "|---|---|", *commands, *map(section, classes())]) + "\n"


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
            text = _linked(entries[node.target.id].replace("``", "`").replace("|", "\\|"))
            *data, trials = _IN_BRACKETS.search(text)[1].split("; ")
            if trials not in COMMANDS or not data:
                data, trials = [*data, trials], trials if trials in COMMANDS else "–"
            meaning = _IN_BRACKETS.sub("." if text.endswith(".") else "", text)
            value = ast.get_source_segment(source, node.value)
            rows.append([f"`{node.target.id}`", f"`{value}`", meaning, "; ".join(data), trials])
    return rows


def _linked(text: str) -> str:
    return _CITED.sub(r"[\1](../\1)", text)
