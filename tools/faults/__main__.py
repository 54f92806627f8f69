"""Injects faults into everything that SemRef writes, and looks whether anything is lost, half or untold (Linux).

    python -m tools.faults [--kills 26] [--disks 4] [--seed 1] [--only WRITER …] [--folder FOLDER] [--write]

Every algorithm that writes files – the provider tells which – and ``python -m core`` run in children forked from one
QGIS, over older outputs and without. ``trials`` has what is injected. After each: all outputs are the old ones or all
the new ones, the ending says which, inputs are as they were. After a kill each output is whole, old or new.
Ends with 1 where that is not so; ``--write`` puts the table into docs/reliability.md.
"""

from __future__ import annotations

import argparse
import dataclasses
import datetime
import json
import os
import platform
import shutil
import sys
import tempfile
import time
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[1]
# Only what is needed on the path: our processing/ must not come before QGIS's.
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != TOOLS.parent]
sys.path += [str(TOOLS.parent / "tests" / "data"), str(TOOLS)]
for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "GDAL_NUM_THREADS"):
    os.environ[variable] = "1"

from plugin_package import load_plugin_package  # noqa: E402

load_plugin_package()

from benchmarks import results  # noqa: E402
from faults import command_line, page, readers, trials  # noqa: E402
from faults.writers import make_quick, tried_writers  # noqa: E402


def _kept(path: Path | None) -> dict[str, trials.Row]:
    """Rows of earlier runs, by writer."""
    if path is None or not path.exists():
        return {}
    return {row["name"]: trials.Row(**row) for row in json.loads(path.read_text(encoding="utf-8"))}


def _told(options: argparse.Namespace, seconds: float) -> str:
    """By which command, when, of which commit and on what machine the table came about."""
    given = f"--kills {options.kills} --disks {options.disks} --most-steps {options.most_steps} --seed {options.seed}"
    return (
        f"*`.venv/bin/python -m tools.faults {given}` on {datetime.date.today().isoformat()}, {results.revision()}, "
        f"{seconds / 60:.0f} minutes. {results.hardware()}; {results.versions()}.*"
    )


def main() -> int:
    """Runs it; 0 when nothing was lost."""
    parser = argparse.ArgumentParser(prog="python -m tools.faults", description=__doc__.split("\n")[0])
    parser.add_argument("--kills", type=int, default=26, help="a writer (default: 26)")
    parser.add_argument("--disks", type=int, default=4, help="full disks a writer (default: 4)")
    parser.add_argument("--most-steps", type=int, default=25, help="cancels a writer at most (default: 25)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="*", default=[], metavar="WRITER")
    parser.add_argument("--folder", type=Path, help="empty one to work in (default: a temporary one)")
    parser.add_argument("--results", type=Path, help="JSON that keeps the rows; a later run leaves out who is in it")
    parser.add_argument("--write", action="store_true", help="put the table into docs/reliability.md")
    options = parser.parse_args()
    folder = options.folder or Path(tempfile.mkdtemp())
    folder.mkdir(exist_ok=True)
    from qgis_session import qgis_session

    started, failed = time.monotonic(), []
    with qgis_session() as provider:
        make_quick()
        from osgeo import gdal
        from qgis.core import Qgis

        print(f"QGIS {Qgis.QGIS_VERSION}, GDAL {gdal.__version__}, {platform.platform()}", flush=True)
        plan = trials.Plan(options.kills, options.disks, options.most_steps, options.seed)
        rows = _kept(options.results)

        def add(row: trials.Row) -> None:
            rows[row.name] = row
            print(row.line(), *row.finds, sep="\n    ", flush=True)
            if options.results:
                stored = [dataclasses.asdict(row) for row in rows.values()]
                options.results.write_text(json.dumps(stored, indent=1), encoding="utf-8")

        for writer in tried_writers(provider, folder, options.only, failed.append, rows):
            add(trials.all_of(writer, folder, plan))
        for name, other in ((command_line.NAME, command_line.row), (readers.NAME, readers.row)):
            if not options.only and name not in rows:
                add(other(provider, folder, plan))
        print(*failed, sep="\n", flush=True)
        finds = [*failed, *(find for row in rows.values() for find in row.finds)]
        table = page.table(list(rows.values()), _told(options, time.monotonic() - started))
        print(table, flush=True)
        if options.write:
            page.write(TOOLS.parent / "docs" / "reliability.md", table)
        del provider
    if options.folder is None:
        shutil.rmtree(folder)
    return 1 if finds else 0


if __name__ == "__main__":
    sys.exit(main())
