"""The report of a flight: its track with error ellipses, what held where, heading and height along it, its gaps."""

from __future__ import annotations

from collections.abc import Sequence

from ..messages.numbers import shown
from ..translation import tr
from . import charts, page, parts
from .maps import FlightPoint, flight_legend, flight_map

MOST_ROWS = 400
"""Of the table of images; longer flights have the rest in their layer."""


def flight_html(
    points: Sequence[FlightPoint], database: str, links: Sequence[str], settings: Sequence[tuple[str, str]]
) -> str:
    """The whole page.

    Args:
        points: All images, in order.
        links: Sentences about the motion between images.
        settings: (name, value) of what was chosen.
    """
    caption = tr(
        "Discs: positions, filled where the image has a fix of its own, with the direction of the image’s top; "
        "ellipses hold the true position in 95 % of cases. North is up."
    )
    placed = [point for point in points if point.position is not None]
    drawn = [page.figure(flight_map(placed, tr("Map of the track")), caption), flight_legend()] if placed else []
    return page.page(
        tr("Report of a flight"),
        database,
        _key_figures(points),
        parts.next_steps(_next(points)),
        page.section(tr("Track"), *drawn),
        page.section(tr("Gaps"), *_gap_table(points)),
        *([page.section(tr("Along the flight"), _curves(points))] if len(placed) > 1 else []),
        page.section(tr("Motion between the images"), *map(page.paragraph, links)),
        page.section(tr("What held where"), *_image_table(points)),
        parts.settings_section(settings),
    )


def _key_figures(points: Sequence[FlightPoint]) -> str:
    placed = [point for point in points if point.position is not None]
    own = sum(point.source == "own" for point in points)
    outvoted = sum(point.outvoted for point in points)
    radii = sorted(point.radius_95 for point in placed if point.radius_95 is not None)
    longest = max((last - first + 1 for first, last in gaps_of(points)), default=0)
    note = tr("{own} by a fix of their own, {flight} by the flight").format(own=own, flight=len(placed) - own)
    return page.key_figures(
        [
            (f"{len(placed)}/{len(points)}", tr("images placed"), note),
            (
                str(len({point.track for point in placed})),
                tr("tracks"),
                tr("longest gap: {count} images").format(count=longest),
            ),
            (page.number(radii[len(radii) // 2] if radii else None, "m"), tr("95 % radius"), tr("median")),
            (str(outvoted), tr("own fixes outvoted"), tr("the flight contradicts them")),
        ]
    )


def _next(points: Sequence[FlightPoint]) -> list[str]:
    placed = sum(point.position is not None for point in points)
    if not placed:
        return [
            tr("No image has a place: try a prior position, the camera table, or a database of this ground."),
            tr("“Assess reference database” tells whether images of this size can be localized there."),
        ]
    steps = []
    if placed < len(points):
        steps.append(tr("Bridge the gaps: an odometry table or the aircraft’s log ties images without landmarks."))
    if any(point.outvoted for point in points):
        steps.append(tr("Look at images whose own fix was outvoted: the map may be out of date there."))
    steps.append(tr("Georeference the images, or play the positions in QGIS’s temporal controller."))
    return steps


def gaps_of(points: Sequence[FlightPoint]) -> list[tuple[int, int]]:
    """(first, last) number of each run of images without a position."""
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
        return [page.paragraph(tr("None: every image has a position."))]
    by_number = {point.number: point for point in points}
    columns = [
        (tr("from image"), lambda gap: by_number[gap[0]].name),
        (tr("to image"), lambda gap: by_number[gap[1]].name),
        (tr("images"), lambda gap: str(gap[1] - gap[0] + 1)),
        (tr("reason"), lambda gap: by_number[gap[0]].reason),
    ]
    return [page.records(gaps, columns, (2,))]


def _image_table(points: Sequence[FlightPoint]) -> list[str]:
    columns = [
        (tr("Number"), lambda point: str(point.number)),
        (tr("Image"), lambda point: point.name),
        (tr("Time"), lambda point: point.time),
        (tr("held by"), _held_by),
        (tr("track"), lambda point: str(point.track) if point.track else page.NOTHING),
        (tr("x"), lambda point: shown(point.position[0], ".1f") if point.position else page.NOTHING),
        (tr("y"), lambda point: shown(point.position[1], ".1f") if point.position else page.NOTHING),
        (tr("heading"), lambda point: _known(point.heading_deg, ".1f", "°")),
        (tr("95 % radius"), lambda point: _known(point.radius_95, ",.2f", f"{page.NO_BREAK}m")),
        (tr("error probability"), lambda point: point.error_probability or page.NOTHING),
        (tr("remark"), lambda point: point.reason),
    ]
    found = [page.records(points[:MOST_ROWS], columns, (0, 4, 5, 6, 7, 8, 9))]
    if len(points) > MOST_ROWS:
        text = tr("The first {count} images; the layer has all of them.")
        found.append(page.paragraph(text.format(count=MOST_ROWS)))
    return found


def _known(value: float | None, spec: str, unit: str) -> str:
    return page.NOTHING if value is None else shown(value, spec) + unit


def _held_by(point: FlightPoint) -> str:
    if point.position is None:
        return page.Marked(tr("nothing"), False)
    if point.outvoted:
        return page.Marked(tr("the flight, against its own fix"), False)
    return page.Marked(tr("its own fix"), True) if point.source == "own" else tr("the flight")


def _curves(points: Sequence[FlightPoint]) -> str:
    """Heading, and height or else pixel size, by number of the image: a line for each track."""
    has_heights = any(point.height is not None for point in points)
    upper = tr("height (m)") if has_heights else tr("pixel size (m)")
    heading = _curve(points, "heading_deg", tr("heading (°)"), (0.0, 360.0), 4)
    level = _curve(points, "height" if has_heights else "pixel_size", upper, None, 5)
    return page.columns(*(figure for figure in (heading, level) if figure))


def _curve(
    points: Sequence[FlightPoint], attribute: str, title: str, limits: tuple[float, float] | None, steps: int
) -> str:
    known = [point for point in points if getattr(point, attribute) is not None]
    if not known:
        return ""
    values = [getattr(point, attribute) for point in known]
    if limits is None:
        room = 0.1 * (max(values) - min(values)) or 0.1 * abs(values[0]) or 1.0
        limits = min(values) - room, max(values) + room
    lines = []
    for track in sorted({point.track for point in known}):
        members = [point for point in known if point.track == track]
        numbers = [float(point.number) for point in members]
        name = tr("Track {number}").format(number=track)
        lines.append(charts.Series(name, numbers, [getattr(point, attribute) for point in members]))
    last = max(len(points), 2)
    step = max(1, round((last - 1) / 6))
    ticks = [(float(number), str(number)) for number in range(1, last + 1, step)]
    x_axis = charts.Axis(tr("image"), (1.0, float(last)), ticks)
    return page.figure(charts.line_chart(lines, x_axis, charts.linear_axis(title, *limits, steps), title), title)
