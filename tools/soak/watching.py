"""Images through ``python -m core watch``.

They are moved into the watched folder as fast as they are localized and removed when they are done. One of ten has
200 × 200 pixels and gets a fix, the others are too small for one; now and then comes one that is no image, or whose
name is no text, and a link to itself lies beside them. As a flight all have 200 × 200 pixels, the camera goes to and
fro over the map, and a table of motion grows with them.
"""

from __future__ import annotations

import importlib
import json
import os
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType

from .held import Held, held, line, processor_s

AT_ONCE = 50
"""Images that lie in the folder together."""

FLIGHT = ("--flight", "--state", "flight.npz", "--odometry", "odometry.csv")

RESTARTED_AFTER = 5
"""Tenths after which a flight's process is killed and goes on."""


def made_area() -> ModuleType:
    """tests/data/onboard_area.py, which needs the plugin as a package."""
    from qgis_session import load_plugin_package

    load_plugin_package()
    sys.path.append(str(Path(__file__).resolve().parents[2] / "tests" / "data"))
    return importlib.import_module("onboard_area")


ROW, COLUMNS = 250, (60, 120, 180, 240, 300, 360, 420, 360, 300, 240, 180, 120)
"""Of the map: the first row of a flight's images, and their first columns, again and again."""


def image_name(number: int) -> bytes:
    """Every hundredth name is no text."""
    return b"\xff%07d.png" % number if number % 100 == 7 else b"%07d.png" % number


def tell_motion(table: Path, numbers: range) -> None:
    """Appends a flight's rows to a table of motion, one an image; not each of their names is a file's."""
    with open(table, "a", encoding="utf-8") as file:
        for number in numbers:
            way = COLUMNS[number % len(COLUMNS)] - COLUMNS[(number - 1) % len(COLUMNS)]
            file.write(f"{image_name(number).decode('utf-8', 'replace')},{way},0,0,1\n")


def send(folder: bytes, outside: bytes, numbers: range, pictures: Sequence[bytes]) -> list[bytes]:
    """Moves images into the folder as a camera does, in turns, some of them damaged; gives their paths."""
    paths = []
    for number in numbers:
        path = os.path.join(folder, image_name(number))
        with open(outside, "wb") as file:
            file.write(b"damaged" if number % 50 == 3 else pictures[number % len(pictures)])
        os.rename(outside, path)
        paths.append(path)
    return paths


def watch_images(count: int, folder: Path, is_flight: bool = False) -> tuple[list[Held], list[list[float]]]:
    """What the process holds after each tenth of ``count`` images, and the processor's seconds of each image by tenths.

    Ends the program when one of them got no answer. As a flight, its state is kept, and half way the process is killed
    and goes on from it.
    """
    incoming = folder / "incoming"
    incoming.mkdir()
    os.symlink("loop.png", incoming / "loop.png")
    onboard_area = made_area()
    onboard_area.copy_core(Path(__file__).resolve().parents[2], folder)
    onboard_area.write_area(str(folder / "area.npz"))
    import cv2

    cuts = [onboard_area.HERE, *[onboard_area.HERE[:60, :60]] * 9]
    if is_flight:
        size = onboard_area.SIZE
        cuts = [onboard_area.MAP[ROW : ROW + size, first : first + size].copy() for first in COLUMNS]
    pictures = tuple(cv2.imencode(".png", cut)[1].tobytes() for cut in cuts)
    command = [sys.executable, "-m", "core", "watch", "incoming", "--database", "area.npz", "--gga", "sentences"]
    command += ["--method", "constellation", *(FLIGHT if is_flight else [])]
    table = folder / "odometry.csv"
    table.write_text("image,dx_m,dy_m,dheading_deg,sigma_m\n", encoding="utf-8")
    rows: list[Held] = []
    seconds: list[list[float]] = []
    with open(folder / "log", "wb") as log:

        def started() -> subprocess.Popen[bytes]:
            return subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=log)

        watching = started()
        try:
            while not rows or rows[-1].done < count:
                done = rows[-1].done if rows else 0
                until = min(done + max(count // 10, 1), count)
                seconds.append([])
                for first in range(done, until, AT_ONCE):
                    numbers = range(first, min(first + AT_ONCE, until))
                    tell_motion(table, numbers)
                    paths = send(os.fsencode(incoming), os.fsencode(folder / "made"), numbers, pictures)
                    answers = set()
                    for _ in paths:
                        before = processor_s(watching.pid)
                        answers.add(json.loads(watching.stdout.readline())["image"])
                        seconds[-1].append(processor_s(watching.pid) - before)
                    if answers != {os.fsdecode(os.path.join(b"incoming", os.path.basename(path))) for path in paths}:
                        raise SystemExit(f"images {numbers} did not get an answer each")
                    for path in paths:
                        os.unlink(path)
                rows.append(held(until, watching.pid))
                print(line(rows[-1]), flush=True)
                if is_flight and len(rows) == RESTARTED_AFTER:
                    time.sleep(1)
                    watching.kill()
                    watching.wait()
                    watching = started()
            # The sentence of the last image follows its line.
            time.sleep(1)
        finally:
            watching.kill()
            watching.wait()
    half, most = middle_and_most([one for tenth in seconds for one in tenth])
    print(f"an image: {half:.2f} s of the processor (median), {most:.2f} s (95 %)", flush=True)
    sentences = (folder / "sentences").read_bytes().count(b"\n")
    if sentences != count:
        raise SystemExit(f"{sentences} sentences for {count} images")
    return rows, seconds


def middle_and_most(seconds: Sequence[float]) -> tuple[float, float]:
    """Median and 95th percentile."""
    ordered = sorted(seconds)
    return ordered[len(ordered) // 2], ordered[int(0.95 * len(ordered))]
