"""The faults that are injected into one writer, and what must hold after each."""

from __future__ import annotations

import contextlib
import random
import shutil
import sqlite3
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from . import children, disks
from .cases import Writer
from .children import Ending, Kill
from .content import State, digest, state, strays
from .writers import lay_out

SLOW_S = 2.0
"""A writer that takes longer gets a third of the faults."""


@dataclass(frozen=True)
class Plan:
    """How many of the faults that have a number of their own; the seed tells at which moments."""

    kills: int
    disks: int
    most_steps: int
    seed: int

    def of(self, count: int, writer: Writer) -> int:
        """Fewer for a slow writer."""
        return max(2, count // 3) if writer.seconds > SLOW_S else count


@dataclass
class Row:
    """What came of one writer.

    Attributes:
        name: The writer.
        counts: Faults by kind.
        mixed: Kills after which some outputs were new and some old.
        finds: What did not hold, in words.
        skipped: Kinds that can't be had here.
    """

    name: str
    counts: dict[str, int] = field(default_factory=dict)
    mixed: int = 0
    finds: list[str] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)

    def line(self) -> str:
        """For the terminal."""
        counts = ", ".join(f"{kind} {count}" for kind, count in self.counts.items())
        return f"{self.name}: {counts}; mixed {self.mixed}; finds {len(self.finds)}; no {self.skipped}"

    def cell(self, kind: str) -> str:
        """For the table."""
        return "not here" if kind in self.skipped else str(self.counts.get(kind, ""))

    def expect(self, holds: bool, what: str) -> None:
        """Keeps what does not hold."""
        if not holds:
            self.finds.append(what)


