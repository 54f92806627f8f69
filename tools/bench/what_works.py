"""The picture of what works for the README, from figures of docs/benchmarks.md: python tools/bench/what_works.py.

`tools/bench NAME --write` draws it anew as well. Nothing in it is written by hand but what the images are.
"""

from __future__ import annotations

import re
import sys
from html import escape
from pathlib import Path
from typing import NamedTuple

if __name__ == "__main__":
    sys.path.append(str(Path(__file__).resolve().parents[1]))

from bench.summary import Line, measured, section_of

ROOT = Path(__file__).resolve().parents[2]
PICTURE = ROOT / "docs" / "images" / "what_works.svg"
BENCHMARKS = ROOT / "docs" / "benchmarks.md"


PLACED = "placed"
"""Of flights: with a position, right or wrong."""


IN_CELL = "in the same cell"
"""Where a cell tells both: ``139/306, 45 % (40–51); 0 wrong``."""

NOTE = "line: 95 % interval; a fix may be wrong at most once in 10,000 times, as told"


class Shown(NamedTuple):
    """A bar: in words, and where the figures stand; nothing is right where no image lies on the map."""

    images: str
    section: str
    row: str
    right: str
    wrong: str


SHOWN = (
    Shown("labels: 20 % of landmarks missed, 20 % invented", "localization", "20 % missed", "right", "wrong"),
    Shown("small to large views, labels clean to hopeless", "reliability", "all ", "RISK 0.0001", IN_CELL),
    Shown("the same, labels of poor networks, class areas", "area reliability", "all ", "RISK 0.0001", IN_CELL),
    Shown("a map 22 years older, 6.4 km in view", "two dates", "6.4 km, 2018|automatic", "right", "wrong"),
    Shown("the same, 3.2 km in view", "two dates", "3.2 km, 2018|automatic", "right", "wrong"),
    Shown("flights, labels too poor for single images", "flights", "640 m ", PLACED, "wrong"),
    Shown("the same, half as wide a view", "flights", "320 m, every", PLACED, "wrong"),
    Shown("wide again, motion that drifts by 5 %", "flights", "drift 5 %", PLACED, "wrong"),
    Shown("photos of the made-up sample area", "photos of the sample area", "automatic", "right", "wrong"),
    Shown("real photos: a town, trained on its other half", "own ground", "for 5 minutes, automatic", "right", "wrong"),
    Shown("six parts of a city, trained on the others", "real tiles", "all, network", "right", "wrong"),
    Shown("of these a shore and mangroves", "real tiles", "tile 6, network", "right", "wrong"),
    Shown("buildings alone, a town's other half", "real places", "west, buildings, all sizes, net", "right", "wrong"),
    Shown("buildings alone, a country never seen", "real places", "kenya, buildings, all sizes, net", "right", "wrong"),
    Shown("images of other places: none is to be found", "elsewhere", "all 0/", "", "fixes"),
)

WIDTH, ROW_PX, TOP_PX, LABELS_PX, BAR_PX = 850, 34, 64, 375, 260
RIGHT, WRONG, INK, PAPER, EMPTY = "#0072b2", "#d55e00", "#222222", "#ffffff", "#e6e6e6"
"""Colors that stay apart for the color-blind (Okabe & Ito)."""


class Count(NamedTuple):
    """So many of so many, and the 95 % interval in per cent, where it is told."""

    count: int
    of: int
    low: float
    high: float


def count_in(cell: str) -> Count | None:
    """The count that a cell tells, such as ``34/40, 85 % (71–93)``; None where it tells none."""
    found = re.match(r"(\d+)/(\d+)(?:.*?\(([\d.]+)[–-]([\d.]+))?", cell)
    if found is None:
        return None
    count, of = int(found[1]), int(found[2])
    share = 100 * count / max(of, 1)
    return Count(count, of, float(found[3] or share), float(found[4] or share))


