"""Images through ``python -m core watch``.

They are moved into the watched folder as fast as they are localized and removed when they are done. One of ten has
200 × 200 pixels and gets a fix, the others are too small for one; now and then comes one that is no image, or whose
name is no text, and a link to itself lies beside them.
"""

from __future__ import annotations

import importlib
import json
import os
import subprocess
import sys
import time
from pathlib import Path
from types import ModuleType

from .held import Held, held, line

AT_ONCE = 50
"""Images that lie in the folder together."""

RESTARTED_AFTER = 5
"""Tenths after which a flight's process is killed and goes on."""


def made_area() -> ModuleType:
    """tests/data/onboard_area.py, which needs the plugin as a package."""
    from qgis_session import load_plugin_package

    load_plugin_package()
    return importlib.import_module("onboard_area")


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


def watch_images(count: int, folder: Path, is_flight: bool = False) -> list[Held]:
    """What the process holds after each tenth of ``count`` images; ends the program when one of them got no answer.

    As a flight, its state is kept, and half way the process is killed and goes on from it.
    """
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
    command += ["--method", "constellation", *(["--flight", "--state", "flight.npz"] if is_flight else [])]
    rows: list[Held] = []
    seconds: list[float] = []
    with open(folder / "log", "wb") as log:

        def started() -> subprocess.Popen[bytes]:
            return subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=log)

        watching = started()
        try:
            while not rows or rows[-1].done < count:
                done = rows[-1].done if rows else 0
                until = min(done + max(count // 10, 1), count)
                for first in range(done, until, AT_ONCE):
                    numbers = range(first, min(first + AT_ONCE, until))
                    paths = send(os.fsencode(incoming), os.fsencode(folder / "made"), numbers, pictures)
                    answers = set()
                    for _ in paths:
                        asked = time.perf_counter()
                        answers.add(json.loads(watching.stdout.readline())["image"])
                        seconds.append(time.perf_counter() - asked)
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
    half, most = sorted(seconds)[len(seconds) // 2], sorted(seconds)[int(0.95 * len(seconds))]
    print(f"an image: {half:.3f} s (median), {most:.3f} s (95 %)", flush=True)
    sentences = (folder / "sentences").read_bytes().count(b"\n")
    if sentences != count:
        raise SystemExit(f"{sentences} sentences for {count} images")
    return rows
