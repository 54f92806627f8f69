"""The picture of docs/scale.md: how time and memory grow, from tables of docs/benchmarks.md.

    python tools/bench/how_it_grows.py

`tools/bench NAME --write` draws it anew as well. Every point is a measured one; lines only join them.
"""

from __future__ import annotations

import math
import re
import sys
from html import escape
from pathlib import Path
from typing import NamedTuple

if __name__ == "__main__":
    sys.path.append(str(Path(__file__).resolve().parents[1]))

from bench.summary import section_of
from bench.what_works import BENCHMARKS, INK, PAPER

PICTURE = BENCHMARKS.parent / "images" / "how_it_grows.svg"

COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#595959")
"""Stay apart for the color-blind (Okabe & Ito); each line has its words beside it as well."""


class Drawn(NamedTuple):
    """A line: in words, the table's section, words that its rows contain, parted by `;`, and its columns."""

    words: str
    section: str
    rows: str
    x: str
    y: str


class Panel(NamedTuple):
    """Lines over one axis, in one unit."""

    title: str
    lines: tuple[Drawn, ...]


PANELS = (
    Panel(
        "Seconds, by landmarks",
        (
            Drawn("index built", "stored index", "", "landmarks", "built, processor s"),
            Drawn("database read", "large databases", "", "landmarks / windows", "opened first, processor s"),
            Drawn("database opened", "large databases", "", "landmarks / windows", "opened again, processor s"),
            Drawn("index opened", "stored index", "", "landmarks", "opened, processor s"),
            Drawn("query, slowest of 20", "catalogue sizes", "other ground;20 / 20 / 5 %", "landmarks", "p95"),
            Drawn("query, median", "catalogue sizes", "other ground;20 / 20 / 5 %", "landmarks", "ms median"),
        ),
    ),
    Panel(
        "Seconds, by km² of map",
        (
            Drawn("areas made ready", "pyramids opened", "", "labeled km²", "made, s"),
            Drawn("areas opened", "pyramids opened", "", "labeled km²", "opened, s"),
            Drawn("query by areas", "large maps", "| modest noise |;larger pixels", "labeled km²", "s median"),
        ),
    ),
    Panel(
        "Gigabytes of memory, by pixels of the label map",
        (
            Drawn("build, starting process", "large builds", "", "map, pixels", "memory, starting process"),
            Drawn("build, a worker", "large builds", "", "map, pixels", "memory, worker"),
        ),
    ),
)

WIDTH, HEIGHT, MARGIN, WORDS_PX = 300, 240, 50, 150
_UNITS = {"ms": 1e-3, "kB": 1e-6, "MB": 1e-3, "GB": 1.0}


def number_in(cell: str) -> float | None:
    """The first number of a cell: ``10,000``, ``1.0e+08``, ``1.33 GB`` in GB; None without one."""
    found = re.search(r"\d[\d,]*(?:\.\d+)?(?:e[+-]?\d+)?", cell)
    if found is None:
        return None
    unit = cell[found.end() :].split()
    return float(found[0].replace(",", "")) * _UNITS.get(unit[0] if unit else "", 1.0)


def points(text: str, drawn: Drawn) -> list[tuple[float, float]]:
    """What the page's table tells of a line, by its first axis; none where the table is not there."""
    rows = [line for line in section_of(text, drawn.section).splitlines() if line.startswith("|")]
    header: list[str] = []
    found = []
    for line in rows:
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if {drawn.x, drawn.y} <= set(cells):
            header = cells
        elif not header or set(line) <= set("|-: "):
            continue
        elif len(cells) == len(header) and all(part.strip() in line for part in drawn.rows.split(";")):
            x, y = number_in(cells[header.index(drawn.x)]), number_in(cells[header.index(drawn.y)])
            if x and y:
                found.append((x, y * (_UNITS["ms"] if drawn.section == "catalogue sizes" else 1.0)))
    return sorted(found)


def picture(text: str) -> str:
    """The picture as SVG."""
    width = len(PANELS) * (WIDTH + WORDS_PX) + 20
    height = HEIGHT + 2 * MARGIN
    panels = [_panel(text, panel, 20 + number * (WIDTH + WORDS_PX)) for number, panel in enumerate(PANELS)]
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
        f'font-size="12"><rect width="{width}" height="{height}" rx="8" fill="{PAPER}"/>'
    )
    return "\n".join([head, *panels, "</svg>"]) + "\n"


def _panel(text: str, panel: Panel, left: int) -> str:
    lines = [(drawn.words, points(text, drawn)) for drawn in panel.lines]
    everything = [point for _, found in lines for point in found]
    parts = [f'<text x="{left}" y="24" font-size="14" font-weight="bold" fill="{INK}">{escape(panel.title)}</text>']
    if not everything:
        return parts[0]
    (x_low, x_high), (y_low, y_high) = (_decades([point[axis] for point in everything]) for axis in (0, 1))
    inner = WIDTH - MARGIN

    def place(x: float, y: float) -> tuple[float, float]:
        across = (math.log10(x) - x_low) / (x_high - x_low)
        up = (math.log10(y) - y_low) / (y_high - y_low)
        return left + MARGIN + across * inner, MARGIN + HEIGHT * (1 - up)

    for decade in range(x_low, x_high + 1):
        x = place(10.0**decade, 10.0**y_low)[0]
        parts.append(f'<path d="M{x:.1f} {MARGIN}V{MARGIN + HEIGHT}" stroke="#dddddd"/>')
        parts.append(
            f'<text x="{x:.1f}" y="{MARGIN + HEIGHT + 18}" text-anchor="middle" fill="{INK}">{_power(decade)}</text>'
        )
    for decade in range(y_low, y_high + 1):
        y = place(10.0**x_low, 10.0**decade)[1]
        parts.append(f'<path d="M{left + MARGIN} {y:.1f}H{left + WIDTH}" stroke="#dddddd"/>')
        parts.append(
            f'<text x="{left + MARGIN - 6}" y="{y + 4:.1f}" text-anchor="end" fill="{INK}">{_power(decade)}</text>'
        )
    ends = []
    for number, (words, found) in enumerate(lines):
        if not found:
            continue
        color, spots = COLORS[number], [place(*point) for point in found]
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in spots)
        parts.append(f'<path d="M{path}" fill="none" stroke="{color}" stroke-width="2"/>')
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{color}"/>' for x, y in spots]
        ends.append((spots[-1][1], words, color, spots[-1][0]))
    lowest = -math.inf
    for y, words, color, x in sorted(ends):
        # One word below the other where lines end beside each other.
        lowest = max(y, lowest + 15)
        parts.append(f'<text x="{x + 8:.1f}" y="{lowest + 4:.1f}" fill="{color}">{escape(words)}</text>')
    return "\n".join(parts)


def _decades(values: list[float]) -> tuple[int, int]:
    low, high = math.floor(math.log10(min(values)) + 1e-9), math.ceil(math.log10(max(values)) - 1e-9)
    return low, max(high, low + 1)


def _power(decade: int) -> str:
    """A power of ten in short: 0.01, 1, 100, then 10⁴."""
    if -3 <= decade <= 3:
        return f"{10.0**decade:g}"
    return "10" + "".join("⁻" if c == "-" else "⁰¹²³⁴⁵⁶⁷⁸⁹"[int(c)] for c in str(decade))


def write() -> None:
    """Draws the picture anew."""
    PICTURE.write_text(picture(BENCHMARKS.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    write()
    print(PICTURE)
