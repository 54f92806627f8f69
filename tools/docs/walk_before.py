"""Goes the walks of docs/what_works.md in an older SemRef, by mouse, and keeps what they took for its table.

    git worktree add ../before 9c048ba
    xvfb-run -a -s "-screen 0 1600x1000x24" .venv/bin/python tools/docs/walk_before.py ../before
    .venv/bin/python tools/docs/list_walks.py DIR

9c048ba is the commit before the walks were made shorter: before databases opened by themselves, fields offered what is
at hand, *Correct* updated the database, and OpenStreetMap was classified. Walks that need no other way are gone as
today's test goes them (tests/gui/walk_job_session.py), the others as walk_before_session.py says.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from list_walks import INSTALL_CLICKS, INSTALL_VALUES

ROOT = Path(__file__).resolve().parents[2]
KEPT = Path(__file__).with_name("walks_before.json")
WALKS = ROOT / "tests" / "gui" / "walk_job_session.py"
SESSION = Path(__file__).with_name("walk_before_session.py")


def main() -> None:
    """Writes walks_before.json."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkout", type=Path, help="of the older commit")
    parser.add_argument("--log", type=Path, help="file for what QGIS says")
    arguments = parser.parse_args()
    sys.path.append(str(ROOT / "tests" / "data"))
    from desktop_qgis import walk

    with tempfile.TemporaryDirectory(prefix="walks-before-") as folder:
        home, sample = Path(folder) / "home", Path(folder) / "sample"
        sample.mkdir()
        variables = {"SEMREF_SAMPLE": str(sample), "SEMREF_WAY": "mouse", "SEMREF_WALKS": str(WALKS)}
        seen = walk(arguments.checkout, home, os.environ["DISPLAY"], SESSION, variables)
    if arguments.log:
        arguments.log.write_text(json.dumps(seen, indent=1), encoding="utf-8")
    if seen["messages"]:
        sys.exit("\n".join(seen["messages"]))
    of = {"clicks", "values", "seconds"}
    kept = {name: {key: one[key] for key in sorted(of)} for name, one in seen.items() if isinstance(one, dict)}
    # Counted, not gone: QGIS's own dialog, then as now.
    kept = {"install": {"clicks": INSTALL_CLICKS, "seconds": None, "values": INSTALL_VALUES}, **kept}
    KEPT.write_text(
        json.dumps({"commit": commit(arguments.checkout), "walks": kept}, indent=1) + "\n", encoding="utf-8"
    )
    print(f"{KEPT}: {', '.join(kept)}")


def commit(checkout: Path) -> str:
    """Its short name."""
    command = ["git", "-C", str(checkout), "rev-parse", "--short=7", "HEAD"]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


if __name__ == "__main__":
    main()
