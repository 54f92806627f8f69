"""``python -m core localize`` and ``watch`` under faults: lines that were there stay, new ones are whole."""

from __future__ import annotations

import random
import shutil
import sys
from pathlib import Path
from typing import Any

from . import children
from .children import Ending, Kill
from .trials import Plan, Row
from .writers import runner

NAME = "python -m core localize, watch"
_OLDER = b'{"image": "older"}\n'


def row(provider: Any, folder: Path, plan: Plan) -> Row:
    """Injects kills and full disks into both commands."""
    at, out = folder / "inputs" / "new", folder / "out"
    runner(provider)("exportonboard", {"DATABASE": str(at / "area.gpkg"), "OUTPUT": str(folder / "area.npz")})
    found = Row(NAME)
    moments = random.Random(f"{plan.seed} core")
    for name, arguments in _commands(folder, at, out).items():
        sound = _Sound(name, arguments, out)
        for n in range(max(4, plan.kills // 2)):
            kill = Kill(byte=moments.randrange(1, sound.size))
            if n % 2:
                kill = Kill(after_s=moments.uniform(0, sound.ending.seconds[0]))
            ending = sound.run(kill=kill, with_older=n % 3 > 0)
            kind = "kills" if ending.how == "killed" else "kills missed"
            found.counts[kind] = found.counts.get(kind, 0) + 1
            sound.check(found, ending, f"{name}: {kill}", may_be_cut=kill.byte is not None)
        for _ in range(plan.disks):
            largest = moments.randrange(len(_OLDER), sound.size)
            ending = sound.run(largest=largest)
            found.counts["file limits"] = found.counts.get("file limits", 0) + 1
            sound.check(found, ending, f"{name}: {largest} bytes", may_be_cut=name == "localize")
            found.expect(ending.told == 3, f"{name}: {largest} bytes: exit code {ending.told}")
    return found


def _commands(folder: Path, at: Path, out: Path) -> dict[str, list[str]]:
    common = ["--database", str(folder / "area.npz"), "--method", "constellation"]
    sinks = ["--fixes", str(out / "fixes.lines"), "--gga", str(out / "gga.lines")]
    images = str(at / "images")
    return {"localize": ["localize", images, *common, "--json"], "watch": ["watch", images, *common, *sinks, "--once"]}


class _Sound:
    """One command, with what it writes when nothing happens."""

    def __init__(self, name: str, arguments: list[str], out: Path) -> None:
        self.name, self._arguments, self._out = name, arguments, out
        self.ending = self.run(with_older=False)
        self._lines = {path.name: path.read_bytes() for path in out.iterdir()}
        self.size = min(len(lines) for lines in self._lines.values() if lines)

    def run(self, kill: Kill | None = None, largest: int | None = None, with_older: bool = True) -> Ending:
        """Runs it over files with a line, or without."""
        shutil.rmtree(self._out, ignore_errors=True)
        self._out.mkdir()
        for name in ("stdout.lines", *(("fixes.lines", "gga.lines") if self.name == "watch" else ())):
            (self._out / name).write_bytes(_OLDER if with_older else b"")
        return children.run(self._main, self._out, kill, largest)

    def _main(self) -> int:
        from semref.core.onboard.command_line import main

        # Left open: what a full disk did not take is tried again when it is closed.
        sys.stdout = open(self._out / "stdout.lines", "a", encoding="utf-8")  # noqa: SIM115
        code = main(self._arguments)
        try:
            sys.stdout.flush()
        except OSError:
            # As core/__main__.py ends.
            return code or 3
        return code

    def check(self, row: Row, ending: Ending, what: str, may_be_cut: bool) -> None:
        """What was there stays; what was added are, in their order, lines of those that come when nothing happens.

        Where there is no room for a line a shorter one may still come after it.
        """
        row.expect(ending.how in ("done", "killed"), f"{what}: {ending.how}: {ending.text[-600:]}")
        for path in self._out.iterdir():
            wanted, found = self._lines[path.name], path.read_bytes()
            added = found[len(_OLDER) :] if found.startswith(_OLDER) else found
            left = iter(_lines(wanted))
            row.expect(all(line in left for line in _lines(added)), f"{what}: other lines in {path.name}")
            row.expect(may_be_cut or added in (b"", wanted) or added.endswith(b"\n"), f"{what}: {path.name} is cut")


def _lines(data: bytes) -> list[bytes]:
    """Whole lines, without what a clock says; a last one without its end is none."""
    return [line.split(b",", 2)[-1] if line.startswith(b"$") else line for line in data.split(b"\n")[:-1]]
