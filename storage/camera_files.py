"""How the camera was held when an image was taken, and when: from a CSV, or from the EXIF and XMP of a photo."""

from __future__ import annotations

import csv
import os
import re
from datetime import datetime, timezone
from math import isfinite

from ..core.errors import ParameterError
from ..core.flight.table import stem_of, text_of
from ..core.geometry.camera import Camera, Height, Lens, above_ground
from ..core.geometry.leveling import Attitude
from ..core.labels.class_table import LONGEST_LINE
from ..core.labels.photo_camera import photo_camera
from ..core.sentences import Sentence

LENSES = ("focal_length_px", "focal_length_35mm", "field_of_view")
COLUMNS = ("image", "roll", "pitch", *LENSES, "time", "height", "heading")


def read_cameras(paths: list[str], table_path: str) -> list[Camera]:
    """The camera of each image.

    From the CSV where it says something, else from EXIF and XMP of the image or of the photo of its name beside it.
    Times are all of the CSV when it has any, else of the photos: clocks differ.

    Args:
        paths: The images.
        table_path: The CSV; empty for none.

    Raises:
        ParameterError: The CSV can't be used, or names none of the images.
    """
    rows = _read_table(table_path) if table_path else {}
    if table_path and not any(stem_of(path) in rows for path in paths):
        raise ParameterError("storage.cameras_of_other_images", path=table_path, image=os.path.basename(paths[0]))
    timed = any(row.time_s is not None for row in rows.values())
    cameras = []
    for path in paths:
        row, photo = rows.get(stem_of(path), Camera()), photo_camera(path)
        known = row if row.attitude else photo
        time_s = row.time_s if timed else photo.time_s
        heading = photo.heading_deg if row.heading_deg is None else row.heading_deg
        lens, height = row.lens or photo.lens, row.height or photo.height
        bent = None if row.lens else photo.distortion
        cameras.append(Camera(known.attitude, lens, known.source, time_s, known.problem, height, heading, bent))
    return cameras


# --- CSV ---


def _read_table(path: str) -> dict[str, Camera]:
    """Rows of the CSV by the stem of their image's name; raises ParameterError naming the line."""
    lines = [line for line in text_of(path).splitlines() if line.strip()]
    if max(map(len, lines), default=0) > LONGEST_LINE:
        raise ParameterError("storage.camera_line_too_long", path=path, most=LONGEST_LINE)
    first = lines[0].strip() if lines else ""
    reader = csv.DictReader(lines, delimiter=max(",;\t", key=first.count), skipinitialspace=True)
    header = [(name or "").strip().lower() for name in reader.fieldnames or []]
    if "image" not in header or not set(header) & set(COLUMNS[1:]):
        raise ParameterError("storage.no_camera_table", path=path, first=first, columns=COLUMNS[1:])
    reader.fieldnames = header
    found: dict[str, Camera] = {}
    dated = set()
    for number, row in enumerate(reader, start=2):
        place = Sentence("labels.line", source=path, line=number)
        texts = {name: (row.get(name) or "").strip() for name in COLUMNS}
        stem = stem_of(texts["image"])
        if not stem or stem in found:
            if stem:
                raise ParameterError("storage.image_named_twice", place=place, image=stem)
            raise ParameterError("storage.no_image_named", place=place)
        found[stem] = _row_camera(texts, place, os.path.basename(path))
        dated |= {_is_date(texts["time"])} if texts["time"] else set()
    if len(dated) > 1:
        raise ParameterError("storage.times_mixed", path=path)
    return found


def _row_camera(texts: dict[str, str], place: Sentence, source: str) -> Camera:
    if bool(texts["roll"]) != bool(texts["pitch"]):
        raise ParameterError("storage.roll_without_pitch", place=place)
    kinds = [kind for kind in LENSES if texts[kind]]
    if len(kinds) > 1:
        raise ParameterError("storage.lens_twice", place=place, kinds=kinds)
    lens = Lens(kinds[0], _number(texts, kinds[0], place)) if kinds else None
    if lens and not 0 < lens.value < (180 if lens.kind == "field_of_view" else float("inf")):
        raise ParameterError("storage.lens_impossible", place=place, kind=lens.kind, value=lens.value)
    attitude = None
    if texts["roll"]:
        try:
            attitude = Attitude(_number(texts, "roll", place), _number(texts, "pitch", place))
        except ParameterError as error:
            raise ParameterError("labels.at_line", where=place, fault=error.sentence) from None
    time_s = _seconds(texts["time"], place) if texts["time"] else None
    heading = _number(texts, "heading", place) % 360.0 if texts["heading"] else None
    if heading is not None and not isfinite(heading):
        raise ParameterError("storage.not_a_number", place=place, name="heading", text=texts["heading"])
    return Camera(attitude, lens, source, time_s, height=_height(texts, place), heading_deg=heading)


def _height(texts: dict[str, str], place: Sentence) -> Height | None:
    if not texts["height"]:
        return None
    meters = _number(texts, "height", place)
    if not 0 < meters < float("inf"):
        raise ParameterError("storage.lens_impossible", place=place, kind="height", value=meters)
    return above_ground(meters)


def _number(texts: dict[str, str], name: str, place: Sentence) -> float:
    try:
        return float(texts[name])
    except ValueError:
        raise ParameterError("storage.not_a_number", place=place, name=name, text=texts[name]) from None


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
        raise ParameterError("storage.no_time", place=place, text=text)
    if moment is None:
        return seconds
    return (moment if moment.tzinfo else moment.replace(tzinfo=timezone.utc)).timestamp()
