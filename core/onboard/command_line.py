"""What the command ``semref`` does: tell what an onboard file holds, localize images, watch a folder for new ones."""

from __future__ import annotations

import argparse
import contextlib
import logging
import math
import os
import sys
from dataclasses import replace
from typing import Any

import cv2

from .. import limits
from ..errors import DatabaseError, ParameterError, SemRefError, reason_of
from ..flight.settings import FLIGHT
from ..labels.image_files import image_files
from ..localization import LEAST_RISK, RISK, Method, Prior, Status
from ..localizer.localizer import Localizer
from ..localizer.record import error_probability
from ..localizer.search import Search
from ..localizer.settings import LOCALIZER
from ..pipeline import Pipeline
from ..segmentation.devices import AUTO, KEYS
from ..sentences import english
from .cameras import opened_cameras
from .flight import FlightFinding
from .format import OnboardDatabase
from .image_records import ERROR, FinderSettings, label_reader
from .log import json_line, say, start_log
from .mavlink import MESSAGES, MavlinkOptions, MavlinkSink, check_place
from .read import read_onboard
from .sinks import is_udp, udp_port
from .state_file import StateFile
from .tables import opened_odometry
from .watch import watch

ALL_FIXED, SOME_WITHOUT_FIX, WRONG_USAGE, REFUSED = range(4)
"""Exit codes; argparse ends with 2 by itself."""

INTERRUPTED = 130
"""As of any program that was ended by Ctrl+C."""

FARTHEST = 1e9
"""Map coordinates and radii beyond are no place on Earth, in any unit of a map."""

_EXIT_CODES = f"""exit codes:
  {ALL_FIXED}  every image has a fix (watch: it was ended)
  {SOME_WITHOUT_FIX}  an image has none, its reason is told
  {WRONG_USAGE}  the command line is wrong
  {REFUSED}  a file could not be used, an image not be read, a result not be written, or the program has a fault
  {INTERRUPTED}  localize was ended by Ctrl+C"""

_EXAMPLES = """examples:
  {program} info area.npz
  {program} localize photo.png --database area.npz
  {program} localize photos/ --database area.npz --model landcover.onnx --json
  {program} watch incoming/ --database area.npz --model landcover.onnx --gga udp:10110

"""


def main(arguments: list[str] | None = None) -> int:
    """Runs one command; gives its exit code."""
    options = _parser().parse_args(arguments)
    start_log(options.log_level)
    try:
        _check_values(options)
    except ParameterError as error:
        return _ended(options, str(error), WRONG_USAGE)
    try:
        return options.command(options)
    except SemRefError as error:
        return _ended(options, str(error), REFUSED)
    except KeyboardInterrupt:
        return ALL_FIXED if options.name == "watch" else INTERRUPTED
    except Exception as error:
        # Python itself would end with 1, which means “no fix”.
        say(logging.ERROR, "fault", traceback=True)
        return _ended(options, f"{type(error).__name__}: {error}", REFUSED)


def _ended(options: argparse.Namespace, sentence: str, code: int) -> int:
    """Says why a command ends; gives the exit code."""
    # A closed or full stderr must not change the exit code.
    with contextlib.suppress(OSError):
        print(f"{options.name}: {sentence}", file=sys.stderr, flush=True)
    return code


