"""The command ``semref``: show an onboard file, localize images, watch a folder for new images."""

from __future__ import annotations

import argparse
import contextlib
import logging
import os
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from itertools import combinations, product
from typing import Any, Callable

import cv2

from .. import limits
from ..errors import DatabaseError, ParameterError, SemRefError, reason_of
from ..flight.settings import FLIGHT
from ..labels.image_files import image_files, is_image_name
from ..localization import LEAST_RISK, RISK, Method, Prior, Status
from ..localizer.localizer import Localizer
from ..localizer.record import error_probability
from ..localizer.search import Search
from ..localizer.settings import LOCALIZER
from ..pipeline import Pipeline
from ..segmentation.devices import AUTO, KEYS
from ..sentences import english, printable
from .cameras import open_cameras
from .flight import FlightFinder
from .format import OnboardDatabase
from .image_records import ERROR, ImageFinder, label_reader
from .log import json_line, log_event, start_log
from .mavlink import MESSAGES, MavlinkSink, split_address
from .read import read_onboard
from .sinks import check_sink, write_to_stdout
from .state_file import StateFile
from .tables import OdometryTable
from .watch import watch

ALL_FIXED, SOME_WITHOUT_FIX, WRONG_USAGE, REFUSED = range(4)
"""Exit codes; argparse itself ends with 2."""

INTERRUPTED = 130
"""Exit code of programs that Ctrl+C ended."""

FARTHEST = 1e9
"""Largest map coordinate and radius; no map on Earth has larger ones in any unit."""

_EXIT_CODES = f"""exit codes:
  {ALL_FIXED}  every image has a fix (watch: it was ended by Ctrl+C)
  {SOME_WITHOUT_FIX}  at least one image has no fix (a likely position is not a fix); the output states the reason
  {WRONG_USAGE}  the command line is wrong
  {REFUSED}  a file or image can't be used, a result can't be written, or the program failed
  {INTERRUPTED}  localize was ended by Ctrl+C"""

_EXAMPLES = """examples:
  {program} info area.npz
  {program} localize photo.png --database area.npz
  {program} localize photos/ --database area.npz --model landcover.onnx --json
  {program} watch incoming/ --database area.npz --model landcover.onnx --gga udp:10110

"""


def main(arguments: list[str] | None = None) -> int:
    """Run one command and return its exit code; a wrong command line ends the program as argparse does."""
    parser = command_parser()
    options = parser.parse_args(arguments)
    if problem := _problem(options):
        parser.error(problem)
    start_log(options.log_level)
    try:
        return options.command(options)
    except SemRefError as error:
        return _refuse(options, str(error))
    except KeyboardInterrupt:
        return ALL_FIXED if options.name == "watch" else INTERRUPTED
    except Exception as error:
        # Python itself would end with 1, which means "no fix".
        log_event(logging.ERROR, "fault", traceback=True)
        return _refuse(options, f"{type(error).__name__}: {error}")


def _refuse(options: argparse.Namespace, reason: str) -> int:
    """Print why a command ends and return the exit code."""
    # A closed or full stderr must not change the exit code.
    with contextlib.suppress(OSError):
        print(f"{options.name}: {reason}", file=sys.stderr, flush=True)
    return REFUSED


def _problem(options: argparse.Namespace) -> str | None:
    """Return the fault of a combination of valid options; None without one."""
    near, origin = getattr(options, "near", None), getattr(options, "mavlink_origin", None)
    if near and not near[2] > 0:
        return f"argument --near: the radius is {near[2]:g}; it must be more than 0 m"
    if origin and not abs(origin[0]) <= 90:
        return f"argument --mavlink-origin: the latitude is {origin[0]:g}; it must be from -90 to 90 degrees"
    for name in ("state", "odometry"):
        if getattr(options, name, None) and not options.flight:
            return f"argument --{name}: it needs --flight"
    return _problem_of_files(options)


def _problem_of_files(options: argparse.Namespace) -> str | None:
    """Return why an output cannot be written where the options say; None if all can."""
    read = ("database", "model", "require_signature", "cameras", "flight_log", "odometry")
    written = ("state", "fixes", "gga")
    inputs, outputs = ([getattr(options, name, None) for name in names] for names in (read, written))
    for output, path in product(outputs, inputs):
        if output and path and os.path.exists(output) and os.path.exists(path) and os.path.samefile(output, path):
            return f"{output} is an input of this command; write to another file"
    for output, other in combinations(filter(None, outputs), 2):
        if output != "-" and os.path.realpath(output) == os.path.realpath(other):
            return f"{other} is given for two outputs; write to a different file for each"
    for output in filter(None, outputs):
        if is_image_name(os.path.basename(output)):
            return f"{output} has the name of an image; write to another file"
    return None


