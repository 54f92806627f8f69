"""Automatic: constellation and map correlation, each checked by the other, on images with good and with poor labels."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from bench import inputs, page
from bench.correlation import BUILDINGS, MAP_CORRELATION, ON_THE_MAP
from bench.ground import COLUMNS, GOAL, Case, Ground, cells, tried
from semref.core.localization import Method
from semref.core.simulation.noise import MODEST, STRONG

PAGE = "benchmarks.md"
SEED = 40_000
COUNT, QUICK_COUNT = 50, 2
LANDMARKS = Case("landmarks 20 / 20 / 5 %", GOAL, wanted=ON_THE_MAP, method=Method.AUTOMATIC)
POOR = replace(MAP_CORRELATION, method=Method.AUTOMATIC)
CASES = (
    LANDMARKS,
    replace(LANDMARKS, name="the same, 8–12 landmarks", wanted=replace(ON_THE_MAP, landmarks=(8, 12))),
    replace(LANDMARKS, name="the same, mirrored", wanted=replace(ON_THE_MAP, is_mirrored=True)),
)
POOR_CASES = (
    replace(POOR, name="modest label noise", noise=MODEST),
    replace(POOR, name="strong label noise", noise=STRONG),
    replace(POOR, name="modest label noise, mirrored", wanted=replace(ON_THE_MAP, is_mirrored=True)),
)
ELSEWHERE = (replace(LANDMARKS, name="landmarks 20 / 20 / 5 %, of the other half", is_of_map=False),)


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"automatic": "Not measured: the real data is not here."}
    ground, count = Ground.of(run), run.how_many(COUNT, QUICK_COUNT)
    found = [*tried(run, ground, CASES, count, SEED, "automatic")]
    found += tried(run, ground.known_elsewhere(), ELSEWHERE, count, SEED + 1, "automatic")
    ground.spoiled_values = BUILDINGS
    found += tried(run, ground, POOR_CASES, count, SEED + 2, "automatic")
    rows = []
    for case, trials in found:
        roads = Counter(t.result.method for t in trials if t.is_right)
        by = f"{roads[Method.CONSTELLATION]}, {roads[Method.MAP_CORRELATION]}"
        rows.append([*cells(trials, case.name), by if trials[0].query.can_be_right else "–"])
    table = page.table([*COLUMNS, "right by constellation, by map correlation"], rows)
    return {"automatic": f"{_ABOUT.format(half=run.half)}\n\n{table}"}


_ABOUT = """\
Both roads, each checked by the other, on images of 1,280 px of Liechtenstein's {half}ern half, any number of landmarks
in view, with the constants of the northern. Right: within 2 % of the footprint. Any fix of a mirrored image, or of the
half that the database doesn't have, is wrong."""
