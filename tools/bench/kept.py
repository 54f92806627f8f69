"""Results kept in the work folder, of one state of the code: a later run goes on, and runs of some rows are joined."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from bench import inputs, machine


def parts(count: int, size: int) -> list[int]:
    """Images of each part of `count`."""
    return [min(size, count - first) for first in range(0, count, size)]


def part(run: inputs.Run, table: str, name: str, number: int, size: int, measured: Callable[[int, int], Any]) -> Any:
    """What a part of a row came to, as JSON has it; measured unless this state of the code has done so.

    Args:
        run: whose work folder keeps it
        table: name of the folder
        name: of the row
        number: of the part; has its own seed
        size: images in it
        measured: number and size of a part → what JSON can hold; called where nothing is kept
    """
    folder = run.work / table
    folder.mkdir(exist_ok=True)
    state = machine.revision().replace(" ", "_")
    path = folder / f"{plain(name)}_{number}_{size}_{run.half}_{state}.json"
    if not path.exists():
        path.write_text(json.dumps(measured(number, size)), encoding="utf-8")
    return json.loads(path.read_text("utf-8"))


def row(
    run: inputs.Run, table: str, name: str, sizes: Sequence[int], measured: Callable[[int, int], list]
) -> Iterator[Any]:
    """What all parts of a row hold, one after the other."""
    for number, size in enumerate(sizes):
        yield from part(run, table, name, number, size, measured)


def plain(name: str) -> str:
    """A row's name as a file may have it."""
    return "".join(letter if letter.isalnum() else "_" for letter in name)