def _number(least: float, most: float, kind: type = float) -> Callable[[str], float]:
    """Return an argparse type: a number from ``least`` to ``most``, both included."""

    def number(text: str) -> float:
        value = kind(text)
        if not least <= value <= most:
            raise argparse.ArgumentTypeError(f"{text} is not a number from {least:g} to {most:g}")
        return value

    return number


def _place(check: Callable[[str], object]) -> Callable[[str], str]:
    """Return an argparse type: a text that ``check`` accepts, which raises ParameterError for any other."""

    def place(text: str) -> str:
        try:
            check(text)
        except ParameterError as error:
            raise argparse.ArgumentTypeError(str(error)) from None
        return text

    return place


def _write(text: str) -> None:
    """Write a line to stdout, with escapes for bytes that are not text; raises ParameterError if that fails."""
    try:
        write_to_stdout(f"{text}\n")
    except OSError as error:
        raise ParameterError(
            "{where} can't be written: {reason}. Choose another output.", where="stdout", reason=reason_of(error)
        ) from None


class _Parser(argparse.ArgumentParser):
    def print_help(self, file: object = None) -> None:
        try:
            _write(self.format_help().rstrip("\n"))
        except ParameterError as error:
            self.exit(REFUSED, f"{self.prog}: {error}\n")


def command_parser() -> argparse.ArgumentParser:
    """Return the parser of all commands and options."""
    raw = argparse.RawDescriptionHelpFormatter
    program = "python -m core" if os.path.basename(sys.argv[0]) == "__main__.py" else "semref"
    parser = _Parser(
        prog=program,
        description="Find where aerial images were taken. Needs a file made by “Export for onboard use” of SemRef.",
        epilog=_EXAMPLES.format(program=program) + _EXIT_CODES,
        formatter_class=raw,
    )
    commands = parser.add_subparsers(dest="name", required=True, metavar="command")
    info = commands.add_parser(
        "info", help="show what an onboard file contains", epilog=_EXIT_CODES, formatter_class=raw
    )
    info.add_argument("database", metavar="DATABASE", help="onboard file (.npz)")
    info.add_argument("--json", action="store_true", help="write JSON")
    info.set_defaults(command=_info)
    localize = commands.add_parser("localize", help="localize images", epilog=_EXIT_CODES, formatter_class=raw)
    localize.add_argument("images", nargs="+", metavar="IMAGE", help="image, or folder of images")
    localize.add_argument("--json", action="store_true", help="write one line of JSON for each image")
    localize.set_defaults(command=_localize)
    watch = commands.add_parser(
        "watch", help="localize images when they arrive in a folder", epilog=_EXIT_CODES, formatter_class=raw
    )
    _add_watch(watch)
    watch.set_defaults(command=_watch)
    for command in (localize, watch):
        _add_localization(command)
    for command in (info, localize, watch):
        text = "use DATABASE only if it was signed with this key at the export"
        command.add_argument("--require-signature", metavar="KEYFILE", help=text)
        levels = ("debug", "info", "warning", "error")
        text = "least severe level of the log, which is JSON lines on stderr (default: warning)"
        command.add_argument("--log-level", choices=levels, default="warning", help=text)
    return parser


def _add_localization(command: argparse.ArgumentParser) -> None:
    """Add the options of ``localize`` and ``watch``."""
    command.add_argument("--database", required=True, help="onboard file (.npz)")
    command.add_argument("--model", help="model (.onnx) for photos; without it, the images are label images")
    names = [_option(method) for method in Method]
    command.add_argument("--method", choices=names, default=names[0], help=f"localization method (default: {names[0]})")
    text = "camera table (CSV): roll, pitch, lens, height, heading; watch reads rows added during the flight"
    command.add_argument("--cameras", metavar="TABLE", help=text)
    text = (
        "flight log (.bin, .ulg, .tlog, .SRT, geo.txt): heading, height, attitude, speed; "
        "watch follows a growing .tlog and reads other logs once"
    )
    command.add_argument("--flight-log", metavar="FILE", help=text)
    number, near = _number(-FARTHEST, FARTHEST), ("X", "Y", "RADIUS")
    command.add_argument("--near", nargs=3, type=number, metavar=near, help="search area: map coordinates and m")
    number = _number(LEAST_RISK, limits.RISK)
    text = f"maximum error probability of a fix (default: {RISK:g}, 1 in {1 / RISK:,.0f})"
    command.add_argument("--risk", type=number, default=RISK, help=text)
    text = "direction of the sun, degrees clockwise from grid north; for a model whose class offsets turn with it"
    command.add_argument("--sun", type=_number(0, 360), metavar="DEG", help=text)
    number, text = _number(1, limits.THREADS, int), "threads of OpenCV and the model (default: 1)"
    command.add_argument("--threads", type=number, default=1, metavar="N", help=text)
    text = f"device of the model (default: {AUTO}, the first one that works)"
    command.add_argument("--device", choices=KEYS, default=AUTO, help=text)