@dataclass(frozen=True)
class _Trials:
    """One writer under faults."""

    writer: Writer
    row: Row
    out: Path
    plan: Plan
    random: random.Random

    def count(self, kind: str) -> None:
        self.row.counts[kind] = self.row.counts.get(kind, 0) + 1

    def check(
        self, ending: Ending, older: State, what: str, newer: State | None = None, left: Sequence[str] = ()
    ) -> None:
        """What must hold after anything; ``left``: what a killed run has left there before."""
        newer = self.writer.new if newer is None else newer
        expect = self.row.expect
        expect(ending.how not in ("fault", "hangs"), f"{what}: {ending.how}: {ending.text[-600:]}")
        if ending.how in ("done", "refused"):
            stays = sorted({*strays(self.out)} - {*left})
            expect(not stays, f"{what}: {ending.how}, and {stays} stays")
        try:
            found = self._check_each(older, newer, what)
        except (sqlite3.Error, OSError) as error:
            self.row.finds.append(f"{what}: {error}")
            return
        if ending.how == "done" or (ending.how == "refused" and self.writer.is_one_run):
            wanted = newer if ending.how == "done" else older
            expect(found == wanted, f"{what}: {ending.how}, but {_told(found, older, newer)}")

    def _check_each(self, older: State, newer: State, what: str) -> State:
        """Right after the end each file is whole, one of the two; counts runs whose outputs differ in age."""
        found = state(self.out)
        for path, content in found.items():
            self.row.expect(content in (older.get(path), newer.get(path)), f"{what}: {path} is neither old nor new")
        if self.writer.is_one_run and found not in (older, newer):
            self.row.mixed += 1
        return found

    def lay_out(self, with_older: bool) -> State:
        lay_out(self.writer, self.out, with_older)
        return state(self.out)

    def new(self, feedback: Any = None) -> None:
        self.writer.run("new", self.out, feedback)

    def kills(self) -> None:
        for n in range(self.plan.of(self.plan.kills, self.writer)):
            kill = (
                Kill(touch=self.random.randrange(self.writer.touches)),
                Kill(byte=int(self.writer.largest * self.random.random() ** 2)),
                Kill(after_s=self.random.uniform(0, 1.1) * self.writer.seconds),
                Kill(touch=self.writer.touches - 1 - self.random.randrange(min(40, self.writer.touches))),
            )[n % 4]
            older = self.lay_out(with_older=n % 3 > 0)
            ending = children.run(self.new, self.out, kill)
            self.count("kills" if ending.how == "killed" else "kills missed")
            self.check(ending, older, f"{kill}")
            if n % 6 == 0:
                older, left = state(self.out), strays(self.out)
                self.check(children.run(self.new, self.out), older, f"the run after {kill}", left=left)

    def full_disks(self) -> None:
        for n in range(self.plan.of(self.plan.disks, self.writer)):
            share = self.random.uniform(0.02, 1.1)
            try:
                self._full_disk(share)
            except OSError:
                self.row.skipped.append("full disks")
                return
            older = self.lay_out(with_older=n % 2 == 0)
            largest = int(self.writer.largest * self.random.uniform(0.0, 1.0))
            self.count("file limits")
            self.check(children.run(self.new, self.out, largest=largest), older, f"files of {largest} bytes")

    def _full_disk(self, share: float) -> None:
        # Kept apart: a file of the older outputs takes whole pages.
        kept = sum(path.stat().st_size // 4096 + 2 for path in self.writer.before.rglob("*")) * 4
        with disks.disk(self.out, kept + int(share * self.writer.needed / 1024)):
            for path in self.writer.before.iterdir():
                (shutil.copytree if path.is_dir() else shutil.copy2)(path, self.out / path.name)
            self.count("full disks")
            self.check(children.run(self.new, self.out), state(self.out), f"a disk with {share:.2f} of the room")

    def read_only(self) -> None:
        try:
            with disks.disk(self.out, 64 << 10):
                for path in self.writer.before.iterdir():
                    (shutil.copytree if path.is_dir() else shutil.copy2)(path, self.out / path.name)
                disks.make_read_only(self.out)
                self.count("read-only")
                ending = children.run(self.new, self.out)
                self.row.expect(ending.how == "refused", f"read-only: {ending.how}")
                self.check(ending, self.writer.old, "read-only")
        except OSError:
            self.row.skipped.append("read-only")

    def two_writers(self) -> None:
        for n in range(3):
            older = self.lay_out(with_older=True)
            both = [children.start(self.new, self.out), children.start(lambda: self._late(n), self.out)]
            endings = [children.wait(*child, self.out) for child in both]
            self.count("two writers")
            for ending in endings:
                self.row.expect(ending.how in ("done", "refused"), f"two writers: {ending.how}: {ending.text[-600:]}")
            found = state(self.out)
            possible = [older] if all(ending.how == "refused" for ending in endings) else []
            possible += [self.writer.new] if endings[0].how == "done" else []
            possible += [self.writer.second] if endings[1].how == "done" else []
            for path, content in found.items():
                # Each output is that of one of the two; of several outputs the last may not be the same run's.
                is_whole = not self.writer.is_one_run or content in [one.get(path) for one in possible]
                self.row.expect(is_whole, f"two writers: {path}: {_told(found, self.writer.second, self.writer.new)}")
            self.row.expect(not strays(self.out), f"two writers: {strays(self.out)} stays")

    def _late(self, n: int) -> None:
        import time

        time.sleep(0.05 * n * self.writer.seconds)
        self.writer.run("new" if " in place" in self.writer.name else "old", self.out)

    def locked_reader(self) -> None:
        """Somebody reads the older outputs: theirs stays whole while the new ones come."""
        older = self.lay_out(with_older=True)
        with contextlib.ExitStack() as stack:
            rows = {}
            for path in self.out.rglob("*.gpkg"):
                connection = stack.enter_context(contextlib.closing(sqlite3.connect(path, isolation_level=None)))
                connection.execute("BEGIN")
                rows[connection] = connection.execute("SELECT * FROM gpkg_contents").fetchall()
            ending = children.run(self.new, self.out)
            self.count("read meanwhile")
            for connection, before in rows.items():
                still = connection.execute("SELECT * FROM gpkg_contents").fetchall()
                self.row.expect(still == before, "read meanwhile: what is read changed")
        self.row.expect(ending.how == "done", f"read meanwhile: {ending.how}: {ending.text[-600:]}")
        self.check(ending, older, "read meanwhile")

    def locked_inputs(self) -> None:
        """Another program writes to the inputs just now."""
        inputs = self.out.parent / "inputs" / "new"
        older = self.lay_out(with_older=True)
        paths = [*inputs.rglob("*.gpkg"), *(self.out.rglob("area.gpkg") if " in place" in self.writer.name else ())]
        with contextlib.ExitStack() as stack:
            for path in paths:
                connection = stack.enter_context(contextlib.closing(sqlite3.connect(path, isolation_level=None)))
                connection.execute("BEGIN EXCLUSIVE")
            ending = children.run(self.new, self.out)
        self.count("locked inputs")
        self.check(ending, older, "locked inputs")

    def vanished_folder(self) -> None:
        if not self.writer.steps:
            # Told by no step when it is.
            return
        for instead, at in ((False, 0.3), (True, 0.6), (False, 1.0)):
            self.lay_out(with_older=True)
            ending = children.run(lambda: self.new(self._at_step(at, lambda: self._vanish(instead))), self.out)
            self.count("vanished folders")
            # A model tells its last step when all has been moved.
            is_late = not self.writer.is_one_run and ending.how == "done" and at == 1.0
            told = f"the folder goes at {at}: {ending.how}: {ending.text[-900:]}"
            self.row.expect(ending.how == "refused" or is_late, told)
            self.out.unlink() if self.out.is_file() else None

    def _vanish(self, instead: bool) -> None:
        shutil.rmtree(self.out)
        if instead:
            self.out.write_bytes(b"")

    def _at_step(self, share: float, then: Callable[[], None]) -> Any:
        from qgis.core import QgsProcessingFeedback

        feedback, count = QgsProcessingFeedback(False), [0]
        wanted = max(1, round(share * self.writer.steps))

        def look(_: float) -> None:
            count[0] += 1
            if count[0] == wanted:
                then()

        feedback.progressChanged.connect(look)
        return feedback

    def cancels(self) -> None:
        steps = self.writer.steps
        most = min(steps, self.plan.of(self.plan.most_steps, self.writer))
        for step in sorted(self.random.sample(range(1, steps + 1), most)):
            older = self.lay_out(with_older=step % 3 > 0)

            def canceled(step: int = step) -> None:
                feedback = self._at_step(step / steps, lambda: feedback.cancel())
                self.new(feedback)

            ending = children.run(canceled, self.out)
            if not self.writer.is_one_run and ending.how == "done":
                # QGIS ends a canceled model after the step that it was in, without an error.
                ending = Ending("killed")
            self.count("cancels")
            self.check(ending, older, f"cancel at step {step} of {steps}")


def all_of(writer: Writer, folder: Path, plan: Plan) -> Row:
    """Injects everything into one writer."""
    row = Row(writer.name)
    trials = _Trials(writer, row, folder / "out", plan, random.Random(f"{plan.seed} {writer.name}"))
    inputs = {path: digest(path) for path in (folder / "inputs").rglob("*") if path.is_file()}
    for inject in (
        trials.kills,
        trials.full_disks,
        trials.read_only,
        trials.two_writers,
        trials.locked_reader,
        trials.locked_inputs,
        trials.vanished_folder,
        trials.cancels,
    ):
        inject()
        for path, before in inputs.items():
            row.expect(path.is_file() and digest(path) == before, f"{inject.__name__}: the input {path.name} changed")
        row.expect(not strays(folder / "inputs"), f"{inject.__name__}: {strays(folder / 'inputs')} beside inputs")
    return row


def _told(found: State, old: State, new: State) -> str:
    """What is old, what is new and what is neither, in words."""
    kinds: dict[str, list[str]] = {}
    for path in sorted({*found, *old, *new}):
        content = found.get(path)
        kind = "same" if old.get(path) == new.get(path) == content else "old" if content == old.get(path) else "neither"
        kinds.setdefault("new" if kind == "neither" and content == new.get(path) else kind, []).append(path)
    return "; ".join(f"{kind}: {', '.join(paths[:4])}" for kind, paths in kinds.items() if kind != "same")
