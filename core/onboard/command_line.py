"""What ``python -m core`` does: tell what an onboard file holds, localize images, watch a folder for new ones."""

from __future__ import annotations

import argparse
import contextlib
import json
import logging
import os
import socket
import sys
import time
from collections.abc import Iterator
from datetime import datetime, timezone
from typing import Any, Callable, NoReturn, TextIO

import cv2
import numpy as np

from ..errors import DatabaseError, ParameterError, SemRefError
from ..labels.class_table import ClassTable
from ..labels.image_files import image_files, is_image_name, read_label_image, read_photo
from ..localization import Method, Prior, Status
from ..localizer.localizer import Localizer
from ..localizer.record import gga_sentence, record
from ..sentences import english
from .format import OnboardDatabase
from .read import read_onboard

ALL_FIXED, SOME_WITHOUT_FIX, WRONG_USAGE, REFUSED = range(4)
"""Exit codes; argparse ends with 2 by itself."""

ERROR = "error"
"""Status of an image that could not be read, as in the plugin."""

LOOK_EVERY_S = 0.2
"""How often a folder is looked into; an image is taken when it has not changed from one look to the next."""

LOOPBACK = "127.0.0.1"

_LOG = logging.getLogger("semref")

_EXIT_CODES = f"""exit codes:
  {ALL_FIXED}  every image has a fix (watch: it was ended)
  {SOME_WITHOUT_FIX}  an image has none, its reason is told
  {WRONG_USAGE}  the command line is wrong
  {REFUSED}  a file could not be used, or an image could not be read"""

_EXAMPLES = """examples:
  python -m core info area.npz
  python -m core localize photo.png --database area.npz
  python -m core localize photos/ --database area.npz --model landcover.onnx --json
  python -m core watch incoming/ --database area.npz --model landcover.onnx --gga udp:10110

"""


def main(arguments: list[str] | None = None) -> int:
    """Runs one command; gives its exit code."""
    options = _parser().parse_args(arguments)
    _start_log(options.log_level)
    try:
        return options.command(options)
    except SemRefError as error:
        print(f"{options.name}: {error}", file=sys.stderr)
        return REFUSED
    except KeyboardInterrupt:
        return ALL_FIXED if options.name == "watch" else SOME_WITHOUT_FIX


def _parser() -> argparse.ArgumentParser:
    raw = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(
        prog="python -m core",
        description="Finds where aerial images were taken, with a file made by SemRef's “Export for onboard use”.",
        epilog=_EXAMPLES + _EXIT_CODES,
        formatter_class=raw,
    )
    commands = parser.add_subparsers(dest="name", required=True, metavar="command")
    info = commands.add_parser("info", help="what an onboard file holds", epilog=_EXIT_CODES, formatter_class=raw)
    info.add_argument("database", metavar="DATABASE", help="onboard file (.npz)")
    info.add_argument("--json", action="store_true", help="as JSON")
    info.set_defaults(command=_info)
    localize = commands.add_parser("localize", help="localize images", epilog=_EXIT_CODES, formatter_class=raw)
    localize.add_argument("images", nargs="+", metavar="IMAGE", help="image, or folder with images")
    localize.add_argument("--json", action="store_true", help="one JSON object a line and image")
    localize.set_defaults(command=_localize)
    watch = commands.add_parser(
        "watch", help="localize the images of a folder as they come", epilog=_EXIT_CODES, formatter_class=raw
    )
    watch.add_argument("folder", metavar="FOLDER", help="folder that images are written into")
    where = "a file to append to, “-” for stdout, or udp:PORT on this computer (127.0.0.1)"
    watch.add_argument("--fixes", metavar="WHERE", default="-", help=f"JSON lines: {where} (default: stdout)")
    watch.add_argument("--gga", metavar="WHERE", help=f"NMEA GGA sentences: {where}")
    watch.add_argument("--once", action="store_true", help="end when the images that are there are done")
    watch.set_defaults(command=_watch)
    for command in (localize, watch):
        command.add_argument("--database", required=True, help="onboard file (.npz)")
        command.add_argument("--model", help="segmentation network (.onnx): the images are photos, not label images")
        names = [_option(method) for method in Method]
        command.add_argument("--method", choices=names, default=names[0], help=f"default: {names[0]}")
        near = ("X", "Y", "RADIUS")
        command.add_argument("--near", nargs=3, type=float, metavar=near, help="search there only, map units")
        command.add_argument("--threads", type=int, default=1, help="for OpenCV and the network (default: 1)")
    for command in (info, localize, watch):
        levels = ("debug", "info", "warning", "error")
        text = "least severe of the JSON lines of the log on stderr (default: warning)"
        command.add_argument("--log-level", choices=levels, default="warning", help=text)
    return parser


def _option(method: Method) -> str:
    return method.key.replace(" ", "-")


# --- info ---


