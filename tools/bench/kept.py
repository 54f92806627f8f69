"""Results kept in the work folder, of one state of the code: a later run goes on, and runs of some rows are joined."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

from bench import inputs

CORE = Path(__file__).resolve().parents[2] / "core"
SIMULATING = ("simulation", "labels", "landmarks", "geometry", "database")
"""Packages of core that make the images of all roads."""

OF_CONSTELLATION = (*SIMULATING, "constellation")
OF_ALL = (*OF_CONSTELLATION, "correlation", "segmentation", "sample", "windows", "localizer")


def parts(count: int, size: int) -> list[int]:
    """Images of each part of `count`."""
    return [min(size, count - first) for first in range(0, count, size)]


@lru_cache
def state(packages: Sequence[str], core: Path = CORE) -> str:
    """Of the code that a figure comes from: other code starts anew, another page or another package does not."""
    files = sorted(path for name in packages for path in (core / name).rglob("*.py"))
    return hashlib.sha256(b"".join(path.read_bytes() for path in files)).hexdigest()[:12]


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
    folder = run.work / table
    folder.mkdir(exist_ok=True)
    path = folder / f"{plain(name)}_{number}_{size}_{run.half}_{state(packages)}.json"
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
    """What all parts of a row hold, one after the other."""
    for number, size in enumerate(sizes):
        yield from part(run, table, name, number, size, measured, packages)


def plain(name: str) -> str:
    """A row's name as a file may have it."""
    return "".join(letter if letter.isalnum() else "_" for letter in name)
