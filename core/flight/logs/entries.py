"""What binary logs tell one message after the other, gathered into a ``Telemetry``."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from ..telemetry import FIELDS, Telemetry, telemetry

GPS_EPOCH_S = 315_964_800
LEAP_SECONDS = 18
"""From 2017 on; GPS's clock is ahead of UTC by so much."""


@dataclass
class Entries:
    """Gathers entries.

    Attributes:
        times_s: On the log's own clock.
        rows: As FIELDS say.
        start_s: UTC of the log's zero; None where nothing told it.
    """

    times_s: list[float] = field(default_factory=list)
    rows: list[list[float]] = field(default_factory=list)
    start_s: float | None = None

    def add(self, time_s: float, **told: float) -> None:
        """One message: what it tells, by FIELDS."""
        self.times_s.append(time_s)
        self.rows.append([float(told.get(name, math.nan)) for name in FIELDS])

    def telemetry(self) -> Telemetry:
        """All of them, in UTC where the log tells it."""
        times = [time + (self.start_s or 0.0) for time in self.times_s]
        return telemetry(times, self.rows, is_clock=self.start_s is not None)
