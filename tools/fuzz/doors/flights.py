"""Of flights: odometry tables, logs of aircraft, the state that `watch --flight` keeps."""

from __future__ import annotations

import io
import math
import struct
import zipfile
from random import Random
from typing import Any

import numpy as np

from ..contract import World, require
from ..door import Door, Placed, Tools
from ..mutations import mutated_bytes, mutated_table

ODOMETRY = (
    "image,dx_m,dy_m,dheading_deg,sigma_m,sigma_heading_deg,scale,sigma_scale\n"
    "a.png,0,0,0,,,,\n"
    "b.png,1.5,98.2,-3.1,2.0,0.5,1.01,0.01\n"
    "c.png,,,,,,,\n"
    "d.png,-4,101,2.5,2,0.5,,\n"
)
NAMES = ["a.png", "b.png", "c.png", "d.png"]
SRT = (
    "1\n00:00:00,000 --> 00:00:00,033\n[rel_alt: 55.5 abs_alt: 90.1] [gb_yaw: -12.5 gb_pitch: -90 gb_roll: 0]\n\n"
    "2\n00:00:00,033 --> 00:00:00,066\nF/2.8, SS 206, GPS (9.5, 47.1, 15), D 2.8m, H 6.0m, H.S 0.0m/s\n\n"
)
GEO = "EPSG:4326\na.png 9.5 47.1 400 12.5 0 0\nb.png 9.5 47.1 400 nan\n# c\n"


def odometry_tables(world: World) -> Tools:
    from semref.core.flight.growing import GrowingTable
    from semref.core.flight.links import links_by_image
    from semref.core.flight.odometry import check_odometry, odometry_links, read_odometry

    placed = Placed(world.folder, "odometry.csv")

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            rows = list(GrowingTable(path, check_odometry).new_rows(is_ended=True))
            require(len(rows) <= 2 * data.count(b"\n") + 1, "rows that nobody wrote")
            steps = read_odometry(path)
        for link in links_by_image(odometry_links(steps, NAMES), len(NAMES)).values():
            numbers = (*link.translation, link.turn, link.log_scale, *np.ravel(link.covariance))
            require(np.isfinite(numbers).all(), "a motion that is none")

    def make(random: Random) -> bytes:
        return mutated_table(random, ODOMETRY, ("image", "dx_m", "sigma_m", "1e308", "-1e-308", "nan", "a.png"))

    return make, attempt


def logs(world: World) -> Tools:
    from semref.core.flight.logs.files import read_log
    from semref.core.flight.telemetry import log_cameras, log_links

    placed = Placed(world.folder, "flight.log")
    good = [_dataflash(), _ulog(), _tlog(), SRT.encode(), GEO.encode()]
    stems, times = ["a", "b", "c"], [0.0, 1.0, 2.0]

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            found = read_log(path)
        require(np.isfinite(found.times_s).all() and (np.diff(found.times_s) >= 0).all(), "times without order")
        require(found.values.shape == (len(found.times_s), 6), "entries without fields")
        start = float(found.times_s[0])
        for camera in log_cameras(found, stems, [start + time for time in times]):
            require(camera.heading_deg is None or math.isfinite(camera.heading_deg), "a heading that is none")
        log_links(found, stems, [start + time for time in times])

    def make(random: Random) -> bytes:
        tokens = [b"\xa3\x95", b"\xa3\x95\x80", b"ULog\x01\x12\x35", b"\xfd\x09", b"\xfe\x1c", b"\xff" * 8, b" --> "]
        return mutated_bytes(random, random.choice(good), tokens, 8)

    return make, attempt