def _add_watch(watch: argparse.ArgumentParser) -> None:
    watch.add_argument("folder", metavar="FOLDER", help="folder where the camera stores images")
    where = "a file to append to, “-” for stdout, or udp:PORT on this computer (127.0.0.1)"
    place, text = _place(check_sink), f"JSON lines: {where} (default: stdout)"
    watch.add_argument("--fixes", type=place, metavar="WHERE", default="-", help=text)
    watch.add_argument("--gga", type=place, metavar="WHERE", help=f"NMEA GGA sentences: {where}")
    where = "udp:PORT of this computer, udp:HOST:PORT, or serial:DEVICE[:BAUD]"
    text = f"positions for an autopilot (needs pymavlink): {where}"
    watch.add_argument("--mavlink", type=_place(split_address), metavar="WHERE", help=text)
    text = f"MAVLink message of a position (default: {MESSAGES[0]})"
    watch.add_argument("--mavlink-as", choices=MESSAGES, default=MESSAGES[0], help=text)
    number, text = _number(1, limits.SYSTEMS, int), "system number of the aircraft (default: 1)"
    watch.add_argument("--mavlink-system", type=number, default=1, metavar="N", help=text)
    text = "origin of the autopilot, degrees; without it, the autopilot receives the center of the map as its origin"
    watch.add_argument("--mavlink-origin", nargs=2, type=_number(-180, 180), metavar=("LAT", "LON"), help=text)
    text = "direction of the image's top, degrees clockwise from the aircraft's nose (default: 0)"
    watch.add_argument("--camera-yaw", type=_number(-360, 360), default=0.0, metavar="DEG", help=text)
    text = "treat the images as one flight: each fix uses all images up to it"
    watch.add_argument("--flight", action="store_true", help=text)
    text = "with --flight: store the flight in this file and continue it after a restart"
    watch.add_argument("--state", metavar="FILE", help=text)
    text = "with --flight: motion from image to image (CSV); rows may be added during the flight"
    watch.add_argument("--odometry", metavar="TABLE", help=text)
    watch.add_argument("--once", action="store_true", help="localize the images in the folder, then end")


def _option(method: Method) -> str:
    return method.key.replace(" ", "-")


# --- info ---


def _info(options: argparse.Namespace) -> int:
    found = description(read_onboard(options.database, key_file=options.require_signature))
    if options.json:
        _write(json_line(found))
    else:
        for name, value in found.items():
            _write(printable(f"{name + ':':24}{value}"))
    return ALL_FIXED


def description(onboard: OnboardDatabase) -> dict[str, Any]:
    """Return the contents of an onboard file in a few lines."""
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
        "exported": _date(onboard),
        "signature": onboard.signature.value,
        "plugin_version": parameters.plugin_version,
    }


def _date(onboard: OnboardDatabase) -> str:
    return "not recorded" if onboard.exported is None else onboard.exported.isoformat()


# --- localize ---


def _localize(options: argparse.Namespace) -> int:
    onboard = read_onboard(options.database, key_file=options.require_signature)
    find = _image_finder(options, onboard, looks_again=True)
    statuses = set()
    for path in image_files(options.images):
        found = find(path)
        _write(json_line(found) if options.json else printable(_line(found)))
        statuses.add(found["status"])
    return exit_code(statuses)


def exit_code(statuses: set[str]) -> int:
    """Return the exit code for the statuses of records."""
    if ERROR in statuses:
        return REFUSED
    return ALL_FIXED if statuses <= {Status.FIX.key} else SOME_WITHOUT_FIX


