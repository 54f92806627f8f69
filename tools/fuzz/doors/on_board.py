"""On board: the file of an area, the command line, the names in a watched folder."""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import logging
import os
import struct
import zipfile
import zlib
from pathlib import Path
from random import Random
from typing import Any

import cv2
import numpy as np

from ..contract import World, require
from ..door import Door, Placed, Tools
from ..mutations import NUMBERS, mutated_bytes, mutated_json, word
from .databases import require_sound

_EXIT_CODES = (0, 1, 2, 3, 130)


def _members(path: str) -> dict[str, bytes]:
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def _npy(data: bytes, shape: Any = None, kind: str = "|u1") -> bytes:
    shape = (len(data),) if shape is None else shape
    header = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}".encode("latin-1", "replace")
    header += b" " * (-(len(header) + 11) % 64) + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + data


def _zipped(random: Random, files: dict[str, bytes]) -> bytes:
    """A zip with right checksums; now and then its directory lies."""
    file = io.BytesIO()
    with zipfile.ZipFile(
        file, "w", random.choice((zipfile.ZIP_STORED, zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED))
    ) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
        if random.random() < 0.02:
            archive.writestr(*random.choice((("header.npy", b"x"), ("../out.npy", b"x"), ("extra.npy", b""))))
    data = bytearray(file.getvalue())
    if random.random() < 0.1:
        place = data.rfind(b"PK\x01\x02")
        field = random.choice((6, 8, 10, 12, 16, 20, 24, 28, 30, 32, 38, 42))
        struct.pack_into("<I", data, place + field, random.choice((0, 1, 8, 0xFFFFFFFF, 0x7FFFFFFF, 1 << 30, 1 << 20)))
    return bytes(data)


def onboard_files(world: World) -> Tools:
    from onboard_blobs import build_blobs, linear

    from semref.core.geometry.lon_lat import fit_lon_lat
    from semref.core.onboard.read import read_onboard
    from semref.core.onboard.write import write_onboard

    database = build_blobs()
    path = str(world.folder / "made.npz")
    write_onboard(path, database, fit_lon_lat(linear, database.parameters.extent))
    whole, files = Path(path).read_bytes(), _members(path)
    os.unlink(path)
    placed = Placed(world.folder, "area.npz")
    header = json.loads(files["header.npy"][10 + struct.unpack_from("<H", files["header.npy"], 8)[0] :])

    def change_member(random: Random, found: dict[str, bytes]) -> None:
        name = random.choice([name for name in found if name != "content_hash.npy"])
        data, kind = found[name], random.randrange(6)
        if kind <= 1:
            text = json.dumps(mutated_json(random, header, ([1e9] * 2, 1e-300, 10**18, [0, 0])))
            found["header.npy"] = _npy(text.encode("utf-8", "surrogatepass"))
        elif kind == 2:
            shape = random.choice(
                ("(4,)", "(2**40,)", "(0,)", "(-1,)", "()", "(1, 2)", "(4294967296, 4294967296)", "x")
            )
            found[name] = _npy(data[128:], shape, random.choice(("|u1", "<u2", "<u4", "|O", "<f8", ">u4", "|V4")))
        elif kind == 3:
            found[name] = data[:128] + mutated_bytes(random, data[128:], [b"\xff" * 8])
        elif kind == 4:
            found[name] = mutated_bytes(random, data)
        else:
            del found[name]

    def make(random: Random) -> bytes:
        if random.random() < 0.15:
            return mutated_bytes(random, whole, [b"PK\x05\x06", b"PK\x01\x02", b"PK\x03\x04"])
        found = dict(files)
        for _ in range(random.choice((1, 1, 2))):
            change_member(random, found)
        if random.random() < 0.95:
            content = hashlib.sha256(b"".join(found[name] for name in sorted(found) if name != "content_hash.npy"))
            found["content_hash.npy"] = _npy(content.digest())
        return _zipped(random, found)

    def attempt(data: bytes) -> None:
        with placed(data) as place:
            onboard = read_onboard(place)
        require_sound(onboard.database)
        require(np.isfinite([onboard.position_error, onboard.area_error, onboard.vector_error]).all(), "no errors")
        if onboard.lon_lat is not None:
            longitudes, latitudes = onboard.lon_lat(onboard.database.windows.centers)
            require(np.isfinite(longitudes).all() and np.isfinite(latitudes).all(), "no longitude and latitude")
            require((np.abs(longitudes) <= 180).all() and (np.abs(latitudes) <= 90).all(), "a place off the Earth")

    return make, attempt


class _Said(logging.Handler):
    def emit(self, record: logging.LogRecord) -> None:
        pass


def _area(world: World) -> str:
    """An onboard file and images beside the world, which stay."""
    import onboard_area

    folder = world.folder.parent / "area"
    folder.mkdir()
    onboard_area.write_area(str(folder / "area.npz"))
    cv2.imwrite(str(folder / "nothing.png"), onboard_area.NOTHING[:40, :40])
    (folder / "broken.png").write_bytes(b"\x89PNG\r\n\x1a\nbroken")
    (folder / "fleet.key").write_bytes(bytes(range(32)))
    (folder / "model.onnx").write_bytes(b"\x08\x08no model")
    return str(folder)


