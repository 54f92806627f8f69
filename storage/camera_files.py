"""How the camera was held when an image was taken, and when: from a CSV, or from the EXIF and XMP of a photo."""

from __future__ import annotations

import csv
import os
import re
from dataclasses import dataclass
from datetime import datetime, timezone
from math import isfinite

from ..core.errors import LabelMapError, ParameterError
from ..core.geometry.leveling import (
    Attitude,
    Leveling,
    attitude_from_gimbal,
    focal_length_from_35mm,
    focal_length_from_view,
    leveling,
)
from ..core.labels.class_table import LONGEST_LINE
from ..core.sentences import Sentence
from .rasters import open_raster

PHOTO_EXTENSIONS = (".jpg", ".jpeg", ".JPG", ".JPEG", ".tif", ".tiff", ".TIF", ".TIFF")
"""Of photos that are looked for beside a label image, by its name."""

LENSES = ("focal_length_px", "focal_length_35mm", "field_of_view")
COLUMNS = ("image", "roll", "pitch", *LENSES, "time")

_LEVEL_DEG = 0.01
"""An image of a camera this near to level is not worth resampling."""

_SAME_SHAPE = 0.02
"""By how much a label image's ratio of width to height may differ from its photo's."""


@dataclass(frozen=True)
class Lens:
    """How wide a camera sees.

    Attributes:
        kind: One of LENSES.
        value: Pixels of the label image, mm on 35 mm film, or degrees across the width.
        ratio: Width to height of the photo that told it; None where none did.
    """

    kind: str
    value: float
    ratio: float | None = None

    def fits(self, shape_hw: tuple[int, int]) -> bool:
        """Whether an image of this shape can show all that the photo shows."""
        return self.ratio is None or abs(shape_hw[1] / shape_hw[0] / self.ratio - 1) <= _SAME_SHAPE

    def focal_length_px(self, shape_hw: tuple[int, int]) -> float:
        """Focal length in pixels of an image of ``shape_hw`` (height, width)."""
        if self.kind == "focal_length_35mm":
            return focal_length_from_35mm(self.value, shape_hw)
        return focal_length_from_view(self.value, shape_hw) if self.kind == "field_of_view" else self.value


@dataclass(frozen=True)
class Camera:
    """What is known of an image's camera.

    Attributes:
        attitude: How it was held.
        lens: How wide it sees.
        source: Name of the file that tells the attitude.
        time_s: Seconds on the clock that all cameras of one call of ``read_cameras`` share.
        problem: What can't be used.
    """

    attitude: Attitude | None = None
    lens: Lens | None = None
    source: str = ""
    time_s: float | None = None
    problem: Sentence | None = None

    def leveling(self, shape_hw: tuple[int, int]) -> Leveling | None:
        """How to level an image; None when it is level or not enough is known.

        Args:
            shape_hw: (height, width) of the image, 1 or more each.

        Raises:
            ParameterError: What the files say can't be used, or the view comes too near the horizon.
            LabelMapError: The leveled image would be too large.
        """
        if self.problem:
            raise ParameterError(self.problem)
        if self.attitude is None or self.lens is None or not self.lens.fits(shape_hw):
            return None
        if max(abs(self.attitude.roll_deg), abs(self.attitude.pitch_deg)) < _LEVEL_DEG:
            return None
        return leveling(self.attitude, self.lens.focal_length_px(shape_hw), shape_hw)


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
    if table_path and not any(_stem(path) in rows for path in paths):
        raise ParameterError("storage.cameras_of_other_images", path=table_path, image=os.path.basename(paths[0]))
    timed = any(row.time_s is not None for row in rows.values())
    cameras = []
    for path in paths:
        row, photo = rows.get(_stem(path), Camera()), _photo_camera(path)
        known = row if row.attitude else photo
        time_s = row.time_s if timed else photo.time_s
        cameras.append(Camera(known.attitude, row.lens or photo.lens, known.source, time_s, known.problem))
    return cameras


def _stem(path: str) -> str:
    """The file's name without folders, of any system, and extension."""
    return os.path.splitext(re.split(r"[/\\]", path)[-1])[0]


# --- CSV ---


