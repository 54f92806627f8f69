"""Camera of an image, from EXIF and XMP of its photo: attitude, lens, height, heading, time."""

from __future__ import annotations

import os
import re
from datetime import datetime, timezone
from math import atan, degrees, isfinite

from ..errors import ParameterError
from ..geometry.camera import Camera, Height, Lens, above_ground, above_takeoff
from ..geometry.lens_distortion import LensDistortion
from ..geometry.leveling import Attitude, attitude_from_gimbal, focal_length_from_35mm
from ..sentences import Sentence
from .photo_tags import PhotoTags, read_tags

PHOTO_EXTENSIONS = (".jpg", ".jpeg", ".JPG", ".JPEG", ".tif", ".tiff", ".TIF", ".TIFF")
"""Suffixes of photos that are searched next to a label image of the same name."""

SENSORS = {
    **dict.fromkeys(("FC300C", "FC300S", "FC300SE", "FC300X", "FC300XW", "FC330"), (6.25, 4000, 3000)),
    **dict.fromkeys(("FC350", "FC220", "FC2204", "FC2103"), (6.25, 4000, 3000)),
    **dict.fromkeys(("FC7203", "FC7303"), (6.3, 4000, 3000)),
    **dict.fromkeys(("FC6310", "FC6310S", "FC6310R", "L1D-20c", "FC3411"), (13.13, 5472, 3648)),
    **dict.fromkeys(("FC550", "FC550RAW"), (17.3, 4608, 3456)),
    **dict.fromkeys(("FC6520", "L2D-20c", "M3E"), (17.42, 5280, 3956)),
    "FC6540": (23.5, 6016, 4008),
    "ZenmuseP1": (35.9, 8192, 5460),
}
"""EXIF's camera name: width of the sensor in mm, columns and rows of its full picture (manufacturer's data; widths are
pixels × pitch). Flat pictures of most drones are cut from a higher one, and their focal length on film is stated for
that one: for the flat picture it would be 9 % too short."""

MOST_ZOOM = 1.01
"""Above this digital zoom the focal length is unknown: manufacturers differ in whether they include the zoom."""

LEAST_HEIGHT_M = 2.0
"""Smaller heights are those of cameras on the ground or without a barometer."""

CALIBRATED = (0.85, 1.18)
"""Accepted ratio of a calibrated focal length to that of lens and sensor; outside it is for another resolution."""


def photo_camera(path: str) -> Camera:
    """Return the camera from the tags of an image, or of a photo of the same name next to it; empty without tags."""
    beside = [os.path.splitext(path)[0] + extension for extension in PHOTO_EXTENSIONS]
    for photo in (path, *(name for name in beside if name != path)):
        camera = camera_of(read_tags(photo), os.path.basename(photo))
        if camera != Camera():
            return camera
    return Camera()


def camera_of(tags: PhotoTags, name: str) -> Camera:
    """Return the camera of a photo."""
    attitude, heading, problem = None, None, None
    # A photo that viewers rotate may have been rotated before labeling.
    if tags.orientation == 1:
        heading = _heading(tags)
        try:
            attitude = _attitude(tags)
        except ParameterError as error:
            problem = Sentence("{where}: {fault}", where=name, fault=error.sentence)
    height, bent = _height(tags, attitude), _distortion(tags)
    lens = _lens(tags)
    if lens is None and bent is not None and tags.shape_hw is not None:
        lens = Lens("field_of_view", 2 * degrees(atan(0.5 / bent.focal_xy[0])), tags.shape_hw[1] / tags.shape_hw[0])
    return Camera(attitude, lens, name if attitude or bent else "", _time(tags), problem, height, heading, bent)


def _attitude(tags: PhotoTags) -> Attitude | None:
    """Use DJI's gimbal angles, or Pix4D's, with roll positive if the right side is down and the axis points left."""
    roll, pitch = tags.number("GimbalRollDegree"), tags.number("GimbalPitchDegree")
    if roll is not None and pitch is not None:
        return attitude_from_gimbal(roll, pitch)
    roll, pitch = tags.number("Camera:Roll"), tags.number("Camera:Pitch")
    return Attitude(-roll, pitch) if roll is not None and pitch is not None else None


def _heading(tags: PhotoTags) -> float | None:
    for name in ("GimbalYawDegree", "Camera:Yaw", "FlightYawDegree"):
        heading = tags.number(name)
        if heading is not None and abs(heading) <= 360:
            return heading % 360.0
    return None


