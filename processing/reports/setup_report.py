"""Report of “Set up an area”: how many photos have a position, and the reasons of the others."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

from ...core.localization import Status
from ..messages.columns import status_words
from ..translation import tr
from . import page, parts


@dataclass(frozen=True)
class PhotoRow:
    """A photo; ``radius_m`` is the 95 % radius, None without a position."""

    image: str
    status: str
    reason: str
    radius_m: float | None


@dataclass(frozen=True)
class SetupReport:
    """Data of the report.

    Attributes:
        summary: Sizes that were used.
        warnings: Sentences from before the run.
        photos: One row for each photo.
    """

    summary: str
    warnings: Sequence[str]
    photos: Sequence[PhotoRow]

    def html(self) -> str:
        """Return the page."""
        body = [page.section(tr("Settings"), page.paragraph(self.summary), *map(page.paragraph, self.warnings))]
        if self.photos:
            body = [self._figures(), *body, page.section(tr("Photos"), self._table())]
        return page.page(tr("Set up an area"), tr("Positions of the photos"), *body, parts.next_steps(self._next()))

    def _figures(self) -> str:
        placed = [photo for photo in self.photos if photo.status == Status.FIX]
        likely = sum(photo.status == Status.LIKELY for photo in self.photos)
        radii = [photo.radius_m for photo in placed if photo.radius_m is not None]
        of_all = tr("of {count} photos").format(count=len(self.photos))
        radius = page.number(median(radii), "m") if radii else page.NOTHING
        return page.key_figures(
            [
                (str(len(placed)), tr("Photos with a position"), of_all),
                (str(likely), tr("Likely positions"), of_all),
                (radius, tr("Median 95 % radius"), tr("of the positions")),
            ]
        )

    def _table(self) -> str:
        header = [tr("Photo"), tr("Status"), tr("95 % radius"), tr("Reason")]
        words = status_words()
        rows = [
            [os.path.basename(one.image), words.get(one.status, one.status), page.number(one.radius_m, "m"), one.reason]
            for one in self.photos
        ]
        return page.table(header, rows, (2,))

    def _next(self) -> list[str]:
        if any(photo.status != Status.FIX for photo in self.photos):
            text = tr("If many photos have no position, train the model on imagery of this area, or train longer.")
            return [text]
        return [tr("Use the database and the model for all further photos of this area.")]
