"""Injects faults into everything that SemRef writes, and looks whether anything is lost, half or untold (Linux).

    python -m tools.faults [--kills 26] [--disks 4] [--seed 1] [--only WRITER …] [--folder FOLDER] [--write]

Every algorithm that writes files – the provider tells which – and ``python -m core`` run in children forked from one
QGIS, over older outputs and without. ``trials`` has what is injected. After each: all outputs are the old ones or all
the new ones, the ending says which, inputs are as they were, and nothing stays that the next run doesn't clear away.
Ends with 1 where that is not so; ``--write`` puts the table into docs/reliability.md.
"""

from __future__ import annotations

import argparse
import datetime
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

from bench import machine  # noqa: E402

from faults import command_line, page, readers, trials  # noqa: E402
from faults.writers import make_quick, tried_writers  # noqa: E402


def _told(options: argparse.Namespace, seconds: float) -> str:
    """By which command, when, of which commit and on what machine the table came about."""
    given = f"--kills {options.kills} --disks {options.disks} --most-steps {options.most_steps} --seed {options.seed}"
    return (
        f"*`.venv/bin/python -m tools.faults {given}` on {datetime.date.today().isoformat()}, {machine.revision()}, "
        f"{seconds / 60:.0f} minutes. {machine.hardware()}; {machine.versions()}.*"
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
    parser.add_argument("--write", action="store_true", help="put the table into docs/reliability.md")
    options = parser.parse_args()
    folder = options.folder or Path(tempfile.mkdtemp())
    folder.mkdir(exist_ok=True)
    from qgis_session import qgis_session

    started, rows, finds, failed = time.monotonic(), [], [], []
    with qgis_session() as provider:
        make_quick()
        from osgeo import gdal
        from qgis.core import Qgis

        print(f"QGIS {Qgis.QGIS_VERSION}, GDAL {gdal.__version__}, {platform.platform()}", flush=True)
        plan = trials.Plan(options.kills, options.disks, options.most_steps, options.seed)
        for writer in tried_writers(provider, folder, options.only, failed.append):
            row = trials.all_of(writer, folder, plan)
            rows.append(row)
            finds += row.finds
            print(row.line(), flush=True)
            for find in row.finds:
                print("   ", find, flush=True)
        for other in (command_line.row, readers.row):
            if options.only:
                break
            rows.append(other(provider, folder, plan))
            finds += rows[-1].finds
            print(rows[-1].line(), *rows[-1].finds, sep="\n    ", flush=True)
        print(*failed, sep="\n", flush=True)
        finds += failed
        table = page.table(rows, _told(options, time.monotonic() - started))
        print(table, flush=True)
        if options.write:
            page.write(TOOLS.parent / "docs" / "reliability.md", table)
        del provider
    if options.folder is None:
        shutil.rmtree(folder)
    return 1 if finds else 0


if __name__ == "__main__":
    sys.exit(main())
