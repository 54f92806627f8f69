"""Collect the messages of binary logs into a ``Telemetry``."""

from __future__ import annotations

import math
import mmap
from array import array
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Callable, Union

import numpy as np

from ... import limits
from ..telemetry import FIELDS, Telemetry, telemetry

Data = Union[bytes, mmap.mmap]
"""Content of a log; a mapped file needs no memory."""

GPS_EPOCH_S = 315_964_800
LEAP_SECONDS = 18
"""Seconds by which GPS time is ahead of UTC since 2017."""


LOOK_EVERY = 1 << 16
"""Bytes or lines of a log between two checks for a cancel."""


def never() -> bool:
    """Return False, for a caller that does not cancel."""
    return False


@dataclass
class Pace:
    """Checks from time to time whether the user canceled.

    Attributes:
        canceled: Returns True once the user canceled.
    """

    canceled: Callable[[], bool]
    _next: int = 0

    def stops_at(self, place: int) -> bool:
        """Return whether reading ends early at a place, counted in bytes or lines."""
        if place < self._next:
            return False
        self._next = place + LOOK_EVERY
        return self.canceled()


@dataclass
class _Kind:
    """Entries with the same fields, one for each ``stride`` messages.

    Attributes:
        numbers: Time and values, one entry after the other.
        stride: Messages for each entry.
        seen: Messages so far.
    """

    numbers: array[float] = field(default_factory=lambda: array("d"))
    stride: int = 1
    seen: int = 0

    def add(self, row: list[float]) -> None:
        if self.seen % self.stride == 0:
            if len(self.numbers) >= limits.LOG_ENTRIES * len(row):
                thinned = np.array(self.numbers).reshape(-1, len(row))[::2]
                self.numbers = array("d", thinned.tobytes())
                self.stride *= 2
            if self.seen % self.stride == 0:
                self.numbers.extend(row)
        self.seen += 1


@dataclass
class Entries:
    """Collects entries; their number does not grow with the log.

    Attributes:
        start_s: UTC of the log's zero; None if unknown.
    """

    start_s: float | None = None
    _kinds: dict[tuple[str, ...], _Kind] = field(default_factory=dict)

    def add(self, time_s: float, **values: float) -> None:
        """Add a message: its values by FIELDS."""
        self._kinds.setdefault(tuple(values), _Kind()).add([time_s, *values.values()])

    def telemetry(self, is_gimbal: bool = False) -> Telemetry:
        """Return all entries, in UTC if it is known; ``is_gimbal`` as of ``Telemetry``."""
        tables = list(self._tables())
        values = np.concatenate([values for _, values in tables]) if tables else np.zeros((0, len(FIELDS)))
        times = np.concatenate([times for times, _ in tables]) if tables else np.zeros(0)
        return telemetry(times + (self.start_s or 0.0), values, is_clock=self.start_s is not None, is_gimbal=is_gimbal)

    def _tables(self) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Yield times (n,) and values (n, 6) of each kind."""
        for names, kind in self._kinds.items():
            rows = np.array(kind.numbers).reshape(-1, 1 + len(names))
            values = np.full((len(rows), len(FIELDS)), math.nan)
            for column, name in enumerate(names, 1):
                values[:, FIELDS.index(name)] = rows[:, column]
            yield rows[:, 0], values
