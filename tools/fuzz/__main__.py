"""Tries the readers with inputs that hypothesis makes and shrinks (Linux).

    .venv/bin/python -m tools.fuzz [--examples 1000] [--door NAME …] [--seed 1]

Each door runs in a process of its own that may take 1 GiB more memory; each input may compute for 5 s. What must hold:
a valid result or one sentence, the input unchanged, nothing new beside it, no file outside read, no host asked. Prints
what broke that, with the smallest input found (docs/development.md#how-semref-is-tested).
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[1]
# Only what is needed on the path: our processing/ must not come before QGIS's.
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != TOOLS.parent]
sys.path += [str(TOOLS.parent / "tests" / "data"), str(TOOLS)]

from qgis_session import load_plugin_package  # noqa: E402

load_plugin_package()

from fuzz import in_qgis, strangers  # noqa: E402
from fuzz.contract import ACCEPTED, REFUSED, Verdict, World, limit_memory, tried  # noqa: E402
from fuzz.doors import DOORS, FAULTY, Door  # noqa: E402

ALL = (*DOORS, *in_qgis.DOORS, *strangers.DOORS)
LONGEST_S = 3600
WORKPLACE = "/dev/shm" if os.path.isdir("/dev/shm") else None


class FoundError(Exception):
    """An input for which the contract does not hold."""


def search(door: Door, examples: int, seed: int, folder: Path) -> tuple[Counter, str]:
    """Tries a door in this process; gives outcomes, and what broke the contract with its smallest input."""
    from hypothesis import HealthCheck, Phase, given, settings, strategies
    from hypothesis import seed as seeded

    from semref.core.errors import SemRefError

    world, counts = World.made(folder / "world"), Counter()
    os.chdir(world.folder.parent)
    tempfile.tempdir = str(folder)
    make, attempt = door.prepare(world)
    world.forget()
    limit_memory()
    last: list[tuple[Verdict, object]] = []

    @settings(
        max_examples=examples,
        deadline=None,
        database=None,
        phases=(Phase.generate, Phase.shrink),
        suppress_health_check=list(HealthCheck),
    )
    @seeded(seed)
    @given(strategies.randoms(use_true_random=False))
    def holds(random: object) -> None:
        made = make(random)
        (folder / "current").write_bytes(repr(made).encode("utf-8", "replace")[:100_000])
        verdict = tried(attempt, made, world, (SemRefError,))
        counts[verdict.outcome] += 1
        if verdict.outcome not in (ACCEPTED, REFUSED):
            last[:] = [(verdict, made)]
            raise FoundError(verdict.where)

    try:
        holds()
    except BaseException as error:
        if not last:
            raise
        verdict, made = last[0]
        return counts, f"{verdict.outcome} {verdict.where}: {error}\n{repr(made)[:2000]}\n{verdict.details}"
    return counts, ""


def in_child(door: Door, examples: int, seed: int) -> tuple[Counter, str]:
    """Run the same in a separate process. A crash of this process counts as a fault."""
    with tempfile.TemporaryDirectory(prefix="semref-fuzz-", dir=WORKPLACE) as name:
        folder = Path(name)
        command = [sys.executable, "-m", "tools.fuzz", "--door", door.name, "--here", name]
        command += ["--examples", str(examples), "--seed", str(seed)]
        try:
            done = subprocess.run(
                command,
                cwd=TOOLS.parent,
                capture_output=True,
                text=True,
                errors="replace",
                timeout=LONGEST_S,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return Counter(died=1), f"hangs at {_current(folder)}"
        result = folder / "result.json"
        if not result.exists():
            return Counter(died=1), f"exit status {done.returncode} at {_current(folder)}\n{done.stderr[-3000:]}"
        counts, found = json.loads(result.read_text(encoding="utf-8"))
        return Counter(counts), found


def _current(folder: Path) -> str:
    path = folder / "current"
    return path.read_text(encoding="utf-8", errors="replace")[:2000] if path.exists() else "its start"


def main() -> int:
    """Runs it; 0 when the contract held for every input."""
    parser = argparse.ArgumentParser(prog="python -m tools.fuzz", description=__doc__.split("\n")[0])
    parser.add_argument("--examples", type=int, default=1000, help="of a door; slow ones take a share of it")
    parser.add_argument("--door", action="append", choices=[door.name for door in (*ALL, *FAULTY)])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--here", type=Path, help=argparse.SUPPRESS)
    options = parser.parse_args()
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    chosen = [door for door in (*ALL, *FAULTY) if door.name in (options.door or [one.name for one in ALL])]
    if options.here is not None:
        result = search(chosen[0], options.examples, options.seed, options.here)
        (options.here / "result.json").write_text(json.dumps(result), encoding="utf-8")
        os._exit(0)  # QGIS's own end is not what is tried here
    broken = 0
    for door in chosen:
        counts, found = in_child(door, max(5, round(options.examples * door.share)), options.seed)
        broken += sum(counts.values()) - counts[ACCEPTED] - counts[REFUSED]
        print(f"{door.name:16} {dict(counts)}\n{found}".strip(), flush=True)
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
