"""What the commands share: who is told, and files that are read."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime, timezone
from pathlib import Path
from typing import Protocol

from ..core.errors import ParameterError
from ..storage.file_states import state


class Teller(Protocol):
    """Takes what is being done."""

    def step(self, text: str, share: float) -> None:
        """What is being done, and how much of all is (0…1)."""

    def say(self, text: str) -> None:
        """Anything else worth a line."""


def seen_by_workers(path: str) -> str:
    """A path that means the same elsewhere; names of GDAL's stay as they are."""
    return path if path.startswith("/vsi") else str(Path(path).absolute())


def plain(number: float) -> str:
    """A number as an option takes it, with all the digits that somebody may have given."""
    return f"{number:.15g}"


def require_apart(path: str, output: str) -> None:
    """Raises ParameterError where a file would be replaced by what is made of it."""
    if Path(path).exists() and Path(output).exists() and Path(path).samefile(output):
        raise ParameterError("cluster.output_is_input", path=path)


def moment_of(found: tuple[int, float]) -> str:
    """When a file of that state was changed last, as a GeoPackage has it: what is made of it is dated so."""
    return datetime.fromtimestamp(found[1], timezone.utc).strftime("%Y-%m-%dT%H:%M:%S.000Z")


def require_unchanged(before: Mapping[str, tuple[int, float]]) -> None:
    """Raises ParameterError where a file is another one than when ``state`` told that of it."""
    for path, then in before.items():
        if state(path) != then:
            raise ParameterError("cluster.map_changed", path=path)
