"""Report of a flight: track with 95 % ellipses, gaps, and a table of all images."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

from ..layers.localized_image import LocalizedImage, moment
from ..messages.numbers import shown
from ..messages.sentences import error_probability
from ..translation import tr
from . import page, parts
from .maps import flight_legend, flight_map

MOST_ROWS = 400
"""Rows of the table of images; the layer has all images."""


Numbered = Sequence[tuple[int, LocalizedImage]]
"""The images of a flight with their numbers, from 1."""


def flight_html(
    flown: Sequence[LocalizedImage], database: str, links: Sequence[str], settings: Sequence[tuple[str, str]]
) -> str:
    """Return the page.

    Args:
        flown: All images in the order of the flight.
        links: Sentences about the motion between images.
        settings: (name, value) of the settings.
    """
    caption = tr(
        "Discs show positions, filled for own positions of images; lines show the heading. The 95 % ellipses contain "
        "the true position in 95 % of cases. North is up."
    )
    numbered = list(enumerate(flown, start=1))
    placed = [(number, item) for number, item in numbered if item.is_placed]
    drawn = [page.figure(flight_map(placed, tr("Map of the track")), caption), flight_legend()] if placed else []
    gaps = gaps_of(numbered)
    return page.page(
        tr("Localization of a flight"),
        database,
        _key_figures(flown, gaps),
        parts.next_steps(_next(flown)),
        page.section(tr("Track"), *drawn),
        page.section(tr("Gaps"), *_gap_table(flown, gaps)),
        page.section(tr("Motion between the images"), *map(page.paragraph, links)),
        page.section(tr("Images"), *_image_table(numbered)),
        parts.settings_section(settings),
    )


def _key_figures(flown: Sequence[LocalizedImage], gaps: Sequence[tuple[int, int]]) -> str:
    placed = [item for item in flown if item.is_placed]
    own = sum(item.source == "own" for item in placed)
    outvoted = sum(item.is_outvoted for item in flown)
    radii = sorted(item.result.error_95_m for item in placed if item.result.error_95_m is not None)
    longest = max((last - first + 1 for first, last in gaps), default=0)
    note = tr("{own} own positions, {flight} from the flight").format(own=own, flight=len(placed) - own)
    return page.key_figures(
        [
            (f"{len(placed)}/{len(flown)}", tr("Images with a position"), note),
            (
                str(len({item.pose.track for item in placed})),
                tr("Tracks"),
                tr("longest gap: {count} images").format(count=longest),
            ),
            (page.number(radii[len(radii) // 2] if radii else None, "m"), tr("95 % radius"), tr("median")),
            (str(outvoted), tr("Outvoted own positions"), tr("they contradict the flight")),
        ]
    )


def _next(flown: Sequence[LocalizedImage]) -> list[str]:
    placed = sum(item.is_placed for item in flown)
    if not placed:
        return [
            tr("No image has a position. Set a prior position, add a camera table, or choose a database of this area."),
            tr("Run “Assess reference database” to see whether images of this footprint width can be localized there."),
        ]
    steps = []
    if placed < len(flown):
        steps.append(
            tr("To close gaps, add an odometry table or the aircraft’s log, which connects images without landmarks.")
        )
    if any(item.is_outvoted for item in flown):
        steps.append(tr("Check images with an outvoted own position: the map may be outdated there."))
    steps.append(tr("Georeference the images, or show the positions in QGIS’s temporal controller."))
    return steps


def gaps_of(numbered: Numbered) -> list[tuple[int, int]]:
    """Return (first, last) number of each run of images without a position."""
    runs = (list(run) for is_placed, run in groupby(numbered, lambda one: one[1].is_placed) if not is_placed)
    return [(run[0][0], run[-1][0]) for run in runs]


def _gap_table(flown: Sequence[LocalizedImage], gaps: Sequence[tuple[int, int]]) -> list[str]:
    if not gaps:
        return [page.paragraph(tr("There are no gaps. All images have a position."))]
    columns = [
        (tr("From image"), lambda gap: flown[gap[0] - 1].name),
        (tr("To image"), lambda gap: flown[gap[1] - 1].name),
        (tr("Images"), lambda gap: str(gap[1] - gap[0] + 1)),
        (tr("Reason"), lambda gap: flown[gap[0] - 1].reason),
    ]
    return [page.records(gaps, columns, (2,))]


def _image_table(numbered: Numbered) -> list[str]:
    header = [
        *(tr("Number"), tr("Image"), tr("Time"), tr("Source"), tr("Track"), "x", "y", tr("Heading")),
        *(tr("95 % radius"), tr("Error probability"), tr("Remark")),
    ]
    rows = [_image_row(number, item) for number, item in numbered[:MOST_ROWS]]
    found = [page.table(header, rows, (0, 4, 5, 6, 7, 8, 9))]
    if len(numbered) > MOST_ROWS:
        text = tr("The table has the first {count} images. The layer has all images.")
        found.append(page.paragraph(text.format(count=MOST_ROWS)))
    return found


def _image_row(number: int, item: LocalizedImage) -> list[str]:
    time = moment(item.time_s)
    text = "" if time is None else time.toString("yyyy-MM-dd hh:mm:ss")
    measures = [page.NOTHING] * 6
    if item.position is not None:
        result = item.result
        measures = [
            str(item.pose.track) if item.pose.track else page.NOTHING,
            *(shown(value, ".1f") for value in item.position),
            page.fixed(result.heading_deg, ".1f", "°"),
            page.fixed(result.error_95_m, ",.2f", f"{page.NO_BREAK}m"),
            error_probability(result.confidence) if result.confidence else page.NOTHING,
        ]
    return [str(number), item.name, text, _source_text(item), *measures, item.reason]


def _source_text(item: LocalizedImage) -> str:
    if not item.is_placed:
        return page.Marked(tr("no position") if item.position is None else tr("likely position"), False)
    if item.is_outvoted:
        return page.Marked(tr("flight; own position outvoted"), False)
    return page.Marked(tr("own position"), True) if item.source == "own" else tr("flight")
