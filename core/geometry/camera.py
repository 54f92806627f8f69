"""What is known of the camera that took an image: how to level that, and how large its pixels are on the ground.

What follows is told as ranges, as wide as such figures are off.

A pixel at the center of an image covers height / focal length (in pixels) of level ground, of a tilted camera divided
by cos¹·⁵ of the tilt. Neither is known well: most cameras tell their height above the place where they took off, not
above the ground they see, and the focal length on a film that they don't have.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import cos, hypot, radians

from ..errors import ParameterError
from ..sentences import Sentence
from .lens_distortion import LensDistortion
from .leveling import Attitude, Leveling, focal_length_from_35mm, focal_length_from_view, leveling

LEVEL_DEG = 0.01
"""An image of a camera this near to level is not worth resampling."""

SAME_SHAPE = 0.02
"""By how much a label image's ratio of width to height may differ from its photo's."""

LENS_SPREAD = 0.03
"""A stated focal length or field of view is off by this share at most: distortion, focus, rounding."""

FULL_SENSOR = 0.75
"""Height to width of most sensors: a flatter picture may be cut from such a one, whose diagonal is then the one that
the “focal length in 35 mm film” keeps."""

UNKNOWN_TILT_DEG = 15.0
"""A camera that doesn't tell its attitude, but is taken to look down, is tilted by so much at most."""

HEADING_SPREAD_DEG = 25.0
"""A compass on a drone, its mounting and the way from true to grid north together are off by so much at most."""


LEAST_DOWN = 0.2
"""Cosine of the largest tilt at which one size is told for the pixels of an image: beyond it they differ too much."""


@dataclass(frozen=True)
class Height:
    """How high above the ground that it sees a camera was.

    Attributes:
        share: By what share of it that may be off, to either side.
        offset_m: How many meters more.
    """

    meters: float
    share: float
    offset_m: float

    @property
    def range_m(self) -> tuple[float, float]:
        """Least and most; never less than ``LEAST_PART`` of what is told."""
        least = max((1 - self.share) * self.meters - self.offset_m, LEAST_PART * self.meters)
        return least, (1 + self.share) * self.meters + self.offset_m


LEAST_PART = 0.4
"""Where more than that of a height is in doubt, pilots would have hit the ground."""


def above_ground(meters: float) -> Height:
    """A height above the ground, from a terrain model, a rangefinder or whoever made a table."""
    return Height(meters, 0.1, 3.0)


def above_takeoff(meters: float) -> Height:
    """A barometer's height above the place of take-off; the ground seen may lie 30 m lower or higher than that."""
    return Height(meters, 0.1, 30.0)


@dataclass(frozen=True)
class Lens:
    """How wide a camera sees.

    Attributes:
        kind: ``focal_length_px``, ``focal_length_35mm`` or ``field_of_view``.
        value: Pixels of the label image, mm on 35 mm film, or degrees across the width.
        ratio: Width to height of the photo that told it; None where none did.
    """

    kind: str
    value: float
    ratio: float | None = None

    def fits(self, shape_hw: tuple[int, int]) -> bool:
        """Whether an image of this shape can show all that the photo shows."""
        return self.ratio is None or abs(shape_hw[1] / shape_hw[0] / self.ratio - 1) <= SAME_SHAPE

    def focal_length_px(self, shape_hw: tuple[int, int]) -> float:
        """Focal length in pixels of an image of ``shape_hw`` (height, width)."""
        if self.kind == "focal_length_35mm":
            return focal_length_from_35mm(self.value, shape_hw)
        return focal_length_from_view(self.value, shape_hw) if self.kind == "field_of_view" else self.value

    def focal_lengths_px(self, shape_hw: tuple[int, int]) -> tuple[float, float]:
        """Least and most that it may be, in pixels of an image of ``shape_hw`` (height, width)."""
        stated, cut = self.focal_length_px(shape_hw), 1.0
        if self.kind == "focal_length_35mm":
            longer, shorter = max(shape_hw), min(shape_hw)
            cut = max(1.0, hypot(longer, FULL_SENSOR * longer) / hypot(longer, shorter))
        return stated * (1 - LENS_SPREAD), stated * (1 + LENS_SPREAD) * cut


@dataclass(frozen=True)
class Camera:
    """What is known of an image's camera.

    Attributes:
        source: Name of the file that tells the attitude.
        time_s: Seconds on the clock that all cameras of one call of ``read_cameras`` share.
        problem: What can't be used.
        height: Above the ground that it sees.
        heading_deg: Where the image's top points to, clockwise from north.
        distortion: How the lens bends, where it is known and the photo not corrected for it.
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
        """The same, for who takes images as they are."""
        return replace(self, attitude=None, problem=None, distortion=None)

    def leveling(self, shape_hw: tuple[int, int]) -> Leveling | None:
        """How to level an image and straighten what its lens bends; None when neither is needed or known.

        Args:
            shape_hw: (height, width) of the image, 1 or more each.

        Raises:
            ParameterError: What the files say can't be used, or the view comes too near the horizon.
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

    def unbending(self, shape_hw: tuple[int, int]) -> Leveling | None:
        """How to straighten what the lens bends in an image that is taken as level; None where it bends nothing known.

        Raises as ``leveling`` does.
        """
        return None if self.distortion is None else replace(self, attitude=None, problem=None).leveling(shape_hw)

    def focal_length_px(self, shape_hw: tuple[int, int]) -> float:
        """In pixels of an image of ``shape_hw`` (height, width): by the lens's calibration where there is one."""
        if self.distortion is not None:
            return sum(self.distortion.focal_xy) / 2 * shape_hw[1]
        return 0.0 if self.lens is None else self.lens.focal_length_px(shape_hw)

    def pixel_sizes(self, shape_hw: tuple[int, int]) -> tuple[float, float] | None:
        """Smallest and largest ground size of a pixel at the image's center, meters; None when not enough is known.

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
        """Ground size of a pixel at the image's center as height and lens tell it, meters; None when they don't.

        Args:
            shape_hw: (height, width) of the image, 1 or more each.
        """
        if self.height is None or self.lens is None or not self.lens.fits(shape_hw):
            return None
        down = 1.0 if self.attitude is None else float(self.attitude.down[2])
        return None if down < LEAST_DOWN else self.height.meters * down**-1.5 / self.focal_length_px(shape_hw)
