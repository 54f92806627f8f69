"""Test all readers with inputs that hypothesis makes and shrinks (Linux only).

    .venv/bin/python -m tools.fuzz [--examples 1000] [--reader NAME …] [--seed 1]

The script prints the outcomes of each reader, and the smallest input that breaks the contract
(docs/development.md#how-semref-is-tested).
"""

import argparse
import json
import multiprocessing
import os
import sys
import tempfile
from collections import Counter
from pathlib import Path

import hypothesis
from hypothesis import HealthCheck, Phase, settings, strategies

TOOLS = Path(__file__).resolve().parents[1]
# Our processing/ must not hide QGIS's.
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != TOOLS.parent]
sys.path += [str(TOOLS.parent / "tests" / "data"), str(TOOLS)]

from qgis_session import load_plugin_package  # noqa: E402

load_plugin_package()

from fuzz import in_qgis, readers  # noqa: E402
from fuzz.contract import ACCEPTED, REFUSED, World, judge, limit_memory  # noqa: E402

ALL = (*readers.READERS, *in_qgis.READERS)
LIMIT_S = 3600
WORKPLACE = "/dev/shm" if os.path.isdir("/dev/shm") else None


def search(reader: readers.Reader, examples: int, seed: int, folder: Path) -> None:
    """Test a reader in this process. Write result.json: number of each outcome, and the smallest input with a fault."""
    output = os.open(folder / "output.txt", os.O_WRONLY | os.O_CREAT)
    os.dup2(output, 1)
    os.dup2(output, 2)
    (folder / "work").mkdir()
    os.chdir(folder / "work")
    tempfile.tempdir = str(folder)
    world, counts, found = World(folder / "world"), Counter(), []
    make, attempt = reader.prepare(world)
    world.reset()
    limit_memory()

    @settings(
        max_examples=examples,
        deadline=None,
        database=None,
        phases=(Phase.generate, Phase.shrink),
        suppress_health_check=list(HealthCheck),
    )
    @hypothesis.seed(seed)
    @hypothesis.given(strategies.randoms(use_true_random=False))
    def test(random: object) -> None:
        made = make(random)
        (folder / "current").write_bytes(repr(made).encode("utf-8", "replace")[:2000])
        outcome, details = judge(attempt, made, world)
        counts[outcome] += 1
        if outcome not in (ACCEPTED, REFUSED):
            found[:] = [f"{outcome}\n{repr(made)[:2000]}\n{details}"]
            raise AssertionError(details)

    try:
        test()
    except BaseException:
        if not found:
            raise
    (folder / "result.json").write_text(json.dumps([counts, "".join(found)]), encoding="utf-8")
    os._exit(0)  # QGIS's own end is not tested here


def search_in_child(reader: readers.Reader, examples: int, seed: int) -> tuple[Counter, str]:
    """Run the search in another process. A crash or an endless run of this process counts as a fault."""
    with tempfile.TemporaryDirectory(prefix="semref-fuzz-", dir=WORKPLACE) as name:
        folder = Path(name)
        child = multiprocessing.get_context("fork").Process(target=search, args=(reader, examples, seed, folder))
        child.start()
        child.join(LIMIT_S)
        child.kill()
        child.join()
        if not (folder / "result.json").exists():
            current, output = (
                path.read_text("utf-8", "replace") if path.exists() else ""
                for path in (folder / "current", folder / "output.txt")
            )
            return Counter(died=1), f"exit status {child.exitcode} at {current or 'its start'}\n{output[-3000:]}"
        counts, found = json.loads((folder / "result.json").read_text(encoding="utf-8"))
        return Counter(counts), found


def main() -> int:
    """Return 0 if the contract holds for every input."""
    parser = argparse.ArgumentParser(prog="python -m tools.fuzz", description=__doc__.split("\n")[0])
    parser.add_argument("--examples", type=int, default=1000, help="inputs for a reader; fewer for slow ones")
    names = [one.name for one in (*ALL, *readers.FAULTY)]
    parser.add_argument("--reader", action="append", choices=names)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    faults = 0
    for one in (*ALL, *readers.FAULTY):
        if one in ALL if options.reader is None else one.name in options.reader:
            counts, found = search_in_child(one, max(5, round(options.examples * one.share)), options.seed)
            faults += sum(counts.values()) - counts[ACCEPTED] - counts[REFUSED]
            print(f"{one.name:16} {dict(counts)}\n{found}".strip(), flush=True)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