def _read_table(path: str) -> dict[str, Camera]:
    """Rows of the CSV by the stem of their image's name; raises ParameterError naming the line."""
    try:
        with open(path, encoding="utf-8-sig") as file:
            lines = [line for line in file.read().splitlines() if line.strip()]
    except OSError as error:
        raise ParameterError("storage.cameras_unreadable", path=path, reason=error.strerror) from None
    except UnicodeDecodeError:
        raise ParameterError("storage.cameras_not_utf8", path=path) from None
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
        stem = _stem(texts["image"])
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
    return Camera(attitude, lens, source, _seconds(texts["time"], place) if texts["time"] else None)


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


# --- EXIF and XMP ---


def _photo_camera(path: str) -> Camera:
    """What EXIF and XMP of an image tell, or of a photo of its name beside it; nothing is no error."""
    beside = [os.path.splitext(path)[0] + extension for extension in PHOTO_EXTENSIONS]
    for photo in (path, *(name for name in beside if name != path)):
        if os.path.isfile(photo):
            camera = _tagged_camera(photo)
            if camera != Camera():
                return camera
    return Camera()


def _tagged_camera(path: str) -> Camera:
    try:
        dataset = open_raster(path)
    except LabelMapError:
        # Whoever needs its pixels says so.
        return Camera()
    exif = {**(dataset.GetMetadata("EXIF") or {}), **(dataset.GetMetadata() or {})}
    exif = {name: _text(value).strip() for name, value in exif.items() if name.startswith("EXIF_")}
    xmp = " ".join(map(_text, dataset.GetMetadata_List("xml:XMP") or []))
    attitude, problem = None, None
    # A photo that viewers turn may have been turned before it was labeled.
    if exif.get("EXIF_Orientation", "1") == "1":
        try:
            attitude = _tagged_attitude(xmp)
        except ParameterError as error:
            problem = Sentence("labels.at_line", where=os.path.basename(path), fault=error.sentence)
    width, height = dataset.RasterXSize, dataset.RasterYSize
    focal = _plain_number(exif.get("EXIF_FocalLengthIn35mmFilm", ""))
    lens = Lens("focal_length_35mm", focal, width / height) if focal else None
    source = os.path.basename(path) if attitude else ""
    return Camera(attitude, lens, source, _tagged_time(exif), problem)


def _text(value: str | bytes) -> str:
    """GDAL gives bytes for what is no UTF-8."""
    return value if isinstance(value, str) else value.decode("latin-1")


def _tagged_attitude(xmp: str) -> Attitude | None:
    """By DJI's gimbal angles, else by Pix4D's, whose roll is positive with the right side down: the axis leans left."""
    roll, pitch = _xmp_number(xmp, "GimbalRollDegree"), _xmp_number(xmp, "GimbalPitchDegree")
    if roll is not None and pitch is not None:
        return attitude_from_gimbal(roll, pitch)
    roll, pitch = _xmp_number(xmp, "Camera:Roll"), _xmp_number(xmp, "Camera:Pitch")
    return Attitude(-roll, pitch) if roll is not None and pitch is not None else None


def _xmp_number(xmp: str, name: str) -> float | None:
    """Of a property written as attribute or as element."""
    found = re.search(rf"\b{name}\s*(?:=\s*[\"']|>)\s*([-+]?\d+(?:\.\d*)?)", xmp)
    return float(found.group(1)) if found else None


def _plain_number(text: str) -> float:
    """0 for what is no number: unknown, in EXIF."""
    return float(text) if re.fullmatch(r"\d+(\.\d*)?", text) else 0.0


def _tagged_time(exif: dict[str, str]) -> float | None:
    """Seconds of the moment of exposure on the camera's own clock."""
    found = re.fullmatch(r"(\d{4}):(\d\d):(\d\d) (\d\d):(\d\d):(\d\d)", exif.get("EXIF_DateTimeOriginal", ""))
    if not found:
        return None
    try:
        moment = datetime(*(int(number) for number in found.groups()), tzinfo=timezone.utc)
    except ValueError:
        # 0000:00:00 is how cameras without a clock say so.
        return None
    # GDAL's spelling of SubSecTimeOriginal.
    parts = re.match(r"\d+", exif.get("EXIF_SubSecTime_Original", ""))
    return moment.timestamp() + (float(f"0.{parts.group()}") if parts else 0.0)
