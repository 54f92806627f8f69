"""Motion from image to image from a table: ``image,dx_m,dy_m,dheading_deg`` and optional standard deviations.

A row contains the motion of the camera since the image of the row before: ``dx_m`` to the right and ``dy_m`` towards
the top of that earlier image, on the ground, and the change of heading (clockwise). Format:
docs/reference/file_formats.md#odometry-table.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ..tables import Columns, Row, image_of, rows_of, stem_of
from .motion import Link, LinkSource

COLUMNS = ("image", "dx_m", "dy_m", "dheading_deg")

FARTHEST_M = 1e6
"""Largest distance between the images of two consecutive rows."""

SHARE, LEAST_M = 0.03, 0.5
"""Default standard deviation of a step: a share of its length, and at least this many meters."""

HEADING_SPREAD_DEG = 1.0
SCALE_SPREAD = 0.02
"""Default standard deviations of turn and scale."""


@dataclass(frozen=True)
class OdometryRow:
    """A row of the table.

    Attributes:
        image: Name without folders and extension.
        right_m: Motion since the image of the row before, to the right of that image.
        up_m: Motion towards the top of that image.
        turn_deg: Change of heading, clockwise.
        sigma_m: Standard deviation of ``right_m`` and ``up_m``.
        scale: Ratio of pixel sizes, this row to the row before.
        sigma_scale: Standard deviation of its logarithm.
        is_break: The motion since the row before is unknown.
    """

    image: str
    right_m: float = 0.0
    up_m: float = 0.0
    turn_deg: float = 0.0
    sigma_m: float = 0.0
    sigma_turn_deg: float = 0.0
    scale: float = 1.0
    sigma_scale: float = SCALE_SPREAD
    is_break: bool = False


def check_odometry(columns: Columns) -> None:
    """Raise ParameterError unless the header is that of an odometry table."""
    columns.need(COLUMNS)


def read_odometry(path: str) -> tuple[OdometryRow, ...]:
    """Return the rows of an odometry table in their order.

    Raises:
        ParameterError: The table can't be used; the error names the line.
    """
    steps: list[OdometryRow] = []
    named: set[str] = set()
    for row in rows_of(path, check_odometry):
        named.add(image_of(row, named))
        steps.append(step_of(row, is_first=not steps))
    return tuple(steps)


def step_of(row: Row, is_first: bool) -> OdometryRow:
    """Return the motion of a row.

    Args:
        is_first: No row comes before it.

    Raises:
        ParameterError: A value can't be used; the error names the line.
    """
    stem = image_of(row)
    if is_first or not any(row.texts.get(name) for name in COLUMNS[1:]):
        # The first row has no row before it; a row without numbers means that the motion is unknown.
        return OdometryRow(stem, is_break=True)
    right, up = (row.within(name, -FARTHEST_M, FARTHEST_M) for name in ("dx_m", "dy_m"))
    usual = max(SHARE * math.hypot(right, up), LEAST_M)
    return OdometryRow(
        stem,
        right,
        up,
        row.within("dheading_deg", -360.0, 360.0),
        row.within("sigma_m", 1e-3, FARTHEST_M, usual),
        row.within("sigma_heading_deg", 1e-3, 180.0, HEADING_SPREAD_DEG),
        row.within("scale", 0.1, 10.0, 1.0),
        row.within("sigma_scale", 1e-4, 1.0, SCALE_SPREAD),
    )


def odometry_links(steps: Sequence[OdometryRow], names: Sequence[str]) -> list[Link]:
    """Return links between the images of a flight from the rows of a table.

    Motion over rows of other images is summed.

    Args:
        names: Of the flight's images, in order; folders and extensions are ignored.
    """
    numbers = {stem_of(name): number for number, name in enumerate(names)}
    links: list[Link] = []
    since: list[OdometryRow] = []
    before: int | None = None
    for step in steps:
        since = [] if step.is_break else [*since, step]
        number = numbers.get(step.image)
        if step.is_break:
            before = number
        elif number is not None:
            if before is not None:
                links.append(link_over(before, number, since))
            before, since = number, []
    return links


def link_over(before: int, after: int, steps: Sequence[OdometryRow]) -> Link:
    """Return the sum of several rows as one link from the earlier image of the flight.

    Args:
        before: Number of the image that the table names first.
        after: Number of the image that the table names last; less than ``before`` if the table has the reverse order.
        steps: Rows after ``before`` up to ``after``, without a break.
    """
    place, heading, log_scale = 0j, 0.0, 0.0
    places = []
    for step in steps:
        places.append(place)
        place += complex(step.right_m, step.up_m) * _direction(heading)
        heading += step.turn_deg
        # The product of many scales would overflow.
        log_scale += math.log(step.scale)
    # An error of the heading rotates all later steps.
    swung = [
        abs(place - start) ** 2 * math.radians(step.sigma_turn_deg) ** 2 for step, start in zip(steps[:-1], places[1:])
    ]
    sigma_m = math.sqrt(sum(step.sigma_m**2 for step in steps) + sum(swung))
    sigma_turn = math.sqrt(sum(step.sigma_turn_deg**2 for step in steps))
    sigma_scale = math.sqrt(sum(step.sigma_scale**2 for step in steps))
    if after < before:
        # The table has the reverse order of the flight.
        before, after = after, before
        sigma_m = math.hypot(sigma_m, abs(place) * math.radians(sigma_turn))
        place, heading, log_scale = -place / _direction(heading), -heading, -log_scale
    return Link.of_odometry(
        before,
        after,
        place.real,
        place.imag,
        heading,
        sigma_m,
        sigma_turn,
        log_scale,
        sigma_scale,
        source=LinkSource.ODOMETRY,
    )


def _direction(heading_deg: float) -> complex:
    """Return the complex direction of a heading, for right + i up."""
    return complex(math.cos(math.radians(heading_deg)), -math.sin(math.radians(heading_deg)))
