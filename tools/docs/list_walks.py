"""Writes what the walks took, from what their tests have kept: a table, and a line into the page of each walk.

SEMREF_PICTURES=DIR python -m pytest tests/gui/test_walk_install.py tests/gui/test_walks.py tests/gui/test_walk_job.py
python tools/docs/list_walks.py DIR

What they took before they were made shorter is in walks_before.json, which walk_before.py writes.
"""

from __future__ import annotations

import argparse
import datetime
import json
import os
import re
from pathlib import Path
from typing import NamedTuple

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGE = "what_works.md"
BEGIN, END = "<!-- walks: tools/docs/list_walks.py -->", "<!-- /walks -->"
LINE = re.compile(r"<!-- walk: (.+?) -->\n.*?<!-- /walk -->", re.DOTALL)

PAGES = {
    "install": ("install from the zip, in a bare profile and without a network", "guide/offline.md"),
    "sample": ("the sample, by its menu", "guide/first_fix.md"),
    "sample, closed, reopened": ("its photos localized, the project closed and opened again", "guide/first_fix.md"),
    "own area": ("own area: a layer of OpenStreetMap classified, then the model into a database", "guide/own_area.md"),
    "own photos": ("own photos: database, model and files named, localized, laid on the map", "guide/own_photos.md"),
    "inspect": ("inspect: windows in turn, by name, on the map; an image compared", "user_guide.md"),
    "correct": ("check → correct → update, of one place to mend", "guide/annotators.md"),
    "assess, route, export": ("assess, route, export for the aircraft", "guide/planners.md"),
    "flight": ("six photos as one flight", "guide/flights.md"),
    "batch": ("a batch of two databases, opened from its file", "guide/toolbox.md"),
}
"""What the walks are, and the pages that tell how to go them."""

INSTALL_CLICKS, INSTALL_VALUES = 3, 1
"""*Install from ZIP*, *…* beside the file, *Install Plugin*; QGIS's own installer is called, as they do."""


BEFORE = Path(__file__).with_name("walks_before.json")

BY_CALLS = ("sample",)
"""Walks whose every press is a call of QGIS's own: which key it would be, nobody has tried."""


class Walk(NamedTuple):
    """What a walk took; ``keys``: by the keyboard alone with all Tabs, None where these were not counted."""

    clicks: int
    keys: int | None
    values: int
    seconds: float


def walks(folder: Path) -> dict[str, Walk]:
    """What was kept there, by the keys of PAGES."""
    found = {}
    install, corrections = _kept(folder, "walk_install.json"), _kept(folder, "walks.json")
    mouse, keys = (_kept(folder, f"walk_job_{way}.json") for way in ("mouse", "keys"))
    if install:
        found["install"] = Walk(INSTALL_CLICKS, None, INSTALL_VALUES, install["seconds"]["install"])
    if corrections:
        by_mouse = corrections["correct_mouse"]
        found["correct"] = Walk(by_mouse["clicks"], None, 0, by_mouse["seconds"])
    for name in PAGES.keys() & mouse.keys():
        one = mouse[name]
        pressed = keys[name]["keys"] if name in keys and name not in BY_CALLS else None
        found[name] = Walk(one["clicks"], pressed, one["values"], one["seconds"])
    return {name: found[name] for name in PAGES if name in found}


def table(found: dict[str, Walk], how: str) -> str:
    """Markdown: all walks, and how they were measured."""
    before = json.loads(BEFORE.read_text(encoding="utf-8"))
    lines = [
        "| walk | clicks | or keys alone | values typed or chosen | seconds | before: clicks, values, seconds |",
        "|---|---|---|---|---|---|",
    ]
    for name, one in found.items():
        what, page = PAGES[name]
        pressed = "–" if one.keys is None else one.keys
        took = f"{one.clicks} | {pressed} | {one.values} | {one.seconds:.0f} | {_before(before['walks'].get(name))}"
        lines.append(f"| [{what}]({page}) | {took} |")
    how = f"In desktop QGIS, by a script that presses and types ({how}). Before: commit {before['commit']}, by"
    return "\n".join(lines) + f"\n\n{how} `tools/docs/walk_before.py`."


def line(name: str, one: Walk) -> str:
    """Markdown: what a walk takes, for its page."""
    pressed = "" if one.keys is None else f", or {one.keys} keys without the mouse"
    values = f"{one.values} {'value' if one.values == 1 else 'values'} to type or choose, "
    up = "../" if "/" in PAGES[name][1] else ""
    text = f"At the least: {one.clicks} clicks{pressed}, {values if one.values else ''}{one.seconds:.0f} s until it is"
    return f"*{text} done ([measured]({up}{PAGE}#the-job-walk-by-walk): {PAGES[name][0]}).*"


def write(docs: Path, found: dict[str, Walk], how: str) -> None:
    """Puts the table and the lines where their marks are; lines of walks that were not gone stay."""
    page = docs / PAGE
    before, _, rest = page.read_text(encoding="utf-8").partition(BEGIN)
    after = rest.partition(END)[2]
    page.write_text(f"{before}{BEGIN}\n\n{table(found, how)}\n\n{END}{after}", encoding="utf-8")

    def told(mark: re.Match) -> str:
        one = found.get(mark[1])
        return mark[0] if one is None else f"<!-- walk: {mark[1]} -->\n{line(mark[1], one)}\n<!-- /walk -->"

    for name in sorted({page for _, page in PAGES.values()}):
        text = (docs / name).read_text(encoding="utf-8")
        (docs / name).write_text(LINE.sub(told, text), encoding="utf-8")


def _before(one: dict | None) -> str:
    """What a walk took before; seconds only where it was gone."""
    if one is None:
        return "not possible"
    return f"{one['clicks']}, {one['values']}, {'–' if one['seconds'] is None else format(one['seconds'], '.0f')}"


def _kept(folder: Path, name: str) -> dict:
    file = folder / name
    return json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}


def main() -> None:
    """Writes the pages."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="that SEMREF_PICTURES named")
    how = f"{datetime.date.today()}, {os.cpu_count()} cores that others used, too"
    write(DOCS, walks(parser.parse_args().folder), how)


if __name__ == "__main__":
    main()
