"""Motion between the images of a whole flight, from their pixels."""

from __future__ import annotations

from ..sentences import Sentence
from .motion import Link
from .pixel_features import Features
from .pixel_motion import motion_between

REMEMBERED = 2
"""Images that the next one is compared with: a blurred image may be between two that show the same ground."""

BLURRED = 0.5
"""A blurred image has fewer corners than this share of those of the next one. A sharp one is not skipped: where it
matches neither neighbor, the images are not in the order of a flight."""


class PixelLinks:
    """Links the images of a flight, one after the other.

    Attributes:
        links: Motion between two images, numbered from 0.
        unlinked: (number of the later image, reason) of neighbors without a common motion.
    """

    def __init__(self) -> None:
        self.links: list[Link] = []
        self.unlinked: list[tuple[int, Sentence]] = []
        self._before: list[Features] = []
        self._number = -1

    def add(self, features: Features) -> bool:
        """Link the next image. Return whether its pixels show other ground, see ``FlightImage.is_apart``."""
        before, self._before = self._before, [features, *self._before][:REMEMBERED]
        self._number += 1
        is_apart = False
        for away, earlier in enumerate(before, 1):
            if away > 1 and len(before[0].points) > BLURRED * len(features.points):
                break
            motion = motion_between(earlier, features, (self._number - away, self._number))
            if motion.link is not None:
                self.links.append(motion.link)
                return False
            if away == 1 and motion.reason is not None:
                self.unlinked.append((self._number, motion.reason))
                is_apart = motion.is_apart
        return is_apart
