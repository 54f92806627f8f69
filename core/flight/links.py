"""Links of a flight, image by image: those between neighbors, and what links that leave out images tell of them."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..errors import ParameterError
from .motion import Link, LinkSource, as_rows

HALVED = (0.1, 5.0, 0.03)
"""Deviations of half of a motion over one image, where nothing else tells of that image: share of the distance,
degrees, ln pixel size. A flight goes on more evenly than that between two places that are known."""


def links_by_image(links: Sequence[Link], count: int) -> dict[int, Link]:
    """Links between consecutive images by the number of the second one.

    Where neighbors have none, one that leaves out an image tells it: as what is left of it after the link that is
    known; by halves where neither is, as over a blurred image.

    Args:
        links: Of the flight, in any order.

    Raises:
        ParameterError: A link is of images that the flight doesn't have.
    """
    for link in links:
        if link.second >= count:
            raise ParameterError(
                "A link leads to image {second}, but the flight has {count} images.", second=link.second, count=count
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
    """From an image to the next one, of a link over it and the one that leads to it.

    Args:
        over: From the image before.
        earlier: From the image before to this one; both in the same unit.
    """
    turn = earlier.turn
    ratio = cmath.exp(complex(0.0 if over.in_meters else earlier.log_scale, -turn))
    step = (over.step - earlier.step) / ratio
    noise = np.array(over.covariance) + np.array(earlier.covariance)
    # What the earlier one's turn is wrong by swings the rest.
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
    """A link over an image as two alike, one after the other."""
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
