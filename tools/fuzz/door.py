"""What a door is."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any, Callable

from .contract import World, require

Tools = tuple[Callable[[Random], Any], Callable[[Any], Any]]
"""Makes an input; gives it to the door, and looks at what comes out."""


@dataclass(frozen=True)
class Door:
    """A way in.

    Attributes:
        name: For the command line.
        title: What comes in, for the table.
        prepare: Makes, once a process, what makes inputs and what tries them.
        inputs: How many of a million it gets.
        batch: Inputs a process.
    """

    name: str
    title: str
    prepare: Callable[[World], Tools]
    inputs: int
    batch: int = 20_000


class Placed:
    """Bytes that lie in a file while a door reads them, and are the same afterwards."""

    def __init__(self, folder: Path, name: str) -> None:
        self.path = os.path.join(folder, name)
        self._data = b""

    def __call__(self, data: bytes) -> Placed:
        self._data = data
        return self

    def __enter__(self) -> str:
        with open(self.path, "wb") as file:
            file.write(self._data)
        return self.path

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        try:
            with open(self.path, "rb") as file:
                same = file.read() == self._data
        except OSError:
            same = False
        finally:
            if os.path.lexists(self.path):
                os.unlink(self.path)
        if not same:
            require(same, "the input was changed")