def _check_values(options: argparse.Namespace) -> None:
    """Refuses values of options that are out of range, before any work; raises ParameterError."""
    threads, near = getattr(options, "threads", 1), getattr(options, "near", None)
    if not 1 <= threads <= limits.THREADS:
        raise ParameterError(
            "--threads is {threads}; it must be from 1 to {most}.", threads=threads, most=limits.THREADS
        )
    if near and not all(math.isfinite(value) and abs(value) <= FARTHEST for value in near):
        raise ParameterError(
            "--near is {near}; it must be three numbers up to {most:g}.",
            near=" ".join(f"{value:g}" for value in near),
            most=FARTHEST,
        )
    risk = getattr(options, "risk", RISK)
    if not LEAST_RISK <= risk <= limits.RISK:
        raise ParameterError(
            "--risk is {risk:g}; it must be a probability from {least:g} to {most:g}.",
            risk=risk,
            least=LEAST_RISK,
            most=limits.RISK,
        )
    sun = getattr(options, "sun", None)
    if sun is not None and not 0 <= sun <= 360:
        raise ParameterError("--sun is {sun:g}; it must be a direction from 0 to 360 degrees.", sun=sun)
    if near and not near[2] > 0:
        raise ParameterError("The radius of --near is {radius:g}; it must be more than 0 map units.", radius=near[2])
    for where in (getattr(options, "fixes", None), getattr(options, "gga", None)):
        if is_udp(where):
            udp_port(str(where))
    _check_apart(options)
    if getattr(options, "mavlink", None):
        _check_mavlink(options)


def _check_apart(options: argparse.Namespace) -> None:
    """Refuses to write into a file that is read; raises ParameterError."""
    names = ("database", "model", "require_signature", "cameras", "flight_log", "odometry")
    read = [getattr(options, name, None) for name in names]
    for where in (getattr(options, name, None) for name in ("state", "fixes", "gga")):
        for path in read:
            if where and path and os.path.exists(where) and os.path.exists(path) and os.path.samefile(where, path):
                raise ParameterError(
                    "{where} can't be written: {reason}; choose another place.",
                    where=where,
                    reason="it is read as well",
                )


def _check_mavlink(options: argparse.Namespace) -> None:
    """Refuses what can't be said to an autopilot; raises ParameterError."""
    check_place(options.mavlink)
    if not 1 <= options.mavlink_system <= limits.SYSTEMS:
        raise ParameterError(
            "--mavlink-system is {system}; it must be from 1 to {most}.",
            system=options.mavlink_system,
            most=limits.SYSTEMS,
        )
    if options.mavlink_origin is not None:
        latitude, longitude = options.mavlink_origin
        if not (abs(latitude) <= 90 and abs(longitude) <= 180):
            raise ParameterError(
                "--mavlink-origin is {latitude:g} {longitude:g}; it must be a latitude and a longitude in degrees.",
                latitude=latitude,
                longitude=longitude,
            )
    if not abs(options.camera_yaw) <= 360:
        raise ParameterError(
            "--camera-yaw is {yaw:g}; it must be an angle of at most 360 degrees.", yaw=options.camera_yaw
        )