def wrong_in(cell: str, right: Count | None) -> Count | None:
    """The wrong ones that a cell tells behind the right ones; None where it does not."""
    found = re.search(r"; (\d+)(?: wrong)?$", cell)
    return None if found is None or right is None else Count(int(found[1]), right.of, 0, 0)


def figures(text: str) -> list[tuple[str, Count | None, Count | None]]:
    """(images, right, wrong) of each bar, from the text of docs/benchmarks.md; what it does not tell has no bar."""
    found = []
    for shown in SHOWN:
        section = section_of(text, shown.section)
        cells = [measured(section, Line("", "", shown.section, shown.row, column)) for column in shown[3:] if column]
        right = count_in(cells[0]) if shown.right else None
        wrong = wrong_in(cells[0], right) if shown.wrong == IN_CELL else count_in(cells[-1])
        if shown.right == PLACED and right and wrong:
            share = 100 * (right.count - wrong.count) / right.of
            right = Count(right.count - wrong.count, right.of, share, share)
        if wrong is not None:
            found.append((shown.images, right, wrong))
    return found


def picture(text: str) -> str:
    """The picture as SVG."""
    rows = figures(text)
    height = TOP_PX + ROW_PX * len(rows) + 34
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}"'
        ' font-family="sans-serif" font-size="14">',
        f'<rect width="{WIDTH}" height="{height}" rx="8" fill="{PAPER}"/>',
        f'<text x="16" y="28" font-size="17" font-weight="bold" fill="{INK}">How many images are found</text>',
        _key(LABELS_PX, RIGHT, "right")
        + _key(LABELS_PX + 90, WRONG, "wrong")
        + _key(LABELS_PX + 180, EMPTY, "no position"),
    ]
    for number, row in enumerate(rows):
        parts.append(_row(TOP_PX + ROW_PX * number, *row))
    parts.append(f'<text x="16" y="{height - 12}" font-size="12" fill="{INK}">{NOTE}</text>')
    return "\n".join([*parts, "</svg>"]) + "\n"


def _key(x: int, color: str, words: str) -> str:
    box = f'<rect x="{x}" y="40" width="12" height="12" fill="{color}"/>'
    return f'{box}<text x="{x + 18}" y="51" font-size="12" fill="{INK}">{words}</text>'


def _row(y: int, images: str, right: Count | None, wrong: Count | None) -> str:
    middle, bar = y + ROW_PX / 2, f'y="{y + 8}" height="{ROW_PX - 16}"'
    parts = [
        f'<text x="16" y="{middle + 5}" fill="{INK}">{escape(images)}</text>',
        f'<rect x="{LABELS_PX}" {bar} width="{BAR_PX}" fill="{EMPTY}"/>',
    ]
    width = BAR_PX * right.count / right.of if right else 0
    if right:
        parts.append(f'<rect x="{LABELS_PX}" {bar} width="{width:.1f}" fill="{RIGHT}"/>')
    if wrong and wrong.count:
        own = BAR_PX * wrong.count / wrong.of
        parts.append(f'<rect x="{LABELS_PX + min(width, BAR_PX - own):.1f}" {bar} width="{own:.1f}" fill="{WRONG}"/>')
    if right:
        low, high = (LABELS_PX + BAR_PX * share / 100 for share in (right.low, right.high))
        parts.append(f'<path d="M{low:.1f} {middle}H{high:.1f}" stroke="{INK}" stroke-width="1.5" opacity="0.6"/>')
    told = f"{right.count:,} of {right.of:,}" if right else f"{wrong.of:,} tried" if wrong else ""
    told += f", {wrong.count or 'none'} wrong" if wrong else ""
    parts.append(f'<text x="{LABELS_PX + BAR_PX + 12}" y="{middle + 5}" font-size="13" fill="{INK}">{told}</text>')
    return "".join(parts)


def write() -> None:
    """Draws the picture anew."""
    PICTURE.write_text(picture(BENCHMARKS.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    write()
    print(PICTURE)
