"""Messages gathered into telemetry."""

import numpy as np

from semref.core.flight.logs.entries import Entries


def test_entries_come_in_order_of_time_and_in_utc_where_it_is_told():
    entries = Entries()
    entries.add(2.0, heading=20)
    entries.add(1.0, height=5)
    log = entries.telemetry()
    assert (log.times_s.tolist(), log.is_clock) == ([1.0, 2.0], False)
    assert log.values[1, 0] == 20 and np.isnan(log.values[0, 0])
    entries.start_s = 1e9
    assert (entries.telemetry().times_s.tolist(), entries.telemetry().is_clock) == ([1e9 + 1, 1e9 + 2], True)


def test_no_entries_are_no_error():
    assert len(Entries().telemetry().times_s) == 0
