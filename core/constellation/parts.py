"""Images put together of two places: a pose that holds on one side of the image only.

Told in docs/method.md#constellation.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from .settings import ConstellationSettings

DIRECTIONS = np.exp(2j * np.pi * np.arange(16) / 16)
CUTS = np.linspace(-0.4, 0.4, 9)
"""Where the image is cut in two: directions, and how far from the middle in half diagonals."""


@dataclass(frozen=True)
class Side:
    """One side of a straight cut through an image.

    Attributes:
        direction: Unit vector to that side.
        begins_px: How far from the image's center it begins, along the direction.
    """

    direction: complex
    begins_px: float

    def holds(self, points: np.ndarray) -> np.ndarray:
        """(n,) bool: whether points, pixels from the image's center, lie on it."""
        return (points * self.direction.conjugate()).real > self.begins_px


@dataclass(frozen=True)
class Agreement:
    """Landmarks of an image, or of the map in it, and whether each agrees with one of the other.

    Attributes:
        points: (n,) complex, pixels from the image's center.
        agree: (n,) bool.
    """

    points: np.ndarray
    agree: np.ndarray


def empty_side(of_image: Agreement, of_map: Agreement, diagonal: float, settings: ConstellationSettings) -> Side | None:
    """The side of an image on which hardly anything agrees with the map, while on the other much does.

    Every side of every cut is looked at: the likelihood of two shares that agree, one a side, over that of one share
    for the whole image. Both must tell it: landmarks of the image that are not on the map may be new houses, or errors
    where there is nothing; landmarks of the map that are not in the image may lie where a network is blind. Other ones
    instead of those of the map are another place.

    Args:
        of_image: Landmarks of the image that could be on the map.
        of_map: Landmarks of the map that should be in the image.
        diagonal: Of the image, pixels.
        settings: How much more likely two shares have to be, and how different they are.

    Returns:
        The side for which that is the most likely; None where no side is empty.
    """
    best, found = settings.empty_side_log_odds[1], None
    for side in _sides(diagonal):
        told = [_told(seen, side, settings) for seen in (of_image, of_map)]
        if min(told) >= settings.empty_side_log_odds[0] and sum(told) >= best:
            best, found = sum(told), side
    return found


def is_uneven(of_image: Agreement, diagonal: float, settings: ConstellationSettings) -> bool:
    """Whether on some side hardly any of the image's landmarks agree, so that another place is worth a search."""
    return any(_told(of_image, side, settings) >= settings.uneven_log_odds for side in _sides(diagonal))


def _sides(diagonal: float) -> Iterator[Side]:
    """Both sides of every cut of an image whose diagonal has so many pixels."""
    for direction, cut in itertools.product(DIRECTIONS, CUTS):
        yield Side(complex(direction), float(cut) * diagonal / 2)


def _told(seen: Agreement, side: Side, settings: ConstellationSettings) -> float:
    """How much more likely two shares are than one; 0 where there are too few to tell, or the side is not emptier."""
    inside = side.holds(seen.points)
    here, there = int(inside.sum()), int((~inside).sum())
    if min(here, there) < settings.empty_side_landmarks:
        return 0.0
    agree, others = int(seen.agree[inside].sum()), int(seen.agree[~inside].sum())
    if agree * there > settings.empty_side_share * others * here:
        return 0.0
    return _likelihood(agree, here) + _likelihood(others, there) - _likelihood(agree + others, here + there)


def _likelihood(successes: int, trials: int) -> float:
    """Largest ln likelihood of a share."""
    share = successes / trials
    return sum(count * math.log(part) for count, part in ((successes, share), (trials - successes, 1 - share)) if count)
