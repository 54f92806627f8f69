"""Puts small faults into modules and tells which of them their own tests do not notice (Linux).

    python -m tools.mutation [--sample 24] [--only core/onboard] [--write]

A seeded sample of the mutants of each module is tried: comparisons and their limits, arithmetic, constants ±1, negated
conditions, statements and values left out, swapped arguments. Each is tried by the module's mirror tests only, without
the slow ones, until the first one fails. Those that change nothing that anybody could see stand in equivalent.txt.
What is left over is listed. With --write the rows of these modules in docs/reliability.md are made anew.

mutmut and cosmic-ray were not taken: both want a package that is imported by its folder's name, which ours is not, and
start Python and its libraries again for each mutant.
"""

from __future__ import annotations

import argparse
import os
import random
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from . import engine
from .modules import MODULES, Module
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
    """What came of a module's mutants.

    Attributes:
        possible: All that there are.
        tried: Of these.
        killed: Noticed by a test.
        equivalent: Not noticed, and found to change nothing that could be.
        left: The others.
    """

    possible: int = 0
    tried: int = 0
    killed: int = 0
    equivalent: int = 0
    left: int = 0

    def counts(self) -> tuple[int, ...]:
        """All of them, as the table has them."""
        return self.possible, self.tried, self.killed, self.equivalent, self.left


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


def judge(module: Module, count: int, log: Path) -> Score:
    """Tries a sample of a module's mutants."""
    score, equivalent, path = Score(), known_equivalents(), ROOT / module.path
    engine.load(module.libraries)
    tests = [*module.tests, "-m", "not slow"]
    # The second time everything is in the caches.
    for _ in range(2):
        status, seconds = engine.run(tests, path, None, None, log)
    if status:
        raise SystemExit(f"{' '.join(tests)} fails without any mutant:\n{log.read_text(errors='replace')}")
    mutants = mutants_of(path.read_text(encoding="utf-8"))
    score.possible = len(mutants)
    for mutant in tried(mutants, count, module.path):
        status, _ = engine.run(tests, path, mutant, engine.patience(seconds), log)
        score.tried += 1
        score.killed += bool(status)
        if not status and f"{module.path} {mutant.key}" in equivalent:
            score.equivalent += 1
        elif not status:
            score.left += 1
            print(f"  left, line {mutant.line}: {module.path} {mutant.key}", flush=True)
    print(f"{row(module.path, score)} {seconds:.1f} s a run", flush=True)
    return score


def row(path: str, score: Score) -> str:
    """A line of the table."""
    return f"| `{path}` | {' | '.join(map(str, score.counts()))} |"


def table(rows: dict[str, Score]) -> str:
    """Modules in the order of MODULES, and their sums."""
    lines = ["| module | mutants | tried | killed | change nothing | left |", "|---|---|---|---|---|---|"]
    lines += [row(module.path, rows[module.path]) for module in MODULES if module.path in rows]
    sums = (str(sum(column)) for column in zip(*(one.counts() for one in rows.values())))
    return "\n".join([*lines, f"| all | {' | '.join(sums)} |"])


def written(page: str) -> dict[str, Score]:
    """The rows that the page has."""
    cells = (line.strip("| ").split(" | ") for line in page.splitlines() if line.startswith("| `"))
    return {name.strip("`"): Score(*map(int, counts)) for name, *counts in cells}


def write(scores: dict[str, Score]) -> None:
    """Puts the rows in the place of theirs on the page."""
    before, rest = PAGE.read_text(encoding="utf-8").split(MARKS[0])
    old, after = rest.split(MARKS[1])
    text = table({**written(old), **scores})
    PAGE.write_text(f"{before}{MARKS[0]}\n{text}\n{MARKS[1]}{after}", encoding="utf-8")


def main() -> int:
    """Runs it; 0 when nothing is left."""
    parser = argparse.ArgumentParser(prog="python -m tools.mutation", description=__doc__.split("\n")[0])
    parser.add_argument("--sample", type=int, default=24, help="mutants of each module (default: 24)")
    parser.add_argument("--only", default="", help="modules whose path begins so")
    parser.add_argument("--write", action="store_true", help="put their rows into docs/reliability.md")
    options = parser.parse_args()
    os.chdir(ROOT)
    scores = {}
    with tempfile.TemporaryDirectory() as folder:
        for module in MODULES:
            if module.path.startswith(options.only):
                scores[module.path] = judge(module, options.sample, Path(folder, "log"))
                if options.write:
                    write(scores)
    print(table(scores))
    return int(any(score.left for score in scores.values()))


if __name__ == "__main__":
    sys.exit(main())
