"""Puts small faults into modules and tells which of them their own tests do not notice (Linux).

    python -m tools.mutation [--sample 40] [--only NAME] [--write]

A seeded sample of the mutants of each module is tried: comparisons and their limits, arithmetic, constants ±1, negated
conditions, statements and values left out, swapped arguments. Each is tried by the module's mirror tests only, without
the slow ones, until the first one fails. Those that change nothing that anybody could see stand in equivalent.txt.
What is left over is listed. With --write the table in docs/reliability.md is made anew.

mutmut and cosmic-ray were not taken: both want a package that is imported by its folder's name, which ours is not, and
start Python and its libraries again for each mutant.
"""

from __future__ import annotations

import argparse
import os
import random
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from . import engine
from .groups import GROUPS, Group
from .operators import Mutant, mutants_of

ROOT = Path(__file__).resolve().parents[2]
# Only what is needed on the path: our processing/ must not come before QGIS's.
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != ROOT]

PAGE = ROOT / "docs" / "reliability.md"
MARKS = "<!-- mutation: begin -->", "<!-- mutation: end -->"
EQUIVALENT = Path(__file__).with_name("equivalent.txt")
SEED = 13


@dataclass
class Score:
    """What came of a group's mutants.

    Attributes:
        possible: All that there are.
        tried: Of these.
        killed: Noticed by a test.
        equivalent: Not noticed, and found to change nothing that could be.
        left: Names of the others.
    """

    possible: int = 0
    tried: int = 0
    killed: int = 0
    equivalent: int = 0
    left: list[str] = field(default_factory=list)


def known_equivalents() -> set[str]:
    """Names of mutants that were looked at and change nothing."""
    lines = EQUIVALENT.read_text(encoding="utf-8").splitlines() if EQUIVALENT.exists() else []
    return {line.strip() for line in lines if line.strip() and not line.startswith("#")}


def tried(mutants: list[Mutant], count: int, path: str) -> list[Mutant]:
    """The same ones each time, in the order of the source."""
    if len(mutants) <= count:
        return mutants
    chosen = random.Random(f"{SEED} {path}").sample(range(len(mutants)), count)
    return [mutants[number] for number in sorted(chosen)]


def judge(group: Group, count: int, log: Path) -> Score:
    """Tries the mutants of a group's modules."""
    score, equivalent = Score(), known_equivalents()
    engine.load(group.libraries)
    for path, files in group.modules:
        tests = [*files, *group.selection]
        # The second time everything is in the caches.
        for _ in range(2):
            status, seconds = engine.run(tests, ROOT / path, None, None, log)
        if status:
            raise SystemExit(f"{' '.join(files)} fails without any mutant:\n{log.read_text(errors='replace')}")
        mutants = mutants_of((ROOT / path).read_text(encoding="utf-8"))
        chosen, before = tried(mutants, count, path), len(score.left)
        for mutant in chosen:
            status, _ = engine.run(tests, ROOT / path, mutant, engine.patience(seconds), log)
            score.killed += bool(status)
            if not status and f"{path} {mutant.key}" in equivalent:
                score.equivalent += 1
            elif not status:
                score.left.append(f"{path} {mutant.key}")
                print(f"  left {path}:{mutant.line} {mutant.key}", flush=True)
        score.possible += len(mutants)
        score.tried += len(chosen)
        print(f"{path}: {len(chosen)} of {len(mutants)}, {len(score.left) - before} left, {seconds:.1f} s", flush=True)
    return score


def table(scores: dict[str, Score]) -> str:
    """Rows by group, as the page has them."""
    rows = ["| modules | mutants | tried | killed | change nothing | left |", "|---|---|---|---|---|---|"]
    for name, one in scores.items():
        rows.append(f"| {name} | {one.possible} | {one.tried} | {one.killed} | {one.equivalent} | {len(one.left)} |")
    sums = [
        sum(values)
        for values in zip(*((s.possible, s.tried, s.killed, s.equivalent, len(s.left)) for s in scores.values()))
    ]
    rows.append(f"| all | {' | '.join(map(str, sums))} |")
    return "\n".join(rows)


def write(text: str) -> None:
    """Puts the table between its marks."""
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(MARKS[0])
    after = rest.split(MARKS[1])[1]
    PAGE.write_text(f"{before}{MARKS[0]}\n{text}\n{MARKS[1]}{after}", encoding="utf-8")


def main() -> int:
    """Runs it; 0 when nothing is left."""
    parser = argparse.ArgumentParser(prog="python -m tools.mutation", description=__doc__.split("\n")[0])
    parser.add_argument("--sample", type=int, default=40, help="mutants of each module (default: 40)")
    parser.add_argument("--only", help="the group of this name")
    parser.add_argument("--write", action="store_true", help="put the table into docs/reliability.md")
    options = parser.parse_args()
    groups = [group for group in GROUPS if options.only in (None, group.name)]
    os.chdir(ROOT)
    with tempfile.TemporaryDirectory() as folder:
        scores = {group.name: judge(group, options.sample, Path(folder, "log")) for group in groups}
    print(table(scores))
    if options.write and not options.only:
        write(table(scores))
    return int(any(score.left for score in scores.values()))


if __name__ == "__main__":
    sys.exit(main())
