"""Constellation localization by docs/benchmarks.md's goals, end to end: a database and a label image in, a fix out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from bench import inputs, page
from bench.ground import COLUMNS, GOAL, HARD, NONE, Case, Ground, Wanted, cells, tried
from semref.core.simulation.noise import LabelNoise

PAGE = "benchmarks.md"
SEED = 1671
COUNT = 300
QUICK_COUNT = 4
ROTATIONS_DEG = tuple(range(0, 360, 30))

RIGHT_M = 10.0
"""A fix is right within so many meters; of a tilted camera within 2 % of its footprint."""

RAGGED = LabelNoise(jitter=2.0)
MERGED = replace(RAGGED, merge_share=0.5, merge_gap=9, split=0.2)


def _case(name: str, noise: LabelNoise = GOAL, goal: str = "", as_landmarks: bool = False, **wanted: object) -> Case:
    within = None if "tilt_deg" in wanted else RIGHT_M
    return Case(name, noise, goal, Wanted(**wanted), as_landmarks=as_landmarks, right_within=within)


CASES = (
    _case("20 % missed, 20 % spurious, 5 % mislabeled", goal="≥ 99 %, wrong ≤ 0.1 %"),
    _case("40 / 40 / 10 %", HARD, "≥ 85 %"),
    _case("20 / 20 / 5 %, perturbed as landmarks", goal="≥ 99 %", as_landmarks=True),
    _case("40 / 40 / 10 %, perturbed as landmarks", HARD, "≥ 85 %", as_landmarks=True),
    _case("20 / 20 / 5 %, scale 0.5–2", goal="≥ 95 %", scales=(0.5, 2.0)),
    _case("no noise, scale 0.5–2", NONE, scales=(0.5, 2.0)),
    _case("20 / 20 / 5 %, 8–12 landmarks", landmarks=(8, 12)),
    _case("no noise, 8–12 landmarks", NONE, landmarks=(8, 12)),
    _case("20 / 20 / 5 %, camera tilted 5°", tilt_deg=5.0),
    _case("20 / 20 / 5 %, camera tilted 10°", tilt_deg=10.0),
    *(
        _case(f"20 / 20 / 5 %, rotation {angle}°", goal="≥ 99 %", scales=(1.0, 1.0), headings_deg=(angle,))
        for angle in ROTATIONS_DEG
    ),
    _case("boundaries jittered by 2 px", RAGGED),
    _case("the same, gaps ≤ 8 px closed in half of the image, 20 % of landmarks cut in two", MERGED),
)


def measure(run: inputs.Run) -> dict[str, str]:
    text = [_about(run), _table(run)]
    if run.area.name != "sample":
        sample = replace(run, area=inputs.sample_area(run.work))
        text += [_SAMPLE.format(size=sample.area.window_size), _table(sample)]
    return {"localization": "\n\n".join(text)}


_SAMPLE = """\
The same on the sample area of `tools/sample`, a made-up landscape with other classes, images of {size:g}
px:"""


def _about(run: inputs.Run) -> str:
    return _ABOUT.format(
        ragged=GOAL.jitter, center=GOAL.center, area=GOAL.log_area, count=how_many(run), right=RIGHT_M, half=run.half
    )


_ABOUT = """\
Constellation, end to end: `semref:builddatabase`'s file is read, a label image is cut from the map at any place and
heading (scale 0.8–1.25 and ≥ 20 whole landmarks in view unless said otherwise), spoiled, and given to `core.localizer`.
Noise in the label image: landmarks erased, landmarks of elsewhere drawn in, landmarks given another class, boundaries
moved by σ {ragged:g} px; “perturbed as landmarks”: the same shares of those found in the clean image, centers moved by
σ {center:g} px, ln area by σ {area:g}. {count} images a row. Right: within {right:g} m, with a tilted camera within
2 % of the footprint. Liechtenstein: images from the {half}ern half, the method's constants are from the northern. Goals
of accuracy: position ≤ 0.3 % of the footprint, heading ≤ 0.3°, scale ≤ 0.5 % (medians); the ellipse holds in 93–97 %.
Found: landmarks in the spoiled image, down to the smallest area at the coarsest pixel size searched. Images are of the
map's own date. Times: processor, one core."""


def how_many(run: inputs.Run) -> int:
    """Images a case."""
    return run.how_many(COUNT, QUICK_COUNT)


def _table(run: inputs.Run) -> str:
    cases: Sequence[Case] = CASES[:: 4 if run.quick and not run.only else 1]
    found = tried(run, Ground.of(run), cases, how_many(run), SEED)
    return page.table(COLUMNS, [cells(trials, case.name, case.goal) for case, trials in found])
