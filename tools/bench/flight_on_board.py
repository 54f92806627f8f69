"""A long flight through `python -m core watch --flight`: seconds an image and memory, by images done.

.venv/bin/python tools/bench flight_on_board [--count 10000] [--write]

The flight is that of `tools.soak --flight`: restarted half way, with a table of motion that grows.
"""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from soak.held import verdict
from soak.watching import middle_and_most, watch_images

from bench import inputs, page

PAGE = "benchmarks.md"
AREA = "A made-up map of 700 × 700 pixels, images of 200 × 200 with labels as the map has them."
COUNT, QUICK_COUNT = 10_000, 20
COLUMNS = (
    "images so far",
    "s of the processor an image: median",
    "95 %",
    "slowest",
    "memory, MB",
    "descriptors",
    "threads",
)


def measure(run: inputs.Run) -> dict[str, str]:
    folder = Path(tempfile.mkdtemp(dir=run.work))
    try:
        rows, seconds = watch_images(run.how_many(COUNT, QUICK_COUNT), folder, is_flight=True)
        states = (folder / "flight.npz").stat().st_size
    finally:
        shutil.rmtree(folder)
    cells = []
    for row, tenth in zip(rows, seconds):
        half, most = middle_and_most(tenth)
        cells.append(
            (f"{row.done:,}", f"{half:.2f}", f"{most:.2f}", f"{max(tenth):.2f}", f"{row.megabytes:.1f}", *row[2:])
        )
    half, most = middle_and_most([one for tenth in seconds for one in tenth])
    text = _ABOUT.format(count=rows[-1].done, half=half, most=most, state=page.size(states), verdict=verdict(rows)[1])
    return {"flight on board": f"{text}\n\n{page.table(COLUMNS, cells)}"}


_ABOUT = """\
{count:,} images as one flight through one `python -m core watch --flight`, as fast as they are answered, the camera to
and fro over the map; a table of motion grows with them; one of 50 is damaged, one of 100 has a name that is no text.
After half of them the process is killed and goes on from its state. All images together: median {half:.2f} s of the
processor, 95th percentile {most:.2f} s; the state's file has {state} at the end; {verdict}."""
