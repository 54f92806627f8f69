"""Report of “Set up an area”: how many photos have a position, how many were to be expected, and the reasons."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

from ...core.localization import Status
from ..messages.columns import status_words
from ..translation import tr
from . import page, parts

REASONS = 3
"""The most frequent reasons that are shown."""

_NONE_IN_VIEW = 1e-6
"""Weight of a square without landmarks in view; it counts only if there are no others."""


@dataclass(frozen=True)
class PhotoRow:
    """A photo; ``radius_m`` is the 95 % radius, None without a position."""

    image: str
    status: str
    reason: str
    radius_m: float | None


@dataclass(frozen=True)
class Expectation:
    """Result of the quick assessment.

    Attributes:
        success: Mean expected success of photos that are centered on a landmark, 0…1.
        reasons: (reason, share of these photos) where less can be expected, the most frequent ones first.
    """

    success: float
    reasons: Sequence[tuple[str, float]]

    def sentence(self) -> str:
        """Return how many of 10 photos can be expected to get a position."""
        text = tr(
            "If the model finds 80 % of the landmarks, about {count} of 10 photos that are centered on a landmark can "
            "be expected to get a position with an error probability of at most 1 in 10,000. A better model places "
            "more."
        )
        return text.format(count=round(10 * self.success))

    def html(self) -> str:
        """Return the section of the report."""
        body = [page.paragraph(self.sentence())]
        if self.reasons:
            rows = [[reason, page.percent(share, 0)] for reason, share in self.reasons]
            body.append(page.table([tr("Reason"), tr("Share of these photos")], rows, (1,)))
        return page.section(tr("Expected success"), *body)


def expectation_of(squares: Sequence[tuple[float, float, str]]) -> Expectation:
    """Return the expectation of photos that are centered on a landmark.

    Args:
        squares: (expected success, landmarks in view, reason where the success is low) of squares of equal size.
    """
    weights = [max(landmarks, _NONE_IN_VIEW) for _, landmarks, _ in squares]
    total = sum(weights)
    # Reasons differ in their numbers only.
    kinds: dict[str, Counter] = {}
    for weight, (_, _, reason) in zip(weights, squares):
        if reason:
            kinds.setdefault(re.sub(r"\d+", "", reason), Counter())[reason] += weight / total
    shares = [(found.most_common(1)[0][0], sum(found.values())) for found in kinds.values()]
    shares.sort(key=lambda one: -one[1])
    success = sum(weight * one for weight, (one, _, _) in zip(weights, squares)) / total
    return Expectation(success, shares[:REASONS])


def setup_html(summary: str, warnings: Sequence[str], expected: Expectation, photos: Sequence[PhotoRow]) -> str:
    """Return the page.

    Args:
        summary: Sizes that were used.
        warnings: Sentences from before the run.
        expected: Result of the quick assessment.
    """
    body = [expected.html(), page.section(tr("Settings"), page.paragraph(summary), *map(page.paragraph, warnings))]
    if photos:
        body = [_figures(photos), *body, page.section(tr("Photos"), _table(photos))]
    return page.page(tr("Set up an area"), tr("Positions of the photos"), *body, parts.next_steps([_next(photos)]))


def _figures(photos: Sequence[PhotoRow]) -> str:
    placed = [photo for photo in photos if photo.status == Status.FIX]
    likely = sum(photo.status == Status.LIKELY for photo in photos)
    radii = [photo.radius_m for photo in placed if photo.radius_m is not None]
    of_all = tr("of {count} photos").format(count=len(photos))
    radius = page.fixed(median(radii) if radii else None, ".1f", f"{page.NO_BREAK}m")
    return page.key_figures(
        [
            (str(len(placed)), tr("Photos with a position"), of_all),
            (str(likely), tr("Likely positions"), of_all),
            (radius, tr("Median 95 % radius"), tr("of the positions")),
        ]
    )


def _table(photos: Sequence[PhotoRow]) -> str:
    words = status_words()
    columns = [
        (tr("Photo"), lambda photo: os.path.basename(photo.image)),
        (tr("Status"), lambda photo: words.get(photo.status, photo.status)),
        (tr("95 % radius"), lambda photo: page.fixed(photo.radius_m, ".1f", f"{page.NO_BREAK}m")),
        (tr("Reason"), lambda photo: photo.reason),
    ]
    return page.records(photos, columns, (2,))


def _next(photos: Sequence[PhotoRow]) -> str:
    if any(photo.status != Status.FIX for photo in photos):
        return tr(
            "If many photos have no position, run it again in a new folder with more minutes of training: on imagery "
            "of this area or, without imagery, on the photos that have a position."
        )
    return tr("Use the database and the model for all further photos of this area.")
