"""Compare the processor time of a command in this checkout and in an earlier commit, in turns.

    .venv/bin/python tools/against.py COMMIT [--turns N] -- COMMAND [arguments]

The command runs in the root of both working trees. The script prints median and extremes of the ratios. Example, with
an onboard file and a folder of label images:

    .venv/bin/python tools/against.py v0.1.0 -- python3 -m core localize --database /data/map.npz /data/images
"""

import argparse
import os
import subprocess
import tempfile
from functools import partial
from pathlib import Path
from statistics import median

from plugin_package import ROOT, load_plugin_package

load_plugin_package()
from benchmarks.turns import ratios, take_turns  # noqa: E402


def processor_seconds(command: list[str], root: Path) -> float:
    """Return the processor seconds (user and system) of the command and its children in ``root``; exit if it fails."""
    before = os.times()
    done = subprocess.run(command, cwd=root, stdout=subprocess.DEVNULL, check=False)
    after = os.times()
    if done.returncode:
        raise SystemExit(f"exit status {done.returncode} in {root}")
    return after.children_user + after.children_system - before.children_user - before.children_system


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commit")
    parser.add_argument("--turns", type=int, default=12)
    parser.add_argument("command", nargs="+")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="semref-against-") as folder:
        # Python must be able to import the name.
        then, git = Path(folder) / "semref_then", ["git", "-C", str(ROOT), "worktree"]
        subprocess.run([*git, "add", "--quiet", "--detach", str(then), options.commit], check=True)
        try:
            runs = {root: partial(processor_seconds, options.command, root) for root in (ROOT, then)}
            now, before = take_turns(runs, options.turns).values()
        finally:
            subprocess.run([*git, "remove", "--force", str(then)], check=True)
    print(
        f"{ratios(now, before)} of the processor time of {options.commit}, {options.turns} turns each "
        f"({median(now):.2f} s against {median(before):.2f} s)"
    )


if __name__ == "__main__":
    main()
