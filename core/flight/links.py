"""Links between neighboring images of a flight, also from links that skip an image."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..errors import ParameterError
from .motion import Link, LinkSource, as_rows

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
    covariance = as_rows(np.array(over.covariance) / 2 + loose)
    first = Link(
        over.first,
        over.first + 1,
        (step.real, -step.imag),
        over.turn / 2,
        over.log_scale / 2,
        covariance,
        LinkSource.ASSUMED,
        over.in_meters,
    )
    return first, replace(first, first=over.first + 1, second=over.second)
