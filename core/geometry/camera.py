"""Camera of an image: how to level the image, and how large its pixels are on the ground.

Values that follow from height and lens are ranges, as wide as the usual errors of such data.

A pixel at the center of an image covers height / focal length (in pixels) of level ground, for a tilted camera divided
by cos¹·⁵ of the tilt. Neither is known well: most cameras record the height above the takeoff point, not above the
ground they see, and the focal length as if on 35 mm film.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import cos, hypot, radians

from ..errors import ParameterError
from ..sentences import Sentence
from .lens_distortion import LensDistortion
from .leveling import Attitude, Leveling, focal_length_from_35mm, focal_length_from_view, leveling

LEVEL_DEG = 0.01
"""An image with a smaller tilt is not resampled."""

SAME_SHAPE = 0.02
"""Largest relative difference between the width-to-height ratios of a label image and its photo."""

LENS_SPREAD = 0.03
"""Largest relative error of a stated focal length or field of view: distortion, focus, rounding."""

FULL_SENSOR = 0.75
"""Height to width of most sensors. A flatter picture may be cut from a full one; the “focal length in 35 mm film” then
refers to the diagonal of the full one."""

UNKNOWN_TILT_DEG = 15.0
"""Largest tilt of a camera that looks down and does not record its attitude."""

HEADING_SPREAD_DEG = 25.0
"""Largest error of a drone's compass, its mounting, and the conversion from true to grid north together."""


LEAST_DOWN = 0.2
"""Cosine of the largest tilt at which one pixel size describes an image; above it pixel sizes differ too much."""


@dataclass(frozen=True)
class Height:
    """Height of a camera above the ground that it sees.

    Attributes:
        share: Relative error to either side.
        offset_m: Additional error, meters.
    """

    meters: float
    share: float
    offset_m: float

    @property
    def range_m(self) -> tuple[float, float]:
        """Smallest and largest height; never less than ``LEAST_PART`` of the stated one."""
        least = max((1 - self.share) * self.meters - self.offset_m, LEAST_PART * self.meters)
        return least, (1 + self.share) * self.meters + self.offset_m


LEAST_PART = 0.4
"""Smallest share of a stated height that is assumed: with less, the aircraft would have hit the ground."""


def above_ground(meters: float) -> Height:
    """Return a height above the ground, from a terrain model, a rangefinder or a table."""
    return Height(meters, 0.1, 3.0)


def above_takeoff(meters: float) -> Height:
    """Return a barometric height above the takeoff point; the ground seen may be 30 m lower or higher than it."""
    return Height(meters, 0.1, 30.0)


@dataclass(frozen=True)
class Lens:
    """Field of view of a camera.

    Attributes:
        kind: ``focal_length_px``, ``focal_length_35mm`` or ``field_of_view``.
        value: Pixels of the label image, mm on 35 mm film, or degrees across the width.
        ratio: Width to height of the photo with this data; None if unknown.
    """

    kind: str
    value: float
    ratio: float | None = None

    def fits(self, shape_hw: tuple[int, int]) -> bool:
        """Return whether an image of this shape can show all that the photo shows."""
        return self.ratio is None or abs(shape_hw[1] / shape_hw[0] / self.ratio - 1) <= SAME_SHAPE

    def focal_length_px(self, shape_hw: tuple[int, int]) -> float:
        """Return the focal length in pixels of an image of ``shape_hw`` (height, width)."""
        if self.kind == "focal_length_35mm":
            return focal_length_from_35mm(self.value, shape_hw)
        return focal_length_from_view(self.value, shape_hw) if self.kind == "field_of_view" else self.value

    def focal_lengths_px(self, shape_hw: tuple[int, int]) -> tuple[float, float]:
        """Return the smallest and largest possible focal length, pixels of an image of ``shape_hw`` (height, width)."""
        stated, cut = self.focal_length_px(shape_hw), 1.0
        if self.kind == "focal_length_35mm":
            longer, shorter = max(shape_hw), min(shape_hw)
            cut = max(1.0, hypot(longer, FULL_SENSOR * longer) / hypot(longer, shorter))
        return stated * (1 - LENS_SPREAD), stated * (1 + LENS_SPREAD) * cut


@dataclass(frozen=True)
class Camera:
    """Known properties of an image's camera.

    Attributes:
        source: Name of the file with the attitude.
        time_s: Seconds on the clock that all cameras of one call of ``read_cameras`` share.
        problem: Why the attitude can't be used.
        height: Above the ground that the camera sees.
        heading_deg: Direction of the image's top, clockwise from north.
        distortion: Distortion of the lens, if it is known and the photo is not corrected for it.
    """

    attitude: Attitude | None = None
    lens: Lens | None = None
    source: str = ""
    time_s: float | None = None
    problem: Sentence | None = None
    height: Height | None = None
    heading_deg: float | None = None
    distortion: LensDistortion | None = None

    def without_leveling(self) -> Camera:
        """Return the camera without the data for leveling."""
        return replace(self, attitude=None, problem=None, distortion=None)

    def leveling(self, shape_hw: tuple[int, int]) -> Leveling | None:
        """Return how to level an image and correct its lens distortion; None if neither is needed or known.

        Args:
            shape_hw: (height, width) of the image, 1 or more each.

        Raises:
            ParameterError: The data of the files can't be used, or the view comes too near the horizon.
            LabelMapError: The leveled image would be too large.
        """
        if self.problem:
            raise ParameterError(self.problem)
        if self.lens is None or not self.lens.fits(shape_hw):
            return None
        attitude = self.attitude or Attitude(0.0, 0.0)
        is_level = max(abs(attitude.roll_deg), abs(attitude.pitch_deg)) < LEVEL_DEG
        if is_level and self.distortion is None:
            return None
        way = leveling(attitude, self.focal_length_px(shape_hw), shape_hw, self.distortion)
        return way if self.attitude is not None else replace(way, nadir=None)

    def focal_length_px(self, shape_hw: tuple[int, int]) -> float:
        """Return the focal length in pixels of an image of ``shape_hw``: from the calibration if there is one, or 0."""
        if self.distortion is not None:
            return sum(self.distortion.focal_xy) / 2 * shape_hw[1]
        return 0.0 if self.lens is None else self.lens.focal_length_px(shape_hw)

    def pixel_sizes(self, shape_hw: tuple[int, int]) -> tuple[float, float] | None:
        """Return the smallest and largest ground size of a pixel at the image's center, meters; None if unknown.

        Args:
            shape_hw: (height, width) of the image, 1 or more each.
        """
        if self.height is None or self.lens is None or not self.lens.fits(shape_hw):
            return None
        if self.attitude is None:
            least_slant, most_slant = 1.0, cos(radians(UNKNOWN_TILT_DEG)) ** -1.5
        else:
            least_slant = most_slant = float(self.attitude.down[2]) ** -1.5
        low, high = self.height.range_m
        shortest, longest = self.lens.focal_lengths_px(shape_hw)
        return low * least_slant / longest, high * most_slant / shortest

    def pixel_size(self, shape_hw: tuple[int, int]) -> float | None:
        """Return the ground size of a pixel at the image's center from height and lens, meters; None if unknown.

        Args:
            shape_hw: (height, width) of the image, 1 or more each.
        """
        if self.height is None or self.lens is None or not self.lens.fits(shape_hw):
            return None
        down = 1.0 if self.attitude is None else float(self.attitude.down[2])
        return None if down < LEAST_DOWN else self.height.meters * down**-1.5 / self.focal_length_px(shape_hw)