def _height(tags: PhotoTags, attitude: Attitude | None) -> Height | None:
    """Use a rangefinder along the axis, else the height above the ground, else above the takeoff point."""
    slant = tags.number("LRFTargetDistance")
    if slant is not None and slant > LEAST_HEIGHT_M and attitude is not None:
        return above_ground(slant * float(attitude.down[2]))
    for name, kind in (("AboveGroundAltitude", above_ground), ("RelativeAltitude", above_takeoff)):
        meters = tags.number(name)
        if meters is not None and meters > LEAST_HEIGHT_M:
            return kind(meters)
    return None


def _lens(tags: PhotoTags) -> Lens | None:
    if tags.shape_hw is None or min(tags.shape_hw) < 1:
        return None
    height, width = tags.shape_hw
    focal_px = _focal_length_px(tags, tags.shape_hw)
    if focal_px is not None:
        return Lens("field_of_view", 2 * degrees(atan(width / 2 / focal_px)), width / height)
    return Lens("focal_length_35mm", tags.focal_length_35mm, width / height) if tags.focal_length_35mm else None


def _focal_length_px(tags: PhotoTags, shape_hw: tuple[int, int]) -> float | None:
    """Return it in pixels of the photo, from a calibration or a known sensor; None if both are unknown."""
    if tags.zoom > MOST_ZOOM:
        return None
    found = None
    if tags.model in SENSORS and tags.focal_length_mm:
        sensor_mm, columns, rows = SENSORS[tags.model]
        is_cut = min(shape_hw) == rows
        scale = 1.0 if is_cut else max(shape_hw) / columns
        found = tags.focal_length_mm / sensor_mm * columns * scale
    roughly = found or (focal_length_from_35mm(tags.focal_length_35mm, shape_hw) if tags.focal_length_35mm else None)
    calibrated = tags.number("CalibratedFocalLength")
    if calibrated and roughly and CALIBRATED[0] <= calibrated / roughly <= CALIBRATED[1]:
        return calibrated
    return found if found and isfinite(found) else None


def _distortion(tags: PhotoTags) -> LensDistortion | None:
    """Read DJI's “dewarp data” (user manuals of Mavic 3 Enterprise, Matrice 4 and Zenmuse P1).

    Its form is “date;fx,fy,cx,cy,k1,k2,p1,p2,k3”, in pixels, with the center relative to the photo's. A photo corrected
    in the camera has DewarpFlag; for a rotated photo or one with digital zoom the calibration is not valid.
    """
    if tags.shape_hw is None or min(tags.shape_hw) < 1 or tags.number("DewarpFlag") or tags.zoom > MOST_ZOOM:
        return None
    height, width = tags.shape_hw
    for name, count in (("DewarpDataK6", 12), ("DewarpData", 9)):
        numbers = _numbers(tags.text(name).rpartition(";")[2], count)
        if numbers and tags.orientation == 1:
            fx, fy, cx, cy, k1, k2, p1, p2, *others = numbers
            found = LensDistortion((fx / width, fy / width), (cx / width, cy / width), (k1, k2, *others), (p1, p2))
            roughly = _focal_length_px(tags, tags.shape_hw)
            fits = roughly is None or CALIBRATED[0] <= fx / roughly <= CALIBRATED[1]
            if any(found.radial) and fits and found.is_usable(height / width):
                return found
    return None


def _numbers(text: str, count: int) -> list[float] | None:
    """Parse exactly ``count`` finite numbers between commas; None for anything else."""
    try:
        numbers = [float(part) for part in text.split(",")]
    except ValueError:
        return None
    return numbers if len(numbers) == count and all(isfinite(number) for number in numbers) else None


def _time(tags: PhotoTags) -> float | None:
    """Return the time of exposure in seconds on the camera's own clock."""
    found = re.fullmatch(r"(\d{4}):(\d\d):(\d\d) (\d\d):(\d\d):(\d\d)", tags.taken, re.ASCII)
    if not found:
        return None
    try:
        year, month, day, hour, minute, second = (int(number) for number in found.groups())
        moment = datetime(year, month, day, hour, minute, second, tzinfo=timezone.utc)
    except ValueError:
        # Cameras without a clock write 0000:00:00.
        return None
    parts = re.match(r"[0-9]{1,9}", tags.fraction)
    return moment.timestamp() + (float(f"0.{parts.group()}") if parts else 0.0)
