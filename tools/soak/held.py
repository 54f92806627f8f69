"""What a process holds, and whether that grew (Linux)."""

from __future__ import annotations

import os
from pathlib import Path
from typing import NamedTuple

MOST_GROWTH_MB = 8.0


class Held(NamedTuple):
    """What a process held when so many things were done."""

    done: int
    megabytes: float
    descriptors: int
    threads: int


def held(done: int, process_id: int) -> Held:
    """Reads it from /proc."""
    lines = Path(f"/proc/{process_id}/status").read_text(encoding="utf-8").splitlines()
    state = dict(line.split(":", 1) for line in lines if ":" in line)
    descriptors = len(os.listdir(f"/proc/{process_id}/fd"))
    return Held(done, int(state["VmRSS"].split()[0]) / 1024, descriptors, int(state["Threads"]))


def processor_s(process_id: int) -> float:
    """Seconds of the processor that a process has had, in steps of a hundredth; others on the machine don't count."""
    words = Path(f"/proc/{process_id}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")


def line(row: Held) -> str:
    """For printing."""
    return "done {:6d}  memory {:6.1f} MB  descriptors {:3d}  threads {:3d}".format(*row)


def verdict(rows: list[Held]) -> tuple[bool, str]:
    """Whether nothing grew after the first tenth (memory by no more than ``MOST_GROWTH_MB``), and that in words."""
    first, last = rows[0], rows[-1]
    growth = last.megabytes - first.megabytes
    more = [later - before for before, later in zip(first[2:], last[2:])]
    flat = growth <= MOST_GROWTH_MB and max(more) <= 0
    words = f"after the first tenth memory grew by {growth:.1f} MB, descriptors by {more[0]}, threads by {more[1]}"
    return flat, f"{words}: {'flat' if flat else 'not flat'}"