def _image_finder(options: argparse.Namespace, onboard: OnboardDatabase, looks_again: bool) -> ImageFinder:
    """Return how to localize according to the options; everything that can be refused is refused here.

    Args:
        looks_again: As for ``Pipeline``.
    """
    cv2.setNumThreads(options.threads)
    method = next(method for method in Method if _option(method) == options.method)
    localizer = Localizer(onboard.database, replace(LOCALIZER, allowed_risk=options.risk), options.sun)
    if method == Method.MAP_CORRELATION and not localizer.has_overview:
        raise DatabaseError(
            "{database} has no overview, which map correlation needs. Export it with the overview.",
            database=options.database,
        )
    prior = Prior(tuple(options.near[:2]), options.near[2]) if options.near else Prior()
    localizer.check(method, prior)
    read_labels = label_reader(options.model, options.threads, onboard.database.class_table, options.device)
    log_event(
        logging.INFO,
        "ready",
        database=options.database,
        content_hash=onboard.content_hash,
        exported=_date(onboard),
        signature=onboard.signature.value,
    )
    # During a watch, tables may still grow; a restart during the flight must not fail because of a table.
    is_ended = getattr(options, "once", True)
    cameras = open_cameras(options.cameras, options.flight_log, is_ended, not _is_restart(options))
    return ImageFinder(onboard, Pipeline(localizer, Search(method, prior), read_labels, looks_again), cameras)


def _is_restart(options: argparse.Namespace) -> bool:
    """Return whether a flight continues from a state."""
    return os.path.exists(getattr(options, "state", None) or "")


def _line(found: dict[str, Any]) -> str:
    if found.get("x") is None:
        return f"{found['image']}: {found['status']}. {found['reason']}"
    units = (
        ("longitude", "longitude {:.7f}"),
        ("latitude", "latitude {:.7f}"),
        ("heading", "heading {:.1f}°"),
        ("pixel_size", "pixel size {:.3g} m"),
        ("error_95", "95 % radius {:.2f} m"),
        ("window", "window {}"),
        ("distance", "distance {:.4f}"),
    )
    texts = [text.format(found[name]) for name, text in units if found.get(name) is not None]
    if found["distance"] is not None:
        texts.append(f"confidence {found['confidence']:.2f}")
    else:
        texts.append(f"error probability {error_probability(found['confidence'])}")
    text = f"{found['image']}: {found['status']}, {found['x']:.2f} {found['y']:.2f}, {', '.join(texts)}"
    return text if found["status"] == Status.FIX else f"{text}. {found['reason']}"


# --- watch ---


def _watch(options: argparse.Namespace) -> int:
    if not os.path.isdir(options.folder):
        raise ParameterError(
            "The folder {folder} does not exist. Create it or watch another one.", folder=options.folder
        )
    onboard = read_onboard(options.database, key_file=options.require_signature)
    is_restart = _is_restart(options)
    # In flight the next image comes before a second look would end.
    find: ImageFinder = _image_finder(options, onboard, looks_again=False)
    after, writer = None, ThreadPoolExecutor(1)
    if options.flight:
        if not find.pipeline.localizer.has_overview:
            raise DatabaseError(
                "{database} has no overview, which flights need. Export it with the overview.",
                database=options.database,
            )
        settings = replace(FLIGHT, allowed_risk=options.risk)
        odometry = OdometryTable(options.odometry, options.once) if options.odometry else None
        if odometry is not None and not is_restart:
            odometry.check()
        state = StateFile.at(options.state, options.require_signature) if options.state else None
        find = FlightFinder(**vars(find), state=state, writer=writer, settings=settings, odometry=odometry)
        after = find.start()
    if (options.gga or options.mavlink) and onboard.lon_lat is None:
        raise DatabaseError(
            "{database} contains no longitude and latitude, which GGA sentences and MAVLink need.",
            database=options.database,
        )
    # The last state is complete before the program ends.
    with writer:
        statuses, lost = watch(
            options.folder, options.once, find, options.fixes, options.gga, _mavlink_sink(options, onboard), after
        )
    return REFUSED if lost else exit_code(statuses)


def _mavlink_sink(options: argparse.Namespace, onboard: OnboardDatabase) -> MavlinkSink | None:
    """Return the output to an autopilot; None without one."""
    if not options.mavlink or onboard.lon_lat is None:
        return None
    origin = tuple(options.mavlink_origin) if options.mavlink_origin else None
    sent = options.mavlink_as, options.mavlink_system, origin, options.camera_yaw
    return MavlinkSink(options.mavlink, onboard.lon_lat, *sent)
