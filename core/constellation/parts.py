"""Images put together of two places: a pose that holds on one side of the image only.

Told in docs/explanation/method.md#constellation.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .settings import Decision

EMPTY_SIDE_LANDMARKS = 5
"""Landmarks without which one side of an image tells nothing about whether it shows the same place."""

UNEVEN_LOG_ODDS = 8.0
"""How much more likely, ln, two shares of the image's landmarks alone have to be than one for those of the emptier side
to be sought elsewhere."""

DIRECTIONS = np.exp(2j * np.pi * np.arange(16) / 16)
CUTS = np.linspace(-0.4, 0.4, 9)
"""Where the image is cut in two: directions, and how far from the middle in half diagonals."""

_DIRECTIONS, _BEGINS = np.repeat(DIRECTIONS, len(CUTS)), np.tile(CUTS, len(DIRECTIONS))
"""Of every side of every cut."""


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
        """Return (n,) bool: whether points, pixels from the image's center, lie on it."""
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


def empty_side(of_image: Agreement, of_map: Agreement, diagonal: float, settings: Decision) -> Side | None:
    """Return the side of an image on which hardly anything agrees with the map, while on the other much does.

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
    each, both = settings.empty_side_log_odds
    told = np.array([_told(seen, diagonal, settings) for seen in (of_image, of_map)])
    summed = np.where(told.min(axis=0) >= each, told.sum(axis=0), -np.inf)
    best = int(summed.argmax())
    if summed[best] < both:
        return None
    return _side(best, diagonal)


def uneven_side(of_image: Agreement, diagonal: float, settings: Decision) -> Side | None:
    """Return the side on which hardly any of the image's landmarks agree, so that another place is worth a search; or None."""
    told = _told(of_image, diagonal, settings)
    best = int(told.argmax())
    return _side(best, diagonal) if told[best] >= UNEVEN_LOG_ODDS else None


def _side(number: int, diagonal: float) -> Side:
    return Side(complex(_DIRECTIONS[number]), float(_BEGINS[number]) * diagonal / 2)


def _told(seen: Agreement, diagonal: float, settings: Decision) -> np.ndarray:
    """Return (S,) how much more likely two shares are than one, for both sides of every cut of an image.

    0 where there are too few landmarks to tell, or the side is not emptier.
    """
    along = (_DIRECTIONS[:, None].conj() * seen.points).real
    inside = along > _BEGINS[:, None] * diagonal / 2
    here, agree = inside.sum(axis=1), inside[:, seen.agree].sum(axis=1)
    there, others = len(seen.points) - here, int(seen.agree.sum()) - agree
    tells = (np.minimum(here, there) >= EMPTY_SIDE_LANDMARKS) & (
        agree * there <= settings.empty_side_share * others * here
    )
    told = _likelihood(agree, here) + _likelihood(others, there) - _likelihood(agree + others, here + there)
    return np.where(tells, told, 0.0)


def _likelihood(successes: np.ndarray, trials: np.ndarray) -> np.ndarray:
    """Largest ln likelihood of shares."""
    failures = trials - successes
    return _weighed(successes, trials) + _weighed(failures, trials)


def _weighed(part: np.ndarray, whole: np.ndarray) -> np.ndarray:
    """Return numbers times ln of their share in others; 0 for none."""
    return part * np.log(np.maximum(part, 1) / np.maximum(whole, 1))