def _write(text: str) -> None:
    """Writes a line to stdout; a name's bytes that are no text are escaped. Raises ParameterError when it can't."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    try:
        print(text.encode(encoding, "backslashreplace").decode(encoding), flush=True)
    except OSError as error:
        raise ParameterError(
            "{where} can't be written: {reason}; choose another place.", where="stdout", reason=reason_of(error)
        ) from None


def _parser() -> argparse.ArgumentParser:
    raw = argparse.RawDescriptionHelpFormatter
    program = "python -m core" if os.path.basename(sys.argv[0]) == "__main__.py" else "semref"
    parser = argparse.ArgumentParser(
        prog=program,
        description="Finds where aerial images were taken, with a file made by SemRef's “Export for onboard use”.",
        epilog=_EXAMPLES.format(program=program) + _EXIT_CODES,
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
    _add_mavlink(watch)
    text = "the images are of one flight: each gets the best estimate of all up to it"
    watch.add_argument("--flight", action="store_true", help=text)
    text = "with --flight: keeps the flight in this file and goes on from it after a restart"
    watch.add_argument("--state", metavar="FILE", help=text)
    text = "with --flight: motion from image to image (CSV); it may grow, a line an image"
    watch.add_argument("--odometry", metavar="TABLE", help=text)
    watch.add_argument("--once", action="store_true", help="end when the images that are there are done")
    watch.set_defaults(command=_watch)
    for command in (localize, watch):
        command.add_argument("--database", required=True, help="onboard file (.npz)")
        command.add_argument("--model", help="segmentation network (.onnx): the images are photos, not label images")
        names = [_option(method) for method in Method]
        command.add_argument("--method", choices=names, default=names[0], help=f"default: {names[0]}")
        near = ("X", "Y", "RADIUS")
        _add_cameras(command)
        command.add_argument("--near", nargs=3, type=float, metavar=near, help="search there only, map units")
        risk = f"probability of being wrong up to which a place is a fix (default: {RISK:g}, once in {1 / RISK:,.0f})"
        command.add_argument("--risk", type=float, default=RISK, help=risk)
        sun = "direction of the sun, degrees clockwise from grid north: biases of the model turn with it"
        command.add_argument("--sun", type=float, metavar="DEG", help=sun)
        command.add_argument("--threads", type=int, default=1, help="for OpenCV and the network (default: 1)")
        text = f"what the network runs on (default: {AUTO}, the first that is there and starts)"
        command.add_argument("--device", choices=KEYS, default=AUTO, help=text)
    for command in (info, localize, watch):
        text = "take DATABASE only if it was signed with this key when it was exported"
        command.add_argument("--require-signature", metavar="KEYFILE", help=text)
        levels = ("debug", "info", "warning", "error")
        text = "least severe of the JSON lines of the log on stderr (default: warning)"
        command.add_argument("--log-level", choices=levels, default="warning", help=text)
    return parser


def _add_cameras(command: argparse.ArgumentParser) -> None:
    text = "camera table (CSV) of roll, pitch, lens, height, heading; with watch it may grow, a line an image"
    command.add_argument("--cameras", metavar="TABLE", help=text)
    text = (
        "log of the flight (.bin, .ulg, .tlog, .SRT, geo.txt): heading, height, attitude, speed; "
        "with watch a .tlog may grow, others are read at the start"
    )
    command.add_argument("--flight-log", metavar="FILE", help=text)


def _add_mavlink(watch: argparse.ArgumentParser) -> None:
    where = "udp:PORT of this computer, udp:HOST:PORT, or serial:DEVICE[:BAUD]"
    watch.add_argument("--mavlink", metavar="WHERE", help=f"positions for an autopilot (needs pymavlink): {where}")
    text = f"message that a position is sent as (default: {MESSAGES[0]})"
    watch.add_argument("--mavlink-as", choices=MESSAGES, default=MESSAGES[0], help=text)
    watch.add_argument("--mavlink-system", type=int, default=1, metavar="N", help="number of the aircraft (default: 1)")
    text = "the autopilot's own origin, degrees; without it, it is told the middle of the map"
    watch.add_argument("--mavlink-origin", nargs=2, type=float, metavar=("LAT", "LON"), help=text)
    text = "where the image's top points to, degrees clockwise from the aircraft's nose (default: 0)"
    watch.add_argument("--camera-yaw", type=float, default=0.0, metavar="DEG", help=text)


def _option(method: Method) -> str:
    return method.key.replace(" ", "-")


# --- info ---


def _info(options: argparse.Namespace) -> int:
    found = description(read_onboard(options.database, key_file=options.require_signature))
    if options.json:
        _write(json_line(found))
    else:
        for name, value in found.items():
            _write(f"{name + ':':24}{value}")
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
        "exported": _date(onboard),
        "signature": onboard.signature.value,
        "plugin_version": parameters.plugin_version,
    }


def _date(onboard: OnboardDatabase) -> str:
    return "not recorded" if onboard.exported is None else onboard.exported.isoformat()


# --- localize ---


def _localize(options: argparse.Namespace) -> int:
    find = _finding(options, read_onboard(options.database, key_file=options.require_signature))
    statuses = set()
    for path in image_files(options.images):
        found = find(path)
        _write(json_line(found) if options.json else _line(found))
        statuses.add(found["status"])
    return exit_code(statuses)


def exit_code(statuses: set[str]) -> int:
    """Of records with these statuses."""
    if ERROR in statuses:
        return REFUSED
    return ALL_FIXED if statuses <= {Status.FIX.key} else SOME_WITHOUT_FIX


def _finding(options: argparse.Namespace, onboard: OnboardDatabase) -> FinderSettings:
    """How the options ask to localize; everything that can be refused is refused here."""
    cv2.setNumThreads(options.threads)
    method = next(method for method in Method if _option(method) == options.method)
    localizer = Localizer(onboard.database, replace(LOCALIZER, allowed_risk=options.risk), options.sun)
    localizer.check(method)
    if method == Method.MAP_CORRELATION and not localizer.has_overview:
        raise DatabaseError(
            "{database} has no overview, which map correlation searches; export it with one.", database=options.database
        )
    prior = Prior(tuple(options.near[:2]), options.near[2]) if options.near else Prior()
    read_labels = label_reader(options.model, options.threads, onboard.database.class_table, options.device)
    say(
        logging.INFO,
        "ready",
        database=options.database,
        content_hash=onboard.content_hash,
        exported=_date(onboard),
        signature=onboard.signature.value,
    )
    # Watching may come before the end of writing; a restart in the air must not end for a table.
    is_ended = getattr(options, "once", True)
    cameras = opened_cameras(options.cameras, options.flight_log, is_ended, not _is_restart(options))
    return FinderSettings(onboard, Pipeline(localizer, Search(method, prior), read_labels), cameras)


def _is_restart(options: argparse.Namespace) -> bool:
    """Whether a flight goes on from a state."""
    return os.path.exists(getattr(options, "state", None) or "")


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
    )
    texts = [text.format(found[name]) for name, text in units if found.get(name) is not None]
    if found["distance"] is not None:
        texts.append(f"confidence {found['confidence']:.2f}")
    else:
        texts.append(f"error probability {error_probability(found['confidence'])}")
    return f"{found['image']}: {found['status']}, {found['x']:.2f} {found['y']:.2f}, {', '.join(texts)}"


# --- watch ---


def _watch(options: argparse.Namespace) -> int:
    if not os.path.isdir(options.folder):
        raise ParameterError("There is no folder {folder}; create it or watch another one.", folder=options.folder)
    onboard = read_onboard(options.database, key_file=options.require_signature)
    is_restart = _is_restart(options)
    find: FinderSettings = _finding(options, onboard)
    after = None
    if options.state and not options.flight:
        raise ParameterError("Only of a flight is a state kept: add --flight, or leave --state out.")
    if options.odometry and not options.flight:
        raise ParameterError("Only of a flight is motion told: add --flight, or leave --odometry out.")
    if options.flight:
        if not find.pipeline.localizer.has_overview:
            raise DatabaseError(
                "{database} has no overview, by which tracks are told apart; export it with one.",
                database=options.database,
            )
        settings = replace(FLIGHT, allowed_risk=options.risk)
        odometry = opened_odometry(options.odometry, options.once, not is_restart)
        state = StateFile.at(options.state, options.require_signature) if options.state else None
        find = FlightFinding(**vars(find), state=state, settings=settings, odometry=odometry)
        after = find.start()
    if (options.gga or options.mavlink) and onboard.lon_lat is None:
        raise DatabaseError(
            "{database} can't tell longitude and latitude, which GGA sentences and MAVLink need.",
            database=options.database,
        )
    statuses, lost = watch(
        options.folder, options.once, find, options.fixes, options.gga, _mavlink_sink(options, onboard), after
    )
    return REFUSED if lost else exit_code(statuses)


def _mavlink_sink(options: argparse.Namespace, onboard: OnboardDatabase) -> MavlinkSink | None:
    """The autopilot that is to be told; None without one."""
    if not options.mavlink or onboard.lon_lat is None:
        return None
    origin = tuple(options.mavlink_origin) if options.mavlink_origin else None
    told = MavlinkOptions(options.mavlink, options.mavlink_as, options.mavlink_system, origin, options.camera_yaw)
    return MavlinkSink(told, onboard.lon_lat)
