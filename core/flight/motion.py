"""Relative motion between two images of a flight: a link with its covariance.

See docs/explanation/method.md#flights. A link maps pixels of the second image to pixels of the first. Both count from
the center of the image, right and down:

    first = translation + exp(log_scale) · R(turn) · second,   R(turn) = [[cos, −sin], [sin, cos]]

The second image has the heading of the first plus ``turn`` (clockwise), and exp(log_scale) times its pixel size.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from .. import limits
from ..errors import ParameterError
from ..geometry.pose import turn_of

Matrix = tuple[tuple[float, ...], ...]
"""A small matrix by rows. Tuples make results comparable."""


class LinkSource(str, Enum):
    """Source of a link; each member equals its key."""

    PIXELS = "pixels"
    ODOMETRY = "odometry"
    LOG = "log"
    ASSUMED = "assumed"

    __str__ = str.__str__
    __format__ = str.__format__  # type: ignore[assignment] # by position, as str has it


def as_rows(matrix: np.ndarray | Sequence[Sequence[float]]) -> Matrix:
    """Return a matrix as tuples of floats."""
    return tuple(tuple(float(value) for value in row) for row in matrix)


@dataclass(frozen=True)
class Link:
    """Motion from an earlier image to a later one.

    Attributes:
        first: Number of the earlier image in the flight, from 0.
        second: Number of the later one.
        translation: Center of the second image relative to that of the first: right, down. In pixels of the first
            image, or in meters along the same axes with ``in_meters``.
        turn: Heading of the second image minus that of the first, radians clockwise.
        log_scale: ln of the ratio of pixel sizes, second to first.
        covariance: (4, 4) of translation (2, its unit), turn (radians) and log_scale.
        in_meters: The translation is in meters, so that no pixel size is needed.
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
        """Check values that tables or other programs provide.

        Raises:
            ParameterError: The images are not in order, a number is not finite or too large, or the covariance is
                invalid.
        """
        if not 0 <= self.first < self.second:
            raise ParameterError(
                "The motion leads from image {first} to image {second}; the second must come after the first.",
                first=self.first,
                second=self.second,
            )
        numbers = np.array([*self.translation, self.turn, self.log_scale])
        known = np.array(self.covariance, np.float64)
        is_finite = np.isfinite(numbers).all() and known.shape == (4, 4) and np.isfinite(known).all()
        if not is_finite or abs(self.log_scale) > limits.LINK_LOG_SCALE:
            raise ParameterError(
                "The motion from image {first} to image {second} has numbers that are not finite or too large.",
                first=self.first,
                second=self.second,
            )
        if not np.allclose(known, known.T) or np.linalg.eigvalsh(known).min() < -1e-9 * max(np.trace(known), 1e-12):
            raise ParameterError(
                "The covariance of the motion from image {first} to image {second} is invalid.",
                first=self.first,
                second=self.second,
            )

    @property
    def step(self) -> complex:
        """The translation as a complex number, right + i up, in its unit."""
        return complex(self.translation[0], -self.translation[1])

    @property
    def ratio(self) -> complex:
        """Complex ratio of the second image's pose to the first one's: exp(log_scale − i turn)."""
        return cmath.exp(complex(self.log_scale, -self.turn))

    def mirrored(self) -> Link:
        """Return the motion of mirrored images (left and right exchanged), which can't be right anywhere."""
        sign = np.array([-1.0, 1.0, -1.0, 1.0])
        known = np.array(self.covariance) * np.outer(sign, sign)
        right, down = self.translation
        return replace(self, translation=(-right, down), turn=-self.turn, covariance=as_rows(known))

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
        """Return a link from a motion in meters.

        Args:
            first: Number of the earlier image.
            second: Number of the later one.
            dx_m: To the right of the first image; with ``heading_deg`` to the east. Meters.
            dy_m: Towards the top of the first image; with ``heading_deg`` to the north. Meters.
            dheading_deg: Heading of the second image minus that of the first, clockwise.
            sigma_m: Standard deviation of dx and dy, meters.
            sigma_heading_deg: Standard deviation of ``dheading_deg``.
            log_scale: ln of the ratio of pixel sizes, second to first, from the heights above ground; 0 if unknown.
            sigma_log_scale: Standard deviation of ``log_scale``.
            heading_deg: Heading of the first image, clockwise from grid north, if dx and dy are along the map's axes.
            sigma_map_heading_deg: Standard deviation of ``heading_deg``.

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


HALVED = (0.1, 5.0, 0.03)
"""Standard deviations of half a motion over one image without other information: share of the distance, degrees, ln
pixel size. A flight is more even than that between two known places."""


def links_by_image(links: Sequence[Link], count: int) -> dict[int, Link]:
    """Return links between consecutive images by the number of the second one.

    A missing link follows from a link that skips an image: as the rest after the known link, or as half of it if
    neither is known, for example over a blurred image.

    Args:
        links: Of the flight, in any order.

    Raises:
        ParameterError: A link names an image that the flight does not have.
    """
    for link in links:
        if link.second >= count:
            raise ParameterError(
                "The motion leads to image {second}, but the flight has {count} images.",
                second=link.second,
                count=count,
            )
    known = {link.second: link for link in links if link.second == link.first + 1}
    for over in sorted((one for one in links if one.second == one.first + 2), key=lambda one: one.second):
        earlier, later = known.get(over.second - 1), known.get(over.second)
        if earlier is None and later is None:
            known[over.second - 1], known[over.second] = halves(over)
        elif earlier is not None and later is None and earlier.in_meters == over.in_meters:
            known[over.second] = rest(over, earlier)
    return known


def rest(over: Link, earlier: Link) -> Link:
    """Return the second part of a link that skips an image.

    Args:
        over: Link from the first image to the third one.
        earlier: Link from the first image to the second one, in the same unit.
    """
    turn = earlier.turn
    ratio = cmath.exp(complex(0.0 if over.in_meters else earlier.log_scale, -turn))
    step = (over.step - earlier.step) / ratio
    noise = np.array(over.covariance) + np.array(earlier.covariance)
    # An error of the earlier turn rotates the rest.
    axis = np.eye(4)
    cos, sin = np.cos(turn), np.sin(turn)
    axis[:2, :2] = np.array([[cos, sin], [-sin, cos]]) / abs(ratio)
    noise = axis @ noise @ axis.T
    noise[:2, :2] += abs(step) ** 2 * earlier.covariance[2][2] * np.eye(2)
    return replace(
        over,
        first=earlier.second,
        translation=(step.real, -step.imag),
        turn=over.turn - turn,
        log_scale=over.log_scale - earlier.log_scale,
        covariance=as_rows((noise + noise.T) / 2),
    )


def halves(over: Link) -> tuple[Link, Link]:
    """Return a link that skips an image as two equal links."""
    share, heading_deg, size = HALVED
    half = cmath.sqrt(over.ratio)
    unit = half / abs(half) if over.in_meters else half
    step = over.step / (1 + unit)
    loose = np.diag([*[(share * abs(step)) ** 2] * 2, np.radians(heading_deg) ** 2, size**2])
    first = replace(
        over,
        second=over.first + 1,
        translation=(step.real, -step.imag),
        turn=over.turn / 2,
        log_scale=over.log_scale / 2,
        covariance=as_rows(np.array(over.covariance) / 2 + loose),
        source=LinkSource.ASSUMED,
    )
    return first, replace(first, first=over.first + 1, second=over.second)
