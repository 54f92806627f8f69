"""Draw the chart of what to expect: a bar of images with right, wrong and no position for each entry of page.toml."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

from jinja2 import Template

from benchmarks import results

TEMPLATE = Path(__file__).with_name("chart.svg.j2")
SIZES = {"WIDTH": 850, "ROW": 34, "TOP": 64, "LEFT": 375, "BAR": 260}
"""Width of the chart, height of a row, and the place and width of the bars, in pixels."""

COLORS = {"RIGHT": "#0072b2", "WRONG": "#d55e00", "INK": "#222222", "PAPER": "#ffffff", "EMPTY": "#e6e6e6"}
"""Colors that color-blind people can distinguish (Okabe & Ito)."""


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
        name, row, right_in, wrong_in = bar["of"]
        right, wrong = (count_in(results.cell(name, row, column)) for column in (right_in, wrong_in))
        if right_in.startswith("placed") and right and wrong:
            share = 100 * (right.count - wrong.count) / right.of
            right = Count(right.count - wrong.count, right.of, share, share)
        if wrong is not None:
            found.append((bar["images"], right, wrong))
    return found


def picture(bars: Sequence[dict[str, Any]]) -> str:
    """Return the chart as SVG."""
    rows = figures(bars)
    template = Template(TEMPLATE.read_text(encoding="utf-8"), keep_trailing_newline=True)
    return template.render(SIZES, **COLORS, rows=rows, height=SIZES["TOP"] + SIZES["ROW"] * len(rows) + 34)
