"""Report of a flight: track with 95 % ellipses, gaps, and a table of all images."""

from __future__ import annotations

from collections.abc import Sequence

from ..messages.numbers import shown
from ..translation import tr
from . import page, parts
from .maps import FlightPoint, flight_legend, flight_map

MOST_ROWS = 400
"""Rows of the table of images; the layer has all images."""


def flight_html(
    points: Sequence[FlightPoint], database: str, links: Sequence[str], settings: Sequence[tuple[str, str]]
) -> str:
    """Return the page.

    Args:
        links: Sentences about the motion between images.
        settings: (name, value) of the settings.
    """
    caption = tr(
        "Discs show positions, filled for own positions of images; lines show the heading. The 95 % ellipses contain "
        "the true position in 95 % of cases. North is up."
    )
    placed = [point for point in points if point.position is not None]
    drawn = [page.figure(flight_map(placed, tr("Map of the track")), caption), flight_legend()] if placed else []
    return page.page(
        tr("Localization of a flight"),
        database,
        _key_figures(points),
        parts.next_steps(_next(points)),
        page.section(tr("Track"), *drawn),
        page.section(tr("Gaps"), *_gap_table(points)),
        page.section(tr("Motion between the images"), *map(page.paragraph, links)),
        page.section(tr("Images"), *_image_table(points)),
        parts.settings_section(settings),
    )


def _key_figures(points: Sequence[FlightPoint]) -> str:
    placed = [point for point in points if point.position is not None]
    own = sum(point.source == "own" for point in points)
    outvoted = sum(point.outvoted for point in points)
    radii = sorted(point.radius_95 for point in placed if point.radius_95 is not None)
    longest = max((last - first + 1 for first, last in gaps_of(points)), default=0)
    note = tr("{own} own positions, {flight} from the flight").format(own=own, flight=len(placed) - own)
    return page.key_figures(
        [
            (f"{len(placed)}/{len(points)}", tr("Images with a position"), note),
            (
                str(len({point.track for point in placed})),
                tr("Tracks"),
                tr("longest gap: {count} images").format(count=longest),
            ),
            (page.number(radii[len(radii) // 2] if radii else None, "m"), tr("95 % radius"), tr("median")),
            (str(outvoted), tr("Outvoted own positions"), tr("they contradict the flight")),
        ]
    )


def _next(points: Sequence[FlightPoint]) -> list[str]:
    placed = sum(point.position is not None for point in points)
    if not placed:
        return [
            tr("No image has a position. Set a prior position, add a camera table, or choose a database of this area."),
            tr("Run “Assess reference database” to see whether images of this footprint width can be localized there."),
        ]
    steps = []
    if placed < len(points):
        steps.append(
            tr("To close gaps, add an odometry table or the aircraft’s log, which connects images without landmarks.")
        )
    if any(point.outvoted for point in points):
        steps.append(tr("Check images with an outvoted own position: the map may be outdated there."))
    steps.append(tr("Georeference the images, or show the positions in QGIS’s temporal controller."))
    return steps


def gaps_of(points: Sequence[FlightPoint]) -> list[tuple[int, int]]:
    """Return (first, last) number of each run of images without a position."""
    found: list[tuple[int, int]] = []
    for point in points:
        if point.position is not None:
            continue
        if found and found[-1][1] == point.number - 1:
            found[-1] = found[-1][0], point.number
        else:
            found.append((point.number, point.number))
    return found


def _gap_table(points: Sequence[FlightPoint]) -> list[str]:
    gaps = gaps_of(points)
    if not gaps:
        return [page.paragraph(tr("There are no gaps. All images have a position."))]
    by_number = {point.number: point for point in points}
    columns = [
        (tr("From image"), lambda gap: by_number[gap[0]].name),
        (tr("To image"), lambda gap: by_number[gap[1]].name),
        (tr("Images"), lambda gap: str(gap[1] - gap[0] + 1)),
        (tr("Reason"), lambda gap: by_number[gap[0]].reason),
    ]
    return [page.records(gaps, columns, (2,))]


def _image_table(points: Sequence[FlightPoint]) -> list[str]:
    columns = [
        (tr("Number"), lambda point: str(point.number)),
        (tr("Image"), lambda point: point.name),
        (tr("Time"), lambda point: point.time),
        (tr("Source"), _source_text),
        (tr("Track"), lambda point: str(point.track) if point.track else page.NOTHING),
        ("x", lambda point: shown(point.position[0], ".1f") if point.position else page.NOTHING),
        ("y", lambda point: shown(point.position[1], ".1f") if point.position else page.NOTHING),
        (tr("Heading"), lambda point: _known(point.heading_deg, ".1f", "°")),
        (tr("95 % radius"), lambda point: _known(point.radius_95, ",.2f", f"{page.NO_BREAK}m")),
        (tr("Error probability"), lambda point: point.error_probability or page.NOTHING),
        (tr("Remark"), lambda point: point.reason),
    ]
    found = [page.records(points[:MOST_ROWS], columns, (0, 4, 5, 6, 7, 8, 9))]
    if len(points) > MOST_ROWS:
        text = tr("The table has the first {count} images. The layer has all images.")
        found.append(page.paragraph(text.format(count=MOST_ROWS)))
    return found


def _known(value: float | None, spec: str, unit: str) -> str:
    return page.NOTHING if value is None else shown(value, spec) + unit


def _source_text(point: FlightPoint) -> str:
    if point.position is None:
        return page.Marked(tr("no position"), False)
    if point.outvoted:
        return page.Marked(tr("flight; own position outvoted"), False)
    return page.Marked(tr("own position"), True) if point.source == "own" else tr("flight")
