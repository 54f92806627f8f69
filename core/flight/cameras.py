"""Cameras of images: attitude, lens, height, heading and time.

Sources are a camera table (CSV), the EXIF and XMP data of photos, and the log of the flight. This module defines which
source comes first.
"""

from __future__ import annotations

import math
import os
import re
from dataclasses import replace
from datetime import datetime, timezone

from ..errors import ParameterError
from ..geometry.camera import Camera, Lens, above_ground
from ..geometry.leveling import Attitude
from ..labels.photo_camera import photo_camera
from ..sentences import Sentence
from ..tables import Columns, Row, image_of, rows_of, stem_of

LENSES = ("focal_length_px", "focal_length_35mm", "field_of_view")
COLUMNS = ("image", "roll", "pitch", *LENSES, "time", "height", "heading")


def read_cameras(paths: list[str], table_path: str) -> list[Camera]:
    """Return the camera of each image.

    Values of the CSV come first, then EXIF and XMP of the image or of the photo of the same name beside it. If the CSV
    has any time, all times are from the CSV: clocks differ.

    Args:
        table_path: Path of the CSV; empty without one.

    Raises:
        ParameterError: The CSV can't be used or does not name any of the images.
    """
    rows = _read_table(table_path) if table_path else {}
    if table_path and not any(stem_of(path) in rows for path in paths):
        raise ParameterError(
            "{path} does not contain any of the images, for example {image}. Its column image must contain file names.",
            path=table_path,
            image=os.path.basename(paths[0]),
        )
    timed = any(row.time_s is not None for row in rows.values())
    return [merge_camera(rows.get(stem_of(path), Camera()), photo_camera(path), timed) for path in paths]


def merge_camera(row: Camera, photo: Camera, is_timed: bool) -> Camera:
    """Return a camera with the values of its table row, and the missing ones from its photo.

    Args:
        photo: Camera from EXIF and XMP.
        is_timed: Use the time of the table.
    """
    known = row if row.attitude else photo
    return Camera(
        known.attitude,
        row.lens or photo.lens,
        known.source,
        row.time_s if is_timed else photo.time_s,
        known.problem,
        row.height or photo.height,
        photo.heading_deg if row.heading_deg is None else row.heading_deg,
        None if row.lens else photo.distortion,
    )


def complete_camera(camera: Camera, logged: Camera, with_attitude: bool) -> Camera:
    """Return a camera with missing values from a flight log.

    Args:
        camera: From table and photo.
        logged: From the log.
        with_attitude: Whether images are leveled.
    """
    return replace(
        camera,
        attitude=camera.attitude or (logged.attitude if with_attitude else None),
        height=camera.height or logged.height,
        heading_deg=logged.heading_deg if camera.heading_deg is None else camera.heading_deg,
    )


# --- CSV ---


def check_cameras(columns: Columns) -> None:
    """Raise ParameterError unless the header is that of a camera table."""
    if "image" not in columns.names or not set(columns.names) & set(COLUMNS[1:]):
        raise ParameterError(
            "{path} is not a camera table. Its header is “{first}”; it needs the column image and some of {columns}.",
            path=columns.path,
            first=columns.first,
            columns=COLUMNS[1:],
        )


def _read_table(path: str) -> dict[str, Camera]:
    """Return the cameras of the CSV by image name without extension. Raises ParameterError with the line."""
    found: dict[str, Camera] = {}
    dated = set()
    for row in rows_of(path, check_cameras):
        stem = image_of(row, found)
        found[stem] = row_camera(row, os.path.basename(path))
        text = row.texts.get("time", "")
        dated |= {_is_date(text)} if text else set()
    if len(dated) > 1:
        raise ParameterError("{path} contains times in seconds and times with dates. Use one form for all.", path=path)
    return found


def row_camera(row: Row, source: str) -> Camera:
    """Return the camera of a row.

    Raises:
        ParameterError: A value can't be used; the error names the line.
    """
    texts, place = {name: row.texts.get(name, "") for name in COLUMNS}, row.place
    if bool(texts["roll"]) != bool(texts["pitch"]):
        raise ParameterError("{place}: roll or pitch is empty. Enter both or neither.", place=place)
    kinds = [kind for kind in LENSES if texts[kind]]
    if len(kinds) > 1:
        raise ParameterError(
            "{place}: {kinds} describe the same lens. Enter only one of them.", place=place, kinds=kinds
        )
    lens = None
    if kinds:
        lens = Lens(kinds[0], _positive(row, kinds[0], 180.0 if kinds[0] == "field_of_view" else math.inf))
    attitude = None
    if texts["roll"]:
        roll, pitch = row.number("roll"), row.number("pitch")
        try:
            attitude = Attitude(roll, pitch)
        except ParameterError as error:
            # Attitude itself does not name the line.
            fault = error.sentence
            raise ParameterError("{where}: {fault}", where=place, fault=fault) from None
    time_s = _seconds(texts["time"], place) if texts["time"] else None
    height = above_ground(_positive(row, "height")) if texts["height"] else None
    heading = row.number("heading") % 360.0 if texts["heading"] else None
    return Camera(attitude, lens, source, time_s, height=height, heading_deg=heading)


def _positive(row: Row, name: str, below: float = math.inf) -> float:
    """Return a number above 0 and below ``below``; raises ParameterError for any other."""
    value = row.number(name)
    if not 0 < value < below:
        raise ParameterError(
            "{place}: {kind} is {value:g}, which is impossible.", place=row.place, kind=name, value=value
        )
    return value


def _is_date(text: str) -> bool:
    return bool(re.match(r"\d{4}-\d", text))


def _seconds(text: str, place: Sentence) -> float:
    """Return a number of seconds, or the seconds since 1970 of an ISO 8601 date and time (UTC without a zone)."""
    try:
        moment = datetime.fromisoformat(re.sub(r"Z$", "+00:00", text)) if _is_date(text) else None
        seconds = float(text) if moment is None else 0.0
    except ValueError:
        seconds = float("nan")
    if not math.isfinite(seconds):
        raise ParameterError(
            "{place}: time is “{text}”. Enter seconds, or a date and time such as 2025-06-30T14:05:09.250.",
            place=place,
            text=text,
        )
    if moment is None:
        return seconds
    return (moment if moment.tzinfo else moment.replace(tzinfo=timezone.utc)).timestamp()
