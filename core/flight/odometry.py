"""Motion from image to image as a table tells it: ``image,dx_m,dy_m,dheading_deg`` with spreads.

A row tells how the camera moved since the image of the row before: ``dx_m`` to the right and ``dy_m`` towards the top
of that earlier image, as it lay on the ground, and by how much the heading grew (clockwise). Format:
docs/reference/file_formats.md#odometry-table.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from .motion import Link, LinkSource
from .table import Columns, Row, image_of, rows_of, stem_of

COLUMNS = ("image", "dx_m", "dy_m", "dheading_deg")

FARTHEST_M = 1e6
"""No two images of a table's rows that follow each other are farther apart."""

SHARE, LEAST_M = 0.03, 0.5
"""Spread of a step that the table tells none of: a share of its length, and so many meters at least."""

HEADING_SPREAD_DEG = 1.0
SCALE_SPREAD = 0.02
"""Spreads of turn and scale that the table tells none of."""


@dataclass(frozen=True)
class OdometryRow:
    """A row of the table.

    Attributes:
        image: Its name without folders and extension.
        right_m: From the image of the row before, to the right of that one.
        up_m: Towards its top.
        turn_deg: By how much the heading grew, clockwise.
        sigma_m: Standard deviation of each of both.
        sigma_turn_deg: Of the turn.
        scale: Pixel size over that of the row before.
        sigma_scale: Of its logarithm.
        is_break: Nothing is known of the motion since the row before.
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
    """Raises ParameterError for a header that is not that of an odometry table."""
    columns.need(COLUMNS)


def read_odometry(path: str) -> tuple[OdometryRow, ...]:
    """The rows of an odometry table, in their order.

    Args:
        path: Of the CSV.

    Raises:
        ParameterError: It can't be used; the line is named.
    """
    steps: list[OdometryRow] = []
    named: set[str] = set()
    for row in rows_of(path, check_odometry):
        named.add(image_of(row, named))
        steps.append(step_of(row, is_first=not steps))
    return tuple(steps)


def step_of(row: Row, is_first: bool) -> OdometryRow:
    """A row's step.

    Args:
        is_first: Nothing comes before it.

    Raises:
        ParameterError: It can't be used; the line is named.
    """
    stem = image_of(row)
    if is_first or not any(row.texts.get(name) for name in COLUMNS[1:]):
        # Nothing comes before the first row; a row without numbers says that the motion is unknown.
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
    """Links between the images of a flight that a table tells the motion of.

    Rows of images that the flight lacks are gone through: their steps are put together.

    Args:
        names: Of the flight's images, in its order; folders and extensions don't matter.
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
    """Of the motion that several steps are together; told from the earlier image of the flight.

    Args:
        before: Number of the image that the table names first.
        after: Of the one that it names last; less than ``before`` where the table goes the other way than the flight.
        steps: Of the rows after ``before`` up to ``after``, none of them a break.
    """
    place, heading, log_scale = 0j, 0.0, 0.0
    places = []
    for step in steps:
        places.append(place)
        place += complex(step.right_m, step.up_m) * _turned(heading)
        heading += step.turn_deg
        # Of many rows the product itself would leave what numbers hold.
        log_scale += math.log(step.scale)
    # A heading that is off turns all that comes after it.
    swung = [
        abs(place - start) ** 2 * math.radians(step.sigma_turn_deg) ** 2 for step, start in zip(steps[:-1], places[1:])
    ]
    sigma_m = math.sqrt(sum(step.sigma_m**2 for step in steps) + sum(swung))
    sigma_turn = math.sqrt(sum(step.sigma_turn_deg**2 for step in steps))
    sigma_scale = math.sqrt(sum(step.sigma_scale**2 for step in steps))
    if after < before:
        # The table goes the other way than the flight.
        before, after = after, before
        sigma_m = math.hypot(sigma_m, abs(place) * math.radians(sigma_turn))
        place, heading, log_scale = -place / _turned(heading), -heading, -log_scale
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


def _turned(heading_deg: float) -> complex:
    """The upward direction's turn, clockwise, for right + i up."""
    return complex(math.cos(math.radians(heading_deg)), -math.sin(math.radians(heading_deg)))
