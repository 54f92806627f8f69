"""Draw the chart of what to expect: a bar of images with right, wrong and no position for each entry of page.toml."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape
from typing import Any, NamedTuple

from benchmarks import results

WIDTH, ROW_PX, TOP_PX, LABELS_PX, BAR_PX = 850, 34, 64, 375, 260
RIGHT, WRONG, INK, PAPER, EMPTY = "#0072b2", "#d55e00", "#222222", "#ffffff", "#e6e6e6"
"""Colors that color-blind people can distinguish (Okabe & Ito)."""

NOTE = "Line: 95 % interval of the share. Error probability of each position: at most 1 in 10,000."


class Count(NamedTuple):
    """A count, its total, and the 95 % interval in percent."""

    count: int
    of: int
    low: float
    high: float


def count_in(cell: str) -> Count | None:
    """Return the count in a cell such as ``34/40, 85 % (71–93)``; None without a count."""
    found = re.match(r"(\d+)/(\d+)(?:.*?\(([\d.]+)[–-]([\d.]+))?", cell)
    if found is None:
        return None
    count, of = int(found[1]), int(found[2])
    share = 100 * count / max(of, 1)
    return Count(count, of, float(found[3] or share), float(found[4] or share))


def figures(bars: Sequence[dict[str, Any]]) -> list[tuple[str, Count | None, Count | None]]:
    """Return (images, right, wrong) of each bar with figures."""
    found = []
    for bar in bars:
        name, row, right_in, wrong_in, *table = bar["of"]
        cell = results.cell(name, row, right_in, *table) if right_in else ""
        right = count_in(cell)
        if wrong_in:
            wrong = count_in(results.cell(name, row, wrong_in, *table))
        else:
            both = re.search(r"; (\d+)(?: wrong)?$", cell)
            wrong = Count(int(both[1]), right.of, 0, 0) if both and right else None
        if right_in.startswith("placed") and right and wrong:
            share = 100 * (right.count - wrong.count) / right.of
            right = Count(right.count - wrong.count, right.of, share, share)
        if wrong is not None:
            found.append((bar["images"], right, wrong))
    return found


def picture(bars: Sequence[dict[str, Any]]) -> str:
    """Return the chart as SVG."""
    rows = figures(bars)
    height = TOP_PX + ROW_PX * len(rows) + 34
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}"'
        ' font-family="sans-serif" font-size="14">',
        f'<rect width="{WIDTH}" height="{height}" rx="8" fill="{PAPER}"/>',
        f'<text x="16" y="28" font-size="17" font-weight="bold" fill="{INK}">Share of images with a position</text>',
        _key(LABELS_PX, RIGHT, "right position")
        + _key(LABELS_PX + 125, WRONG, "wrong position")
        + _key(LABELS_PX + 255, EMPTY, "no position"),
    ]
    parts += [_row(TOP_PX + ROW_PX * number, *row) for number, row in enumerate(rows)]
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
    words = f"{right.count:,} of {right.of:,}" if right else f"{wrong.of:,} tried" if wrong else ""
    words += f", {wrong.count} wrong" if wrong else ""
    parts.append(f'<text x="{LABELS_PX + BAR_PX + 12}" y="{middle + 5}" font-size="13" fill="{INK}">{words}</text>')
    return "".join(parts)
