"""The table that docs/benchmarks.md begins with: figure, goal, measured, command; read from the page's sections."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from bench import page

NAME = "summary"
AREAS = "coverage of map correlation"
COLUMNS = ("figure", "goal", "measured", "command")


@dataclass(frozen=True)
class Line:
    """A figure and where it stands.

    Attributes:
        figure: in words
        goal: in words
        section: that has it
        row: words that its row's first cells contain, parted by `|`; without any, all rows
        column: words that its column contains; of several columns the first counts
        bench: that writes the section; without one it is called as the section is
        largest: of all these rows and columns, the largest number
    """

    figure: str
    goal: str
    section: str
    row: str
    column: str
    bench: str = ""
    largest: bool = False

    @property
    def command(self) -> str:
        """What measures it."""
        return f"tools/bench {self.bench or self.section}"


LINES = (
    Line("rasterizing, times `gdal_rasterize`", "≤ 1.2", "rasterize", "running QGIS", "× `gdal"),
    Line("building, stride 350 m, times faster than a plain loop", "≥ 3", "build", "1280 / 350", "same work"),
    Line("building, stride 50 m", "≥ 10", "build", "1280 / 50", "2 threads"),
    Line("peak memory of building 5 Gpx", "≤ 1.5 GB", "memory", "99,424", "peak"),
    Line("right at 20 / 20 / 5 %", "≥ 99.5 %", "localization", "20 % missed", "right"),
    Line("wrong at 20 / 20 / 5 %", "≤ 0.05 %", "localization", "20 % missed", "wrong"),
    Line("right at 40 / 40 / 10 %", "≥ 95 %", "localization", "40 / 40 / 10 %", "right"),
    Line("95 % radius holds, any heading", "93–97 %", "localization", "20 % missed", "in the 95"),
    Line("95 % radius holds, right angles", "93–97 %", "localization", "rotation 90", "in the 95"),
    Line("95 % ellipse holds, another date (simulated)", "93–97 %", "coverage", "constellation: other date", "95 %"),
    Line("the same, maps of 1996 and 2018", "93–97 %", "coverage", "constellation: C|1996, images of 2018", "95 %"),
    Line("the same, buildings 3 m off, not stated", "93–97 %", "coverage", "constellation: b|3 m, not", "95 %"),
    Line("the same, automatic, another date", "93–97 %", AREAS, "automatic: other date", "95 %", "coverage"),
    Line("the same, map correlation, tilt 5°", "93–97 %", AREAS, "map correlation: tilt", "95 %", "coverage"),
    Line("images that lie nowhere, RISK 1 in 10,000: fixes", "0", "reliability", "not of the map", "RISK 0.0001"),
    Line("a query, ms (median, p95)", "p95 ≤ 100", "localization", "20 % missed", "ms median"),
    Line("fixes of images from elsewhere", "0 of 30,000", "elsewhere", "all", "fixes"),
    Line(
        "the same, given to automatic",
        "0 of 3,000",
        "elsewhere by automatic",
        "all but",
        "fixes",
        "elsewhere_automatic",
    ),
    Line("right anywhere on the ground, 1,280 m", "≥ 90 %", "footprints", "Liechtenstein, 1,280 m, 20|any", "right"),
    Line("right anywhere on the ground, 640 m", "≥ 70 %", "footprints", "Liechtenstein, 640 m, 20|any", "right"),
    Line("wrong fixes among 10⁶ landmarks", "0", "catalogue sizes", "1,000,000|other", "wrong", "catalogue_sizes"),
    Line(
        "a map of another date, 6.4 km, automatic", "≥ 99.5 %", "two dates", "6.4 km, 2018|auto", "right", "two_dates"
    ),
    Line("map correlation, strong noise", "–", "map correlation", "Liechtenstein|strong", "right", "correlation"),
    Line("automatic, strong noise", "–", "automatic", "strong", "right"),
    Line("tilted by 20°, leveled: right", "–", "tilted cameras", "20°, leveled", "right", "attitude"),
    Line("photos of the sample area, automatic", "≥ 90 %", "photos of the sample area", "automatic", "right", "photos"),
    Line(
        "real photos ≥ 512 px of a town, automatic", "≥ 90 %", "real photos", "tile 4|≥ 512 px|auto", "right", "photos"
    ),
    Line(
        "real photos ≥ 512 px of a shore, automatic", "≥ 90 %", "real photos", "tile 6|≥ 512 px|auto", "right", "photos"
    ),
    Line("assessment: right fixes, expected", "as measured", "assessment", "right fixes", "expected"),
    Line("assessment: right fixes, measured", "as expected", "assessment", "right fixes", "measured"),
    Line("onboard file, bytes a window", "≤ 40", "onboard file", "without", "a window", "onboard"),
    Line("onboard file, bytes a landmark", "≤ 6", "onboard file", "without", "a landmark", "onboard"),
    Line("update, share of a rebuild", "≤ 5 %", "update", "changed areas", "share"),
    Line("segmenting, times bare onnxruntime", "≥ 0.9", "segment", "multiplications", "of onnxruntime"),
    Line("longest stall of the dock, ms", "≤ 100", "dock stalls", "", "(ms)", "dock", largest=True),
)


def summary(text: str) -> str:
    """The table, from a page's sections."""
    rows = [
        [line.figure, line.goal, measured(section_of(text, line.section), line), f"`{line.command}`"] for line in LINES
    ]
    return page.table(COLUMNS, rows)


def section_of(text: str, name: str) -> str:
    """What stands between the markers of a section; nothing where there are none."""
    found = re.search(rf"<!-- bench:{name} -->(.*?)<!-- /bench:{name} -->", text, re.DOTALL)
    return found.group(1) if found else ""


def measured(section: str, line: Line) -> str:
    """The cell of the section's tables that a line means; “–” where there is none."""
    cells = [cell.replace("**", "") for cell in cells_of(section, line) if cell]
    if not cells:
        return "–"
    return max(cells, key=float) if line.largest else cells[0]


def cells_of(section: str, line: Line) -> Iterator[str]:
    """The cells in a line's rows and columns, from the top, from the left."""
    header: list[str] = []
    for row in section.splitlines():
        cells = [cell.strip() for cell in row.strip().strip("|").split(" | ")] if row.startswith("|") else []
        if not cells:
            header = []
        elif not header:
            header = cells
        elif set(row) - set("|-: ") and all(part in " ".join(cells[:2]) for part in line.row.split("|")):
            yield from (cell for name, cell in zip(header, cells) if line.column in name)
