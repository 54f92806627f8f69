"""Store frames of a video as images of a flight: ``python -m core.flight.video VIDEO FOLDER --every 2``.

The folder also gets ``cameras.csv``, a camera table with the time of each frame in the video. If DJI subtitles with the
video's name are beside it, the table contains the gimbal's heading and attitude.
"""

from __future__ import annotations

import argparse
import contextlib
import csv
import io
import math
import os
import sys
from collections.abc import Iterator
from typing import TextIO

import cv2

from .. import limits
from ..errors import ParameterError, SemRefError, reason_of
from ..tables import bytes_of, stem_of
from .logs.files import read_log
from .telemetry import Telemetry, log_cameras

TABLE = "cameras.csv"
LEAST_STEP_S, MOST_STEP_S = 0.02, 3600.0
_QUALITY = 95
_STARTS = ((4, b"ftyp"), (0, b"\x1a\x45\xdf\xa3"), (8, b"AVI "), (0, b"\x47"), (0, b"\0\0\1\xba"))
"""First bytes of MP4 and QuickTime, Matroska, AVI and MPEG files. Playlists and stream descriptions could lead to other
computers and are refused."""


def write_frames(video: str, folder: str, every_s: float, log: Telemetry | None = None) -> Iterator[tuple[str, float]]:
    """Write frames of a video as JPEGs, then their camera table; yield the path of each frame and the share done.

    Args:
        folder: Target, created if missing. Existing files are never replaced.
        log: Of the same flight, in the video's time.

    Raises:
        ParameterError: The video can't be read, or a file can't be written.
    """
    table = os.path.join(folder, TABLE)
    if not LEAST_STEP_S <= every_s <= MOST_STEP_S:
        raise ParameterError(
            "The interval between frames is {every:g} s; it must be from {least:g} to {most:g} s.",
            every=every_s,
            least=LEAST_STEP_S,
            most=MOST_STEP_S,
        )
    capture = _open_video(video)
    if os.path.lexists(table):
        raise ParameterError("{path} exists already. Choose another folder.", path=table)
    stem = stem_of(video)
    count = capture.get(cv2.CAP_PROP_FRAME_COUNT)
    names: list[str] = []
    times: list[float] = []
    wanted, number = 0.0, 0
    try:
        while len(names) < limits.FRAMES and capture.grab():
            # The time is 0 before the first frame, and later that of the latest frame.
            time_s, number = capture.get(cv2.CAP_PROP_POS_MSEC) / 1000, number + 1
            if not math.isfinite(time_s) or time_s < wanted - 1e-6:
                continue
            is_there, frame = capture.retrieve()
            if not is_there:
                continue
            wanted = max(wanted + every_s, time_s + every_s / 2)
            names.append(f"{stem}_{time_s:010.3f}.jpg")
            times.append(time_s)
            path = os.path.join(folder, names[-1])
            _write(path, cv2.imencode(".jpg", frame, [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])[1].tobytes())
            yield path, min(number / count, 1.0) if count >= 1 else 0.0
    finally:
        capture.release()
    if not names:
        raise ParameterError("{path} has no readable frames.", path=video)
    _write(table, _table(names, times, log).encode("utf-8"))


def _open_video(video: str) -> cv2.VideoCapture:
    no_video = ParameterError("{path} is not a readable video. Choose an MP4, MOV, MKV, AVI or MPEG file.", path=video)
    start = bytes_of(video, 1 << 50, 16)
    if not any(start[at : at + len(mark)] == mark for at, mark in _STARTS):
        raise no_video
    path = os.path.abspath(video)
    # OpenCV ends the whole program for a name with bytes that are not text.
    if path.encode("utf-8", "replace").decode("utf-8") != path:
        raise no_video
    capture = cv2.VideoCapture(path)
    if not capture.isOpened():
        raise no_video
    return capture


def _write(path: str, data: bytes) -> None:
    """Write a new file completely or not at all; raises ParameterError if it exists or can't be written."""
    try:
        os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
        file = open(path, "xb")  # noqa: SIM115  closed below
    except FileExistsError:
        raise ParameterError("{path} exists already. Choose another folder.", path=path) from None
    except OSError as error:
        raise ParameterError("{path} can't be written: {reason}.", path=path, reason=reason_of(error)) from None
    try:
        with file:
            file.write(data)
    except OSError as error:
        with contextlib.suppress(OSError):
            os.remove(path)
        raise ParameterError("{path} can't be written: {reason}.", path=path, reason=reason_of(error)) from None


def _table(names: list[str], times: list[float], log: Telemetry | None) -> str:
    """Return the camera table. Heights above take-off are left out: the table's heights are above the ground."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(["image", "time", "heading", "roll", "pitch"])
    stems = [os.path.splitext(name)[0] for name in names]
    cameras = [None] * len(names) if log is None else log_cameras(log, stems, list(times))
    for name, time_s, camera in zip(names, times, cameras):
        heading = camera.heading_deg if camera else None
        attitude = camera.attitude if camera else None
        angles = (None, None) if attitude is None else (attitude.roll_deg, attitude.pitch_deg)
        cells = ["" if value is None else f"{value:.2f}" for value in (heading, *angles)]
        rows.writerow([name, f"{time_s:.3f}", *cells])
    return text.getvalue()


def subtitles_of(video: str) -> str | None:
    """Return the path of the subtitles beside a video; None without any."""
    stem = os.path.splitext(video)[0]
    return next((stem + ending for ending in (".SRT", ".srt") if os.path.isfile(stem + ending)), None)


def _print_line(text: str, where: TextIO | None = None) -> None:
    """Print a line; bytes of a name that are not text are escaped."""
    print(text.encode("utf-8", "backslashreplace").decode("utf-8"), file=where, flush=True)


def main(arguments: list[str] | None = None) -> int:
    """Run the command and return its exit code."""
    parser = argparse.ArgumentParser("python -m core.flight.video", description="Write frames of a video as images.")
    parser.add_argument("video", metavar="VIDEO")
    parser.add_argument("folder", metavar="FOLDER", help="target folder of the images and cameras.csv")
    parser.add_argument("--every", type=float, default=2.0, metavar="S", help="seconds between frames (default: 2)")
    parser.add_argument("--log", help="flight log in the video's time (default: the subtitles beside it with its name)")
    options = parser.parse_args(arguments)
    try:
        path = options.log or subtitles_of(options.video)
        for written, _ in write_frames(options.video, options.folder, options.every, read_log(path) if path else None):
            _print_line(written)
    except SemRefError as error:
        _print_line(str(error), sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
