"""Writes the table of walks into docs/what_works.md, from what the tests of walks have kept:

SEMREF_PICTURES=DIR python -m pytest tests/gui/test_walk_install.py tests/gui/test_walks.py tests/gui/test_walk_job.py
python tools/docs/list_walks.py DIR
"""

from __future__ import annotations

import argparse
import datetime
import json
import os
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs" / "what_works.md"
BEGIN, END = "<!-- walks: tools/docs/list_walks.py -->", "<!-- /walks -->"

PAGES = {
    "sample": ("the sample, by its menu", "guide/first_fix.md"),
    "sample, closed, reopened": ("its photos localized, the project closed and opened again", "guide/first_fix.md"),
    "own area": ("own area: a layer of OpenStreetMap classified, then the model into a database", "guide/own_area.md"),
    "own photos": ("own photos: database, model and files named, localized, laid on the map", "user_guide.md"),
    "inspect": ("inspect: windows in turn, by name, on the map; an image compared", "user_guide.md"),
    "assess, route, export": ("assess, route, export for the aircraft", "guide/planners.md"),
    "flight": ("six photos as one flight", "guide/flights.md"),
    "batch": ("a batch of two databases, opened from its file", "guide/toolbox.md"),
}


def rows(folder: Path) -> list[tuple]:
    """(what, page, clicks, values, seconds) of the walks that were kept."""
    found = []
    install = _kept(folder, "walk_install.json")
    if install:
        what = "install from the zip, in a bare profile and without a network"
        found.append((what, "guide/offline.md", 3, 1, install["seconds"]["install"]))
    job = _kept(folder, "walk_job.json")
    for key, (what, page) in PAGES.items():
        if key in job:
            found.append((what, page, job[key]["clicks"], job[key]["values"], job[key]["seconds"]))
    walks = _kept(folder, "walks.json")
    if walks:
        mended = walks["correct_mouse"]
        what = f"check → correct → update; places to mend: {mended['places']}"
        found.append((what, "guide/annotators.md", mended["clicks"], 0, mended["seconds"]))
    return found


def listing(folder: Path, day: datetime.date) -> str:
    """Markdown: the table, and how it was measured."""
    lines = ["| walk | clicks | values typed or chosen | seconds |", "|---|---|---|---|"]
    lines += [f"| [{what}]({page}) | {c} | {v} | {s:.0f} |" for what, page, c, v, s in rows(folder)]
    load = f"{os.cpu_count()} cores that others used, too"
    return "\n".join(lines) + f"\n\nIn desktop QGIS, by a script that presses and types ({day}, {load})."


def _kept(folder: Path, name: str) -> dict:
    file = folder / name
    return json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}


def main() -> None:
    """Writes the page."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="that SEMREF_PICTURES named")
    folder = parser.parse_args().folder
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
    after = rest.partition(END)[2]
    text = listing(folder, datetime.date.today())
    PAGE.write_text(f"{before}{BEGIN}\n\n{text}\n\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
