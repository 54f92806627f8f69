"""Record results of the plugin, and compare two recordings.

    .venv/bin/python -m tools.baseline record FOLDER [--repository PATH] [--quick] [--only SECTION ...]
    .venv/bin/python -m tools.baseline compare FOLDER_A FOLDER_B [--additions] [--ignore PATTERN ...]

`record` runs the Processing algorithms and `python -m core` of a checkout (this one, or --repository), and writes all
results to FOLDER as JSON and .npz. `compare` prints the differences. Its exit status is 1 if a value differs by more
than 1e-9 of its value.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from pathlib import Path

from .compare import compare
from .store import RecordingError

ROOT = Path(__file__).resolve().parents[2]
DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")


def main(arguments: list[str] | None = None) -> int:
    """Run a command and return its exit status."""
    options = parse(arguments)
    try:
        if options.command == "compare":
            return compare(options.folder_a, options.folder_b, options.ignore, options.additions, options.every)
        return _record(options)
    except RecordingError as error:
        print(f"tools.baseline: {error}", file=sys.stderr)
        return 2


def parse(arguments: list[str] | None = None) -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser("tools.baseline", description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(dest="command", required=True)
    record = commands.add_parser("record", help="run the plugin of a checkout and write down its answers")
    record.add_argument("folder", type=Path, help="where the recording goes; an older recording is replaced")
    record.add_argument("--repository", type=Path, default=ROOT, help="checkout to record; default: this one")
    record.add_argument("--data", type=Path, default=DATA, help="the real data's folder; default: %(default)s")
    record.add_argument("--sample-only", action="store_true", help="do not use the real data")
    record.add_argument("--quick", action="store_true", help="a part that takes two minutes")
    record.add_argument("--only", nargs="+", metavar="SECTION", help="repeat only these sections, and the areas")
    record.add_argument("--work", type=Path, help="empty folder for the outputs, kept; default: a temporary one")
    compared = commands.add_parser("compare", help="say what differs between two recordings")
    compared.add_argument("folder_a", type=Path, help="the reference recording")
    compared.add_argument("folder_b", type=Path, help="the recording to check")
    compared.add_argument("--ignore", nargs="+", default=[], metavar="PATTERN", help="rows to leave out, such as */log")
    compared.add_argument("--every", action="store_true", help="print a line for everything, also for identical values")
    text = "FOLDER_B may have columns, keys and outputs that FOLDER_A lacks"
    compared.add_argument("--additions", action="store_true", help=text)
    return parser.parse_args(arguments)


def _record(options: argparse.Namespace) -> int:
    # QGIS is needed from here on only.
    from .record import record

    repository, folder = options.repository.resolve(), options.folder.resolve()
    if not (repository / "metadata.txt").exists():
        raise RecordingError(f"{repository} is no checkout of the plugin: it has no metadata.txt.")
    if not options.sample_only and not options.data.is_dir():
        raise RecordingError(f"There is no real data in {options.data}; set SEMREF_DATA, or give --sample-only.")
    data = Path(os.devnull) if options.sample_only else options.data.resolve()
    if options.work:
        options.work.mkdir(parents=True, exist_ok=True)
        return record(folder, options.work.resolve(), repository, data, options.quick, options.only)
    with tempfile.TemporaryDirectory(prefix="semref-baseline-") as work:
        return record(folder, Path(work), repository, data, options.quick, options.only)


if __name__ == "__main__":
    sys.exit(main())
