"""Detect images composed of two places: a pose is valid on one side of the image only.

See docs/explanation/method.md#constellation.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .settings import Decision

EMPTY_SIDE_LANDMARKS = 5
"""Smallest number of landmarks on each side of a cut for a comparison."""

UNEVEN_LOG_ODDS = 8.0
"""Smallest log likelihood ratio of two shares of agreeing landmarks over one for a search of the emptier side's
landmarks at another place."""

DIRECTIONS = np.exp(2j * np.pi * np.arange(16) / 16)
CUTS = np.linspace(-0.4, 0.4, 9)
"""Straight cuts through the image: directions, and distances from the center in half diagonals."""

_DIRECTIONS, _BEGINS = np.repeat(DIRECTIONS, len(CUTS)), np.tile(CUTS, len(DIRECTIONS))
"""For every side of every cut."""


@dataclass(frozen=True)
class Side:
    """One side of a straight cut through an image.

    Attributes:
        direction: Unit vector to that side.
        begins_px: Distance from the image's center where it starts, along the direction.
    """

    direction: complex
    begins_px: float

    def contains(self, points: np.ndarray) -> np.ndarray:
        """Return (n,) bool: whether points, pixels from the image's center, are on this side."""
        return (points * self.direction.conjugate()).real > self.begins_px


@dataclass(frozen=True)
class Agreement:
    """Landmarks of an image, or of the map in it, and whether each agrees with one of the other set.

    Attributes:
        points: (n,) complex, pixels from the image's center.
        agree: (n,) bool.
    """

    points: np.ndarray
    agree: np.ndarray


def empty_side(of_image: Agreement, of_map: Agreement, diagonal: float, settings: Decision) -> Side | None:
    """Return the side of an image where hardly anything agrees with the map, while much does on the other side.

    Every side of every cut is tested: the likelihood of one share of agreeing landmarks for each side, over that of one
    share for the whole image. Landmarks of both the image and the map must show it. Landmarks of the image that are not
    on the map may be new houses, or errors where the map is empty. Landmarks of the map that are not in the image may
    be where a network fails. Both together mean another place.

    Args:
        of_image: Landmarks of the image that could be on the map.
        of_map: Landmarks of the map that should be in the image.
        diagonal: Of the image, pixels.

    Returns:
        The side with the largest likelihood ratio; None if no side is empty.
    """
    each, both = settings.empty_side_log_odds
    ratios = np.array([_log_ratios(seen, diagonal, settings) for seen in (of_image, of_map)])
    summed = np.where(ratios.min(axis=0) >= each, ratios.sum(axis=0), -np.inf)
    best = int(summed.argmax())
    if summed[best] < both:
        return None
    return _side(best, diagonal)


def uneven_side(of_image: Agreement, diagonal: float, settings: Decision) -> Side | None:
    """Return the side where hardly any of the image's landmarks agree, as a reason to search another place; or None."""
    ratios = _log_ratios(of_image, diagonal, settings)
    best = int(ratios.argmax())
    return _side(best, diagonal) if ratios[best] >= UNEVEN_LOG_ODDS else None


def _side(number: int, diagonal: float) -> Side:
    return Side(complex(_DIRECTIONS[number]), float(_BEGINS[number]) * diagonal / 2)


def _log_ratios(seen: Agreement, diagonal: float, settings: Decision) -> np.ndarray:
    """Return (S,) log likelihood ratios of two shares over one, for both sides of every cut of an image.

    0 where there are too few landmarks, or the side is not emptier.
    """
    along = (_DIRECTIONS[:, None].conj() * seen.points).real
    inside = along > _BEGINS[:, None] * diagonal / 2
    here, agree = inside.sum(axis=1), inside[:, seen.agree].sum(axis=1)
    there, others = len(seen.points) - here, int(seen.agree.sum()) - agree
    is_tested = (np.minimum(here, there) >= EMPTY_SIDE_LANDMARKS) & (
        agree * there <= settings.empty_side_share * others * here
    )
    ratios = _likelihood(agree, here) + _likelihood(others, there) - _likelihood(agree + others, here + there)
    return np.where(is_tested, ratios, 0.0)


def _likelihood(successes: np.ndarray, trials: np.ndarray) -> np.ndarray:
    """Return the largest ln likelihood of shares."""
    failures = trials - successes
    return _weighed(successes, trials) + _weighed(failures, trials)


def _weighed(part: np.ndarray, whole: np.ndarray) -> np.ndarray:
    """Return counts times ln of their share of ``whole``; 0 for a count of 0."""
    return part * np.log(np.maximum(part, 1) / np.maximum(whole, 1))
