"""Tries the doors with many inputs (Linux).

    .venv/bin/python -m tools.fuzz [--inputs 1000000] [--door NAME …] [--seed 1] [--finds FOLDER] [--write]

The million is dealt out to the doors as they need it; --door takes some only (each --inputs of its own then). Input N
of a door is the same wherever and whenever it is made: `--door NAME --first N --inputs 1` tries it again. What breaks
the contract is printed with its first input, and told in whole in FOLDER. --write puts the table into
docs/reliability.md.
"""

from __future__ import annotations

import argparse
import datetime
import json
import os
import sys
import time
from collections import Counter
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[1]
# Only what is needed on the path: our processing/ must not come before QGIS's.
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != TOOLS.parent]
sys.path += [str(TOOLS.parent / "tests" / "data"), str(TOOLS)]

from qgis_session import load_plugin_package  # noqa: E402

load_plugin_package()

from benchmarks import results  # noqa: E402
from fuzz.contract import ACCEPTED, REFUSED  # noqa: E402
from fuzz.door import Door  # noqa: E402
from fuzz.doors.all import DOORS  # noqa: E402
from fuzz.runner import Tally, run  # noqa: E402

_MILLION = 1_000_000


_ROUNDS = 10
"""Every door gets a tenth of its inputs before the first gets its second: a run that is ended has seen all doors."""


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m tools.fuzz", description=__doc__.split("\n")[0])
    parser.add_argument("--inputs", type=int, default=_MILLION)
    parser.add_argument("--door", action="append", choices=[door.name for door in DOORS])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--finds", type=Path, help="folder for what was found")
    parser.add_argument("--results", type=Path, help="JSON that keeps the numbers; a later run goes on where it ended")
    parser.add_argument("--write", action="store_true", help="put the table of --results into docs/reliability.md")
    return parser.parse_args()


def _tell(door: Door, tally: Tally, now: int, seconds: float, finds: Path | None) -> None:
    print(
        f"{door.name:18} inputs {tally.inputs:7d}  refused {tally.outcomes[REFUSED]:7d}  accepted "
        f"{tally.outcomes[ACCEPTED]:7d}  broken {tally.broken:6d}  {now / max(seconds, 1e-9):7.0f}/s",
        flush=True,
    )
    for name, (number, told) in sorted(tally.finds.items(), key=lambda item: item[1][0]):
        print(f"    {name}  (input {number})", flush=True)
        if finds is not None:
            finds.mkdir(parents=True, exist_ok=True)
            kept = "".join(sign if sign.isalnum() else "_" for sign in name)[:100]
            text = f"{door.name} {number}\n{told}"
            (finds / f"{door.name}_{kept}.txt").write_text(text, encoding="utf-8", errors="replace")


def _kept(path: Path | None) -> dict[str, Tally]:
    """What earlier runs found, by door."""
    if path is None or not path.exists():
        return {}
    stored = json.loads(path.read_text(encoding="utf-8"))
    return {name: Tally(Counter(outcomes), finds) for name, (outcomes, finds) in stored.items()}


def _keep(path: Path | None, tallies: dict[str, Tally]) -> None:
    if path is not None:
        stored = {name: (tally.outcomes, tally.finds) for name, tally in tallies.items()}
        path.write_text(json.dumps(stored, indent=1), encoding="utf-8")


def _write(tallies: dict[str, Tally], inputs: int, seed: int) -> None:
    """Puts the table into docs/reliability.md."""
    rows = []
    for door in DOORS:
        tally = tallies.get(door.name, Tally())
        rows.append((door.title, tally.inputs, tally.outcomes[REFUSED], tally.outcomes[ACCEPTED], tally.broken))
    rows.append(("**all**", *(sum(row[n] for row in rows) for n in range(1, 5))))
    shown = [(title, *(f"{number:,}" for number in numbers)) for title, *numbers in rows]
    body = results.markdown(("door", "inputs", "refused", "accepted", "contract broken"), shown)
    today, command = (
        datetime.date.today().isoformat(),
        f".venv/bin/python -m tools.fuzz --inputs {inputs} --seed {seed}",
    )
    note = f"*`{command}` on {today}, {results.revision()}. {results.hardware()}; {results.versions()}.*"
    results.write_section(TOOLS.parent / "docs" / "reliability.md", "fuzz", f"{body}\n\n{note}")


def main() -> int:
    """Runs it; 0 when the contract held for every input."""
    options = _options()
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    tallies = _kept(options.results)
    if options.write:
        _write(tallies, options.inputs, options.seed)
        return 0
    chosen = [door for door in DOORS if not options.door or door.name in options.door]
    rounds = 1 if options.door or options.inputs < _MILLION // 10 else _ROUNDS
    for turn in range(1, rounds + 1):
        for door in chosen:
            wanted = options.inputs if options.door else max(1, door.inputs * options.inputs // _MILLION)
            before = tallies.setdefault(door.name, Tally())
            first, last = options.first + before.inputs, options.first + wanted * turn // rounds
            if last > first:
                started = time.perf_counter()
                before.merge(run(door, options.seed, last - first, first))
                _tell(door, before, last - first, time.perf_counter() - started, options.finds)
                _keep(options.results, tallies)
    return 1 if any(tally.broken or tally.finds for tally in tallies.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