def _dataflash() -> bytes:
    def described(kind: int, name: bytes, letters: bytes, labels: bytes, packed: str) -> bytes:
        size = 3 + struct.calcsize(packed)
        return b"\xa3\x95\x80" + struct.pack("<BB4s16s64s", kind, size, name, letters, labels)

    data = described(128, b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns", "<BB4s16s64s")
    data += described(60, b"ATT", b"QccC", b"TimeUS,Roll,Pitch,Yaw", "<QhhH")
    data += described(61, b"XKF1", b"QBff", b"TimeUS,C,VN,VE", "<QBff")
    for n in range(20):
        data += b"\xa3\x95\x3c" + struct.pack("<QhhH", 100_000 * n, 150, -250, 27_050)
        data += b"\xa3\x95\x3d" + struct.pack("<QBff", 100_000 * n, 0, 3.0, 4.0)
    return data


def _ulog() -> bytes:
    def message(kind: str, content: bytes) -> bytes:
        return struct.pack("<HB", len(content), ord(kind)) + content

    data = b"ULog\x01\x12\x35\x01" + bytes(8)
    data += message("F", b"vehicle_attitude:uint64_t timestamp;float[4] q;")
    data += message("F", b"vehicle_local_position:uint64_t timestamp;float z;float vx;float vy;")
    for n, name in enumerate((b"vehicle_attitude", b"vehicle_local_position")):
        data += message("A", b"\0" + struct.pack("<H", n) + name)
    for n in range(20):
        data += message("D", struct.pack("<HQ4f", 0, 100_000 * n, 0.7, 0, 0, 0.7))
        data += message("D", struct.pack("<HQ3f", 1, 100_000 * n, -55.5, 3, 4))
    return data


def _tlog() -> bytes:
    from semref.core.flight.logs.mavlink import checksum

    data = b""
    for n in range(20):
        content = struct.pack("<I6f", n, 0.1, -0.2, 1.5, 0, 0, 0)
        head = bytes([len(content), 7, 1, 1, 30])
        total = checksum(head + content + bytes([39]))
        data += struct.pack(">Q", 10**15 + 100_000 * n) + b"\xfe" + head + content + struct.pack("<H", total)
    return data


def states(world: World) -> Tools:
    from onboard_blobs import MAP, build_blobs

    from semref.core.errors import ParameterError
    from semref.core.flight.model import FlightImage
    from semref.core.flight.tracker import FlightTracker
    from semref.core.localizer.localizer import Localizer
    from semref.core.onboard.state_file import StateFile

    localizer = Localizer(build_blobs())
    tracker = FlightTracker(localizer)
    image = FlightImage("a.png", np.ascontiguousarray(MAP[100:160, 100:160]))
    tracker.add(image)
    good = {name: _saved(value) for name, value in tracker.state().items()}
    placed, key = Placed(world.folder, "flight.npz"), b"a key of the fuzzer"

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            try:
                StateFile(path, key).read()
            except ParameterError:
                pass
            else:
                require(False, "a state was used that nobody signed")
        with placed(data + StateFile("", key).code(data)) as path:
            arrays = StateFile(path, key).read()
        again = FlightTracker.from_state(localizer, arrays)
        require(set(again.state()) >= {"counts", "numbers"}, "a state without its counts")

    def make(random: Random) -> bytes:
        members = dict(good)
        name = random.choice(sorted(members))
        kind = random.randrange(4)
        if kind == 0:
            del members[name]
        elif kind == 1:
            members[name] = members[random.choice(sorted(members))]
        else:
            members[name] = mutated_bytes(random, members[name], [b"\xff" * 8, b"\0" * 8, b"(1, 1)", b"|O"], 3)
        file = io.BytesIO()
        with zipfile.ZipFile(file, "w") as archive:
            for one, content in members.items():
                archive.writestr(f"{one}.npy", content)
        return file.getvalue() if random.random() < 0.9 else mutated_bytes(random, file.getvalue())

    return make, attempt


def _saved(value: Any) -> bytes:
    file = io.BytesIO()
    np.save(file, value)
    return file.getvalue()


DOORS = (
    Door("odometry", "odometry tables (CSV)", odometry_tables, 60_000),
    Door("logs", "flight logs: `.bin`, `.ulg`, `.tlog`, `.SRT`, `geo.txt`", logs, 30_000, 10_000),
    Door("flight_state", "what `watch --flight` keeps of a flight", states, 2_000, 1_000),
)
