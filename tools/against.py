"""Compare the processor time of a command in this checkout and in an earlier commit, in turns.

    .venv/bin/python tools/against.py COMMIT [--turns N] -- COMMAND [arguments]

The command runs in the root of both working trees. {root}, {folder} and {name} become the path of the tree, the path of
the folder above, and its name. The script prints median and extremes of the ratios. Examples (the first one needs an
onboard file and a folder of label images):

    .venv/bin/python tools/against.py v0.1.0 -- python3 -m core localize --database /data/map.npz /data/images
    .venv/bin/python tools/against.py v0.1.0 -- \\
        python3 -c "import sys; sys.path.insert(0, '{folder}'); import {name}.plugin"
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from statistics import median

from plugin_package import ROOT, load_plugin_package

load_plugin_package()
from benchmarks.turns import ratios, take_turns  # noqa: E402


def in_tree(command: Sequence[str], root: Path) -> list[str]:
    """Return the command for the working tree at ``root``."""
    places = {"{root}": str(root), "{folder}": str(root.parent), "{name}": root.name}
    parts = []
    for part in command:
        for place, value in places.items():
            part = part.replace(place, value)
        parts.append(part)
    return parts


def processor_seconds(command: Sequence[str], root: Path) -> float:
    """Return the processor seconds (user and system) of the command and its children in ``root``.

    Raises:
        SystemExit: The command failed.
    """
    before = os.times()
    done = subprocess.run(in_tree(command, root), cwd=root, stdout=subprocess.DEVNULL, check=False)
    after = os.times()
    if done.returncode:
        raise SystemExit(f"exit status {done.returncode} in {root}")
    return after.children_user + after.children_system - before.children_user - before.children_system


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commit")
    parser.add_argument("--turns", type=int, default=12)
    parser.add_argument("command", nargs="+")
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory(prefix="semref-against-") as folder:
        # Python must be able to import the name.
        then = Path(folder) / "semref_then"
        git = ["git", "-C", str(ROOT)]
        subprocess.run([*git, "worktree", "add", "--quiet", "--detach", str(then), options.commit], check=True)
        try:
            trees = {"now": ROOT, options.commit: then}
            runs = {name: partial(processor_seconds, options.command, root) for name, root in trees.items()}
            seconds = take_turns(runs, options.turns)
        finally:
            subprocess.run([*git, "worktree", "remove", "--force", str(then)], check=True)
    now, before = seconds["now"], seconds[options.commit]
    print(
        f"{ratios(now, before)} of the processor time of {options.commit}, {options.turns} turns each "
        f"({median(now):.2f} s against {median(before):.2f} s)"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
