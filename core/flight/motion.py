"""Relative motion between two images of a flight: a link, with what is unknown of it.

See docs/explanation/method.md#flights.

A link takes pixels of the second image to pixels of the first, both from the image's
center, right and down:

    first = translation + exp(log_scale) · R(turn) · second,   R(turn) = [[cos, −sin], [sin, cos]]

so that the second image has the heading of the first plus ``turn`` (clockwise) and exp(log_scale) times its pixel size.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from .. import limits
from ..errors import ParameterError
from ..geometry.pose import turn_of

Matrix = tuple[tuple[float, ...], ...]
"""A small matrix, row by row: results that hold one can be compared."""


class LinkSource(str, Enum):
    """Where a link is from; each equals its key."""

    PIXELS = "pixels"
    ODOMETRY = "odometry"
    LOG = "log"
    ASSUMED = "assumed"

    __str__ = str.__str__
    __format__ = str.__format__  # type: ignore[assignment] # by position, as str has it


def as_rows(matrix: np.ndarray | Sequence[Sequence[float]]) -> Matrix:
    """A matrix as tuples of floats."""
    return tuple(tuple(float(value) for value in row) for row in matrix)


@dataclass(frozen=True)
class Link:
    """How a later image lies in an earlier one.

    Attributes:
        first: Number of the earlier image in the flight, from 0.
        second: Number of the later one.
        translation: Of the second image's center in the first, from that one's center: right, down. Pixels of the
            first image; meters (map units) along the same axes where ``in_meters``.
        turn: Heading of the second image less that of the first, radians clockwise.
        log_scale: ln of the second image's pixel size over the first one's.
        covariance: (4, 4) of translation (2, its unit), turn (radians) and log_scale.
        source: Where it is from.
        in_meters: The translation is in map units: no pixel size has to be known.
    """

    first: int
    second: int
    translation: tuple[float, float]
    turn: float
    log_scale: float
    covariance: Matrix
    source: LinkSource = LinkSource.PIXELS
    in_meters: bool = False

    def __post_init__(self) -> None:
        """Checks what a table or another program may have got wrong.

        Raises:
            ParameterError: The images are not in order, a number is not finite or of no flight, or the covariance is
                none.
        """
        if not 0 <= self.first < self.second:
            raise ParameterError(
                "A link leads from image {first} to image {second}; the second must come after the first.",
                first=self.first,
                second=self.second,
            )
        numbers = np.array([*self.translation, self.turn, self.log_scale])
        known = np.array(self.covariance, np.float64)
        if not np.isfinite(numbers).all() or abs(self.log_scale) > limits.LINK_LOG_SCALE:
            raise ParameterError(
                "The motion from image {first} to image {second} has numbers that are none.",
                first=self.first,
                second=self.second,
            )
        if known.shape != (4, 4) or not np.isfinite(known).all():
            raise ParameterError(
                "The motion from image {first} to image {second} has numbers that are none.",
                first=self.first,
                second=self.second,
            )
        if not np.allclose(known, known.T) or np.linalg.eigvalsh(known).min() < -1e-9 * max(np.trace(known), 1e-12):
            raise ParameterError(
                "The deviations of the motion from image {first} to image {second} are none.",
                first=self.first,
                second=self.second,
            )

    @property
    def step(self) -> complex:
        """The translation as a complex number, right + i up, in its unit."""
        return complex(self.translation[0], -self.translation[1])

    @property
    def ratio(self) -> complex:
        """Turn of the second image's pose over that of the first: exp(log_scale − i turn)."""
        return cmath.exp(complex(self.log_scale, -self.turn))

    def mirrored(self) -> Link:
        """The same motion of mirrored images, left and right exchanged: it can't be right anywhere."""
        sign = np.array([-1.0, 1.0, -1.0, 1.0])
        known = np.array(self.covariance) * np.outer(sign, sign)
        return Link(
            self.first,
            self.second,
            (-self.translation[0], self.translation[1]),
            -self.turn,
            self.log_scale,
            as_rows(known),
            self.source,
            self.in_meters,
        )

    def after(self, center: complex, turn: complex) -> tuple[complex, complex]:
        """Center and turn of the second image (``core/geometry/pose.py``) from those of the first."""
        unit = turn / abs(turn) if self.in_meters else turn
        return center + unit * self.step, turn * self.ratio

    def before(self, center: complex, turn: complex) -> tuple[complex, complex]:
        """Center and turn of the first image from those of the second."""
        earlier = turn / self.ratio
        unit = earlier / abs(earlier) if self.in_meters else earlier
        return center - unit * self.step, earlier

    @classmethod
    def of_odometry(  # noqa: PLR0913 - a row of a table
        cls,
        first: int,
        second: int,
        dx_m: float,
        dy_m: float,
        dheading_deg: float,
        sigma_m: float | tuple[float, float],
        sigma_heading_deg: float,
        log_scale: float = 0.0,
        sigma_log_scale: float = 0.02,
        heading_deg: float | None = None,
        sigma_map_heading_deg: float = 0.0,
        source: LinkSource = LinkSource.ODOMETRY,
    ) -> Link:
        """From motion in meters.

        Args:
            first: Number of the earlier image.
            second: Number of the later one.
            dx_m: To the right of the first image; with ``heading_deg`` to the east. Meters.
            dy_m: Towards its top; with ``heading_deg`` to the north. Meters.
            dheading_deg: Heading of the second image less that of the first, clockwise.
            sigma_m: Standard deviation of dx and dy, meters.
            sigma_heading_deg: Of ``dheading_deg``.
            log_scale: ln of the second pixel size over the first: of the heights over ground, 0 where unknown.
            sigma_log_scale: Of that.
            heading_deg: Of the first image's top, clockwise from grid north, where dx and dy are along the map's axes.
            sigma_map_heading_deg: Of ``heading_deg``.
            source: What tells it.

        Raises:
            ParameterError: As of the link.
        """
        along, across = (sigma_m, sigma_m) if isinstance(sigma_m, (int, float)) else sigma_m
        step, known = complex(dx_m, dy_m), np.diag([along**2, across**2])
        if heading_deg is not None and math.isfinite(heading_deg):
            axis = turn_of(heading_deg, 1.0)
            step /= axis
            turned = np.array([[axis.real, axis.imag], [-axis.imag, axis.real]])
            off = np.array([-step.imag, step.real]) * math.radians(sigma_map_heading_deg)
            known = turned @ known @ turned.T + np.outer(off, off)
        down = np.diag([1.0, -1.0])
        full = np.zeros((4, 4))
        full[:2, :2] = down @ known @ down
        full[2, 2], full[3, 3] = math.radians(sigma_heading_deg) ** 2, sigma_log_scale**2
        translation = step.real, -step.imag
        return cls(
            first, second, translation, math.radians(dheading_deg), log_scale, as_rows(full), source, in_meters=True
        )