def _main(arguments: list[str]) -> int:
    """Runs the command line here; Broken where it has a fault or says what is no line."""
    from semref.core.onboard.command_line import main

    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code: Any = main(arguments)
        except SystemExit as ended:
            code = ended.code
    require(code in _EXIT_CODES, f"exit code {code}")
    said = err.getvalue()
    require("Traceback" not in said and '"fault"' not in said, f"a fault: {said[-1500:]}")
    if "--json" in arguments or arguments[:1] == ["watch"]:
        for line in out.getvalue().split("\n") if code in (0, 1) and "-h" not in arguments else ():
            require_record(line)
    return int(code)


def require_record(line: str) -> None:
    """Raises Broken for a line that is no JSON or has numbers that are none."""
    if not line.startswith("{"):
        return

    def refuse(name: str) -> None:
        require(False, f"a result that is {name}")

    json.loads(line, parse_constant=refuse)


def command_line(world: World) -> Tools:
    from semref.core.errors import ParameterError

    folder = _area(world)
    inside = str(world.folder)
    base = [
        ["info", f"{folder}/area.npz", "--json"],
        ["localize", f"{folder}/nothing.png", "--database", f"{folder}/area.npz", "--json", "--near", "1", "2", "3"],
        ["localize", f"{folder}/broken.png", "--database", f"{folder}/area.npz", "--method", "topology-vector"],
        ["watch", inside, "--once", "--database", f"{folder}/area.npz", "--threads", "1"],
    ]
    paths = [
        f"{folder}/{name}" for name in ("area.npz", "nothing.png", "broken.png", "fleet.key", "model.onnx", "none")
    ]
    options = ["--json", "--database", "--model", "--method", "--near", "--threads", "--fixes", "--gga", "--once", "-h"]
    options += [
        "--require-signature",
        "--log-level",
        "--",
        "-",
        "udp:1",
        "udp:99999",
        "udp:x",
        "udp:-1",
        "@x",
        "--near=1",
    ]
    methods = ["automatic", "topology-vector", "constellation", "map-correlation", "debug", "/dev/null", "/dev/full"]
    numbers = [number for number in NUMBERS if number.isascii()]

    def make(random: Random) -> list[str]:
        found = list(random.choice(base))
        for _ in range(random.choice((1, 1, 2, 3))):
            kind, place = random.randrange(6), random.randrange(len(found) + 1)
            new = random.choice((word(random), random.choice(paths), random.choice(numbers)))
            new = random.choice((new, random.choice(options), random.choice(methods)))
            if kind <= 1:
                found[place:place] = [new]
            elif kind <= 4 and place < len(found):
                found[place] = new
            elif place < len(found):
                del found[place]
        # A program's arguments have no null characters; sinks must not fill the disk with odd names.
        return [_harmless(argument, found[n - 1] if n else "") for n, argument in enumerate(found)]

    def attempt(arguments: list[str]) -> None:
        if "watch" in arguments and "--once" not in arguments:
            arguments = [*arguments, "--once"]
        if _main(arguments) in (2, 3):
            raise ParameterError("onboard.no_folder", folder="refused")

    return make, attempt


def _harmless(argument: str, before: str) -> str:
    text = argument.replace("\0", "")[:50_000]
    is_sink = before in ("--fixes", "--gga")
    return text if not is_sink or text.startswith(("udp:", "/dev/", "-")) else "/dev/null"


def watched_names(world: World) -> Tools:
    from semref.core.errors import LabelMapError

    folder = _area(world)
    picture = Path(folder, "nothing.png").read_bytes()
    watched = world.folder / "watched"
    watched.mkdir()

    def make(random: Random) -> list[tuple]:
        found = []
        for _ in range(random.choice((1, 2, 3))):
            name = random.choice((word(random).encode("utf-8", "replace"), random.randbytes(6)))
            name = name.replace(b"/", b"_").replace(b"\0", b"")[:200] + random.choice(
                (b".png", b".PNG", b".jpg", b".tif", b"")
            )
            found.append((name, random.randrange(6), random.choice((0, 1, -1, 2**31, 2**40, 2**52))))
        return found

    def attempt(made: list[tuple]) -> None:
        placed = []
        try:
            for name, kind, moment in made:
                path = os.path.join(os.fsencode(watched), name)
                with contextlib.suppress(OSError, ValueError, OverflowError):
                    _put(path, kind, picture)
                    placed.append(path)
                    os.utime(path, (moment, moment), follow_symlinks=False)
            code = _main(["watch", str(watched), "--once", "--database", f"{folder}/area.npz"])
        finally:
            for path in placed:
                with contextlib.suppress(OSError):
                    os.rmdir(path) if os.path.isdir(path) and not os.path.islink(path) else os.unlink(path)
        if code == 3:
            raise LabelMapError("labels.no_pixels")

    return make, attempt


def _put(path: bytes, kind: int, picture: bytes) -> None:
    if kind == 0:
        os.symlink(os.path.basename(path), path)
    elif kind == 1:
        os.mkfifo(path)
    elif kind == 2:
        os.mkdir(path)
    elif kind == 3:
        os.symlink(b"/dev/zero", path)
    else:
        with open(path, "wb") as file:
            file.write(picture if kind == 4 else zlib.compress(picture))


DOORS = (
    Door("onboard", "onboard files: zip, arrays, header, area", onboard_files, 20_000, 10_000),
    Door("command_line", "arguments of `python -m core`", command_line, 6_000, 5000),
    Door("watched", "names and kinds of files in a watched folder", watched_names, 500, 500),
)
