"""Results kept in the work folder, of one state of the code: a later run goes on, and runs of some rows are joined."""

from __future__ import annotations

import ast
import hashlib
import json
import pickle
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

from bench import inputs

CORE = Path(__file__).resolve().parents[2] / "core"
SIMULATING = ("simulation", "labels", "landmarks", "geometry", "database")
"""Packages of core that make the images of all roads."""

OF_CONSTELLATION = (*SIMULATING, "constellation")
OF_AREAS = (*OF_CONSTELLATION, "correlation", "windows", "localizer")
OF_ALL = (*OF_AREAS, "segmentation", "sample")

SERVING = ("labels", "geometry")
"""Packages for everybody: of these, only what the others import counts."""

BESIDE = (
    "database/changed_regions.py",
    "database/update.py",
    "localizer/leveled.py",
    "localizer/record.py",
    "localizer/track.py",
)
"""Of the other packages, what no simulated label image goes through: cameras, flights, updates."""

TRIALS_A_PART = 10


def parts(count: int, size: int) -> list[int]:
    """Images of each part of `count`."""
    return [min(size, count - first) for first in range(0, count, size)]


def wanted(
    run: inputs.Run,
    table: str,
    name: str,
    sizes: Sequence[int],
    packages: Sequence[str] = OF_CONSTELLATION,
    suffix: str = "json",
) -> Sequence[int]:
    """Images in the parts of a row: as they are given, or with --kept in those that are there."""
    if not run.is_kept:
        return sizes
    there: list[int] = []
    while True:
        start = f"{plain(name)}_{len(there)}_"
        end = _path(run, table, name, 0, 0, packages, suffix).name[len(f"{plain(name)}_0_0") :]
        names = [path.name for path in (run.work / table).glob(f"{start}*{end}")]
        here = [name[len(start) : -len(end)] for name in names]
        here = [int(size) for size in here if size.isdigit()]
        if not here:
            return there
        there.append(max(here))


@lru_cache
def state(packages: Sequence[str], core: Path = CORE) -> str:
    """Of the code that a figure comes from: other code starts anew; another page, comment or module does not."""
    used = sorted(modules(packages, core))
    return hashlib.sha256("\n".join(map(instructions, used)).encode()).hexdigest()[:12]


def modules(packages: Sequence[str], core: Path) -> set[Path]:
    """Those of packages of core, and of SERVING what they import."""
    found = {path for name in packages if name not in SERVING for path in (core / name).rglob("*.py")}
    found = {path for path in found if path.relative_to(core).as_posix() not in BESIDE}
    serving, unread = tuple(core / name for name in SERVING if name in packages), list(found)
    while unread:
        others = {path for path in imported(unread.pop()) if path.parent in serving} - found
        found |= others
        unread += others
    return found


def imported(path: Path) -> set[Path]:
    """Modules that a module imports by their place beside it."""
    found: set[Path] = set()
    for node in ast.walk(ast.parse(path.read_bytes())):
        if isinstance(node, ast.ImportFrom) and node.level:
            target = path.parents[node.level - 1].joinpath(*(node.module or "").split("."))
            found |= {target.with_suffix(".py"), *(target / f"{alias.name}.py" for alias in node.names)}
    return {one for one in found if one.is_file()}


def instructions(path: Path) -> str:
    """A module without what is for people alone: comments, docstrings, line breaks."""
    tree = ast.parse(path.read_bytes())
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list):
            node.body = [one for one in body if not _is_text(one)]
    return ast.unparse(tree)


def _is_text(node: ast.AST) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def part(
    run: inputs.Run,
    table: str,
    name: str,
    number: int,
    size: int,
    measured: Callable[[int, int], Any],
    packages: Sequence[str] = OF_CONSTELLATION,
) -> Any:
    """What a part of a row came to, as JSON has it; measured unless this state of the code has done so.

    Args:
        run: whose work folder keeps it
        table: name of the folder
        name: of the row
        number: of the part; has its own seed
        size: images in it
        measured: number and size of a part → what JSON can hold; called where nothing is kept
        packages: of core that the figures come from
    """
    path = _path(run, table, name, number, size, packages, "json")
    if not path.exists():
        path.write_text(json.dumps(measured(number, size)), encoding="utf-8")
    return json.loads(path.read_text("utf-8"))


def row(
    run: inputs.Run,
    table: str,
    name: str,
    sizes: Sequence[int],
    measured: Callable[[int, int], list],
    packages: Sequence[str] = OF_CONSTELLATION,
) -> Iterator[Any]:
    """What all parts of a row hold, one after the other; with --kept those that are there."""
    for number, size in enumerate(wanted(run, table, name, sizes, packages)):
        yield from part(run, table, name, number, size, measured, packages)


def trials(
    run: inputs.Run,
    table: str,
    name: str,
    count: int,
    measured: Callable[[int, int], list],
    packages: Sequence[str] = OF_AREAS,
) -> list:
    """Whole trials, or whatever a list may hold, of all parts of a row; arguments as above.

    Files of one's own work folder are read as pickles: nobody else's belong there.
    """
    found: list = []
    sizes = parts(count, TRIALS_A_PART)
    for number, size in enumerate(wanted(run, table, name, sizes, packages, "pickle")):
        path = _path(run, table, name, number, size, packages, "pickle")
        if not path.exists():
            path.write_bytes(pickle.dumps(measured(number, size)))
        found += pickle.loads(path.read_bytes())
    return found


def plain(name: str) -> str:
    """A row's name as a file may have it."""
    return "".join(letter if letter.isalnum() else "_" for letter in name)


def _path(run: inputs.Run, table: str, name: str, number: int, size: int, packages: Sequence[str], suffix: str) -> Path:
    folder = run.work / table
    folder.mkdir(exist_ok=True)
    return folder / f"{plain(name)}_{number}_{size}_{run.half}_{state(packages)}.{suffix}"
