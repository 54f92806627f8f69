"""How the camera was held when an image was taken, and when.

From a CSV, from the EXIF and XMP of a photo, from the log of its flight: the one place that says which counts first.
"""

from __future__ import annotations

import os
import re
from dataclasses import replace
from datetime import datetime, timezone
from math import isfinite

from ..errors import ParameterError
from ..geometry.camera import Camera, Height, Lens, above_ground
from ..geometry.leveling import Attitude
from ..labels.photo_camera import photo_camera
from ..sentences import Sentence
from .table import Columns, Row, image_of, rows_of, stem_of

LENSES = ("focal_length_px", "focal_length_35mm", "field_of_view")
COLUMNS = ("image", "roll", "pitch", *LENSES, "time", "height", "heading")


def read_cameras(paths: list[str], table_path: str) -> list[Camera]:
    """The camera of each image.

    From the CSV where it says something, else from EXIF and XMP of the image or of the photo of its name beside it.
    Times are all of the CSV when it has any, else of the photos: clocks differ.

    Args:
        table_path: The CSV; empty for none.

    Raises:
        ParameterError: The CSV can't be used, or names none of the images.
    """
    rows = _read_table(table_path) if table_path else {}
    if table_path and not any(stem_of(path) in rows for path in paths):
        raise ParameterError(
            "{path} names none of the images, for example {image}; its column image holds their file names.",
            path=table_path,
            image=os.path.basename(paths[0]),
        )
    timed = any(row.time_s is not None for row in rows.values())
    return [merge_camera(rows.get(stem_of(path), Camera()), photo_camera(path), timed) for path in paths]


def merge_camera(row: Camera, photo: Camera, is_timed: bool) -> Camera:
    """A camera by its row of a table where that says something, else by its photo.

    Args:
        photo: What EXIF and XMP tell.
        is_timed: The time is that of the table.
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


def complete_camera(camera: Camera, told: Camera, with_attitude: bool) -> Camera:
    """A camera with what a flight log tells and it doesn't.

    Args:
        camera: By table and photo.
        told: By the log.
        with_attitude: Whether images are leveled.
    """
    return replace(
        camera,
        attitude=camera.attitude or (told.attitude if with_attitude else None),
        height=camera.height or told.height,
        heading_deg=told.heading_deg if camera.heading_deg is None else camera.heading_deg,
    )


# --- CSV ---


def check_cameras(columns: Columns) -> None:
    """Raises ParameterError for a header that is not that of a camera table."""
    if "image" not in columns.names or not set(columns.names) & set(COLUMNS[1:]):
        raise ParameterError(
            "{path} is no camera table: its header is “{first}”, but it needs the column image and some of {columns}.",
            path=columns.path,
            first=columns.first,
            columns=COLUMNS[1:],
        )


def _read_table(path: str) -> dict[str, Camera]:
    """Rows of the CSV by the stem of their image's name; raises ParameterError naming the line."""
    found: dict[str, Camera] = {}
    dated = set()
    for row in rows_of(path, check_cameras):
        stem = image_of(row)
        if stem in found:
            raise ParameterError(
                "{place}: the image {image} is named a second time; give each image one line.",
                place=row.place,
                image=stem,
            )
        found[stem] = row_camera(row, os.path.basename(path))
        text = row.texts.get("time", "")
        dated |= {_is_date(text)} if text else set()
    if len(dated) > 1:
        raise ParameterError("{path} has times in seconds and times with dates; use one of them throughout.", path=path)
    return found


def row_camera(row: Row, source: str) -> Camera:
    """The camera of a row.

    Args:
        source: Name of the file.

    Raises:
        ParameterError: It can't be used; the line is named.
    """
    texts, place = {name: row.texts.get(name, "") for name in COLUMNS}, row.place
    if bool(texts["roll"]) != bool(texts["pitch"]):
        raise ParameterError("{place}: roll or pitch is empty; give both, or neither.", place=place)
    kinds = [kind for kind in LENSES if texts[kind]]
    if len(kinds) > 1:
        raise ParameterError("{place}: {kinds} say the same thing twice; give one of them.", place=place, kinds=kinds)
    lens = Lens(kinds[0], _number(texts, kinds[0], place)) if kinds else None
    if lens and not 0 < lens.value < (180 if lens.kind == "field_of_view" else float("inf")):
        raise ParameterError(
            "{place}: {kind} is {value:g}, which no camera has.", place=place, kind=lens.kind, value=lens.value
        )
    attitude = None
    if texts["roll"]:
        try:
            attitude = Attitude(_number(texts, "roll", place), _number(texts, "pitch", place))
        except ParameterError as error:
            raise ParameterError("{where}: {fault}", where=place, fault=error.sentence) from None
    time_s = _seconds(texts["time"], place) if texts["time"] else None
    heading = _number(texts, "heading", place) % 360.0 if texts["heading"] else None
    if heading is not None and not isfinite(heading):
        raise ParameterError(
            "{place}: {name} is “{text}”, which is not a number.", place=place, name="heading", text=texts["heading"]
        )
    return Camera(attitude, lens, source, time_s, height=_height(texts, place), heading_deg=heading)


def _height(texts: dict[str, str], place: Sentence) -> Height | None:
    if not texts["height"]:
        return None
    meters = _number(texts, "height", place)
    if not 0 < meters < float("inf"):
        raise ParameterError(
            "{place}: {kind} is {value:g}, which no camera has.", place=place, kind="height", value=meters
        )
    return above_ground(meters)


def _number(texts: dict[str, str], name: str, place: Sentence) -> float:
    try:
        return float(texts[name])
    except ValueError:
        raise ParameterError(
            "{place}: {name} is “{text}”, which is not a number.", place=place, name=name, text=texts[name]
        ) from None


def _is_date(text: str) -> bool:
    return bool(re.match(r"\d{4}-\d", text))


def _seconds(text: str, place: Sentence) -> float:
    """Of a number of seconds or a date and time as in ISO 8601, in UTC unless it says otherwise."""
    try:
        moment = datetime.fromisoformat(re.sub(r"Z$", "+00:00", text)) if _is_date(text) else None
        seconds = float(text) if moment is None else 0.0
    except ValueError:
        seconds = float("nan")
    if not isfinite(seconds):
        raise ParameterError(
            "{place}: time is “{text}”; give seconds, or a date and time such as 2025-06-30T14:05:09.250.",
            place=place,
            text=text,
        )
    if moment is None:
        return seconds
    return (moment if moment.tzinfo else moment.replace(tzinfo=timezone.utc)).timestamp()
