"""Sends images through ``python -m core watch`` and measures what the process holds (Linux).

    python -m tools.soak [--images 10000] [--folder FOLDER]

Images are moved into the watched folder as fast as they are localized and removed when they are done. One of ten has
200 × 200 pixels and gets a fix, the others are too small for one; now and then comes one that is no image, or whose
name is no text, and a link to itself lies beside them. Prints a line for each tenth, and ends with 1 when memory grew
by more than ``MOST_GROWTH_MB`` after the first tenth, or descriptors or threads at all, or when an image got no answer.
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from types import ModuleType

TOOLS = Path(__file__).resolve().parents[1]
# Only what is needed on the path: our processing/ must not come before QGIS's.
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != TOOLS.parent]
sys.path += [str(TOOLS.parent / "tests" / "data"), str(TOOLS)]

MOST_GROWTH_MB = 8.0
AT_ONCE = 50
"""Images that lie in the folder together."""


def made_area() -> ModuleType:
    """tests/data/onboard_area.py, which needs the plugin as a package."""
    from qgis_session import load_plugin_package

    load_plugin_package()
    return importlib.import_module("onboard_area")


def held(process_id: int) -> tuple[float, int, int]:
    """(MB in memory, descriptors, threads) of a process."""
    lines = Path(f"/proc/{process_id}/status").read_text(encoding="utf-8").splitlines()
    state = dict(line.split(":", 1) for line in lines if ":" in line)
    descriptors = len(os.listdir(f"/proc/{process_id}/fd"))
    return int(state["VmRSS"].split()[0]) / 1024, descriptors, int(state["Threads"])


def image_name(number: int) -> bytes:
    """Every hundredth name is no text."""
    return b"\xff%07d.png" % number if number % 100 == 7 else b"%07d.png" % number


def send(folder: bytes, outside: bytes, numbers: range, pictures: tuple[bytes, bytes]) -> list[bytes]:
    """Moves images into the folder as a camera does, some of them damaged; gives their paths."""
    paths = []
    for number in numbers:
        path = os.path.join(folder, image_name(number))
        with open(outside, "wb") as file:
            file.write(b"damaged" if number % 50 == 3 else pictures[number % 10 == 0])
        os.rename(outside, path)
        paths.append(path)
    return paths


def soak(count: int, folder: Path) -> list[tuple[int, float, int, int]]:
    """(images done, MB, descriptors, threads) at each tenth."""
    incoming = folder / "incoming"
    incoming.mkdir()
    os.symlink("loop.png", incoming / "loop.png")
    onboard_area = made_area()
    onboard_area.copy_aircraft_rooms(Path(__file__).resolve().parents[2], folder)
    onboard_area.write_area(str(folder / "area.npz"))
    import cv2

    cuts = (onboard_area.HERE[:60, :60], onboard_area.HERE)
    pictures = tuple(cv2.imencode(".png", cut)[1].tobytes() for cut in cuts)
    command = [sys.executable, "-m", "core", "watch", "incoming", "--database", "area.npz", "--gga", "sentences"]
    command += ["--method", "constellation"]
    rows = []
    with open(folder / "log", "wb") as log:
        watching = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=log)
        try:
            while not rows or rows[-1][0] < count:
                done = rows[-1][0] if rows else 0
                until = min(done + max(count // 10, 1), count)
                for first in range(done, until, AT_ONCE):
                    numbers = range(first, min(first + AT_ONCE, until))
                    paths = send(os.fsencode(incoming), os.fsencode(folder / "made"), numbers, pictures)
                    answers = {json.loads(watching.stdout.readline())["image"] for _ in paths}
                    if answers != {os.fsdecode(os.path.join(b"incoming", os.path.basename(path))) for path in paths}:
                        raise SystemExit(f"images {numbers} did not get an answer each")
                    for path in paths:
                        os.unlink(path)
                rows.append((until, *held(watching.pid)))
                print("images {:6d}  memory {:6.1f} MB  descriptors {:3d}  threads {:3d}".format(*rows[-1]), flush=True)
            # The sentence of the last image follows its line.
            time.sleep(1)
        finally:
            watching.kill()
            watching.wait()
    sentences = (folder / "sentences").read_bytes().count(b"\n")
    if sentences != count:
        raise SystemExit(f"{sentences} sentences for {count} images")
    return rows


def main() -> int:
    """Runs it; 0 when nothing grew."""
    parser = argparse.ArgumentParser(prog="python -m tools.soak", description=__doc__.split("\n")[0])
    parser.add_argument("--images", type=int, default=10_000)
    parser.add_argument("--folder", type=Path, help="empty one to work in (default: a temporary one)")
    options = parser.parse_args()
    folder = options.folder or Path(tempfile.mkdtemp())
    started = time.perf_counter()
    try:
        rows = soak(options.images, folder)
    finally:
        if options.folder is None:
            shutil.rmtree(folder)
    first, last = rows[0], rows[-1]
    growth = last[1] - first[1]
    flat = growth <= MOST_GROWTH_MB and last[2:] == first[2:]
    print(
        f"{last[0]} images in {time.perf_counter() - started:.0f} s; after the first tenth memory grew by {growth:.1f} "
        f"MB, descriptors by {last[2] - first[2]}, threads by {last[3] - first[3]}: {'flat' if flat else 'not flat'}"
    )
    return 0 if flat else 1


if __name__ == "__main__":
    sys.exit(main())