def _info(options: argparse.Namespace) -> int:
    found = description(read_onboard(options.database))
    if options.json:
        print(json.dumps(found, ensure_ascii=False))
    else:
        for name, value in found.items():
            print(f"{name + ':':24}{value}")
    return ALL_FIXED


def description(onboard: OnboardDatabase) -> dict[str, Any]:
    """What an onboard file holds, in a few lines."""
    database, parameters = onboard.database, onboard.database.parameters
    overview = database.overview
    return {
        "file": database.source,
        "bytes": onboard.size_bytes,
        "windows": len(database.windows),
        "references": len(database.references),
        "overview": "none" if overview is None else f"{overview.shape[1]} × {overview.shape[0]} pixels",
        "classes": english(database.class_table.describe()),
        "reference_classes": ", ".join(c.name for c in database.class_table.references),
        "crs": parameters.crs.split('"')[1] if '"' in parameters.crs else parameters.crs,
        "extent": list(parameters.extent),
        "pixel_size": parameters.pixel_size,
        "window_size": parameters.window_size,
        "levels": list(parameters.levels),
        "position_error": onboard.position_error,
        "area_error": onboard.area_error,
        "vector_error": onboard.vector_error,
        "lon_lat_error_m": None if onboard.lon_lat is None else onboard.lon_lat.error_m,
        "map_hash": parameters.map_hash,
        "class_table_hash": parameters.class_table_hash,
        "content_hash": onboard.content_hash,
        "plugin_version": parameters.plugin_version,
    }


# --- localize ---


def _localize(options: argparse.Namespace) -> int:
    find = _finder(options, read_onboard(options.database))
    records = []
    for path in image_files(options.images):
        found = find(path)
        print(json.dumps(found, ensure_ascii=False) if options.json else _line(found), flush=True)
        records.append(found)
    return _exit_code(records)


def _exit_code(records: list[dict[str, Any]]) -> int:
    statuses = {found["status"] for found in records}
    if ERROR in statuses:
        return REFUSED
    return ALL_FIXED if statuses <= {Status.FIX.key} else SOME_WITHOUT_FIX


def _finder(options: argparse.Namespace, onboard: OnboardDatabase) -> Callable[[str], dict[str, Any]]:
    """The function path → record that the options ask for; everything that can be refused is refused here."""
    if options.threads < 1:
        raise ParameterError("onboard.threads", threads=options.threads)
    cv2.setNumThreads(options.threads)
    if options.near and not options.near[2] > 0:
        raise ParameterError("onboard.near_radius", radius=options.near[2])
    method = next(method for method in Method if _option(method) == options.method)
    localizer = Localizer(onboard.database)
    localizer.check(method)
    if method == Method.MAP_CORRELATION and not localizer.has_overview:
        raise DatabaseError("onboard.no_overview", database=options.database)
    prior = Prior(tuple(options.near[:2]), options.near[2]) if options.near else Prior()
    read_labels = label_reader(options.model, options.threads, onboard.database.class_table)
    _say(logging.INFO, "ready", database=options.database, content_hash=onboard.content_hash)

    def find(path: str) -> dict[str, Any]:
        started = time.perf_counter()
        found: dict[str, Any] = {"image": path, "time": None}
        try:
            found["time"] = _time_of(path).isoformat()
            labels_hw = read_labels(path)
            result = localizer.localize(labels_hw, method, prior)
            found.update(record(result))
            if result.position is not None and onboard.lon_lat is not None:
                longitudes, latitudes = onboard.lon_lat(np.array([result.position]))
                found.update(longitude=float(longitudes[0]), latitude=float(latitudes[0]))
        except SemRefError as error:
            # One bad image must not stop the others.
            found.update(status=ERROR, reason=str(error))
        level = logging.WARNING if found["status"] == ERROR else logging.INFO
        seconds = round(time.perf_counter() - started, 3)
        _say(level, "image", image=path, status=found["status"], reason=found["reason"], seconds=seconds)
        return found

    return find


def label_reader(model_path: str | None, threads: int, table: ClassTable) -> Callable[[str], np.ndarray]:
    """The function path → labels: of label images, or with a model of photos."""
    if not model_path:
        return lambda path: read_label_image(path, table)
    # onnxruntime is needed for photos only.
    from ..segmentation.model import SegmentationModel
    from ..segmentation.photo_labels import PhotoLabels

    model = SegmentationModel(model_path, threads)
    values = model.classes.values_in(table, model_path)

    def labels_of(path: str) -> np.ndarray:
        photo = read_photo(path)
        return PhotoLabels(model, photo.image, values, photo.pixel_size_m).found()

    return labels_of


def _time_of(path: str) -> datetime:
    """When an image was written, which a camera does when it was taken."""
    try:
        return datetime.fromtimestamp(os.stat(path).st_mtime, timezone.utc)
    except OSError as error:
        raise ParameterError("labels.image_unreadable", path=path, reason=error.strerror) from None


