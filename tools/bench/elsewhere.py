"""Images that lie nowhere on the map: any fix is a wrong one. In parts; a later run with the same --work goes on."""

from __future__ import annotations

import json
import sys
from collections import Counter
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np

from bench import inputs, machine, page
from bench.localization_trials import rate

PAGE = "benchmarks.md"
SEED = 30_000
COUNT = 500
QUICK_COUNT = 10
PART = 500
"""Images of one kind that are tried and noted together; each part has its own seed."""

REACH_PX = 1_200
"""Images of the southern half see at most so far beyond its edge."""

OTHER_HALF = "other half"
KINDS = {
    "sample": "made-up landscapes, another one each part",
    "mirrored": "mirrored, 20 / 20 / 5 %",
    "mirrored_few": "mirrored, 8–12 objects",
    "lattices": "regular lattices of plots with gaps",
    OTHER_HALF: "the southern half, 20 / 20 / 5 %, on a map of the northern",
}
"""Rows of tools/measure_constellation.py, and images of one half of the country on a map of the other."""


def measure(run: inputs.Run) -> dict[str, str]:
    import measure_constellation as constellation

    if run.area.name == "sample":
        return {"elsewhere": "Not measured: the real data is not here."}
    cv2.setNumThreads(1)
    each = -(-run.how_many(COUNT, QUICK_COUNT) // len(KINDS))
    area = constellation.Area(inputs.read_labels(run.label_map()), "south")
    rows, every = [], Counter()
    for kind, title in KINDS.items():
        statuses, index = Counter(), None
        for part, size in enumerate(parts(each)):
            kept = _kept(run, kind, part, size)
            if not kept.exists():
                index = index or _index(area, kind)
                found = _tried(constellation, area, kind, part, size, index)
                kept.write_text(json.dumps(found), encoding="utf-8")
            statuses.update(json.loads(kept.read_text("utf-8")))
            print(f"  {kind}: {sum(statuses.values())} of {each}, {dict(statuses)}", file=sys.stderr, flush=True)
        every.update(statuses)
        rows.append(_row(title, statuses))
    rows.append(_row("all", every))
    header = ["images", "fixes: all wrong", "ambiguous", "no match", "too few objects"]
    return {"elsewhere": f"{_ABOUT}\n\n{page.table(header, rows)}"}


_ABOUT = """\
Constellation, images of 1,280 px that lie nowhere on the map of Liechtenstein (southern half, where images are cut from
it). Goal: no fix for any of 30,000 (with none, the 95 % interval ends at 0.013 %). Each part of 500 images has its own
seed; `--work` keeps what was tried, and more are added by a larger `--count`."""


def parts(count: int, size: int = PART) -> list[int]:
    """Images of each part of `count`."""
    return [min(size, count - first) for first in range(0, count, size)]


def _kept(run: inputs.Run, kind: str, part: int, size: int) -> Path:
    """Statuses of one part; of this state of the code alone, so that no run mixes two."""
    folder = run.work / "elsewhere"
    folder.mkdir(exist_ok=True)
    state = machine.revision().replace(" ", "_")
    return folder / f"{kind.replace(' ', '_')}_{part}_{size}_{state}.json"


def _index(area, kind: str):
    from semref.core.constellation.index import build_index

    references = area.references()
    if kind == OTHER_HALF:
        northern = references.positions[:, 1] > area.extent[3] + REACH_PX
        references = replace(references, **{k: v[northern] for k, v in vars(references).items() if v is not None})
    return build_index(references, 1.0)


def _tried(constellation, area, kind: str, part: int, size: int, index) -> dict[str, int]:
    """How many images of a part came out with each status."""
    rng = np.random.default_rng([SEED, list(KINDS).index(kind), part])
    sample = constellation.sample_labels(SEED + part) if kind == "sample" else None
    row = constellation.ROWS["goal" if kind == OTHER_HALF else kind]
    return Counter(constellation.trial(area, row, index, rng, sample).status for _ in range(size))


def _row(title: str, statuses: Counter) -> list[str]:
    total = sum(statuses.values())
    others = [str(statuses[status]) for status in ("ambiguous", "no_match", "too_few_references")]
    return [title, rate(statuses["fix"], total), *others]
