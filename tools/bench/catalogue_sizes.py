"""The constellation in catalogues of 10⁴, 10⁵ and 10⁶ objects: time to index them, time of a query."""

from __future__ import annotations

import sys
import time

import cv2
import numpy as np

from bench import inputs, page
from bench.localization_trials import rate

PAGE = "benchmarks.md"
SEED = 1671
COUNT = 100
QUICK_COUNT = 3
GOALS_MS = {10_000: 100, 100_000: 300, 1_000_000: 1000}
NOISES = ("goal", "hard")


def measure(run: inputs.Run) -> dict[str, str]:
    import measure_constellation as constellation

    if run.area.name == "sample":
        return {"catalogue sizes": "Not measured: the real data is not here."}
    cv2.setNumThreads(1)
    count = run.how_many(COUNT, QUICK_COUNT)
    area = constellation.Area(inputs.read_labels(run.label_map()), "south")
    rows, first = [], None
    for size, goal in list(GOALS_MS.items())[: 1 if run.quick else None]:
        seconds, index = _built(constellation.tiled(area, size, SEED))
        each = seconds / len(index)
        first = first or each
        for noise in NOISES:
            rng = np.random.default_rng([SEED, size])
            row = constellation.ROWS[noise]
            outcomes = [constellation.trial(area, row, index, rng, None) for _ in range(count)]
            median, high = 1000 * np.percentile([outcome.seconds for outcome in outcomes], [50, 95])
            right = sum(outcome.right for outcome in outcomes)
            wrong = sum(outcome.status == "fix" for outcome in outcomes) - right
            rows.append(
                [
                    f"{len(index):,}",
                    row.name,
                    f"{median:.0f}",
                    f"{high:.0f}",
                    f"≤ {goal}",
                    rate(right, count),
                    rate(wrong, count),
                    f"{seconds:.1f}",
                    f"{each / first:.2f}",
                ]
            )
            print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    header = [
        "objects",
        "images",
        "ms median",
        "p95",
        "goal p95",
        "right fixes",
        "wrong fixes",
        "s to index",
        "time per object × the first row's",
    ]
    return {"catalogue sizes": f"{_ABOUT.format(count=count)}\n\n{page.table(header, rows)}"}


_ABOUT = """\
One query of the constellation after its objects are found, processor time of one core, {count} images a row from
the southern half of Liechtenstein. Larger catalogues: the country with altered copies of itself beside it (other
places, other sizes). Indexing happens once, when a database is first used."""


def _built(references):
    from semref.core.constellation.index import build_index

    started = time.process_time()
    index = build_index(references, 1.0)
    return time.process_time() - started, index