def _line(found: dict[str, Any]) -> str:
    """A record for people."""
    if found.get("x") is None:
        return f"{found['image']}: {found['status']}. {found['reason']}"
    units = (
        ("longitude", "longitude {:.7f}"),
        ("latitude", "latitude {:.7f}"),
        ("heading", "heading {:.1f}°"),
        ("pixel_size", "pixel size {:.3g} m"),
        ("error_95", "within {:.2f} m (95 %)"),
        ("window", "window {}"),
        ("distance", "distance {:.4f}"),
        ("confidence", "confidence {:.2f}"),
    )
    texts = [text.format(found[name]) for name, text in units if found.get(name) is not None]
    return f"{found['image']}: {found['status']}, {found['x']:.2f} {found['y']:.2f}, {', '.join(texts)}"


# --- watch ---


def _watch(options: argparse.Namespace) -> int:
    if not os.path.isdir(options.folder):
        raise ParameterError("onboard.no_folder", folder=options.folder)
    onboard = read_onboard(options.database)
    find = _finder(options, onboard)
    if options.gga and onboard.lon_lat is None:
        raise DatabaseError("onboard.no_lon_lat", database=options.database)
    records = []
    with _destination(options.fixes) as send_fix, _destination(options.gga) as send_gga:
        for path in _arriving(options.folder, options.once):
            found = find(path)
            send_fix(json.dumps(found, ensure_ascii=False) + "\n")
            send_gga(_gga(found) + "\r\n")
            if options.once:
                records.append(found)
    return _exit_code(records)


def _gga(found: dict[str, Any]) -> str:
    taken = datetime.fromisoformat(found["time"]) if found["time"] else datetime.now(timezone.utc)
    return gga_sentence(taken, found.get("longitude"), found.get("latitude"), found.get("inliers") or 0)


def _arriving(folder: str, once: bool) -> Iterator[str]:
    """Images of a folder, each when it is complete, in order of time and name; one that is written anew comes again."""
    before: dict[str, tuple[int, int]] = {}
    done: dict[str, tuple[int, int]] = {}
    while True:
        now = _images_in(folder)
        complete = [path for path, state in now.items() if done.get(path) != state]
        if not once:
            complete = [path for path in complete if before.get(path) == now[path] and now[path][1] > 0]
        for path in sorted(complete, key=lambda path: (now[path][0], path)):
            done[path] = now[path]
            yield path
        if once:
            return
        before = now
        time.sleep(LOOK_EVERY_S)


def _images_in(folder: str) -> dict[str, tuple[int, int]]:
    """(time of change in ns, bytes) of each image by path."""
    try:
        with os.scandir(folder) as entries:
            found = {entry.path: entry.stat() for entry in entries if is_image_name(entry.name) and entry.is_file()}
    except FileNotFoundError:
        # An image was removed between being listed and being looked at: the next look sees the rest.
        return {} if os.path.isdir(folder) else _folder_is_gone(folder)
    return {path: (state.st_mtime_ns, state.st_size) for path, state in found.items()}


def _folder_is_gone(folder: str) -> NoReturn:
    raise ParameterError("onboard.folder_gone", folder=folder)


@contextlib.contextmanager
def _destination(where: str | None) -> Iterator[Callable[[str], object]]:
    """Gives a function that sends one line there: nowhere, stdout, a file, a UDP port of this computer."""
    if where is None:
        yield lambda line: None
    elif where == "-":
        yield lambda line: print(line, end="", flush=True)
    elif where.startswith("udp:"):
        port = _port(where)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            yield lambda line: sender.sendto(line.encode("utf-8"), (LOOPBACK, port))
    else:
        with _opened(where) as file:
            yield lambda line: print(line, end="", file=file, flush=True)


def _opened(where: str) -> TextIO:
    try:
        return open(where, "a", encoding="utf-8", newline="")
    except OSError as error:
        raise ParameterError("onboard.unwritable", where=where, reason=error.strerror) from None


def _port(where: str) -> int:
    text = where[len("udp:") :]
    if not text.isdecimal() or not 0 < int(text) < 65_536:
        raise ParameterError("onboard.no_udp_port", where=where)
    return int(text)


# --- log ---


def _say(level: int, event: str, **details: object) -> None:
    _LOG.log(level, event, extra={"details": details})


class _JsonLines(logging.Formatter):
    def format(self, entry: logging.LogRecord) -> str:
        """One JSON object: time, level, event and its details."""
        moment = datetime.fromtimestamp(entry.created, timezone.utc).isoformat(timespec="milliseconds")
        found = {"time": moment, "level": entry.levelname.lower(), "event": entry.getMessage()}
        return json.dumps({**found, **getattr(entry, "details", {})}, ensure_ascii=False)


def _start_log(level: str) -> None:
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(_JsonLines())
    _LOG.handlers = [handler]
    _LOG.setLevel(level.upper())
