"""Inputs in processes of their own, so that what crashes or hangs is told with its number."""

from __future__ import annotations

import json
import mmap
import os
import shutil
import signal
import struct
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from typing import Any, Callable

from .contract import ACCEPTED, REFUSED, Verdict, World, limit_memory, tried
from .door import Door

_HANG_S, _START_S = 60.0, 300.0
"""A process that is this long at one input, or at its start, is ended: no signal reaches what does not return."""

_WORKPLACE = "/dev/shm" if os.path.isdir("/dev/shm") else None


@dataclass
class Tally:
    """What became of a door's inputs.

    Attributes:
        outcomes: Inputs by outcome.
        finds: The first number of each find, by what it is, with what it told.
    """

    outcomes: Counter = field(default_factory=Counter)
    finds: dict[str, Any] = field(default_factory=dict)

    def add(self, number: int, verdict: Verdict) -> None:
        self.outcomes[verdict.outcome] += 1
        if verdict.outcome not in (ACCEPTED, REFUSED):
            self.finds.setdefault(f"{verdict.outcome} {verdict.where}", [number, verdict.told])

    def merge(self, other: Tally) -> None:
        self.outcomes.update(other.outcomes)
        for name, found in other.finds.items():
            self.finds.setdefault(name, found)

    @property
    def inputs(self) -> int:
        """How many were tried."""
        return sum(self.outcomes.values())

    @property
    def broken(self) -> int:
        """Inputs for which the contract did not hold."""
        return self.inputs - self.outcomes[ACCEPTED] - self.outcomes[REFUSED]


def random_of(seed: int, door: Door, number: int) -> Random:
    """The random that makes input ``number``: the same wherever and whenever."""
    return Random(f"{seed}:{door.name}:{number}")


def run_here(door: Door, seed: int, first: int, last: int, world: World, seen: Callable[[int], None]) -> Tally:
    """Tries inputs in this process; ``seen`` is told the number of each before it is tried."""
    from semref.core.errors import SemRefError

    tally = Tally()
    make, attempt = door.prepare(world)
    world.forget()
    limit_memory()
    for number in range(first, last):
        seen(number)
        tally.add(number, tried(attempt, make(random_of(seed, door, number)), world, (SemRefError,)))
    return tally


def run(door: Door, seed: int, count: int, first: int = 0, told: Callable[[str], None] = print) -> Tally:
    """Tries ``count`` inputs of a door, each batch in a process of its own."""
    whole, number, last = Tally(), first, first + count
    while number < last:
        end = min(number + door.batch, last)
        tally, reached, death = _batch(door, seed, number, end)
        if death:
            told(f"{door.name}: {death} at input {reached}")
            # What it had found went with it.
            tally = run(door, seed, reached - number, number, told) if reached > number else Tally()
            tally.add(reached, Verdict("Died", death, death))
        whole.merge(tally)
        number = reached + 1 if death else end
    return whole


def _batch(door: Door, seed: int, first: int, last: int) -> tuple[Tally, int, str]:
    """(what it found, the last number it came to, how it died or nothing)."""
    shared = mmap.mmap(-1, 8)
    shared[:] = struct.pack("q", first)
    folder = Path(tempfile.mkdtemp(prefix="semref-fuzz-", dir=_WORKPLACE))
    results = folder / "results"
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        _child(door, seed, first, last, folder, results, shared)
    try:
        death = _watched(child, shared)
        reached = struct.unpack("q", shared[:])[0]
        tally = Tally()
        for line in results.read_text(encoding="utf-8").splitlines() if results.exists() else ():
            outcomes, finds = json.loads(line)
            tally = Tally(Counter(outcomes), finds)
        if death and tally.finds:
            # It could still say why.
            death = "\n".join(text for _, text in tally.finds.values())
        return tally, reached, death
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _child(door: Door, seed: int, first: int, last: int, folder: Path, results: Path, shared: mmap.mmap) -> None:
    """Runs a batch and ends this process."""
    status = 1
    try:
        quiet = os.open(os.devnull, os.O_WRONLY)
        if not os.environ.get("SEMREF_FUZZ_LOUD"):
            os.dup2(quiet, 1)
            os.dup2(quiet, 2)
        world = World.made(folder / "world")
        os.chdir(world.folder.parent)
        # Whatever is made elsewhere goes with the batch's folder.
        tempfile.tempdir = str(folder)

        def seen(number: int) -> None:
            shared[:] = struct.pack("q", number)

        tally = run_here(door, seed, first, last, world, seen)
        results.write_text(json.dumps([tally.outcomes, tally.finds]), encoding="utf-8")
        status = 0
    except BaseException as error:
        import traceback

        text = "".join(traceback.format_exception(error))
        tally = Tally(Counter(), {f"Harness {type(error).__name__}": [first, text]})
        results.write_text(json.dumps([tally.outcomes, tally.finds]), encoding="utf-8")
    finally:
        os._exit(status)


def _watched(child: int, shared: mmap.mmap) -> str:
    """Waits for a process; gives how it died, nothing where it ended well."""
    at, since, patience = None, time.monotonic(), _START_S
    while True:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            number: int | None = -os.waitstatus_to_exitcode(status)
            return f"signal {signal.Signals(number).name}" if number and number > 0 else ("exit" if number else "")
        now = struct.unpack("q", shared[:])[0]
        if now != at:
            patience = _START_S if at is None else _HANG_S
            at, since = now, time.monotonic()
        elif time.monotonic() - since > patience:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            return "hang"
        time.sleep(0.02)
